#pragma once
// A recording and its arm, as every subcommand that works on one needs them.
#include <optional>
#include <string>

#include "core/import/import.h"
#include "core/robot/robot_model.h"

namespace heft::cli {

/// A recording with the arm that its joints belong to.
struct Input {
  Recording recording;
  std::optional<RobotModel> robot;  ///< Absent where the poses in the file do without it.
  Findings findings;

  const RobotModel* model() const { return robot ? &*robot : nullptr; }
};

/// Reads any recording and brings it to the plain form; `robot` ("panda" or a URDF, may be empty) overrides the meta's.
/// Throws Failed.
Input readInput(const std::string& file, const ImportOptions& options, const std::string& robot,
                const Progress& progress);

/// The same for a recording that was read, checked or simulated already.
Input withArm(ReadRecording read);

}  // namespace heft::cli
