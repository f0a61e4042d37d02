#include "ui/controller/workspace.h"

#include <QElapsedTimer>
#include <QFileInfo>

#include "core/import/import.h"
#include "core/motion/motion.h"

namespace heft {
namespace {

using OpenResult = Result<std::shared_ptr<const OpenRecording>>;

OpenResult openRecording(const QString& path, const Progress& progress) {
  QElapsedTimer clock;
  clock.start();
  auto read = heft::openRecording(std::filesystem::path(path.toStdString()), ImportOptions{}, progress);
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

}  // namespace

Workspace::Workspace(QObject* parent) : QObject(parent) {
  connect(&jobs_, &JobRunner::started, this, &Workspace::busyChanged);
  connect(&jobs_, &JobRunner::finished, this, &Workspace::busyChanged);
}

void Workspace::fail(const Error& error) {
  if (error.cancelled) return;
  lastFailure_ = QString::fromStdString(error.message);
  emit failed(lastFailure_);
}

void Workspace::open(const QString& path) {
  const QString absolute = QFileInfo(path).absoluteFilePath();
  jobs_.start(
      tr("Opening %1").arg(QFileInfo(path).fileName()),
      [absolute](const Progress& progress) { return openRecording(absolute, progress); },
      [this](OpenResult result) {
        if (!result) return fail(result.error());
        opened_ = *result;
        report_.reset();
        emit openedChanged();
        emit reportChanged();
        estimate();
      });
}

void Workspace::estimate() {
  if (!opened_) return;
  lastFailure_.clear();
  jobs_.start(
      tr("Estimating"),
      [snapshot = opened_](const Progress& progress) -> Result<std::shared_ptr<const EstimateReport>> {
        auto result = heft::estimate(snapshot->recording, snapshot->robot.get(), EstimateOptions{}, progress);
        if (!result) return result.error();
        // Findings of reading concern the result as much as those of estimating.
        auto report = std::make_shared<EstimateReport>(std::move(result).value());
        report->timing.read = snapshot->readSeconds;
        report->findings.insert(report->findings.begin(), snapshot->findings.begin(), snapshot->findings.end());
        return std::shared_ptr<const EstimateReport>(std::move(report));
      },
      [this](Result<std::shared_ptr<const EstimateReport>> result) {
        if (!result) return fail(result.error());
        report_ = *result;
        emit reportChanged();
      });
}

void Workspace::cancel() { jobs_.cancel(); }

}  // namespace heft
