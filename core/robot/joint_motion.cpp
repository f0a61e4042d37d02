#include "core/robot/joint_motion.h"

#include <algorithm>

namespace heft {

void JointMotion::at(double t, VectorXd& position, VectorXd& velocity, VectorXd& acceleration) const {
  const double* begin = time.data();
  const auto next = std::clamp<Eigen::Index>(std::upper_bound(begin, begin + size(), t) - begin, 1, size() - 1);
  const Eigen::Index k = next - 1;
  const double h = time(next) - time(k);
  const double u = std::clamp((t - time(k)) / h, 0.0, 1.0);
  const double u2 = u * u, u3 = u2 * u, u4 = u3 * u, u5 = u4 * u;
  // Quintic Hermite basis and its derivatives in u.
  const double b[6] = {1 - 10 * u3 + 15 * u4 - 6 * u5, u - 6 * u3 + 8 * u4 - 3 * u5, 0.5 * (u2 - 3 * u3 + 3 * u4 - u5),
                       0.5 * (u3 - 2 * u4 + u5),       -4 * u3 + 7 * u4 - 3 * u5,    10 * u3 - 15 * u4 + 6 * u5};
  const double d[6] = {
      -30 * u2 + 60 * u3 - 30 * u4,     1 - 18 * u2 + 32 * u3 - 15 * u4, 0.5 * (2 * u - 9 * u2 + 12 * u3 - 5 * u4),
      0.5 * (3 * u2 - 8 * u3 + 5 * u4), -12 * u2 + 28 * u3 - 15 * u4,    30 * u2 - 60 * u3 + 30 * u4};
  const double s[6] = {
      -60 * u + 180 * u2 - 120 * u3,     -36 * u + 96 * u2 - 60 * u3, 0.5 * (2 - 18 * u + 36 * u2 - 20 * u3),
      0.5 * (6 * u - 24 * u2 + 20 * u3), -24 * u + 84 * u2 - 60 * u3, 60 * u - 180 * u2 + 120 * u3};
  const auto mix = [&](const double* w) {
    return VectorXd((w[0] * q.row(k) + h * w[1] * dq.row(k) + h * h * w[2] * ddq.row(k) + h * h * w[3] * ddq.row(next) +
                     h * w[4] * dq.row(next) + w[5] * q.row(next))
                        .transpose());
  };
  position = mix(b);
  velocity = mix(d) / h;
  acceleration = mix(s) / (h * h);
}

JointMotion JointMotion::slower(double factor) const {
  return {time * factor, q, dq / factor, ddq / (factor * factor)};
}

JointMotion straightMotion(const VectorXd& from, const VectorXd& to, double seconds) {
  JointMotion motion;
  motion.time = Eigen::Vector2d(0.0, seconds);
  motion.q.resize(2, from.size());
  motion.q << from.transpose(), to.transpose();
  motion.dq = motion.ddq = MatrixXd::Zero(2, from.size());
  return motion;
}

}  // namespace heft
