#include "app/cli/reading.h"

#include <fmt/format.h>

#include "app/cli/cli.h"
#include "core/motion/motion.h"
#include "core/motion/mount_link.h"
#include "core/motion/sensor_axes.h"

namespace heft::cli {

Input readInput(const std::string& file, const ImportOptions& options, const std::string& robot,
                const Progress& progress) {
  ImportOptions known = options;
  known.robot = robot;
  return withArm(orFail(openRecording(file, known, progress)));
}

Input withArm(ReadRecording read) {
  Input input{std::move(read.recording), std::nullopt, std::move(read.findings)};
  Recording& recording = input.recording;
  if (!recording.hasJoints() || (recording.hasOrientation() && !recording.meta.robot)) {
    orFail(toSensorAxes(recording, nullptr));
    return input;
  }
  if (!recording.meta.robot)
    throw Failed(
        fmt::format("{} has joint angles, but nothing says of which arm: state \"robot\", \"panda\" or a URDF, in its "
                    "setup file.",
                    recording.file));
  input.robot = orFail(robotFor(recording.meta, input.findings));
  mountOnFlange(recording.meta, *input.robot, input.findings);
  orFail(toSensorAxes(recording, input.model()));
  return input;
}

}  // namespace heft::cli
