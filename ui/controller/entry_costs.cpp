#include "ui/controller/entry_costs.h"

#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/exporters/controller_file.h"

namespace heft {
EntryCosts::EntryCosts(QObject* workspace) : QObject(workspace), workspace_(dynamic_cast<Workspace&>(*workspace)) {
  for (auto signal :
       {&Workspace::openedChanged, &Workspace::reportChanged, &Workspace::controllerChanged, &Workspace::exportChanged})
    connect(&workspace_, signal, this, &EntryCosts::refresh);
  refresh();
}

std::optional<EntryCosts::Entry> EntryCosts::entry() const {
  const ControllerChoice& choice = workspace_.session().controller;
  if (choice.told.mass) return Entry{choice.told, QString::fromStdString(choice.source), false};
  const auto opened = workspace_.opened();
  if (!opened || !opened->recording.configured || !opened->recording.configured->payload.mass) return std::nullopt;
  const ConfiguredPayload& configured = *opened->recording.configured;
  Entry out{configured.payload, QString::fromStdString(configured.source), true};
  // Where its axes are not known to be those that the sensor is mounted in, the weight alone can be compared.
  if (!opened->recording.meta.mount.parent.ends_with(configured.flange))
    out.payload = {configured.payload.mass, {}, {}};
  return out;
}

Result<bool> EntryCosts::read(const QString& file) {
  const QFileInfo info(file);
  const auto json = readJsonFile(file.toStdString());
  if (!json) return json.error();
  const auto payload = controllerPayloadFromJson(*json, info.fileName().toStdString());
  if (!payload) return payload.error();
  ControllerChoice choice = workspace_.session().controller;
  choice.told = {payload->mass, payload->com, payload->inertiaCom};
  choice.source = info.fileName().toStdString();
  workspace_.setController(choice, tr("the controller’s entry"));
  return true;
}

void EntryCosts::refresh() {
  const auto opened = workspace_.opened();
  const auto report = workspace_.report();
  const auto now = entry();
  const bool possible = opened && report && now && report->trust != Trust::none;
  std::vector<Payload> mounted;
  nlohmann::json asked;
  const ControllerChoice& choice = workspace_.session().controller;
  if (possible) {
    for (const MountedPart& part : workspace_.session().exporting.mounted)
      if (part.present) mounted.push_back(part.payload);
    asked = {*now->payload.mass, choice.collisionForce, choice.collisionTorque, choice.stiffness};
    const PartialPayload& told = now->payload;
    asked.push_back(
        toJson(Payload{*told.mass, told.com.value_or(Vector3d::Zero()), told.inertiaCom.value_or(Matrix3d::Zero())}));
    asked.push_back({told.com.has_value(), told.inertiaCom.has_value()});
    for (const Payload& part : mounted) asked.push_back(toJson(part));
  }
  // Another export format, say, makes no other cost.
  if (of_ == report && asked_ == asked.dump()) return;
  of_ = report;
  asked_ = asked.dump();
  jobs_.cancel();
  cost_.reset();
  failure_.clear();
  if (possible)
    jobs_.start(
        tr("Computing what the entry costs"),
        [opened, report, mounted, told = now->payload,
         limits = ControllerLimits{choice.collisionForce, choice.collisionTorque, choice.stiffness}](const Progress&) {
          return costOfEntry(told, *report, mounted, limits, opened->recording, opened->robot.get());
        },
        [this](Result<EntryCost> result) {
          if (result)
            cost_ = std::make_shared<const EntryCost>(std::move(result).value());
          else if (!result.error().cancelled)
            failure_ = QString::fromStdString(result.error().message);
          emit changed();
        });
  emit changed();
}

}  // namespace heft
