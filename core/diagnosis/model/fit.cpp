#include "core/diagnosis/model/fit.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "core/diagnosis/calibration.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// Moves by `step`, kept inside bounds and, for the causes' parameters, within a few realistic sizes at once.
Model moved(const Model& from, const VectorXd& step, double factor) {
  VectorXd all = from.packed() + factor * step;
  const VectorXd old = from.packed();
  Eigen::Index at = kLinear;
  for (const auto& term : from.terms)
    for (std::size_t p = 0; p < term.form->parameters.size(); ++p, ++at) {
      const Parameter& parameter = term.form->parameters[p];
      if (!term.moves(static_cast<Eigen::Index>(p))) {
        all(at) = old(at);
        continue;
      }
      const double reach = 6.0 * parameter.size;
      all(at) = std::clamp(all(at), old(at) - reach, old(at) + reach);
      all(at) = std::clamp(all(at), parameter.lower, parameter.upper);
    }
  Model out = from;
  out.unpack(all);
  return out;
}

/// `value`: what the model predicts; `off`: how far its parameters are from where they were thought, to `sd`.
double misfit(const Signals& signals, const std::vector<Stretch>& stretches, const Noise& noise, const VectorXd& off,
              const Wrenches& value, const VectorXd& sd) {
  const Wrenches r = signals.measured - value;
  return whitened(flat(r), noise, stretches).squaredNorm() + off.cwiseQuotient(sd).squaredNorm();
}

/// Information that is left of the parameters in `own` when all in `others` are unknown; both are indices.
MatrixXd informationBeside(const MatrixXd& information, const std::vector<Eigen::Index>& own,
                           const std::vector<Eigen::Index>& others) {
  const MatrixXd B = information(others, own);
  MatrixXd A = information(others, others);
  A.diagonal().array() += 1e-9;
  return information(own, own) - transposedProduct(B, SymmetricSolver(A).solveAll(B));
}

constexpr double kWidth = 3.5;       ///< 2 ln of how many widths of a prior there are to choose from
constexpr double kLeastWalk = 1e-3;  ///< Of a parameter's size: a walk that is none

/// What a walk's waves cost: how far the data had to narrow what the walk left open, and how far they are from zero.
double priceOfWaves(const MatrixXd& information, const VectorXd& scale, const std::vector<Eigen::Index>& own,
                    const std::vector<Eigen::Index>& others, const Term& term, const VectorXd& sd) {
  const VectorXd spread = sd(own), prior = spread.cwiseQuotient(scale(own));
  MatrixXd M = prior.asDiagonal() * informationBeside(information, own, others) * prior.asDiagonal();
  M.diagonal().array() += 1.0;
  double out = 2.0 * choleskyFactor(M).diagonal().array().log().sum() + term.v.cwiseQuotient(spread).squaredNorm();
  for (const int c : {0, 3}) {
    const double least = kLeastWalk * term.form->parameters[static_cast<std::size_t>(c)].size;
    if (term.walk(c) > 2.0 * least * least) out += kWidth;
  }
  return out;
}

/// The walk's size that explains its waves best: sum of squares over how many of them the data tell (MacKay). Channels
/// of one kind share it: what makes one of a sensor's gauges creep makes the others.
void learnWalk(Model& model, const MatrixXd& covariance) {
  Eigen::Index at = kLinear;
  for (auto& term : model.terms) {
    const Eigen::Index count = term.v.size() / 6;
    for (Eigen::Index first = 0; term.form->walk && term.moves(0) && first < 6; first += 3) {
      const double least = kLeastWalk * term.form->parameters[static_cast<std::size_t>(first)].size;
      double squares = 0.0, told = 0.0;
      for (Eigen::Index c = first; c < first + 3; ++c)
        for (Eigen::Index k = 1; k <= count; ++k) {
          const Eigen::Index p = 6 * (k - 1) + c;
          const double k2 = static_cast<double>(k * k);
          squares += k2 * term.v(p) * term.v(p);
          told += 1.0 - std::min(1.0, k2 * covariance(at + p, at + p) / term.walk(c));
        }
      term.walk.segment<3>(first).setConstant(std::max(least * least, squares / std::max(0.2, told)));
    }
    at += term.v.size();
  }
}

/// A walk's size before anything was learned: what its waves say by themselves.
void startWalk(Model& model) {
  for (auto& term : model.terms) {
    if (!term.form->walk || !term.walk.isZero(0.0)) continue;
    const Eigen::Index count = term.v.size() / 6;
    for (Eigen::Index first = 0; first < 6; first += 3) {
      const double size = term.form->parameters[static_cast<std::size_t>(first)].size;
      double squares = 0.0;
      for (Eigen::Index c = first; c < first + 3; ++c)
        for (Eigen::Index k = 1; k <= count; ++k)
          squares += std::pow(static_cast<double>(k) * term.v(6 * (k - 1) + c), 2);
      term.walk.segment<3>(first).setConstant(
          std::max(std::pow(0.1 * size, 2), squares / static_cast<double>(3 * count)));
    }
  }
}

struct Price {
  int dimensions = 0;
  double complexity = 0.0;
};

/// Directions of the causes' parameters that the motion tells apart from bias and payload, and what they cost.
Price priceOfTerms(const MatrixXd& information, const Model& model, const VectorXd& sd, double lnN) {
  Price out;
  if (model.terms.empty()) return out;
  const VectorXd scale = information.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const MatrixXd unit = scale.asDiagonal() * information * scale.asDiagonal();
  std::vector<Eigen::Index> linear(kLinear), causes(static_cast<std::size_t>(model.size() - kLinear));
  std::iota(linear.begin(), linear.end(), Eigen::Index{0});
  std::iota(causes.begin(), causes.end(), Eigen::Index{kLinear});
  const VectorXd values = symmetricEigen(informationBeside(unit, causes, linear)).values;
  out.dimensions = static_cast<int>((values.array() > 1e-6).count());
  double all = 0.0, waves = 0.0;
  for (const auto& [placedTerm, at] : indexedTerms(model)) {
    const Term& term = *placedTerm;
    // How far the term stands out: its amplitudes over what bias, payload and the other terms leave known of them.
    std::vector<Eigen::Index> own, others(linear);
    double count = 0.0;
    for (Eigen::Index p = 0; p < term.v.size(); ++p) count += term.moves(p) ? 1.0 : 0.0;
    for (const int p : term.form->scan)
      if (term.moves(p)) own.push_back(at + p);
    for (Eigen::Index i = kLinear; i < model.size(); ++i)
      if (i < at || i >= at + term.v.size()) others.push_back(i);
    all += count;
    if (term.form->walk) {
      if (!own.empty()) waves += priceOfWaves(unit, scale, own, others, term, sd);
      continue;
    }
    VectorXd size(static_cast<Eigen::Index>(own.size()));
    for (std::size_t i = 0; i < own.size(); ++i)
      size(static_cast<Eigen::Index>(i)) = (term.v(own[i] - at) - term.form->start(own[i] - at)) / scale(own[i]);
    // A form that leaves out what does not pay has had its choice of parameters: each costs in full.
    const double gain = term.form->subset ? 1e300 : size.dot(informationBeside(unit, own, others) * size);
    out.complexity += complexityPenalty(gain, count, lnN);
  }
  if (all > 0.0) out.complexity *= out.dimensions / all;
  out.complexity += waves;
  return out;
}

}  // namespace

double complexityPenalty(double gain, double count, double lnN) {
  if (count <= 0.0) return 0.0;
  return std::min(count * lnN, kWidth + count * (1.0 + std::log(std::max(1.0, gain / count))));
}

double complexityOfRandomWalk(const VectorXd& amplitudes, const VectorXd& variances, double longest) {
  double out = kWidth / 3.0;
  for (Eigen::Index i = 0; i < amplitudes.size(); ++i) {
    const double prior = longest / std::pow(static_cast<double>(i + 1), 2);
    out += amplitudes(i) * amplitudes(i) / prior + std::log1p(prior / variances(i));
  }
  return out;
}

bool hasRandomWalk(const Model& model) {
  return std::any_of(model.terms.begin(), model.terms.end(), [](const Term& t) { return t.form->walk; });
}

Normal::Normal(const WhitenedColumns& J, const VectorXd& sd) : information(J.gram()) {
  MatrixXd H = information;
  H.diagonal() += sd.cwiseAbs2().cwiseInverse();
  scale_ = H.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  unit_ = SymmetricSolver(scale_.asDiagonal() * H * scale_.asDiagonal());
}

MatrixXd Normal::inverse() const {
  const Eigen::Index n = scale_.size();
  return scale_.asDiagonal() * unit_.solveAll(MatrixXd::Identity(n, n)) * scale_.asDiagonal();
}

VectorXd weakPrior(const Model& model) {
  VectorXd sd(model.size());
  sd.head(6).setConstant(1e9);  // A zero may be anywhere, as of readings that are counts.
  sd(6) = 30.0;
  sd.segment<3>(7).setConstant(3.0);
  sd.segment<6>(10).setConstant(1.0);
  Eigen::Index at = kLinear;
  for (const auto& term : model.terms)
    for (std::size_t p = 0; p < term.form->parameters.size(); ++p) {
      const double longest = term.walk(static_cast<Eigen::Index>(p % 6));
      const std::size_t course = p / 6 + 1;
      sd(at++) = term.form->walk && longest > 0.0 ? std::sqrt(longest) / static_cast<double>(course)
                                                  : 100.0 * term.form->parameters[p].size;
    }
  return sd;
}

namespace {

enum class Weights { coloured, whiteFirst };

/// Deviations `sd` a priori with next to none for the causes' parameters that `holds` (term, its parameter, in
/// Model::packed()).
template <class Holds>
VectorXd heldWhere(const Model& model, VectorXd sd, const Holds& holds) {
  constexpr double kHeld = 1e-9;  ///< Of a parameter's size
  Eigen::Index at = kLinear;
  for (const Term& term : model.terms)
    for (Eigen::Index p = 0; p < term.v.size(); ++p, ++at)
      if (holds(term, p, at)) sd(at) = kHeld * term.form->parameters[static_cast<std::size_t>(p)].size;
  return sd;
}

bool isOfShape(const Term& term, Eigen::Index p, Eigen::Index) { return !isAmplitude(*term.form, p); }

/// The step that `pull` asks for. What stands at its bound and would leave it stays: the others step as they would
/// without it.
VectorXd stepInside(const WhitenedColumns& J, const Normal& normal, const VectorXd& pull, const Model& model,
                    const VectorXd& sd) {
  const VectorXd step = normal.solve(pull);
  bool leaves = false;
  const auto stays = [&](const Term& term, Eigen::Index p, Eigen::Index i) {
    const Parameter& parameter = term.form->parameters[static_cast<std::size_t>(p)];
    const bool out = term.moves(p) && ((step(i) < 0.0 && term.v(p) <= parameter.lower) ||
                                       (step(i) > 0.0 && term.v(p) >= parameter.upper));
    leaves = leaves || out;
    return out;
  };
  const VectorXd held = heldWhere(model, sd, stays);
  return leaves ? Normal(J, held).solve(pull) : step;
}

/// Whether a parameter stands at the end of what is believable.
bool isAtBound(const Term& term) {
  for (Eigen::Index p = 0; p < term.v.size(); ++p) {
    const Parameter& parameter = term.form->parameters[static_cast<std::size_t>(p)];
    const double margin = 1e-6 * parameter.size;
    if (term.moves(p) &&
        ((!parameter.lowerIsFine && term.v(p) <= parameter.lower + margin) || term.v(p) >= parameter.upper - margin))
      return true;
  }
  return false;
}

/// Covariance, complexity and evidence of a fit whose model, noise and residual have come to rest. `sd`: as of
/// weakPrior().
void judge(Fit& fit, const CachedJacobian& columns, const std::vector<Stretch>& stretches, const VectorXd& sd) {
  const Normal normal(WhitenedColumns(columns.columns(), fit.noise, stretches), sd);
  fit.information = normal.information;
  fit.covariance = normal.inverse();
  const Price price = priceOfTerms(fit.information, fit.model, sd, std::log(std::max(2.0, fit.noise.samples)));
  fit.dimensions = price.dimensions;
  fit.complexity = price.complexity;
  fit.evidence = fit.noise.evidence - fit.complexity;
  fit.atBound = fit.atBound || std::ranges::any_of(fit.model.terms, isAtBound);
}

Fit fitted(const Signals& signals, const std::vector<Stretch>& stretches, Model start, int rounds, Weights weights,
           const CachedJacobian* known) {
  Fit fit;
  fit.model = std::move(start);
  startWalk(fit.model);
  const bool learnsWalk = hasRandomWalk(fit.model);
  VectorXd sd = weakPrior(fit.model);
  CachedJacobian columns = known != nullptr ? CachedJacobian(*known, fit.model) : CachedJacobian(signals, fit.model);
  Wrenches reading = valueOf(signals, fit.model);
  fit.residual = signals.measured - reading;
  fit.noise = weights == Weights::coloured ? fitNoise(fit.residual, stretches, signals.noiseScale)
                                           : white(fit.residual, stretches, signals.noiseScale);
  // What whitens best is not what the noise is learned as: evidence may fall again, and then what was best counts.
  constexpr int kMostFalls = 2;
  struct State {
    Model model;
    Noise noise;
    Wrenches residual;
    std::optional<CachedJacobian> columns;
  };
  State best;
  double most = weights == Weights::coloured ? fit.noise.evidence : -1e300;
  int falls = 0;  // Rounds since then
  for (int round = 0; round < rounds && falls < kMostFalls; ++round) {
    const WhitenedColumns J(columns.columns(), fit.noise, stretches);
    const VectorXd r = whitened(flat(fit.residual), fit.noise, stretches);
    const Normal normal(J, sd);
    const VectorXd pull = J.transposeTimes(r) - fit.model.packed().cwiseQuotient(sd.cwiseAbs2());
    const VectorXd step = stepInside(J, normal, pull, fit.model, sd);
    const double before = r.squaredNorm() + fit.model.packed().cwiseQuotient(sd).squaredNorm();
    Model next;
    Wrenches value;
    const auto betters = [&](Model model) {
      next = std::move(model);
      value = valueOf(signals, next);
      return next.terms.empty() || misfit(signals, stretches, fit.noise, next.packed(), value, sd) <= before;
    };
    double factor = 1.0;
    for (int half = 0; half < 4; ++half, factor *= 0.4) {
      if (betters(moved(fit.model, step, factor))) break;
      if (half < 3) continue;
      // A time, a frequency or so leads astray, such as that of a step between two samples: then what is linear moves
      // alone.
      if (betters(moved(fit.model, Normal(J, heldWhere(fit.model, sd, isOfShape)).solve(pull), 1.0))) break;
      next = fit.model;
      value = reading;
    }
    if (learnsWalk) learnWalk(next, normal.inverse());
    State was{std::exchange(fit.model, std::move(next)), std::move(fit.noise), std::move(fit.residual), {}};
    sd = weakPrior(fit.model);
    fit.residual = signals.measured - value;
    fit.noise = fitNoise(fit.residual, stretches, signals.noiseScale);
    const bool rests = std::abs(fit.noise.evidence - was.noise.evidence) < 0.05;
    if (fit.noise.evidence >= most) {
      most = fit.noise.evidence;
      falls = 0;
    } else if (++falls == 1) {
      was.columns = columns;
      best = std::move(was);
    }
    reading = std::move(value);
    if (rests || round + 1 == rounds || falls == kMostFalls) break;
    columns.follow(fit.model);
  }
  if (falls > 0) {
    fit.model = std::move(best.model);
    fit.noise = std::move(best.noise);
    fit.residual = std::move(best.residual);
    columns = *std::move(best.columns);
    sd = weakPrior(fit.model);
  }
  columns.refresh(fit.model);
  judge(fit, columns, stretches, sd);
  return fit;
}

}  // namespace

Fit fitModel(const Signals& signals, const std::vector<Stretch>& stretches, Model start, int rounds,
             const CachedJacobian* known) {
  return fitted(signals, stretches, std::move(start), rounds, Weights::coloured, known);
}

Fit settled(const Signals& signals, const std::vector<Stretch>& stretches, Fit fit, const CachedJacobian* known) {
  Fit other = fitted(signals, stretches, fit.model, 8, Weights::whiteFirst, known);
  if (other.evidence > fit.evidence) return other;
  return fit;
}

Model refitted(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit, CachedJacobian columns) {
  // What these stretches say nothing of, such as a swing that has died away, is of the order of what all of them say;
  // what has no order, such as when something happened, stays where it was.
  constexpr double kOrder = 3.0;
  VectorXd sd = weakPrior(fit.model), thought = VectorXd::Zero(fit.model.size());
  for (const auto& [term, at] : indexedTerms(fit.model)) {
    for (const int p : term->form->scan)
      if (term->form->start(p) == 0.0)
        sd(at + p) = std::min(sd(at + p), kOrder * std::abs(term->v(p)) +
                                              kSmallShare * term->form->parameters[static_cast<std::size_t>(p)].size);
    for (Eigen::Index p = 0; p < term->v.size(); ++p)
      if (!isAmplitude(*term->form, p)) thought(at + p) = term->v(p);
  }
  Model model = fit.model;
  for (int round = 0; round < 2; ++round) {
    if (round > 0) columns.follow(model);
    const Wrenches residual = round == 0 ? fit.residual : Wrenches(signals.measured - valueOf(signals, model));
    const WhitenedColumns J(columns.columns(), fit.noise, stretches);
    const VectorXd r = whitened(flat(residual), fit.noise, stretches), off = model.packed() - thought;
    const VectorXd step = Normal(J, sd).solve(J.transposeTimes(r) - off.cwiseQuotient(sd.cwiseAbs2()));
    Model next = moved(model, step, 1.0);
    // A step too far, such as between two forms that do nearly the same, is a shorter one.
    const double before = r.squaredNorm() + off.cwiseQuotient(sd).squaredNorm();
    for (double factor = 0.3; factor > 0.01 && !fit.model.terms.empty(); factor *= 0.3) {
      const VectorXd nextOff = next.packed() - thought;
      if (misfit(signals, stretches, fit.noise, nextOff, valueOf(signals, next), sd) <= before) break;
      next = moved(model, step, factor);
    }
    model = std::move(next);
    if (fit.model.terms.empty()) break;
  }
  return model;
}

MatrixXd explainedSpace(const ChannelColumns& columns, const Noise& noise, const std::vector<Stretch>& stretches) {
  const MatrixXd J = whitened(columns.dense(), noise, stretches);
  const VectorXd size = J.colwise().norm().transpose().cwiseMax(1e-300).cwiseInverse();
  return columnSpace(J * size.asDiagonal());
}

}  // namespace heft::diagnosis
