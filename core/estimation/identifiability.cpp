#include "core/estimation/identifiability.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/base/say.h"
#include "core/estimation/map.h"
#include "core/estimation/prior.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {
constexpr double kIdentified = 0.30;  // largest relative standard deviation of an identified number
/// How much less certain than the answer the data may be by themselves. Bodies that can exist end somewhere: at such an
/// end, where a body is a rod or a point, the answer looks exact, and no reading made it so.
constexpr double kSharpest = 3.0;
constexpr const char* kAxes[] = {"x", "y", "z"};

/// Three axes that directions are told about, with names a person can find on the tool.
struct NamedAxes {
  Matrix3d R;  ///< Columns, S axes.
  std::array<std::string, 3> names;
};

/// The tool's principal axes where its moments of inertia tell them apart, the sensor's otherwise.
NamedAxes namedAxes(const Payload& payload) {
  constexpr double kDistinct = 1.25;
  const SymmetricEigen eigen = symmetricEigen(payload.inertiaCom);
  const Vector3d moments = eigen.values;
  const bool isLong = moments(1) > kDistinct * moments(0), isFlat = moments(2) > kDistinct * moments(1);
  if (!isLong && !isFlat)
    return {Matrix3d::Identity(),
            {heft::say("the sensor's x axis"), heft::say("the sensor's y axis"), heft::say("the sensor's z axis")}};
  const auto near = [&](int i) {
    Eigen::Index axis = 0;
    eigen.vectors.col(i).cwiseAbs().maxCoeff(&axis);
    return " " + heft::say("(near the sensor's {})", kAxes[axis]);
  };
  const std::string crosswise = heft::say("an axis across the tool"),
                    flat = heft::say("an axis in the plane of the tool's flat side");
  return {eigen.vectors,
          {(isLong ? heft::say("the tool's long axis") : flat) + near(0), (isLong ? crosswise : flat) + near(1),
           (isFlat && !isLong ? heft::say("the axis perpendicular to the tool's flat side") : crosswise) + near(2)}};
}

/// What a small change of the parameters mostly is.
std::string aboutWhat(const Vector10d& components, const Payload& payload, const NamedAxes& axes) {
  const double size = std::sqrt(std::max(1e-12, payload.inertiaCom.trace() / (2.0 * payload.mass)));
  const Matrix3d change = axes.R.transpose() * inertiaTensor(components) * axes.R;
  const Matrix3d inertia = axes.R.transpose() * payload.inertiaCom * axes.R;
  const Vector3d shift = axes.R.transpose() * components.segment<3>(1) / size;
  double largest = std::abs(components(0)) / payload.mass;
  std::string about = heft::say("mass");
  const auto consider = [&](double value, const std::string& words) {
    if (std::abs(value) <= largest) return;
    largest = std::abs(value);
    about = words;
  };
  for (int i = 0; i < 3; ++i)
    consider(shift(i), heft::say("centre of mass along {}", axes.names[static_cast<std::size_t>(i)]));
  for (int r = 0; r < 3; ++r)
    for (int c = r; c < 3; ++c) {
      const std::string& row = axes.names[static_cast<std::size_t>(r)];
      consider(change(r, c) / std::sqrt(inertia(r, r) * inertia(c, c)),
               r == c
                   ? heft::say("rotation about {}", row)
                   : heft::say("coupling of rotations about {} and {}", row, axes.names[static_cast<std::size_t>(c)]));
    }
  return about;
}

std::vector<Identifiability::Direction> directionsOf(const MapPrior& prior, const MapSolution& solution,
                                                     const Matrix10d& componentsByV) {
  const Payload payload = fromParameters(solution.phi);
  const NamedAxes axes = namedAxes(payload);
  const auto [values, vectors] = generalizedEigen(solution.dataInformation, prior.normalInformation(solution.v));
  std::vector<Identifiability::Direction> directions;
  for (int i = 9; i >= 0; --i) {
    const double lambda = std::max(0.0, values(i));
    directions.push_back({lambda / (1.0 + lambda), aboutWhat(componentsByV * vectors.col(i), payload, axes)});
  }
  return directions;
}

}  // namespace

std::string_view toString(Source source) {
  switch (source) {
    case Source::data:
      return "data";
    case Source::prior:
      return "prior";
    case Source::doubted:
    case Source::none:
      return "none";
  }
  return "none";
}

VectorXd scaledSingularValues(const Triangle& R) {
  const MatrixXd block = R.block<11, 10>(kBiasColumns, kBiasColumns);
  const VectorXd lengths = block.colwise().norm();
  if (lengths.minCoeff() <= 0.0) return {};
  return singularValues(block * lengths.cwiseInverse().asDiagonal());
}

namespace {

double conditionOf(const VectorXd& values) {
  return values.size() > 0 && values(9) > 0.0 ? values(0) / values(9) : std::numeric_limits<double>::infinity();
}

}  // namespace

double scaledCondition(const Triangle& R) { return conditionOf(scaledSingularValues(R)); }

Identifiability assess(const Triangle& R, const MapPrior& prior, const MapSolution& solution, const Payload& std,
                       const ToldParts& told) {
  Identifiability out;
  out.singularValues = scaledSingularValues(R);
  out.conditionNumber = conditionOf(out.singularValues);
  const Matrix10d J = product(componentsJacobian(solution.phi), parametersJacobian(prior, solution.v));
  const Vector10d posterior = congruence(J, solution.covariance).diagonal();
  const Vector10d before = congruence(J, inverse(prior.normalInformation(solution.v))).diagonal();
  const Payload payload = fromParameters(solution.phi);
  const Vector10d deviation = componentsOf(std);
  const double size = std::sqrt(std::max(0.0, payload.inertiaCom.trace() / (2.0 * payload.mass)));

  const auto share = [&](int i) { return std::clamp(1.0 - posterior(i) / before(i), 0.0, 1.0); };
  // What the data tell by themselves. A number that gets more than half of its information from elsewhere is not
  // theirs, not even where that is only what a hand-held tool can be.
  const Vector10d alone = congruence(componentsJacobian(solution.phi), plainFit(R, true).covariance).diagonal();
  // What is nobody's: too uncertain, and nothing was told that it could come from.
  const auto source = [&](int i, double scale, bool wasTold) {
    const bool known = deviation(i) < kIdentified * scale && alone(i) < 2.0 * std::pow(kIdentified * scale, 2) &&
                       alone(i) < std::pow(kSharpest * deviation(i), 2);
    if (!wasTold) return known ? Source::data : Source::none;
    return share(i) > 0.5 && known ? Source::data : Source::prior;
  };
  out.mass = source(0, payload.mass, told.mass);
  out.massShare = share(0);
  for (int i = 0; i < 3; ++i) {
    out.com[static_cast<std::size_t>(i)] = source(1 + i, size, told.com);
    out.comShare += share(1 + i) / 3.0;
  }
  static constexpr int kPlace[3][3] = {{4, 5, 6}, {5, 7, 8}, {6, 8, 9}};
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) {
      const double scale = std::sqrt(payload.inertiaCom(r, r) * payload.inertiaCom(c, c));
      out.inertia[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)] = source(kPlace[r][c], scale, told.inertia);
      if (r == c) out.inertiaShare += share(kPlace[r][c]) / 3.0;
    }
  // A shape without its weight tells no inertia.
  if (out.mass == Source::none)
    for (auto& row : out.inertia) row.fill(Source::none);
  out.directions = directionsOf(prior, solution, J);
  return out;
}

std::vector<std::string> weakDirections(const Identifiability& identifiability, const Motion& motion,
                                        const Payload& payload, const std::array<bool, 6>& silent) {
  std::vector<std::string> words;
  const bool deafForces = silent[0] || silent[1] || silent[2], deafTorques = silent[3] || silent[4] || silent[5];
  const double degrees = 180.0 / std::numbers::pi;
  // Gravity's directions in S: their mean length is 1 if the tool was never tilted.
  Vector3d mean = Vector3d::Zero();
  for (Eigen::Index k = 0; k < motion.size(); ++k) mean += motion.specificForce.col(k).normalized();
  mean /= std::max<double>(1.0, static_cast<double>(motion.size()));
  const double spread = std::acos(std::clamp(mean.norm(), 0.0, 1.0)) * degrees;
  const bool comWeak =
      std::any_of(identifiability.com.begin(), identifiability.com.end(), [](Source s) { return s != Source::data; });
  if (identifiability.mass != Source::data && !deafForces)
    words.push_back(
        heft::say("The tool kept nearly the same tilt (about {:.0f} degrees of change), so its weight cannot be "
                  "separated from the sensor's bias.",
                  spread));
  if (comWeak && !deafTorques) {
    std::string axes;
    for (std::size_t i = 0; i < 3; ++i)
      if (identifiability.com[i] != Source::data) axes += (axes.empty() ? "" : ", ") + std::string(kAxes[i]);
    words.push_back(
        heft::say("The tool was not tilted in enough directions to determine its centre of mass along {}.", axes));
  }
  // The moment about an axis is told by turning to and fro about it, and weak in the sensor's axes where one of the
  // tool's is.
  const NamedAxes axes = namedAxes(payload);
  Vector3d weak = Vector3d::Zero();
  for (int i = 0; i < 3; ++i)
    if (identifiability.inertia[static_cast<std::size_t>(i)][static_cast<std::size_t>(i)] != Source::data)
      weak(i) = 1.0;
  for (int i = 0; i < 3 && !deafTorques; ++i) {
    const Vector3d axis = axes.R.col(i);
    if (axis.cwiseAbs2().dot(weak) < 0.5) continue;
    words.push_back(
        heft::say("The tool was never rotated fast enough about {}: rotate it back and forth about that axis, faster.",
                  axes.names[static_cast<std::size_t>(i)]));
  }
  return words;
}

}  // namespace heft
