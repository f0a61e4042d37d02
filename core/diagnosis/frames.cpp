#include "core/diagnosis/frames.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"

namespace heft::diagnosis {

using conventions::Change;

namespace {

/// Mirrored readings are a sign and a turn. Columns that are swapped are so exactly: each axis as the one that it is
/// nearest to, or `turn` itself where it is far from all.
Matrix3d alongAxes(const Matrix3d& turn) {
  constexpr double kNear = 15.0 * std::numbers::pi / 180.0;  // What is smaller is a cause
  Matrix3d out = Matrix3d::Zero();
  for (Eigen::Index i = 0; i < 3; ++i) {
    Eigen::Index axis = 0;
    turn.row(i).cwiseAbs().maxCoeff(&axis);
    out(i, axis) = turn(i, axis) < 0.0 ? -1.0 : 1.0;
  }
  return (turn - out).norm() < std::sqrt(2.0) * kNear ? out : turn;
}

/// Orientations the other way round beside positions as they should be, as of a matrix whose rows were taken for
/// columns: whether these fit, and clearly better than what `report` has.
bool keepsPositions(const Recording& recording, const Motion& motion, const conventions::Report& report) {
  conventions::Reading inverted = report.stated;
  using Pose = Conventions::PoseDirection;
  Pose& pose = inverted.conventions.pose;
  pose = pose == Pose::sensorInBase ? Pose::baseInSensor : Pose::sensorInBase;
  const Motion turned = conventions::readSo(motion, report.stated, inverted, true);
  Motion other = motion;
  other.R_BS = turned.R_BS;
  other.omega = turned.omega;
  other.alpha = turned.alpha;
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    other.specificForce.col(k) = other.R_BS[i].transpose() * (motion.R_BS[i] * motion.specificForce.col(k));
  }
  const auto kept = conventions::check(conventions::questionOf(recording, other));
  return kept.verdict == conventions::Verdict::asStated && kept.misfit.worst() < kMajority * report.misfit.worst();
}

}  // namespace

bool FrameMistake::has(Change change) const { return std::ranges::find(changes, change) != changes.end(); }

std::string FrameMistake::sentence() const {
  if (positionsKept && only(Change::poseInverted))
    return heft::say("Orientations are stored inverted: base in sensor instead of sensor in base.");
  return conventions::sentence(stated, reading);
}

std::string FrameMistake::check() const { return conventions::whatToCheck(stated, reading); }

std::optional<FrameMistake> frameMistake(const Recording& recording, const Motion& motion,
                                         const conventions::Report& report) {
  using Told = conventions::Verdict;
  FrameMistake kept;
  kept.stated = kept.reading = report.stated;
  const bool poses = recording.hasOrientation() && recording.hasPosition() &&
                     recording.meta.kind == RecordingKind::motion && report.stated.conventions == Conventions{};
  const bool described = report.verdict == Told::asStated && report.misfit.worst() < kMinorShare;
  if (poses && report.enough && !described && keepsPositions(recording, motion, report)) {
    kept.reading.conventions.pose = Conventions::PoseDirection::baseInSensor;
    kept.changes = {Change::poseInverted};
    kept.positionsKept = true;
    kept.evidence = report.overStated;
    return kept;
  }
  if ((report.verdict != Told::suggested && report.verdict != Told::ambiguous) || !report.suggested)
    return std::nullopt;
  FrameMistake out;
  out.stated = report.stated;
  out.reading = *report.suggested;
  out.tied = report.verdict == Told::ambiguous;
  out.evidence = report.overStated;
  out.ties = report.ties;
  out.decides = report.decides;
  out.changes = conventions::changes(out.stated, out.reading);
  if (out.has(Change::mirrored) && out.has(Change::wrenchSign) && out.reading.conventions.mirroredAxis &&
      !out.stated.conventions.mirroredAxis) {
    // One axis mirrored and the other sign are a sensor that is mounted turned by half: one thing, not two.
    const Vector3d axis = Vector3d::Unit(*std::exchange(out.reading.conventions.mirroredAxis, std::nullopt));
    out.reading.sign = out.stated.sign;
    out.reading.turn = Matrix3d(2.0 * axis * axis.transpose() - Matrix3d::Identity()) * out.reading.turn;
    out.changes = conventions::changes(out.stated, out.reading);
  }
  if (out.changes.empty()) return std::nullopt;
  if (out.has(Change::turned) && out.has(Change::wrenchSign))
    out.reading.turn = alongAxes(out.turn()) * out.stated.turn;
  return out;
}

void refineTurn(FrameMistake& mistake, const Signals& right, const std::vector<Stretch>& stretches) {
  constexpr int kRounds = 3;
  if (stretches.empty()) return;
  const auto form = std::make_shared<const Form>(findCause("sensor_rotation")->forms(right).front());
  Signals signals = right;
  for (int round = 0; round < kRounds; ++round) {
    Model model;
    model.terms.push_back({form, VectorXd::Zero(3), {}});
    const Fit fit = fitModel(signals, stretches, std::move(model));
    const Vector3d more = fit.model.terms.front().v;
    const Matrix3d turn = rotationFromVector(more);
    mistake.reading.turn = turn * mistake.reading.turn;
    mistake.turnStd = fit.std().segment<3>(kLinear);
    signals.readings.topRows<3>() = (turn * signals.readings.topRows<3>()).eval();
    signals.readings.bottomRows<3>() = (turn * signals.readings.bottomRows<3>()).eval();
    signals.measured = averaged(signals, signals.readings);
  }
}

}  // namespace heft::diagnosis
