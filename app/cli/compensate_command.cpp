// heft compensate: the forces of a demonstration without the payload's share, in phases.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "app/cli/recording_options.h"
#include "core/base/json_file.h"
#include "core/compensation/compensation.h"
#include "core/diagnosis/correction/corrected.h"

namespace heft::cli {
namespace {

struct CompensateArguments {
  std::string recording, result, diagnosis, output, robot, json;
  bool force = false;
  ImportOptions import;
};

void run(const CompensateArguments& options) {
  if (options.output == "-" && options.json == "-")
    throw WrongUsage("The CSV and --json cannot both go to stdout; give -o FILE or --json FILE.");
  const Overwrite overwriteJson = ownResult(options.force, "heft.compensate/1");
  const Overwrite overwriteCsv{options.force, {}};
  if (!options.json.empty()) requireWritable(options.json, overwriteJson);
  if (!options.output.empty()) requireWritable(options.output, overwriteCsv);
  const CompensateOptions settings =
      orFail(compensateOptionsFromJson(orFail(readJsonFile(options.result)), options.result));

  ProgressLine line;
  Input input = readInput(options.recording, options.import, options.robot, line.progress());
  if (!options.diagnosis.empty())
    input.recording = orFail(
        correctedByAll(input.recording, input.model(), orFail(readJsonFile(options.diagnosis)), options.diagnosis));
  Compensated compensated = orFail(compensate(input.recording, input.model(), settings, line.progress()));
  line.clear();
  compensated.findings.insert(compensated.findings.begin(), input.findings.begin(), input.findings.end());
  if (!options.output.empty()) writeOutput(options.output, toCsv(compensated, input.recording), overwriteCsv);
  if (!options.json.empty()) {
    nlohmann::json result = toJson(compensated, input.recording);
    result["findings"] = toJson(compensated.findings);
    writeResult(options.json, result, overwriteJson);
  }
  if (options.output == "-" || options.json == "-") return;
  print(toText(compensated, input.recording));
}

}  // namespace

Command makeCompensateCommand(CLI::App& root) {
  auto options = std::make_shared<CompensateArguments>();
  CLI::App* app = root.add_subcommand("compensate", "Subtract the payload from the measured wrench");
  app->add_option("RECORDING", options->recording,
                  "CSV with time, motion and wrench columns, SI units; or ROS bag, MCAP, HDF5, ...")
      ->type_name("")
      ->required();
  app->add_option("RESULT", options->result, "JSON from 'heft estimate --json', or a payload JSON in sensor axes")
      ->type_name("")
      ->required();
  app->add_option("--diagnosis", options->diagnosis, "JSON from 'heft diagnose --json': its causes are corrected, too")
      ->type_name("FILE");
  app->add_option("-o,--output", options->output, "CSV with motion, compensated wrench and phase; - is stdout")
      ->type_name("FILE");
  app->add_option("--json", options->json, "Write the phases as JSON; - is stdout, instead of the text")
      ->type_name("FILE");
  app->add_option("--robot", options->robot, "panda or a URDF, instead of the setup file's")->type_name("ROBOT");
  app->add_flag("--force", options->force, "Overwrite existing files");
  addRecordingOptions(*app, options->import);
  addRateOption(*app, options->import);
  app->footer(
      "Examples:\n"
      "  heft compensate rec.csv result.json\n"
      "  heft compensate rec.csv result.json -o contact.csv --json phases.json\n\n"
      "Phases: free, approach (on the way to a contact), contact, ignore. The wrench keeps the recording's sign "
      "inside\n"
      "Heft, what the sensor exerts on the payload; \"on the tool\" is what the surroundings exert.");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
