#include "ui/controller/robot_choice.h"

#include <QCoreApplication>
#include <QFileInfo>

#include "core/base/json_file.h"
#include "core/motion/motion.h"
#include "core/recording/csv_reader.h"
#include "core/recording/meta_file.h"

namespace heft {
namespace {

struct RobotChoice {
  Q_DECLARE_TR_FUNCTIONS(RobotChoice)
};

}  // namespace

QString metaFileBeside(const OpenRecording& opened) {
  return QString::fromStdString(metaFileOf(std::filesystem::path(opened.path.toStdString())).string());
}

Result<bool> nameRobot(const OpenRecording& opened, const QString& urdf) {
  RecordingMeta meta = opened.recording.meta;
  meta.robot = QFileInfo(urdf).absoluteFilePath().toStdString();
  Findings findings;
  const auto robot = robotFor(meta, findings);
  if (!robot) return robot.error();
  if (opened.recording.hasJoints()) {
    if (robot->dof() != opened.recording.q.cols())
      return Error{RobotChoice::tr("%1 has %2 joints, the recording %3: choose the description of the robot that was recorded.")
                       .arg(QFileInfo(urdf).fileName())
                       .arg(robot->dof())
                       .arg(opened.recording.q.cols())
                       .toStdString()};
    if (!robot->findLink(meta.mount.parent))
      return Error{RobotChoice::tr("%1 has no link \"%2\", where the sensor is mounted: set sensor.mount.parent in %3 to the right one.")
                       .arg(QFileInfo(urdf).fileName(), QString::fromStdString(meta.mount.parent), metaFileBeside(opened))
                       .toStdString()};
  }
  const std::filesystem::path file = metaFileBeside(opened).toStdString();
  const auto merged = mergedMeta(file, {{"robot", *meta.robot}});
  if (!merged) return merged.error();
  return writeTextFile(file, merged->dump(2) + "\n");
}

}  // namespace heft
