#pragma once
// What stands around the arm, for commands that propose motions.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "core/base/findings.h"
#include "core/coach/guided_tool.h"
#include "core/collision/clearance.h"

namespace CLI {
class App;
}

namespace heft::cli {

struct ClearanceArguments {
  std::string room, shape, shapeFile;
};

/// --room, --shape and --shape-file.
void addClearanceOptions(CLI::App& app, ClearanceArguments& arguments);

/// What motions are judged against.
class Surroundings {
 public:
  /// Arm and tool are always judged against each other where the robot's bodies are known; a warning says where they
  /// are not. Throws WrongUsage and Failed.
  Surroundings(const ClearanceArguments& arguments, const GuidedTool& tool, Findings& findings);

  const Clearance* clearance() const { return clearance_ ? &*clearance_ : nullptr; }
  /// For a person: what a proposed motion keeps clear of, and what it does not know. A line.
  std::string words() const;
  /// {"room", "margin_m", "obstacles", "arm"}
  nlohmann::json toJson() const;

 private:
  std::string file_;  ///< Of the room; empty: none
  Room room_;
  std::optional<Clearance> clearance_;
};

}  // namespace heft::cli
