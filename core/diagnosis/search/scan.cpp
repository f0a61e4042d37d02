#include "core/diagnosis/search/scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "core/base/parallel.h"
#include "core/diagnosis/calibration.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

constexpr double kFinerChoice = 6.0;

/// Draws the waves of a walk (`amplitudes`, of `variances` from the data) to what a walk of the likeliest size makes of
/// them; returns their price.
double asWalk(VectorXd& amplitudes, const VectorXd& variances) {
  const Eigen::Index count = amplitudes.size() / 6;
  double price = 0.0;
  Vector6d size = Vector6d::Zero();  // Of a walk's longest wave, squared; channels of one kind share it
  for (Eigen::Index c = 0; c < 6; ++c)
    for (Eigen::Index k = 0; k < count; ++k)
      size.segment<3>(c - c % 3).array() += std::pow(static_cast<double>(k + 1), 2) *
                                            (std::pow(amplitudes(6 * k + c), 2) - variances(6 * k + c)) /
                                            static_cast<double>(3 * count);
  for (Eigen::Index c = 0; c < 6; ++c) {
    VectorXd waves(count), spread(count);
    const double longest = size(c);
    for (Eigen::Index k = 0; k < count; ++k) {
      waves(k) = amplitudes(6 * k + c);
      spread(k) = std::max(1e-300, variances(6 * k + c));
    }
    for (Eigen::Index k = 0; k < count; ++k) {
      const double prior = std::max(0.0, longest) / std::pow(static_cast<double>(k + 1), 2);
      waves(k) *= prior / (prior + spread(k));
      amplitudes(6 * k + c) = waves(k);
    }
    if (longest > 0.0) price += complexityOfRandomWalk(waves, spread, longest);
  }
  return price;
}

/// One way of weighting the rows.
class Weighting {
 public:
  /// `columns`: of the fit's model. All others must outlive this.
  Weighting(const Noise& noise, const std::vector<Stretch>& stretches, const Fit& fit, ChannelColumns columns)
      : noise_(noise), stretches_(stretches), fit_(fit), columns_(std::move(columns)), J_(columns_, noise, stretches) {
    r_ = whitened(flat(fit.residual), noise, stretches);
    inverse_ = Normal(J_, weakPrior(fit.model)).inverse();
    Jr_ = J_.transposeTimes(r_);
  }

  struct Answer {
    VectorXd gamma;
    std::vector<bool> kept;
    double gain = 0.0;     ///< Twice the log-likelihood
    double squares = 0.0;  ///< The same, had the noise been known
    double score = -1e300;
    VectorXd others;  ///< How far all other parameters give way
    double walkPrice = 0.0;
  };

  /// Standard deviation of each scanned parameter if it were the only one.
  VectorXd deviations(const Signature& signature) const {
    const WhitenedColumns C(*signature.columns, noise_, stretches_, signature.reach.from);
    const MatrixXd JC = J_.transposeTimes(C);
    const VectorXd squares = C.gram().diagonal();
    VectorXd out(C.cols());
    for (Eigen::Index i = 0; i < C.cols(); ++i) {
      const double own = squares(i), left = own - JC.col(i).dot(inverse_ * JC.col(i));
      out(i) = left > 1e-6 * own && own > 0.0 ? 1.0 / std::sqrt(left) : std::numeric_limits<double>::infinity();
    }
    return out;
  }

  /// Gain and score as the squares tell them, which is close where they are few.
  Answer firstGuess(const Signature& signature, double lnN) const {
    const WhitenedColumns C(*signature.columns, noise_, stretches_, signature.reach.from);
    const MatrixXd JC = J_.transposeTimes(C);
    const MatrixXd own = C.gram();
    const MatrixXd G = own - JC.transpose() * inverse_ * JC;
    const VectorXd g = C.transposeTimes(r_.segment(6 * signature.reach.from, 6 * signature.columns->blocks())) -
                       JC.transpose() * (inverse_ * Jr_);
    const Eigen::Index d = C.cols();
    Answer out;
    out.kept.assign(static_cast<std::size_t>(d), true);
    // What bias and payload can do as well is no direction of the cause.
    for (Eigen::Index i = 0; i < d; ++i)
      if (!(G(i, i) > 1e-6 * own(i, i)) || own(i, i) <= 0.0) out.kept[static_cast<std::size_t>(i)] = false;
    for (;;) {
      std::vector<Eigen::Index> free;
      for (Eigen::Index i = 0; i < d; ++i)
        if (out.kept[static_cast<std::size_t>(i)]) free.push_back(i);
      out.gamma = VectorXd::Zero(d);
      if (free.empty()) return out;
      const auto size = static_cast<Eigen::Index>(free.size());
      MatrixXd Gf(size, size);
      VectorXd gf(size);
      for (Eigen::Index i = 0; i < size; ++i) {
        gf(i) = g(free[static_cast<std::size_t>(i)]);
        for (Eigen::Index j = 0; j < size; ++j)
          Gf(i, j) = G(free[static_cast<std::size_t>(i)], free[static_cast<std::size_t>(j)]);
      }
      const VectorXd s = Gf.diagonal().cwiseSqrt().cwiseInverse();
      MatrixXd unit = s.asDiagonal() * Gf * s.asDiagonal();
      unit.diagonal().array() += 1e-9;
      const MatrixXd inverse = SymmetricSolver(unit).solveAll(MatrixXd::Identity(size, size));
      const VectorXd gamma = s.asDiagonal() * (inverse * (s.asDiagonal() * gf));
      // The least telling one goes, as long as its evidence does not pay for it.
      Eigen::Index weakest = -1;
      double least = lnN;
      for (Eigen::Index i = 0; signature.form.subset && i < size; ++i) {
        const double z2 = gamma(i) * gamma(i) / (s(i) * s(i) * std::max(1e-300, inverse(i, i)));
        if (z2 < least) {
          least = z2;
          weakest = i;
        }
      }
      if (weakest >= 0) {
        out.kept[static_cast<std::size_t>(free[static_cast<std::size_t>(weakest)])] = false;
        continue;
      }
      for (Eigen::Index i = 0; i < size; ++i) out.gamma(free[static_cast<std::size_t>(i)]) = gamma(i);
      out.squares = gamma.dot(gf);
      if (signature.form.walk && size == d)
        out.walkPrice = asWalk(out.gamma, s.cwiseAbs2().cwiseProduct(inverse.diagonal()));
      break;
    }
    out.others = inverse_ * (Jr_ - JC * out.gamma);
    score(out, signature.form, out.squares, lnN);
    return out;
  }

  /// The same with the noise learned anew, once the other parameters have given way.
  void learnNoise(Answer& answer, const Signature& signature, double lnN) const {
    if (answer.others.size() == 0) return;
    Wrenches residual = fit_.residual;
    Eigen::Map<VectorXd> left(residual.data(), residual.size());
    left -= columns_.times(answer.others);
    left.segment(6 * signature.reach.from, 6 * signature.columns->blocks()) -= signature.columns->times(answer.gamma);
    score(answer, signature.form, fitNoise(residual, stretches_, fit_.noise.noiseScale).evidence - fit_.noise.evidence,
          lnN);
  }

  Answer judge(const Signature& signature, double lnN) const {
    Answer out = firstGuess(signature, lnN);
    learnNoise(out, signature, lnN);
    return out;
  }

 private:
  static void score(Answer& answer, const Form& form, double gain, double lnN) {
    const auto count = static_cast<double>(std::count(answer.kept.begin(), answer.kept.end(), true));
    answer.gain = gain;
    answer.score = gain - (form.walk     ? answer.walkPrice
                           : form.subset ? count * lnN
                                         : complexityPenalty(gain, count, lnN));
  }

  const Noise& noise_;
  const std::vector<Stretch>& stretches_;
  const Fit& fit_;
  ChannelColumns columns_;
  WhitenedColumns J_;
  MatrixXd inverse_;
  VectorXd r_, Jr_;
};

}  // namespace

std::vector<VectorXd> leastVisible(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                                   const std::vector<Signature>& bank, double threshold) {
  const double lnN = std::log(std::max(2.0, fit.noise.samples));
  const Weighting weighting(fit.noise, stretches, fit, CachedJacobian(signals, fit.model).columns());
  std::vector<VectorXd> out(bank.size());
  parallelFor(bank.size(), [&](std::size_t i) { out[i] = std::sqrt(threshold + lnN) * weighting.deviations(bank[i]); });
  return out;
}

namespace {

/// The candidate as the answer has it, its price for having been chosen left as it is.
void take(Candidate& candidate, const Weighting::Answer& answer) {
  const Form& form = candidate.form;
  candidate.score = answer.score - candidate.choicePenalty;
  candidate.v = form.start;
  if (answer.score <= -1e299) return;
  candidate.active.assign(form.parameters.size(), true);
  for (std::size_t j = 0; j < form.scan.size(); ++j) {
    const auto p = static_cast<std::size_t>(form.scan[j]);
    const Parameter& parameter = form.parameters[p];
    candidate.active[p] = answer.kept[j];
    const double value = form.start(form.scan[j]) + answer.gamma(static_cast<Eigen::Index>(j));
    candidate.v(form.scan[j]) = std::clamp(value, parameter.lower, parameter.upper);
  }
}

}  // namespace

std::vector<Candidate> scan(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                            const std::vector<Signature>& bank) {
  const double lnN = std::log(std::max(2.0, fit.noise.samples));
  // A cause has kinds of forms, and of some kinds many, such as one for each of several frequencies; rare ones have
  // doubts of their own.
  std::map<std::pair<const Cause*, bool>, std::map<std::vector<int>, int>> forms;
  for (const auto& signature : bank) ++forms[{signature.form.cause, signature.form.rare}][signature.form.choice];
  const Noise flatNoise = white(fit.residual, stretches, fit.noise.noiseScale);
  const ChannelColumns columns = CachedJacobian(signals, fit.model).columns();
  const Weighting coloured(fit.noise, stretches, fit, columns), plain(flatNoise, stretches, fit, columns);
  std::vector<std::array<Weighting::Answer, 2>> answers(bank.size());
  parallelFor(bank.size(), [&](std::size_t i) {
    answers[i] = {coloured.firstGuess(bank[i], lnN), plain.firstGuess(bank[i], lnN)};
  });
  std::array<double, 2> many{};
  for (std::size_t i = 0; i < bank.size(); ++i)
    for (std::size_t k = 0; k < 2; ++k)
      if (!bank[i].form.walk) many[k] = std::max(many[k], kSmallShare * answers[i][k].squares);
  std::vector<Candidate> out(bank.size());
  parallelFor(bank.size(), [&](std::size_t i) {
    const Form& form = bank[i].form;
    Candidate& candidate = out[i];
    candidate.form = form;
    const auto& kinds = forms.at({form.cause, form.rare});
    candidate.choicePenalty = 2.0 * std::log(static_cast<double>(std::ssize(kinds) * kinds.at(form.choice)));
    // What moves between the forms, such as a frequency, has been chosen from more than their number.
    if (form.scan.size() < form.parameters.size()) candidate.choicePenalty += kFinerChoice;
    auto& [best, other] = answers[i];
    // Few squares are what the noise gains by; and what they do not pay for having been chosen is settled: of a long
    // recording's thousands of touches, nearly all.
    const double few = std::max(kSameLikelihood, candidate.choicePenalty);
    if (form.walk || best.squares > std::max(few, many[0]) || other.squares > std::max(few, many[1])) {
      coloured.learnNoise(best, bank[i], lnN);
      plain.learnNoise(other, bank[i], lnN);
      if (other.score > best.score) best = std::move(other);
    }
    take(candidate, best);
    if (best.score <= -1e299) return;
    // The wrong sign of the one thing that a form is about: it does not explain anything.
    const auto only = static_cast<std::size_t>(form.scan[0]);
    const double lower = form.parameters[only].lower;
    if (form.scan.size() == 1 && lower == form.start(form.scan[0]) && candidate.v(form.scan[0]) == lower)
      candidate.score = -1e300;
  });
  std::stable_sort(out.begin(), out.end(), [](const Candidate& a, const Candidate& b) { return a.score > b.score; });
  return out;
}

struct OnsetRefinement::Around {
  Around(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit, const CachedJacobian& columns)
      : lnN(std::log(std::max(2.0, fit.noise.samples))),
        flat(white(fit.residual, stretches, fit.noise.noiseScale)),
        coloured(fit.noise, stretches, fit, columns.columns()),
        plain(flat, stretches, fit, columns.columns()),
        surroundings(signals, fit.model) {}

  double lnN;
  Noise flat;
  Weighting coloured, plain;
  LinearisationPoint surroundings;
};

OnsetRefinement::OnsetRefinement(const Signals& signals, const std::vector<Stretch>& stretches, const Fit& fit,
                                 const CachedJacobian& columns)
    : block_(1.0 / signals.blockRate()), around_(std::make_unique<const Around>(signals, stretches, fit, columns)) {}
OnsetRefinement::~OnsetRefinement() = default;

Candidate OnsetRefinement::refined(const Candidate& candidate) const {
  const auto at = [&](double time) { return signatureAt(time, candidate.form, around_->surroundings); };
  // Where the squares fall most, whatever the noise's memory; then block by block, the noise learned anew.
  double about = candidate.v(0), most = -1e300;
  for (double off = -kEvent; off < kEvent + 0.5 * kMoment; off += kMoment) {
    const double squares = around_->plain.firstGuess(at(candidate.v(0) + off), around_->lnN).squares;
    if (squares <= most) continue;
    most = squares;
    about = candidate.v(0) + off;
  }
  Candidate best = candidate;
  for (double off = -kMoment; off < kMoment + 0.5 * block_; off += block_) {
    const Signature signature = at(about + off);
    for (const Weighting* weighting : {&around_->coloured, &around_->plain}) {
      Candidate trial = candidate;
      trial.form = signature.form;
      take(trial, weighting->judge(signature, around_->lnN));
      if (trial.score > best.score) best = std::move(trial);
    }
  }
  return best;
}

}  // namespace heft::diagnosis
