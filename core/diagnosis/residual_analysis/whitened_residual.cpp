#include "core/diagnosis/residual_analysis/whitened_residual.h"

#include <cmath>

#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

constexpr Eigen::Index kFew = 72;  ///< Columns that may be taken all at once

}  // namespace

WhitenedResidual::WhitenedResidual(const std::vector<Stretch>& where, const Fit& what, const ChannelColumns& columns,
                                   const Noise& with, bool refits)
    : stretches(where), fit(what), noise(with), learnsAgain(refits) {
  basis = explainedSpace(columns, noise, stretches);
  take(even(flat(fit.residual), noise));
}

WhitenedResidual::WhitenedResidual(const WhitenedResidual& other, const Wrenches& residual) : WhitenedResidual(other) {
  take(flat(residual));
}

double WhitenedResidual::evidence(const VectorXd& left) const {
  Wrenches residual = Eigen::Map<const Wrenches>(left.data(), 6, left.size() / 6);
  for (Eigen::Index c = 0; c < 6; ++c) residual.row(c) *= noise.channels[static_cast<std::size_t>(c)].sigma;
  return fitNoise(residual, stretches, nullptr).evidence - before;
}

void WhitenedResidual::take(const VectorXd& residual) {
  Noise same = noise;
  same.noiseScale = nullptr;
  same.level = nullptr;
  before = fitNoise(Eigen::Map<const Wrenches>(residual.data(), 6, residual.size() / 6), stretches, nullptr).evidence;
  r = whitened(residual, same, stretches);
  energy = std::max(1.0, r.squaredNorm());
  r -= basis * (basis.transpose() * r);
}

Dictionary::Dictionary(const WhitenedResidual& ground, const MatrixXd& columns)
    : ground_(ground), C_(ChannelColumns(columns), ground.noise, ground.stretches) {
  constexpr double kLeft = 1e-9;  ///< Share of a column's squares that is left of it by rounding alone
  explained_ = C_.transposeTimes(ground.basis);
  products = C_.gram();
  const VectorXd own = products.diagonal();
  products -= explained_ * explained_.transpose();
  squares = (products.diagonal().array() > kLeft * own.array()).select(products.diagonal(), 0.0);
  if (C_.cols() > kFew) return;
  scale_ = (squares.array() > 0.0).select(squares.cwiseSqrt().cwiseMax(1e-9).cwiseInverse(), 0.0);
  MatrixXd unit = scale_.asDiagonal() * products * scale_.asDiagonal();
  unit.diagonal().array() += 1e-6;
  together_ = SymmetricSolver(unit);
}

VectorXd Dictionary::likeness(const VectorXd& r) const {
  return scale_.asDiagonal() * together_.solve(scale_.asDiagonal() * productsWith(r));
}

Judged judgeAll(const Dictionary& of, const WhitenedResidual& ground, double lnN, double tries) {
  const VectorXd left = ground.r - of.sum(of.likeness(ground.r));
  const double explained = ground.r.squaredNorm() - left.squaredNorm();
  const double gain = ground.learnsAgain ? ground.evidence(left) : explained;
  const double price = complexityPenalty(gain, static_cast<double>((of.squares.array() > 1e-12).count()), lnN);
  return {gain - price - 2.0 * std::log(2.0 * tries), explained / ground.energy};
}

namespace {

/// Forward selection: the column that explains most, as long as it pays for itself and for the choice. What is chosen
/// is made orthogonal to what was chosen before (Chen, Billings and Luo 1989), by products alone.
Judged judgeBest(const Dictionary& of, const WhitenedResidual& ground, double lnN) {
  constexpr double kLeast = 1e-12;  // Squared length below which a column says nothing new
  Judged out;
  VectorXd g = of.productsWith(ground.r), squares = of.squares, left = ground.r;
  const double choice = 2.0 * std::log(2.0 * static_cast<double>(of.squares.size()));
  double price = 0.0, explained = 0.0, gain = 0.0;
  std::vector<VectorXd> chosen, shares;  // Unit columns, and what each column has of them
  int idle = 0;
  for (int step = 0; step < 12 && idle < 3; ++step) {
    Eigen::Index best = -1;
    double most = 0.0;
    for (Eigen::Index i = 0; i < squares.size(); ++i) {
      if (squares(i) < kLeast) continue;
      const double z2 = g(i) * g(i) / squares(i);
      if (z2 > most) {
        most = z2;
        best = i;
      }
    }
    if (best < 0 || most < lnN + choice) break;
    price += lnN + choice;
    explained += most;
    VectorXd unit = of.sum(VectorXd::Unit(squares.size(), best)), share = of.products.col(best);
    for (std::size_t k = 0; k < chosen.size(); ++k) {
      unit -= shares[k](best) * chosen[k];
      share -= shares[k](best) * shares[k];
    }
    const double length = std::sqrt(squares(best)), along = g(best) / length;
    unit /= length;
    share /= length;
    left -= along * unit;
    g -= along * share;
    squares -= share.cwiseAbs2();
    squares(best) = 0.0;
    chosen.push_back(std::move(unit));
    shares.push_back(std::move(share));
    gain = (ground.learnsAgain ? ground.evidence(left) : explained) - price;
    ++idle;
    if (gain <= out.gain) continue;
    out = {gain, explained / ground.energy};
    idle = 0;
  }
  return out;
}

}  // namespace

Judged judge(const Dictionary& of, const WhitenedResidual& ground, double lnN) {
  Judged out = judgeBest(of, ground, lnN);
  if (!of.few()) return out;
  const Judged all = judgeAll(of, ground, lnN, 1.0);
  return all.gain > out.gain ? all : out;
}

MatrixXd stacked(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd out(a.rows() + b.rows(), a.cols());
  out << a, b;
  return out;
}

MatrixXd onEachChannel(const MatrixXd& features) {
  const Eigen::Index count = features.rows(), blocks = features.cols();
  MatrixXd columns = MatrixXd::Zero(6 * blocks, 6 * count);
  for (Eigen::Index c = 0; c < 6; ++c)
    for (Eigen::Index f = 0; f < count; ++f)
      for (Eigen::Index n = 0; n < blocks; ++n) columns(6 * n + c, c * count + f) = features(f, n);
  return columns;
}

}  // namespace heft::diagnosis
