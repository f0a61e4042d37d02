#include "ui/controller/open_recording.h"

#include <QElapsedTimer>
#include <algorithm>

#include "core/base/say.h"
#include "core/import/import.h"
#include "core/motion/motion.h"
#include "core/motion/sensor_axes.h"
#include "core/recording/csv_reader.h"

namespace heft {

namespace {

/// Where the columns can be listed, the user can say what they are.
ReadCure cureOf(const std::filesystem::path& file, const Progress& progress) {
  const auto contents = inspectRecording(file, {}, progress);
  if (!contents) return ReadCure::none;
  if (!contents->missing.empty()) return ReadCure::sources;
  const auto joints = std::count_if(contents->chosen.begin(), contents->chosen.end(), [](const ColumnSource& each) {
    return each.column[0] == 'q' && each.column[1] <= '9';
  });
  Findings findings;
  const std::filesystem::path meta = metaFileOf(file);
  const auto said = std::filesystem::exists(meta) ? readMeta(meta, findings) : Result<RecordingMeta>(RecordingMeta{});
  return joints > 0 && joints != 7 && said && !said->robot ? ReadCure::rig : ReadCure::sources;
}

}  // namespace

Result<std::shared_ptr<const OpenRecording>> loadRecording(const QString& path, const Progress& progress,
                                                           ReadCure& cure) {
  cure = ReadCure::none;
  QElapsedTimer clock;
  clock.start();
  auto read = openRecording(std::filesystem::path(path.toStdString()), ImportOptions{}, progress);
  if (!read) {
    if (!read.error().cancelled) cure = cureOf(path.toStdString(), progress);
    return read.error();
  }
  auto opened = std::make_shared<OpenRecording>();
  opened->path = path;
  opened->readSeconds = static_cast<double>(clock.elapsed()) / 1000.0;
  opened->findings = std::move(read->findings);
  opened->recording = std::move(read->recording);
  if (progress.cancelled()) return Error{heft::say("Reading was stopped."), true};
  // A pose says where the sensor is without a robot; then the robot is only for looks and may be missing.
  if (opened->recording.meta.robot) {
    auto robot = robotFor(opened->recording.meta, opened->findings);
    if (robot) {
      opened->robot = std::make_shared<const RobotModel>(std::move(robot).value());
      opened->look = std::make_shared<const RobotLook>(loadLook(*opened->robot, opened->findings, progress));
    } else if (opened->recording.hasJoints() && !opened->recording.hasOrientation()) {
      cure = ReadCure::rig;
      return robot.error();
    } else {
      opened->findings.push_back({Severity::warning, "robot_not_loaded", robot.error().message, "", {}});
    }
  }
  if (auto turned = toSensorAxes(opened->recording, opened->robot.get()); !turned) {
    cure = ReadCure::rig;
    return turned.error();
  }
  return std::shared_ptr<const OpenRecording>(std::move(opened));
}

}  // namespace heft
