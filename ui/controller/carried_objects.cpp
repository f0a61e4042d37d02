#include "ui/controller/carried_objects.h"

#include <QFileInfo>

#include "core/estimation/picked_up.h"
#include "ui/controller/open_recording.h"

namespace heft {
namespace {

/// Shape, scale and CAD are those of one body.
EstimateOptions plainOptions(const EstimateOptions& options) {
  EstimateOptions out;
  out.bias = options.bias;
  out.trim = options.trim;
  out.keepTrim = options.keepTrim;
  out.motion = options.motion;
  out.conventions = options.conventions;
  return out;
}

Result<CarriedObject> carriedIn(const Snapshot& now, const QString& without, const Progress& progress) {
  const auto recording = now.recording();
  const EstimateOptions options = plainOptions(now.options);
  const JointInput with{recording.get(), now.robot()};
  if (without.isEmpty()) return estimatePickedUp(with, options, now.opened->findings, progress);
  ReadCure cure = ReadCure::none;
  const auto other = loadRecording(without, progress, cure);
  if (!other) return other.error();
  return estimateCarriedObject(with, {&(*other)->recording, (*other)->robot.get()}, options,
                               {now.opened->findings, (*other)->findings}, progress);
}

}  // namespace

CarriedObjects::CarriedObjects(QObject* workspace)
    : QObject(workspace), workspace_(dynamic_cast<Workspace&>(*workspace)) {
  connect(&workspace_, &Workspace::openedChanged, this, &CarriedObjects::refresh);
  connect(&workspace_, &Workspace::reportChanged, this, &CarriedObjects::refresh);
}

Result<bool> CarriedObjects::findMinus(const QString& without) {
  const auto opened = workspace_.opened();
  if (opened && QFileInfo(opened->path) == QFileInfo(without))
    return Error{tr("This is the recording with the object itself. Choose one without it.").toStdString()};
  return ask(QFileInfo(without).absoluteFilePath());
}

Result<bool> CarriedObjects::ask(const QString& without) {
  if (!workspace_.opened()) return Error{tr("Open the recording with the object first.").toStdString()};
  asked_ = true;
  without_ = without;
  start();
  return true;
}

void CarriedObjects::start() {
  const Snapshot now = workspace_.snapshot();
  of_ = now.opened;
  report_ = workspace_.report();
  object_.reset();
  failure_.clear();
  jobs_.cancel();
  jobs_.start(
      tr("Estimating what is carried"),
      [now, without = without_](const Progress& progress) { return carriedIn(now, without, progress); },
      [this](Result<CarriedObject> result) {
        if (result)
          object_ = std::make_shared<const CarriedObject>(std::move(result).value());
        else if (result.error().cancelled)
          asked_ = false;
        else
          failure_ = QString::fromStdString(result.error().message);
        emit changed();
      });
  emit changed();
}

void CarriedObjects::forget() {
  jobs_.cancel();
  asked_ = false;
  object_.reset();
  failure_.clear();
  emit changed();
}

void CarriedObjects::refresh() {
  if (!asked_) return;
  if (workspace_.opened() != of_.lock()) return forget();
  // Other marks, other settings, or the same said in another language.
  const auto report = workspace_.report();
  if (report && report != report_) start();
}

}  // namespace heft
