// heft room: walls and tables that were touched by hand, for heft coach --room.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "app/cli/recording_options.h"
#include "core/base/json_file.h"
#include "core/compensation/touched_room.h"
#include "core/estimation/estimate.h"

namespace heft::cli {
namespace {

struct RoomArguments {
  std::string recording, result, shape, shapeFile, output, robot;
  double margin = Room{}.margin;
  bool force = false;
  ImportOptions import;
};

void writeTouched(const RoomArguments& options) {
  const auto tool = shapeChoice(options.shape, options.shapeFile);
  if (!tool) throw WrongUsage("Say by --shape or --shape-file what touched: a plane begins where the tool ends.");
  requireRange("--margin", options.margin, 0.0, 0.5, "m");
  const Overwrite overwrite = ownResult(options.force, "heft.room/1");
  requireWritable(options.output, overwrite);
  ProgressLine line;
  const Input input = readInput(options.recording, options.import, options.robot, line.progress());
  const nlohmann::json result =
      options.result.empty() ? heft::toJson(orFail(estimate(input.recording, input.model(), {}, line.progress())))
                             : orFail(readJsonFile(options.result));
  line.clear();
  printFindings(input.findings, true);
  const TouchedRoom touched =
      orFail(findTouchedRoom(input.recording, input.model(), result,
                             options.result.empty() ? input.recording.file : options.result, *tool, line.progress()));
  line.clear();
  const Room room = roomOf(touched, options.margin);
  writeResult(options.output, heft::toJson(room), overwrite);
  printFindings(touched.findings, true);
  if (options.output == "-") return;
  std::string text = fmt::format("{}: {} plane{} from {}\n", options.output, room.obstacles.size(),
                                 room.obstacles.size() == 1 ? "" : "s", input.recording.file);
  for (std::size_t i = 0; i < touched.planes.size(); ++i) {
    const TouchedPlane& p = touched.planes[i];
    text += fmt::format(
        "  {:<10} {} touch{}, faces ({:.2f}, {:.2f}, {:.2f}){}, {:.1f} mm along it from the base's origin to {:.1f} "
        "mm\n",
        room.obstacles[i].name, p.when.size(), p.when.size() == 1 ? "" : "es", p.plane.normal.x(), p.plane.normal.y(),
        p.plane.normal.z(),
        fmt::format(fmt::runtime(p.plumb ? "; the touch alone tells it to {:.0f} degrees" : " to {:.0f} degrees"),
                    p.normalSpread * 180.0 / std::numbers::pi),
        1e3 * p.plane.normal.dot(p.plane.point), 1e3 * p.offsetSpread);
  }
  print(text);
}

}  // namespace

Command makeRoomCommand(CLI::App& root) {
  auto options = std::make_shared<RoomArguments>();
  CLI::App* app = root.add_subcommand("room", "Find walls and tables that were touched by hand");
  app->add_option("RECORDING", options->recording,
                  "The tool is pressed against each wall or table and held there for a second")
      ->type_name("")
      ->required();
  app->add_option("--payload", options->result,
                  "JSON from 'heft estimate --json'; otherwise estimated from the recording's free parts")
      ->type_name("FILE");
  app->add_option("--shape", options->shape, "Shape of the tool that touches, as in 'heft estimate'")
      ->type_name("SHAPE");
  app->add_option("--shape-file", options->shapeFile, "Shape as JSON: several bodies, meshes")->type_name("FILE");
  app->add_option("-o,--output", options->output, "Room to write (heft.room/1); - is stdout")
      ->type_name("FILE")
      ->required();
  app->add_option("--margin", options->margin, "Distance that motions keep from everything [m]")
      ->type_name("M")
      ->capture_default_str();
  app->add_option("--robot", options->robot, "panda or a URDF, instead of the setup file's")->type_name("ROBOT");
  app->add_flag("--force", options->force, "Overwrite an existing file");
  addRecordingOptions(*app, options->import);
  addRateOption(*app, options->import);
  app->footer(
      "Examples:\n"
      "  heft room touches.csv --shape box:0.06,0.06,0.16@0,0,0.08 -o room.json\n"
      "  heft coach rec.csv --room room.json --shape box:0.06,0.06,0.16@0,0,0.08");
  return {app, [options] { writeTouched(*options); }};
}

}  // namespace heft::cli
