#include "app/cli/reading.h"

#include <fmt/format.h>

#include "app/cli/cli.h"
#include "core/motion/motion.h"

namespace heft::cli {

Input readInput(const std::string& file, const ImportOptions& options, const std::string& robot,
                const Progress& progress) {
  ReadRecording read = orFail(openRecording(file, options, progress));
  Input input{std::move(read.recording), std::nullopt, std::move(read.findings)};
  const Recording& recording = input.recording;
  if (!robot.empty()) input.recording.meta.robot = robot == "panda" ? robot : std::filesystem::absolute(robot).string();
  if (!recording.hasJoints() || (recording.hasOrientation() && !recording.meta.robot)) return input;
  if (!recording.meta.robot)
    throw Failed(
        fmt::format("{} has joint angles, but nothing says of which arm: state \"robot\", \"panda\" or a URDF, in its "
                    "meta file.",
                    recording.file));
  input.robot = orFail(robotFor(recording.meta, input.findings));
  return input;
}

}  // namespace heft::cli
