#include "core/motion/inertial_witness.h"

#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/base/say.h"
#include "core/math/degrees.h"

namespace heft {

namespace {

constexpr double kDisagrees = 0.3;    ///< [m/s2] As much as 1.8 degrees of gravity.
constexpr double kClearlyLess = 0.8;  ///< Of the squares that are left, from which on signs are turned.
constexpr double kShareMissed = 0.5;  ///< Of the accelerations beside gravity that it may feel otherwise.

std::string turnOf(const AccelerometerMount& mount) {
  const Vector3d rpy = rpyFromRotation(mount.R_SI) / kRadPerDegree;
  return fmt::format("{:.1f}, {:.1f}, {:.1f}", rpy.x(), rpy.y(), rpy.z());
}

void note(Severity severity, const char* code, std::string text, std::string remedy, Motion& motion) {
  motion.findings.push_back({severity, code, std::move(text), std::move(remedy), {}});
}

/// Readings that point the other way: some drivers give gravity, less the acceleration, in place of what is felt. No
/// rotation does the same, unless gravity turns in one plane of the sensor alone, where the sign does not matter.
bool pointsTheOtherWay(const std::optional<AccelerometerMount>& asRead,
                       const std::optional<AccelerometerMount>& turned) {
  if (!asRead || !turned) return turned.has_value();
  return turned->rms * turned->rms < kClearlyLess * asRead->rms * asRead->rms;
}

/// The specific force that is not gravity, per axis.
double beyondGravity(const Motion& motion) {
  double squares = 0.0;
  const double g = motion.specificForce.colwise().norm().mean();
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    const double more = motion.specificForce.col(k).norm() - g;
    squares += more * more;
  }
  return std::sqrt(squares / static_cast<double>(motion.size()));
}

}  // namespace

void hearAccelerometer(const Eigen::Matrix3Xd& given, const Eigen::Matrix3Xd& rates, Motion& motion) {
  const bool ask = !motion.originAccelerationKnown && motion.wrench.cols() == motion.size();
  const Eigen::Matrix3Xd force = ask ? Eigen::Matrix3Xd(motion.wrench.topRows<3>()) : Eigen::Matrix3Xd(3, 0);
  const auto mountFor = [&](const Eigen::Matrix3Xd& y) {
    return mountOf({y, motion.specificForce, motion.omega, motion.alpha, rates, force}, motion.originAccelerationKnown);
  };
  auto mount = mountFor(given);
  Eigen::Matrix3Xd readings = given;
  if (const auto turned = mountFor(-given); pointsTheOtherWay(mount, turned)) {
    mount = turned;
    readings = -given;
    note(Severity::info, "accelerometer_gravity",
         heft::say("The accelerometer reports gravity instead of specific force (at rest it points down); its signs "
                   "were inverted."),
         {}, motion);
  }
  if (!mount) {
    note(Severity::info, "accelerometer_unused",
         heft::say("The accelerometer was not used: its readings do not follow how gravity turns in the sensor."),
         heft::say("Is it on the tool side of the sensor, and does it read specific force, gravity included?"), motion);
    return;
  }
  if (!motion.originAccelerationKnown) {
    motion.specificForce = mount->specificForce(readings);
    motion.originAccelerationKnown = true;
    motion.accelerometer = mount;
    note(Severity::info, "accelerometer_used",
         heft::say("The sensor's acceleration was taken from the accelerometer, which is turned by {} degrees (roll, "
                   "pitch, yaw) against the sensor, as the data show.",
                   turnOf(*mount)),
         {}, motion);
    return;
  }
  const double size = beyondGravity(motion);
  if (mount->rms < std::max(kDisagrees, kShareMissed * size))
    note(Severity::info, "accelerometer_agrees",
         heft::say(
             "The accelerometer agrees with the motion to {:.2g} m/s2 rms; it is turned by {} degrees (roll, pitch, "
             "yaw) against the sensor and stands at {:.0f}, {:.0f}, {:.0f} mm.",
             mount->rms, turnOf(*mount), 1e3 * mount->p_SoI_S.x(), 1e3 * mount->p_SoI_S.y(), 1e3 * mount->p_SoI_S.z()),
         {}, motion);
  else
    note(Severity::warning, "accelerometer_disagrees",
         heft::say("The accelerometer differs from the motion by {:.2g} m/s2 rms, wherever it is mounted: the tool "
                   "accelerated differently from what the joints or poses say.",
                   mount->rms),
         heft::say("Check the direction of gravity, the clocks, and whether something between arm and tool is loose."),
         motion);
}

}  // namespace heft
