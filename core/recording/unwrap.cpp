#include "core/recording/unwrap.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/parallel.h"
#include "core/base/say.h"

namespace heft {

namespace {

constexpr double kTurnsPerSecond = 1.0;  ///< Arms are slower than this.
constexpr double kLeastSlack = 0.05;     ///< [turns]
constexpr double kMostSlack = 0.25;      ///< [turns] Across a gap an arm may really have moved far.

}  // namespace

double Unwrapper::next(double angle, double step) {
  if (!std::isfinite(angle)) return angle;
  if (any_) {
    const double turns = (angle - last_) / turn_;
    const double whole = std::round(turns);
    const double slack = std::clamp(kTurnsPerSecond * std::abs(step), kLeastSlack, kMostSlack);
    if (whole != 0.0 && std::abs(turns - whole) < slack) {
      offset_ -= whole * turn_;
      jumped_ = true;
    }
  }
  any_ = true;
  last_ = angle;
  return angle + offset_;
}

std::vector<int> unwrapJoints(const VectorXd& time, MatrixXd& q) {
  constexpr double kWholeTurn = 2.0 * std::numbers::pi;
  std::vector<char> jumped(static_cast<std::size_t>(q.cols()), 0);
  parallelFor(jumped.size(), [&](std::size_t joint) {
    const auto j = static_cast<Eigen::Index>(joint);
    Unwrapper angle(kWholeTurn);
    for (Eigen::Index k = 0; k < q.rows(); ++k) q(k, j) = angle.next(q(k, j), k > 0 ? time(k) - time(k - 1) : 0.0);
    if (!angle.jumped()) return;
    jumped[joint] = 1;
    const double middle = 0.5 * (q.col(j).maxCoeff() + q.col(j).minCoeff());
    q.col(j).array() -= kWholeTurn * std::round(middle / kWholeTurn);
  });
  std::vector<int> joints;
  for (std::size_t j = 0; j < jumped.size(); ++j)
    if (jumped[j] != 0) joints.push_back(static_cast<int>(j));
  return joints;
}

std::string unwrapped(const std::vector<int>& joints) {
  std::string names;
  for (std::size_t i = 0; i < joints.size(); ++i)
    names += (i == 0 ? "" : i + 1 == joints.size() ? heft::say(" and ") : ", ") + fmt::format("q{}", joints[i] + 1);
  return heft::say("Angles that wrap around: whole turns were removed from {}.", names);
}

}  // namespace heft
