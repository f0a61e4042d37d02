#include "ui/controller/open_recording.h"

#include <QElapsedTimer>

#include "core/import/import.h"
#include "core/motion/motion.h"

namespace heft {

Result<std::shared_ptr<const OpenRecording>> loadRecording(const QString& path, const Progress& progress) {
  QElapsedTimer clock;
  clock.start();
  auto read = openRecording(std::filesystem::path(path.toStdString()), ImportOptions{}, progress);
  if (!read) return read.error();
  auto opened = std::make_shared<OpenRecording>();
  opened->path = path;
  opened->readSeconds = static_cast<double>(clock.elapsed()) / 1000.0;
  opened->findings = std::move(read->findings);
  opened->recording = std::move(read->recording);
  if (progress.cancelled()) return Error{"Opening was stopped.", true};
  // A pose says where the sensor is without a robot; then the robot is only for looks and may be missing.
  if (opened->recording.meta.robot) {
    auto robot = robotFor(opened->recording.meta, opened->findings);
    if (robot) {
      opened->robot = std::make_shared<const RobotModel>(std::move(robot).value());
      opened->look = std::make_shared<const RobotLook>(loadLook(*opened->robot, opened->findings, progress));
    } else if (opened->recording.hasJoints() && !opened->recording.hasOrientation()) {
      return robot.error();
    } else {
      opened->findings.push_back({Severity::warning, "robot_not_loaded", robot.error().message, "", {}});
    }
  }
  return std::shared_ptr<const OpenRecording>(std::move(opened));
}

}  // namespace heft
