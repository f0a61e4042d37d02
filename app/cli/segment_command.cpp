// heft segment: what of a recording is free, and what happens in the rest.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "app/cli/recording_options.h"
#include "core/base/json_file.h"
#include "core/estimation/segment_recording.h"

namespace heft::cli {
namespace {

struct SegmentArguments {
  std::string recording, robot, payload, segments = "auto", json;
  bool force = false;
  ImportOptions import;
};

void run(const SegmentArguments& options) {
  constexpr std::array kSegmentModes{SegmentMode::automatic, SegmentMode::marks};
  EstimateOptions settings;
  settings.segments = kSegmentModes[chooseWord("--segments", options.segments, {"auto", "marks"})];
  const Overwrite overwrite = ownResult(options.force, "heft.segment/1");
  if (!options.json.empty()) requireWritable(options.json, overwrite);
  if (!options.payload.empty())
    settings.firstEstimate = orFail(payloadGuessFromJson(orFail(readJsonFile(options.payload)), options.payload));

  ProgressLine line;
  const Input input = readInput(options.recording, options.import, options.robot, line.progress());
  SegmentedRecording segmented = orFail(segmentRecording(input.recording, input.model(), settings, line.progress()));
  line.clear();
  segmented.findings.insert(segmented.findings.begin(), input.findings.begin(), input.findings.end());
  if (!options.json.empty()) {
    nlohmann::json result = toJson(segmented, input.recording);
    result["findings"] = toJson(segmented.findings);
    writeResult(options.json, result, overwrite);
  }
  if (options.json != "-") print(toText(segmented, input.recording));
}

}  // namespace

Command makeSegmentCommand(CLI::App& root) {
  auto options = std::make_shared<SegmentArguments>();
  CLI::App* app = root.add_subcommand("segment", "Find free segments, contact and other events in a recording");
  app->add_option("RECORDING", options->recording,
                  "CSV with time, motion and wrench columns, SI units; or ROS bag, MCAP, HDF5, ...")
      ->type_name("")
      ->required();
  app->add_option("--json", options->json, "Write the segments as JSON; - is stdout, instead of the text")
      ->type_name("FILE");
  app->add_option("--robot", options->robot, "panda or a URDF, instead of the setup file's")->type_name("ROBOT");
  app->add_option("--payload", options->payload, "A first estimate: result or payload JSON, in sensor axes")
      ->type_name("FILE");
  app->add_option("--segments", options->segments, "auto: look for contact, marks win; marks: only what is marked")
      ->type_name("NAME")
      ->capture_default_str();
  app->add_flag("--force", options->force, "Overwrite existing files");
  addRecordingOptions(*app, options->import);
  addRateOption(*app, options->import);
  app->footer(
      "Examples:\n"
      "  heft segment rec.csv\n"
      "  heft segment rec.csv --payload result.json --json segments.json\n\n"
      "Labels: free (used for the estimate), contact, ignore. Each segment has a reason and a confidence.");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
