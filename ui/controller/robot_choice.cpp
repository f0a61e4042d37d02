#include "ui/controller/robot_choice.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/import/mapping.h"
#include "core/motion/motion.h"
#include "core/recording/csv_reader.h"
#include "core/recording/meta_file.h"

namespace heft {
namespace {

using nlohmann::json;

struct RobotChoice {
  Q_DECLARE_TR_FUNCTIONS(RobotChoice)
};

json triple(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

json changesBetween(const RecordingMeta& before, const RecordingMeta& after) {
  json out = metaPatch(before.conventions, after.conventions);
  if (before.robot != after.robot) out["robot"] = after.robot ? json(*after.robot) : json(nullptr);
  if (before.kind != after.kind) out["kind"] = after.kind == RecordingKind::poses ? "poses" : "motion";
  if (before.gravity != after.gravity) out["gravity_m_s2"] = triple(after.gravity);
  if (before.wrenchSign != after.wrenchSign)
    out["sensor"]["wrench_sign"] =
        after.wrenchSign == WrenchSign::payloadOnSensor ? "payload_on_sensor" : "sensor_on_payload";
  if (before.sensorModel != after.sensorModel) out["sensor"]["model"] = after.sensorModel;
  if (before.mount.parent != after.mount.parent || before.mount.xyz != after.mount.xyz ||
      before.mount.rpy != after.mount.rpy)
    out["sensor"]["mount"] = {
        {"parent", after.mount.parent}, {"xyz_m", triple(after.mount.xyz)}, {"rpy_rad", triple(after.mount.rpy)}};
  return out;
}

/// Conventions that change are no longer stated in the map file beside the recording, which would count more.
std::optional<Error> leaveToMeta(const QString& recording, const Conventions& before, const Conventions& after) {
  const std::filesystem::path file = mapFileOf(recording.toStdString());
  if (before == after || !std::filesystem::exists(file)) return std::nullopt;
  auto wishes = readMapFile(file);
  if (!wishes) return wishes.error();
  const json patch = metaPatch(before, after);
  bool stated = false;
  for (const bool inSensor : {true, false})
    for (const auto& key : conventionKeys(inSensor))
      if (inSensor ? patch.value("sensor", json::object()).contains(key) : patch.contains(key))
        stated = wishes->conventions.keys.erase(key) > 0 || stated;
  if (!stated) return std::nullopt;
  const auto written = writeTextFile(file, mapText(*wishes, file.parent_path()));
  return written ? std::nullopt : std::optional<Error>(written.error());
}

}  // namespace

QString metaFileBeside(const QString& recording) {
  return QString::fromStdString(metaFileOf(std::filesystem::path(recording.toStdString())).string());
}

Result<RecordingMeta> rigOf(const QString& recording, const OpenRecording* opened) {
  if (opened) return opened->recording.meta;
  const std::filesystem::path file = metaFileBeside(recording).toStdString();
  if (!std::filesystem::exists(file)) return RecordingMeta{};
  Findings findings;
  return readMeta(file, findings);
}

Result<bool> writeRig(const QString& recording, const OpenRecording* opened, const RecordingMeta& before,
                      const RecordingMeta& after) {
  const QString meta = metaFileBeside(recording);
  if (after.robot) {
    Findings findings;
    const auto robot = robotFor(after, findings);
    if (!robot) return robot.error();
    const QString name =
        *after.robot == "panda" ? QString("Panda") : QFileInfo(QString::fromStdString(*after.robot)).fileName();
    if (opened && opened->recording.hasJoints() && robot->dof() != opened->recording.q.cols())
      return Error{
          RobotChoice::tr("%1 has %2 joints, the recording %3: choose the description of the robot that was recorded.")
              .arg(name)
              .arg(robot->dof())
              .arg(opened->recording.q.cols())
              .toStdString()};
    if ((!opened || opened->recording.hasJoints()) && !robot->findLink(after.mount.parent))
      return Error{RobotChoice::tr(
                       "%1 has no link “%2”: choose the link that carries the sensor under Tools, “Robot and sensor”.")
                       .arg(name, QString::fromStdString(after.mount.parent))
                       .toStdString()};
  }
  json changes = changesBetween(before, after);
  // What was only assumed is said from now on.
  const std::filesystem::path file = meta.toStdString();
  if (after.robot && !std::filesystem::exists(file)) changes["robot"] = *after.robot;
  if (changes.empty()) return true;
  if (auto failure = leaveToMeta(recording, before.conventions, after.conventions)) return *failure;
  const auto merged = mergedMeta(file, changes);
  if (!merged) return merged.error();
  json out = *merged;
  // A merge patch takes away what is null; "no robot" must be said.
  if (changes.contains("robot") && changes["robot"].is_null()) out["robot"] = nullptr;
  return writeTextFile(file, out.dump(2) + "\n");
}

Result<bool> nameRobot(const OpenRecording& opened, const QString& urdf) {
  RecordingMeta meta = opened.recording.meta;
  meta.robot = QFileInfo(urdf).absoluteFilePath().toStdString();
  return writeRig(opened.path, &opened, opened.recording.meta, meta);
}

}  // namespace heft
