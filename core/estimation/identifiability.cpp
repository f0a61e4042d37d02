#include "core/estimation/identifiability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/estimation/uncertainty.h"

namespace heft {

namespace {
constexpr double kIdentified = 0.30;  // largest relative standard deviation of an identified number
constexpr const char* kAxes[] = {"x", "y", "z"};
}  // namespace

std::string_view toString(Source source) {
  switch (source) {
    case Source::data:
      return "data";
    case Source::prior:
      return "prior";
    case Source::none:
      return "none";
  }
  return "none";
}

double scaledCondition(const Triangle& R) {
  const MatrixXd block = R.block<11, 10>(kBiasColumns, kBiasColumns);
  const VectorXd lengths = block.colwise().norm();
  if (lengths.minCoeff() <= 0.0) return std::numeric_limits<double>::infinity();
  const VectorXd values = Eigen::JacobiSVD<MatrixXd>(block * lengths.cwiseInverse().asDiagonal()).singularValues();
  return values(9) > 0.0 ? values(0) / values(9) : std::numeric_limits<double>::infinity();
}

Identifiability assess(const Triangle& R, const MapPrior& prior, const MapSolution& solution, const Payload& std,
                       bool userPrior) {
  Identifiability out;
  out.conditionNumber = scaledCondition(R);
  const Matrix10d J = componentsJacobian(solution.phi) * parametersJacobian(prior, solution.v);
  const Vector10d posterior = (J * solution.covariance * J.transpose()).diagonal();
  const Vector10d before = (J * prior.information.inverse() * J.transpose()).diagonal();
  const Payload payload = fromParameters(solution.phi);
  const Vector10d deviation = componentsOf(std);
  const double size = std::sqrt(std::max(0.0, payload.inertiaCom.trace() / (2.0 * payload.mass)));

  const auto share = [&](int i) { return std::clamp(1.0 - posterior(i) / before(i), 0.0, 1.0); };
  const auto source = [&](int i, double scale) {
    if (userPrior) return share(i) > 0.5 ? Source::data : Source::prior;
    return deviation(i) < kIdentified * scale ? Source::data : Source::none;
  };
  out.mass = source(0, payload.mass);
  out.massShare = share(0);
  for (int i = 0; i < 3; ++i) {
    out.com[static_cast<std::size_t>(i)] = source(1 + i, size);
    out.comShare += share(1 + i) / 3.0;
  }
  static constexpr int kPlace[3][3] = {{4, 5, 6}, {5, 7, 8}, {6, 8, 9}};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double scale = std::sqrt(payload.inertiaCom(r, r) * payload.inertiaCom(c, c));
      out.inertia[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = source(kPlace[r][c], scale);
      if (r == c) out.inertiaShare += share(kPlace[r][c]) / 3.0;
    }
  return out;
}

std::vector<std::string> weakDirections(const Identifiability& identifiability, const Motion& motion) {
  std::vector<std::string> words;
  const double degrees = 180.0 / std::numbers::pi;
  // Gravity's directions in S: their mean length is 1 if the tool was never tilted.
  Vector3d mean = Vector3d::Zero();
  for (Eigen::Index k = 0; k < motion.size(); ++k) mean += motion.specificForce.col(k).normalized();
  mean /= std::max<double>(1.0, static_cast<double>(motion.size()));
  const double spread = std::acos(std::clamp(mean.norm(), 0.0, 1.0)) * degrees;
  const bool comWeak =
      std::any_of(identifiability.com.begin(), identifiability.com.end(), [](Source s) { return s != Source::data; });
  if (identifiability.mass != Source::data)
    words.push_back(
        fmt::format("The tool kept nearly the same tilt (about {:.0f} degrees of change), so its weight cannot be "
                    "told from the sensor's bias.",
                    spread));
  if (comWeak) {
    std::string axes;
    for (std::size_t i = 0; i < 3; ++i)
      if (identifiability.com[i] != Source::data) axes += (axes.empty() ? "" : ", ") + std::string(kAxes[i]);
    words.push_back(fmt::format(
        "The tool was not tilted into enough directions to tell where its centre of mass lies along {}.", axes));
  }
  for (int i = 0; i < 3; ++i) {
    if (identifiability.inertia[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)] == Source::data) continue;
    const double alpha =
        std::sqrt(motion.alpha.row(i).squaredNorm() / std::max<double>(1.0, static_cast<double>(motion.size())));
    words.push_back(fmt::format(
        "Rotation about the sensor's {} axis was never fast enough (it sped up by {:.1f} rad/s2 on average): "
        "turn the tool to and fro about it.",
        kAxes[i], alpha));
  }
  return words;
}

}  // namespace heft
