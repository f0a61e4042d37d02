#include "core/import/delay.h"

#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/motion/accelerometer.h"

namespace heft {

namespace {

constexpr double kLittleExplained = 0.5;  ///< Share of the force's variance
constexpr double kReach = 0.5;            ///< [s] Delays on a common clock that one expects.
constexpr double kWideReach = 10.0;       ///< [s] Delays on a common clock are looked for up to this.
constexpr double kLongestReach = 600.0;   ///< [s] Offsets between unrelated clocks are looked for up to this.

OffsetEstimate offsetWithin(const Motion& moved, const Conventions& conventions, const Signal& wrench, double from,
                            double to) {
  return findOffset(inWrenchAxes(moved, conventions), moved.startTime, moved.rateHz, wrench.time,
                    wrench.values.leftCols<3>(), from, to);
}

std::string figuresOf(const OffsetEstimate& offset) {
  return heft::say("{:.3f} s (+- {:.3f} s; the motion then explains {:.0f} % of the force)", offset.seconds,
                   2.0 * offset.std, 100.0 * offset.explained);
}

}  // namespace

std::optional<Motion> specificForceOf(const Signal& joints, const Signal& quaternion, const RecordingMeta& meta,
                                      const std::string& file) {
  Recording alone;
  alone.file = file;
  alone.meta = meta;
  if (!joints.empty() && !alone.meta.robot && joints.values.cols() == 7) alone.meta.robot = "panda";
  const Signal& from = joints.empty() ? quaternion : joints;
  alone.time = from.time;
  alone.wrench.setZero(from.time.size(), 6);
  Findings aside;
  std::optional<RobotModel> robot;
  if (!joints.empty()) {
    if (!alone.meta.robot) return std::nullopt;
    auto made = robotFor(alone.meta, aside);
    if (!made || made->dof() != joints.values.cols()) return std::nullopt;
    robot = std::move(*made);
    alone.q = joints.values;
  } else {
    alone.quaternion = quaternion.values;
    for (Eigen::Index k = 0; k < alone.quaternion.rows(); ++k) {
      const double norm = alone.quaternion.row(k).norm();
      if (norm < 0.5) return std::nullopt;
      alone.quaternion.row(k) /= norm;
    }
  }
  MotionOptions options;
  options.cutoffHz = 5.0;
  options.outputRateHz = 100.0;
  auto motion = motionOf(alone, robot ? &*robot : nullptr, options);
  if (!motion || motion->size() < 50 || !motion->specificForce.allFinite()) return std::nullopt;
  return std::move(*motion);
}

MatrixXd inWrenchAxes(const Motion& motion, const Conventions& conventions) {
  const bool base = conventions.wrenchAxes == Conventions::WrenchAxes::base;
  MatrixXd out(12, motion.size());
  for (Eigen::Index k = 0; k < out.cols(); ++k) {
    const Matrix3d axes = base ? motion.R_BS[static_cast<std::size_t>(k)] : Matrix3d::Identity();
    out.col(k).head<3>() = axes * motion.specificForce.col(k);
    out.col(k).tail<9>() = (axes * leverMatrix(motion.omega.col(k), motion.alpha.col(k))).reshaped();
  }
  return out;
}

void tellDelay(const Motion& moved, const Conventions& conventions, const Signal& motion, const Signal& wrench,
               Joining& joining) {
  const auto offset = offsetWithin(moved, conventions, wrench, -kReach, kReach);
  if (!offset.sure && offset.explained < kLittleExplained) {
    // The best delay inside explains little: it may be longer than any that one expects on a common clock.
    const auto wide = offsetWithin(moved, conventions, wrench, -kWideReach, kWideReach);
    if (wide.sure && std::abs(wide.seconds) > kReach) {
      joining.note(
          Severity::warning, "time_offset_estimated",
          heft::say("The force of {} does not follow the motion of {} within half a second, but does when shifted by "
                    "{:.3f} s (+- {:.3f} s; the motion then explains {:.0f} % of the force); nothing was shifted.",
                    joining.nameOf(wrench.stream), joining.nameOf(motion.stream), wide.seconds, 2.0 * wide.std,
                    100.0 * wide.explained),
          heft::say("The recorder lagged, or one clock is wrong.") + " " +
              joining.howToShift(wrench.stream, wide.seconds));
      return;
    }
  }
  if (!offset.sure) return;
  joining.note(std::abs(offset.seconds) > std::max(0.02, 4.0 * offset.std) ? Severity::warning : Severity::info,
               "time_offset_estimated",
               heft::say("On their common clock the force of {} follows the motion of {} best when shifted by {}; "
                         "nothing was shifted.",
                         joining.nameOf(wrench.stream), joining.nameOf(motion.stream), figuresOf(offset)),
               joining.howToShift(wrench.stream, offset.seconds));
}

Result<OffsetEstimate> findClockOffset(const std::optional<Motion>& moved, const Conventions& conventions,
                                       const Signal& motion, const Signal& wrench, double zeros, Joining& joining) {
  const double begin = motion.time(0), end = motion.time(motion.time.size() - 1);
  const double first = wrench.time(0), last = wrench.time(wrench.time.size() - 1);
  OffsetEstimate offset;
  if (moved)
    offset = offsetWithin(*moved, conventions, wrench, std::max(begin - last, begin - first - kLongestReach),
                          std::min(end - first, begin - first + kLongestReach));
  if (!offset.sure)
    return errorAt(
        {joining.file, 0, 0},
        heft::say("the clocks of {} and {} have nothing in common, and the data do not show the offset between them.",
                  joining.nameOf(motion.stream), joining.nameOf(wrench.stream)),
        joining.howToShift(wrench.stream, 0.0));
  joining.note(
      Severity::warning, "clock_offset",
      heft::say("{} and {} are on different clocks: the wrench was shifted by {}.", joining.nameOf(motion.stream),
                joining.nameOf(wrench.stream), figuresOf(offset)),
      heft::say("Found by matching the force to the motion; this also removes any delay of the sensor itself.") + " " +
          joining.howToShift(wrench.stream, zeros + offset.seconds));
  return offset;
}

}  // namespace heft
