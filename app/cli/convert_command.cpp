// heft convert: a recording of any kind in the contract's plain form, and what is odd about it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "app/cli/recording_options.h"
#include "core/base/text.h"
#include "core/conventions/check.h"
#include "core/motion/motion.h"
#include "core/motion/mount_link.h"
#include "core/motion/sensor_axes.h"

namespace heft::cli {
namespace {

using nlohmann::json;

struct ConvertArguments {
  std::string input, output, json;
  ImportOptions import;
  bool force = false;
  bool list = false;
};

std::string motionForm(const Recording& recording) {
  if (recording.hasJoints()) return fmt::format("{} joints", recording.q.cols());
  if (recording.hasPosition()) return "sensor poses";
  return "orientation only";
}

/// What physics says that the numbers mean, where motion and wrench are there; else null. `text`: the same for a
/// person.
json conventionsOf(const ConvertArguments& options, std::string& text) {
  std::optional<Input> input;
  try {
    ProgressLine line;
    input = readInput(options.input, options.import, {}, line.progress());
  } catch (const Failed&) {
    return nullptr;  // Cannot be read as a whole: converting or estimating it says why.
  }
  const Recording& recording = input->recording;
  const auto motion = recording.meta.kind == RecordingKind::poses ? standingPoses(recording, input->model())
                                                                  : motionOf(recording, input->model(), {});
  if (!motion) return nullptr;
  const auto question = conventions::questionOf(recording, *motion);
  const conventions::Report report = conventions::check(question);
  json out = toJson(report, recording.meta.mount, !question.posesInFile);
  if (!report.enough) {
    text = "\nToo few numbers to tell what they mean.\n";
    return out;
  }
  text = fmt::format("\n{}\n", report.sentence);
  for (const auto& tie : report.ties) text += fmt::format("  fits equally well: {}\n", tie.sentence);
  if (!report.decides.empty()) text += fmt::format("  {}\n", report.decides);
  if (const json& meta = out["meta"]; !meta.is_null())
    text += fmt::format("  Write into the setup file: {}\n", meta.dump());
  if (!report.check.empty()) text += fmt::format("  {}\n", report.check);
  return out;
}

/// What there is to choose from, and what would be taken.
void list(const ConvertArguments& options) {
  if (!options.output.empty()) throw WrongUsage("--list writes no recording; leave OUT away.");
  RecordingContents contents = [&] {
    ProgressLine line;
    return orFail(inspectRecording(options.input, options.import, line.progress()));
  }();
  std::string text = fmt::format("{}: {}\n", options.input, toString(contents.kind));
  json streams = json::array();
  const auto& taking = contents.chosen.empty() ? contents.proposed : contents.chosen;
  for (std::size_t s = 0; s < contents.streams.size(); ++s) {
    const Stream& stream = contents.streams[s];
    text += fmt::format("\n{}{}{}\n  {} samples, {}\n", stream.name.empty() ? stream.file : stream.name,
                        stream.type.empty() ? "" : ", ", stream.type, stream.samples,
                        stream.clockless ? std::string("no clock")
                                         : fmt::format("{:.4g} Hz, {:.4g} s", stream.rateHz(), stream.duration()));
    json fields = json::array();
    for (std::size_t f = 0; f < stream.fields.size(); ++f) {
      const auto taken =
          std::find_if(taking.begin(), taking.end(), [&](const auto& c) { return c.stream == s && c.field == f; });
      const bool is = taken != taking.end();
      text +=
          fmt::format("    {}{}\n", stream.fields[f], is ? fmt::format("  -> {} ({})", taken->column, taken->why) : "");
      fields.push_back({{"name", stream.fields[f]},
                        {"column", is ? json(taken->column) : json(nullptr)},
                        {"why", is ? json(taken->why) : json(nullptr)}});
    }
    streams.push_back({{"name", stream.name},
                       {"type", stream.type},
                       {"file", stream.file},
                       {"samples", stream.samples},
                       {"rate_hz", stream.rateHz()},
                       {"fields", std::move(fields)}});
  }
  std::string meaning;
  const json conventions = contents.missing.empty() ? conventionsOf(options, meaning) : json();
  if (!options.json.empty())
    writeResult(options.json,
                {{"schema", "heft.contents/1"},
                 {"file", options.input},
                 {"kind", toString(contents.kind)},
                 {"streams", std::move(streams)},
                 {"missing", contents.missing.empty() ? json(nullptr) : json(contents.missing)},
                 {"conventions", conventions},
                 {"findings", toJson(contents.findings)}},
                ownResult(options.force, "heft.contents/1"));
  if (options.json == "-") return;
  if (!contents.missing.empty()) text += fmt::format("\n{}\n", contents.missing);
  print(text + meaning);
  printFindings(contents.findings, true);
}

void run(const ConvertArguments& options) {
  if (options.list) return list(options);
  if (options.output.empty()) throw WrongUsage("OUT is missing: the CSV to write.");
  const std::filesystem::path csv = options.output;
  if (csv.extension() != ".csv")
    throw WrongUsage(fmt::format("OUT expects a name that ends in .csv, not '{}'.", options.output));
  std::error_code ec;
  if (std::filesystem::equivalent(options.input, csv, ec))
    throw WrongUsage("IN and OUT are the same file; a recording is never written over itself.");
  requireWritable(csv, {options.force, {}});
  auto metaOut = csv;
  metaOut.replace_extension(".meta.json");
  requireWritable(metaOut, {options.force, {}});

  ReadRecording read = [&] {
    ProgressLine line;
    return orFail(openRecording(options.input, options.import, line.progress()));
  }();
  if (read.recording.hasJoints() && read.recording.meta.robot)
    if (const auto robot = robotFor(read.recording.meta, read.findings))
      mountOnFlange(read.recording.meta, *robot, read.findings);
  orFail(toSensorAxes(read.recording));
  // One form in every file that Heft writes, and one sign: what the sensor exerts on the payload.
  const bool flipped = read.recording.meta.wrenchSign == WrenchSign::payloadOnSensor;
  const json conventions = toJson(read.recording.meta.conventions);
  read.recording.meta.numbersArePlain();
  orFail(writeRecording(read.recording, csv));

  const Recording& recording = read.recording;
  if (!options.json.empty()) {
    const json summary{{"schema", "heft.convert/1"},           {"file", displayName(csv)},
                       {"meta", displayName(metaOut)},         {"samples", recording.rows()},
                       {"rate_hz", recording.rateHz()},        {"duration_s", recording.duration()},
                       {"motion", motionForm(recording)},      {"wrench_sign_changed", flipped},
                       {"conventions_taken_out", conventions}, {"findings", toJson(read.findings)}};
    writeResult(options.json, summary, ownResult(options.force, "heft.convert/1"));
  }
  if (options.json == "-") return;
  std::string text = fmt::format("{} and {}: {} samples, {:.1f} s at {:.0f} Hz, {}\n", displayName(csv),
                                 displayName(metaOut.filename()), recording.rows(), recording.duration(),
                                 recording.rateHz(), motionForm(recording));
  if (flipped) text += "  the wrench's sign was turned: it is now what the sensor exerts on the payload\n";
  std::string taken;
  for (const auto& [key, value] : conventions.items())
    taken += fmt::format("{}{} {}", taken.empty() ? "" : ", ", key,
                         value.is_string() ? value.get<std::string>() : value.dump());
  if (!taken.empty()) text += fmt::format("  converted from: {}\n", taken);
  print(text);
  printFindings(read.findings, true);
}

}  // namespace

Command makeConvertCommand(CLI::App& root) {
  auto options = std::make_shared<ConvertArguments>();
  CLI::App* app = root.add_subcommand("convert", "Validate a recording and convert it to Heft CSV");
  app->add_option("IN", options->input, "The recording: CSV, ROS 1 or ROS 2 bag, MCAP, JSON lines, HDF5, MATLAB, NumPy")
      ->type_name("")
      ->required();
  app->add_option("OUT", options->output, "CSV to write; its setup file is written beside it")->type_name("");
  app->add_flag("--list", options->list, "Show topics and columns, and what would be used; write nothing");
  app->add_option("--robot", options->import.robot, "panda or a URDF, instead of the setup file's")->type_name("ROBOT");
  addRecordingOptions(*app, options->import);
  addRateOption(*app, options->import);
  app->add_option("--json", options->json, "Also write what was found as JSON; - is stdout")->type_name("FILE");
  app->add_flag("--force", options->force, "Overwrite existing files");
  app->footer(
      "Examples:\n"
      "  heft convert raw.csv rec.csv\n"
      "  heft convert raw.csv rec.csv --meta sensor.meta.json --json check.json\n"
      "  heft convert demo.bag --list\n"
      "  heft convert demo.bag rec.csv --use wrench=/ft/raw\n"
      "  heft convert robot_log.csv rec.csv --join wrench.csv\n\n"
      "Commas between columns, SI units, time rising, unit quaternions, wrench as the sensor exerts it on the\n"
      "payload. What was repaired or looks odd is said with line and column.");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
