// heft prove: is the payload that was entered the one that is carried?
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "app/cli/recording_options.h"
#include "core/base/json_file.h"
#include "core/compensation/proof.h"

namespace heft::cli {
namespace {

struct ProveArguments {
  std::string payload, recording, robot, json, segments;
  bool force = false;
  ImportOptions import;
};

void proveFiles(const ProveArguments& options) {
  EstimateOptions settings;
  settings.segments = segmentChoice(options.segments);
  const Overwrite overwrite = ownResult(options.force, "heft.prove/1");
  if (!options.json.empty()) requireWritable(options.json, overwrite);
  const auto payload = orFail(readJsonFile(options.payload));
  ProgressLine line;
  const Input input = readInput(options.recording, options.import, options.robot, line.progress());
  const EnteredPayload entered = orFail(enteredPayloadFromJson(payload, options.payload, input.recording.meta.mount));
  const Proof proof = orFail(prove(entered, input.recording, input.model(), settings, input.findings, line.progress()));
  line.clear();
  if (!options.json.empty()) writeResult(options.json, toJson(proof), overwrite);
  if (options.json != "-") print(toText(proof));
  if (proof.verdict != ProofVerdict::pass) throw Failed("NOT YET: " + proof.reasons.front().text);
}

}  // namespace

Command makeProveCommand(CLI::App& root) {
  auto options = std::make_shared<ProveArguments>();
  CLI::App* app = root.add_subcommand("prove", "Verify with a new recording that the entered payload is right");
  app->add_option(
         "PAYLOAD", options->payload,
         "JSON from 'heft estimate --json', a payload JSON in sensor axes, or Franka's file from 'heft export'")
      ->type_name("")
      ->required();
  app->add_option("RECORDING", options->recording,
                  "Ten seconds of guiding or more; CSV with time, motion and wrench columns, SI units, or ROS bag, ...")
      ->type_name("")
      ->required();
  app->add_option("--json", options->json, "Write the result as JSON; - is stdout, instead of the text")
      ->type_name("FILE");
  app->add_option("--robot", options->robot, "panda or a URDF, instead of the setup file's")->type_name("ROBOT");
  app->add_option("--segments", options->segments, "auto, marks or all, as for 'heft estimate'")->type_name("NAME");
  app->add_flag("--force", options->force, "Overwrite existing files");
  addRecordingOptions(*app, options->import);
  addRateOption(*app, options->import);
  app->footer(
      "Examples:\n"
      "  heft prove result.json check.csv\n"
      "  heft prove result.json check.csv --json proof.json\n\n"
      "PASS (exit code 0): with the payload subtracted, free segments contain only sensor noise.\n"
      "NOT YET (exit code 1): another mass, centre or inertia, something besides a rigid payload, or a motion that\n"
      "cannot tell; the reason is said. A right payload passes in 99 of 100 recordings.");
  return {app, [options] { proveFiles(*options); }};
}

}  // namespace heft::cli
