// heft export-model: the rig as a diagnosis found it, for other simulators.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "core/base/json_file.h"
#include "core/twin/model_export.h"

namespace heft::cli {
namespace {

struct ExportModelArguments {
  std::string found, target, output;
  ModelExportOptions model;
  bool force = false;
};

void exportFound(ExportModelArguments options) {
  constexpr std::array kTargets{ModelTarget::mujoco, ModelTarget::gazebo, ModelTarget::data};
  const ModelTarget target = kTargets[chooseWord("--for", options.target, {"mujoco", "gazebo", "json"})];
  options.model.program = programVersion();
  const ExportedModel model =
      orFail(exportModel(orFail(readJsonFile(options.found)), options.found, target, options.model));
  const bool toStdout = options.output.empty() || options.output == "-";
  // People work on in such files: another text than this one is not known to be ours.
  writeOutput(toStdout ? "-" : options.output, model.text, {options.force, {}});
  if (toStdout) return;
  std::string text = fmt::format("{}: the rig of {} for {}\n", options.output, options.found, options.target);
  for (const auto& cause : model.causes)
    text += fmt::format("  {:<18} {}\n", cause.id,
                        cause.simulated               ? "in the model's geometry"
                        : target == ModelTarget::data ? "as numbers"
                                                      : "as numbers; the simulation runs without it");
  if (model.causes.empty()) text += "  no cause was found: payload and sensor alone\n";
  print(text);
}

}  // namespace

Command makeExportModelCommand(CLI::App& root) {
  auto options = std::make_shared<ExportModelArguments>();
  CLI::App* app = root.add_subcommand("export-model", "Write the setup as a diagnosis found it, for another simulator");
  app->add_option("FOUND", options->found, "The --json file of 'heft diagnose'")->type_name("")->required();
  app->add_option("--for", options->target,
                  "mujoco: MJCF; gazebo: SDF 1.9; json: everything that is known, for your own programs")
      ->type_name("NAME")
      ->required();
  app->add_option("-o,--output", options->output, "Output file; otherwise stdout")->type_name("FILE");
  app->add_option("--without", options->model.without, "Switch this cause off (repeatable)")
      ->type_name("CAUSE")
      ->expected(1)
      ->take_all();
  app->add_option("--name", options->model.name, "Name of the carried body")->type_name("NAME")->capture_default_str();
  app->add_flag("--force", options->force, "Overwrite an existing file");
  app->footer(
      "Examples:\n"
      "  heft diagnose rec.csv --json found.json\n"
      "  heft export-model found.json --for mujoco -o rig.xml\n"
      "  heft export-model found.json --for gazebo --without gravity_tilt -o rig.sdf\n\n"
      "A sensor that was found turned or beside its place, and a tilted gravity, are part of the geometry. What the\n"
      "simulator does not know (delays, filters, gains, drifts, cables) stands in the file as numbers with their "
      "names.");
  return {app, [options] { exportFound(*options); }};
}

}  // namespace heft::cli
