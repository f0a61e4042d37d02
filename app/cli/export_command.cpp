// heft export: a result, or a bare payload, as the file that a controller reads.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "core/base/json_file.h"
#include "core/base/text.h"
#include "core/exporters/flange.h"
#include "core/exporters/urdf_copy.h"

namespace heft::cli {
namespace {

struct ExportArguments {
  std::string result, format, output, json, xyz, rpy, tcp, mount, into, link;
  std::vector<std::string> add;
  FlangeOptions flange;
  bool force = false;
};

std::string formatList() {
  std::string text;
  for (const auto& format : exportFormats()) text += fmt::format("  {:<20}{}\n", format.id, format.title);
  return text;
}

void run(ExportArguments options) {
  const bool copies = !options.into.empty();
  if (copies && !options.format.empty()) throw WrongUsage("--into writes a copy of a URDF; it takes no --format.");
  if (copies != !options.link.empty()) throw WrongUsage("--into ROBOT.urdf and --link NAME belong together.");
  if (!copies && options.format.empty()) throw WrongUsage("Say which file to write: --format NAME, or --into a URDF.");
  std::vector<std::string> ids;
  for (const auto& format : exportFormats()) ids.emplace_back(format.id);
  const ExportFormat& format = exportFormats()[chooseWord("--format", copies ? "urdf" : options.format, ids)];
  if (!options.flange.parentLink.empty() && (copies || format.id != "urdf"))
    throw WrongUsage("--parent goes with --format urdf.");
  if (!options.xyz.empty()) options.flange.xyz = parseVector3("--xyz", options.xyz);
  if (!options.rpy.empty()) options.flange.rpy = parseVector3("--rpy", options.rpy);
  if (!options.tcp.empty()) options.flange.X_FE = parsePose("--tcp", options.tcp);
  const bool toStdout = options.output.empty() || options.output == "-";
  if (toStdout && options.json == "-")
    throw WrongUsage("The payload file and --json cannot both go to stdout; give -o FILE as well.");

  if (!options.mount.empty())
    options.flange.mount = orFail(sensorMountFromJson(orFail(readJsonFile(options.mount)), options.mount));
  for (const auto& file : options.add) {
    options.flange.add.push_back(orFail(payloadFromJson(orFail(readJsonFile(file)), file)));
    options.flange.addNames.push_back(displayName(std::filesystem::path(file).filename()));
  }
  options.flange.program = programVersion();
  options.flange.force = options.force;
  FlangePayload payload = orFail(toFlange(orFail(readJsonFile(options.result)), options.result, options.flange));
  const std::string text = copies ? orFail(payloadIntoUrdf(orFail(readTextFile(options.into)), options.into,
                                                           options.link, payload, payload.findings))
                                  : orFail(exportPayload(format, payload.input, payload.findings));
  writeOutput(toStdout ? "-" : options.output, text, {options.force, {}});
  printFindings(payload.findings, true);

  const Payload& p = payload.input.payload;
  if (!options.json.empty()) {
    const nlohmann::json summary{{"schema", "heft.export/1"},
                                 {"format", format.id},
                                 {"into", copies ? nlohmann::json(options.into) : nlohmann::json()},
                                 {"file", toStdout ? nlohmann::json() : nlohmann::json(options.output)},
                                 {"payload", toJson(p)},
                                 {"findings", toJson(payload.findings)}};
    writeResult(options.json, summary, ownResult(options.force, "heft.export/1"));
  }
  if (!toStdout && options.json != "-")
    print(fmt::format("{}: {}\n  mass {:.4f} kg, centre of mass ({:.1f}, {:.1f}, {:.1f}) mm from the flange\n",
                      options.output, format.title, p.mass, 1e3 * p.com.x(), 1e3 * p.com.y(), 1e3 * p.com.z()));
}

}  // namespace

Command makeExportCommand(CLI::App& root) {
  auto options = std::make_shared<ExportArguments>();
  CLI::App* app = root.add_subcommand("export", "Write a payload file for a controller");
  app->add_option("RESULT", options->result, "The --json file of 'heft estimate', or a payload in the flange frame")
      ->type_name("")
      ->required();
  app->add_option("-f,--format", options->format, "File format, see below")->type_name("NAME");
  app->add_option("--into", options->into, "Write a copy of this URDF with the payload in it instead, see --link")
      ->type_name("URDF");
  app->add_option("--link", options->link, "The link of --into that carries the payload")->type_name("NAME");
  app->add_option("-o,--output", options->output, "Output file; otherwise stdout")->type_name("FILE");
  app->add_option("--name", options->flange.name, "Name of the tool, in formats that have one")
      ->type_name("NAME")
      ->capture_default_str();
  app->add_option("--parent", options->flange.parentLink,
                  "Put a massless link of this name and a fixed joint above the tool, for --format urdf")
      ->type_name("NAME");
  app->add_option("--frame", options->flange.sensorFrame, "Name of the sensor's frame in ROS, in formats that have one")
      ->type_name("NAME");
  app->add_option("--mount", options->mount, "Take the sensor's pose on the flange from this setup file")
      ->type_name("FILE");
  app->add_option("--xyz", options->xyz, "Sensor origin on the flange, x,y,z [m]")->type_name("X,Y,Z");
  app->add_option("--rpy", options->rpy, "Sensor rotation on the flange, roll,pitch,yaw [rad], fixed axes")
      ->type_name("R,P,Y");
  app->add_option("--tcp", options->tcp,
                  "Tool centre point on the flange, in formats that have one (Franka's tool files)")
      ->type_name("X,Y,Z[,R,P,Y]");
  app->add_option("--add", options->add,
                  "Payload JSON in the flange frame of something else that is mounted, such as the\n"
                  "sensor and its adapter, which the estimate does not contain; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app->add_option("--json", options->json, "Also write payload and findings as JSON; - is stdout")->type_name("FILE");
  app->add_flag("--force", options->force, "Overwrite existing files, and write even a payload that is not reliable");
  app->footer("Formats:\n" + formatList() +
              "\nExamples:\n"
              "  heft export result.json --format franka-desk -o tool.json\n"
              "  heft export result.json --format urdf --add sensor.json\n"
              "  heft export result.json --format libfranka --xyz 0,0,0.04 --rpy 0,0,-0.7854\n"
              "  heft export result.json --into robot.urdf --link tool0 -o robot_with_tool.urdf\n\n"
              "The numbers are turned from sensor axes into flange axes with the sensor mount of the recording's meta\n"
              "file. A payload that cannot exist is refused; numbers that nobody measured are warned about.");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
