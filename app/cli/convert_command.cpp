// heft convert: a recording in the contract's plain form, and what is odd about it.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "core/base/text.h"
#include "core/recording/csv_reader.h"

namespace heft::cli {
namespace {

using nlohmann::json;

struct Options {
  std::string input, output, meta, json;
  bool force = false;
};

std::string motionForm(const Recording& recording) {
  if (recording.hasJoints()) return fmt::format("{} joints", recording.q.cols());
  if (recording.hasPosition()) return "sensor poses";
  return "orientation only";
}

void run(const Options& options) {
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
    return orFail(readRecording(options.input, {options.meta}, line.progress()));
  }();
  // One sign in every file that Heft writes: what the sensor exerts on the payload.
  const bool flipped = read.recording.meta.wrenchSign == WrenchSign::payloadOnSensor;
  read.recording.meta.wrenchSign = WrenchSign::sensorOnPayload;
  orFail(writeRecording(read.recording, csv));

  const Recording& recording = read.recording;
  if (!options.json.empty()) {
    const json summary{
        {"schema", "heft.convert/1"},      {"file", displayName(csv)},       {"meta", displayName(metaOut)},
        {"samples", recording.rows()},     {"rate_hz", recording.rateHz()},  {"duration_s", recording.duration()},
        {"motion", motionForm(recording)}, {"wrench_sign_changed", flipped}, {"findings", toJson(read.findings)}};
    writeOutput(options.json, fileText(summary),
                {options.force, [](const std::string& old) { return hasSchema(old, "heft.convert/1"); }});
  }
  if (options.json == "-") return;
  std::string text = fmt::format("{} and {}: {} samples, {:.1f} s at {:.0f} Hz, {}\n", displayName(csv),
                                 displayName(metaOut.filename()), recording.rows(), recording.duration(),
                                 recording.rateHz(), motionForm(recording));
  if (flipped) text += "  the wrench's sign was turned: it is now what the sensor exerts on the payload\n";
  print(text);
  printFindings(read.findings, true);
}

}  // namespace

Command makeConvertCommand(CLI::App& root) {
  auto options = std::make_shared<Options>();
  CLI::App* app = root.add_subcommand("convert", "Check a recording and write it in the plain form");
  app->add_option("IN", options->input, "The recording, CSV with a header row")->type_name("")->required();
  app->add_option("OUT", options->output, "CSV to write; its meta file is written beside it")
      ->type_name("")
      ->required();
  app->add_option("--meta", options->meta, "Meta file; otherwise IN's own .meta.json if it exists")->type_name("FILE");
  app->add_option("--json", options->json, "Also write what was found as JSON; - is stdout")->type_name("FILE");
  app->add_flag("--force", options->force, "Replace files that exist");
  app->footer(
      "Examples:\n"
      "  heft convert raw.csv rec.csv\n"
      "  heft convert raw.csv rec.csv --meta sensor.meta.json --json check.json\n\n"
      "Commas between columns, SI units, time rising, unit quaternions, wrench as the sensor exerts it on the\n"
      "payload. What was repaired or looks odd is said with line and column.");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
