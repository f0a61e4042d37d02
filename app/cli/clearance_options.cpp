#include "app/cli/clearance_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "app/cli/recording_options.h"
#include "core/base/say.h"

namespace heft::cli {

void addClearanceOptions(CLI::App& app, ClearanceArguments& arguments) {
  const char* const kGroup = "Obstacles";
  app.add_option("--room", arguments.room,
                 "Walls, tables, boxes and meshes as JSON (heft.room/1): nothing comes nearer\n"
                 "than its margin")
      ->type_name("FILE")
      ->group(kGroup);
  app.add_option("--shape", arguments.shape, "Shape of the tool, as in 'heft estimate'; otherwise from the URDF")
      ->type_name("SHAPE")
      ->group(kGroup);
  app.add_option("--shape-file", arguments.shapeFile, "Shape as JSON: several bodies, meshes")
      ->type_name("FILE")
      ->group(kGroup);
}

Surroundings::Surroundings(const ClearanceArguments& arguments, const GuidedTool& tool, Findings& findings)
    : file_(arguments.room) {
  if (!file_.empty()) room_ = orFail(readRoom(file_));
  const HeldTool held{tool.link, tool.X_LS, shapeChoice(arguments.shape, arguments.shapeFile)};
  auto made = Clearance::of(*tool.robot, held, room_, findings);
  if (made) {
    clearance_ = std::move(*made);
  } else if (!file_.empty() || held.shape) {
    throw Failed(made.error().message);
  } else {
    findings.push_back(
        {Severity::warning,
         "arm_not_judged",
         heft::say("The arm's bodies cannot be read, so motions are not checked against the arm itself: {}",
                   made.error().message),
         {},
         {}});
  }
}

std::string Surroundings::words() const {
  if (!clearance_) return "  Neither the arm's own bodies nor obstacles are known to Heft: see that the way is free.\n";
  if (file_.empty())
    return "  Arm and tool stay clear of each other. Obstacles are not known: see that the way is free, or give "
           "--room.\n";
  return fmt::format("  Arm and tool stay {:.0f} mm clear of each other and of the {} obstacle{} in {}.\n",
                     1e3 * room_.margin, room_.obstacles.size(), room_.obstacles.size() == 1 ? "" : "s", file_);
}

nlohmann::json Surroundings::toJson() const {
  return {{"room", file_.empty() ? nlohmann::json() : nlohmann::json(file_)},
          {"margin_m", clearance_ ? nlohmann::json(room_.margin) : nlohmann::json()},
          {"obstacles", room_.obstacles.size()},
          {"arm", clearance_.has_value()}};
}

}  // namespace heft::cli
