#include "core/coach/prediction.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/estimation/prepare.h"
#include "core/estimation/prior.h"
#include "core/estimation/triangle.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"

namespace heft {

namespace {
constexpr double kNormal95 = 1.959963984540054;
constexpr int kPerBlock = 4;  // instants that are averaged into a block
}  // namespace

std::string_view toString(CoachGoal quantity) {
  switch (quantity) {
    case CoachGoal::mass:
      return "mass";
    case CoachGoal::com:
      return "com";
    case CoachGoal::inertia:
      return "inertia";
  }
  return "mass";
}

std::optional<CoachGoal> quantityFromString(std::string_view text) {
  for (const CoachGoal q : {CoachGoal::mass, CoachGoal::com, CoachGoal::inertia})
    if (text == toString(q)) return q;
  return std::nullopt;
}

double Uncertainty::of(CoachGoal quantity) const {
  return quantity == CoachGoal::mass ? mass : quantity == CoachGoal::com ? com : inertia;
}

Uncertainty uncertaintyOf(const OnlineInformation& information) {
  const MapSolution& s = information.solution;
  const MapCost cost(information.whitened, information.prior, information.bias);
  const Matrix10d Jv = parametersJacobian(information.prior, s.v);
  const MatrixXd AJ = product(cost.A(), Jv);
  const SymmetricSolver solver(transposedProduct(AJ, AJ) + information.prior.curvature(s.v));
  const MatrixXd J = product(componentsJacobian(s.phi), Jv);
  const Vector10d sd = product(J, solver.solveAll(J.transpose())).diagonal().cwiseMax(0.0).cwiseSqrt();
  const Payload payload = fromParameters(s.phi);
  Uncertainty out;
  out.mass = sd(0);
  out.com = sd.segment<3>(1).maxCoeff();
  out.inertia =
      std::max({sd(4) / payload.inertiaCom(0, 0), sd(7) / payload.inertiaCom(1, 1), sd(9) / payload.inertiaCom(2, 2)});
  return out;
}

Triangle rowsOfMotion(const OnlineInformation& information, const GuidedTool& tool, const Vector3d& gravity,
                      const JointMotion& motion) {
  WrenchRows rows;
  rows.rateHz = information.blockRateHz;
  const auto blocks = static_cast<Eigen::Index>(std::floor(motion.duration() * rows.rateHz));
  if (blocks <= kMaxArOrder + 4) return Triangle::Zero();
  rows.wrench.resize(6, blocks);
  VectorXd q, dq, ddq;
  for (Eigen::Index b = 0; b < blocks; ++b) {
    Regressor Y = Regressor::Zero();
    for (int i = 0; i < kPerBlock; ++i) {
      motion.at((static_cast<double>(b) + (i + 0.5) / kPerBlock) / rows.rateHz, q, dq, ddq);
      const FrameMotion m = tool.robot->frameMotion(tool.link, tool.X_LS, q, dq, ddq);
      const Matrix3d R = m.X_BS.linear().transpose();
      Y += regressor({R * (m.a_BSo_B - gravity), R * m.w_BS_B, R * m.alpha_BS_B});
    }
    rows.Y.push_back(Y / kPerBlock);
    rows.wrench.col(b) = rows.Y.back() * information.solution.phi + information.solution.bias;
  }
  const Eigen::Matrix<double, 6, Eigen::Dynamic> weights = Eigen::Matrix<double, 6, Eigen::Dynamic>::Ones(6, blocks);
  return honestTriangle(rows, information.noise, information.weighting, weights, {{0, blocks}});
}

OnlineInformation informationWith(const OnlineInformation& information, const Triangle& rows) {
  OnlineInformation out = information;
  out.whitened = merged({information.whitened, rows});
  return out;
}

std::string gainWords(CoachGoal quantity, const Uncertainty& before, const Uncertainty& after) {
  const auto line = [](const char* name, double a, double b, const char* unit) {
    const auto number = [](double x) {
      return x >= 99.5 ? fmt::format("{:.0f}", x) : x >= 0.95 ? fmt::format("{:.1f}", x) : fmt::format("{:.2f}", x);
    };
    return fmt::format("{} ± {} {} -> ± {} {}", name, number(a), unit, number(b), unit);
  };
  switch (quantity) {
    case CoachGoal::mass:
      return line("mass", 1e3 * kNormal95 * before.mass, 1e3 * kNormal95 * after.mass, "g");
    case CoachGoal::com:
      return line("centre of mass", 1e3 * kNormal95 * before.com, 1e3 * kNormal95 * after.com, "mm");
    case CoachGoal::inertia:
      return line("inertia", 1e2 * kNormal95 * before.inertia, 1e2 * kNormal95 * after.inertia, "%");
  }
  return {};
}

Result<OnlineInformation> informationOf(const Recording& recording, const RobotModel* robot,
                                        const std::optional<Shape>& shape, std::vector<Segment>* segments) {
  EstimateOptions options;
  options.shape = shape;
  options.trim = 0.0;
  auto prepared = prepare(recording, robot, options, {});
  if (!prepared) return prepared.error();
  Findings findings;
  const auto prior = priorFor(options, prepared->whitened, findings);
  if (!prior) return prior.error();
  OnlineInformation out;
  out.whitened = prepared->whitened;
  out.prior = prior->prior;
  out.told = prior->told;
  out.solution = solveMap(out.whitened, out.prior, options.bias, prior->start);
  out.noise = prepared->noise;
  out.weighting = bounded(prepared->noise);
  out.blockRateHz = prepared->blocks.rateHz;
  if (segments) *segments = prepared->segments;
  return out;
}

}  // namespace heft
