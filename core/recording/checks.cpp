#include <fmt/format.h>

#include "core/recording/checks.h"

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/recording/plain_form.h"

namespace heft {

namespace {

/// Calls `act` with every series that has rows.
template <class Act>
void forEachSeries(Recording& recording, Act act) {
  if (recording.time.rows() > 0) act(recording.time);
  if (recording.q.rows() > 0) act(recording.q);
  if (recording.dq.rows() > 0) act(recording.dq);
  if (recording.position.rows() > 0) act(recording.position);
  if (recording.quaternion.rows() > 0) act(recording.quaternion);
  if (recording.twist.rows() > 0) act(recording.twist);
  if (recording.accelerometer.rows() > 0) act(recording.accelerometer);
  if (recording.gyroscope.rows() > 0) act(recording.gyroscope);
  if (recording.wrench.rows() > 0) act(recording.wrench);
}

}  // namespace

std::string percent(double share) {
  return share >= 0.1 ? fmt::format("{:.0f} %", 100.0 * share) : fmt::format("{:.2g} %", 100.0 * share);
}

std::optional<Error> assumeRobot(const Examined& examined, long header) {
  auto& meta = examined.recording.meta;
  if (!examined.map.hasJoints() || meta.robot) return std::nullopt;
  const auto joints = examined.map.joints.size();
  if (joints == 7) {
    meta.robot = "panda";
    examined.note(
        examined.map.hasOrientation() ? Severity::info : Severity::warning, "robot_assumed", examined.column(0),
        heft::say(
            "No robot is named; with seven joints it is taken to be a Franka Panda, with the sensor at its flange."),
        remedy(Remedy::nameRobot));
    return std::nullopt;
  }
  if (examined.map.hasOrientation()) return std::nullopt;
  return errorAt({examined.file, header, examined.table ? examined.map.joints[0] : 0},
                 heft::say("there are {} joints but no robot is named.", joints), remedy(Remedy::nameRobot));
}

namespace {

void checkMarks(const Examined& examined) {
  const Recording& recording = examined.recording;
  if (recording.meta.kind == RecordingKind::poses) return;
  const double from = recording.time(0);
  const double to = recording.time(recording.rows() - 1);
  for (const auto& mark : recording.meta.marks)
    if (mark.to < from || mark.from > to)
      examined.note(Severity::warning, "mark_outside", examined.column(0),
                    heft::say("The mark \"{}\" from {} to {} s lies outside the recording, which runs from {} to {} s.",
                              toString(mark.label), mark.from, mark.to, from, to),
                    heft::say("Marks are on the clock of the column time."));
}

void undoTwist(const Examined& examined, const PlainForm& plain) {
  auto& twist = examined.recording.twist;
  if (twist.rows() == 0) return;
  if (!plain.twistIsLost()) return plain.undoTwist(twist);
  twist.resize(0, 6);
  examined.note(Severity::info, "columns_set_aside", examined.column(examined.map.twist[0]),
                heft::say("vx, vy, vz, wx, wy, wz are not used: the pose is the base's in the sensor, and the "
                          "reference point and axes of the velocities are not stated."));
}

}  // namespace

std::optional<Error> checkAll(const Examined& examined, NumberForm form) {
  if (auto failure = checkTime(examined)) return failure;
  auto& recording = examined.recording;
  const PlainForm plain(recording.meta);
  const bool undo = form == NumberForm::asStated;
  if (undo) {
    plain.undoWrench(recording.wrench);
    plain.undoAngles(recording.q);
    plain.undoAngles(recording.dq);
    plain.undoQuaternionOrder(recording.quaternion);
    undoTwist(examined, plain);
    plain.undoAcceleration(recording.accelerometer);
    plain.undoAngles(recording.gyroscope);
  }
  recording.wrenchNeedsPose = recording.meta.conventions.needPose();
  if (auto failure = checkQuaternions(examined)) return failure;
  if (undo) {
    plain.undoDirection(recording.quaternion);
    plain.undoPosition(recording.position, recording.quaternion);
  }
  if (auto failure = checkAngles(examined)) return failure;
  if (auto failure = checkUnits(examined)) return failure;
  checkSignals(examined);
  checkMarks(examined);
  return std::nullopt;
}

void truncateRows(Recording& recording, std::vector<std::uint32_t>& lines, Eigen::Index rows) {
  forEachSeries(recording, [&](auto& series) {
    if (series.rows() != rows) series.conservativeResize(rows, series.cols());
  });
  const auto count = static_cast<std::size_t>(rows);
  if (!recording.labels.empty()) recording.labels.resize(count);
  for (auto& extra : recording.extra) extra.cells.resize(count);
  lines.resize(count);
}

void keepRows(Recording& recording, std::vector<std::uint32_t>& lines, const std::vector<char>& keep) {
  std::vector<std::size_t> kept;
  for (std::size_t k = 0; k < keep.size(); ++k)
    if (keep[k] != 0) kept.push_back(k);
  const auto compact = [&](auto& list) {
    for (std::size_t k = 0; k < kept.size(); ++k)
      if (kept[k] != k) list[k] = std::move(list[kept[k]]);
  };
  forEachSeries(recording, [&](auto& series) {
    for (Eigen::Index c = 0; c < series.cols(); ++c)
      for (std::size_t k = 0; k < kept.size(); ++k)
        series(static_cast<Eigen::Index>(k), c) = series(static_cast<Eigen::Index>(kept[k]), c);
  });
  if (!recording.labels.empty()) compact(recording.labels);
  for (auto& extra : recording.extra) compact(extra.cells);
  compact(lines);
  truncateRows(recording, lines, static_cast<Eigen::Index>(kept.size()));
}

}  // namespace heft
