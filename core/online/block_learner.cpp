#include "core/online/block_learner.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/noise_certainty.h"
#include "core/estimation/prior.h"
#include "core/estimation/standstill.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"
#include "core/segmentation/segmentation.h"

namespace heft {

namespace {

constexpr Eigen::Index kMargin = 3;      // blocks kept away from a contact on both sides
constexpr double kForceAllowed = 0.3;    // [N] no contact below this
constexpr double kTorqueAllowed = 0.03;  // [N m]
/// By which factor the blocks that are learned from must change in number before a small shortfall is drawn again. It
/// falls as they grow in number, so that until then intervals are rather too wide, by this share at most.
constexpr double kShortfallGrowth = 1.4, kSmallShortfall = 0.1;
constexpr double kNormal95 = 1.959963984540054;

std::array<Interval, 10> listed(const PayloadInterval& i) {
  return {i.mass,
          i.com[0],
          i.com[1],
          i.com[2],
          i.inertiaCom[0][0],
          i.inertiaCom[0][1],
          i.inertiaCom[0][2],
          i.inertiaCom[1][1],
          i.inertiaCom[1][2],
          i.inertiaCom[2][2]};
}

PayloadInterval unlisted(const std::array<Interval, 10>& i) {
  PayloadInterval out;
  out.mass = i[0];
  out.com = {i[1], i[2], i[3]};
  out.inertiaCom = {{{i[4], i[5], i[6]}, {i[5], i[7], i[8]}, {i[6], i[8], i[9]}}};
  return out;
}

/// The runs' rows in the narrower band, whitened, with honest variances. `shortfall` is found where it is not known.
Triangle narrowFit(const Prepared& prepared, std::vector<Run> runs, const WideBand& wide,
                   std::optional<double>& shortfall) {
  for (auto& run : runs) run.to = std::min(run.to, wide.blocks.size());
  std::erase_if(runs, [](const Run& run) { return run.to - run.from <= kMaxArOrder; });
  if (runs.empty()) return Triangle::Zero();
  FitRowsQuestion question{wide.blocks, runs, {prepared.silent, prepared.rounding}, std::nullopt, nullptr};
  question.predicts = wide.stride;
  question.shortfall = shortfall;
  const FitRows fit = fitRowsOf(question);
  shortfall = fit.shortfall;
  return fit.whitened;
}

/// Standard deviations of the ten components by the curvature at the mode.
Vector10d curvatureStd(const MapPrior& prior, const MapSolution& solution) {
  const Matrix10d J = componentsJacobian(solution.phi) * parametersJacobian(prior, solution.v);
  return (J * solution.covariance * J.transpose()).diagonal().cwiseMax(1e-300).cwiseSqrt();
}

}  // namespace

Prepared learnedWith(const LaneBlocks& blocks, std::vector<MarkLabel> labels) {
  Prepared out;
  out.blocks = blocks.rows(0, blocks.size());
  out.labels = std::move(labels);
  for (Eigen::Index k = 0; k < blocks.size(); ++k)
    if (!blocks.usable[static_cast<std::size_t>(k)]) out.labels[static_cast<std::size_t>(k)] = MarkLabel::ignore;
  out.runs = runsOf(out.labels, 0, blocks.size(), kMaxArOrder + 4);
  for (const auto& run : out.runs) out.usedBlocks += run.to - run.from;
  if (6 * out.usedBlocks < Eigen::Index{4} * kColumns) {
    out.runs.clear();
    out.usedBlocks = 0;
    return out;
  }
  calm(out);
  learnNoise(out, false);
  LearnedNoise learned = withTaken({out.noise, out.weights, {}}, out.blocks, out.runs, {out.silent, out.rounding});
  out.noise = std::move(learned.noise);
  out.weights = std::move(learned.weights);
  return out;
}

Prepared learnedFrom(const LaneBlocks& blocks) {
  if (6 * blocks.size() < Eigen::Index{4} * kColumns) {
    Prepared out;
    out.blocks = blocks.rows(0, blocks.size());
    return out;
  }
  return learnedWith(blocks, segmentRows(Recording(), blocks.rows(0, blocks.size()), SegmentMode::automatic).labels);
}

Prepared withoutFirst(const Prepared& prepared, Eigen::Index count) {
  Prepared out;
  const Eigen::Index n = prepared.blocks.size();
  out.blocks.rateHz = prepared.blocks.rateHz;
  out.blocks.startTime = prepared.blocks.time(count);
  out.blocks.Y.assign(prepared.blocks.Y.begin() + count, prepared.blocks.Y.end());
  out.blocks.wrench = prepared.blocks.wrench.rightCols(n - count);
  out.labels.assign(prepared.labels.begin() + count, prepared.labels.end());
  out.still = prepared.still;
  out.noise = prepared.noise;
  out.weights = prepared.weights.rightCols(n - count);
  for (const auto& run : prepared.runs) {
    const Run rest{std::max<Eigen::Index>(0, run.from - count), run.to - count};
    if (rest.to - rest.from <= kMaxArOrder) continue;
    out.runs.push_back(rest);
    out.usedBlocks += rest.to - rest.from;
  }
  return out;
}

WideBand WideBand::withoutFirst(Eigen::Index count) const {
  WideBand out{blocks, stride};
  count = std::min(count, blocks.size());
  out.blocks.startTime = blocks.time(count);
  out.blocks.Y.erase(out.blocks.Y.begin(), out.blocks.Y.begin() + count);
  out.blocks.wrench = blocks.wrench.rightCols(blocks.size() - count);
  return out;
}

void BlockLearner::learn(const Prepared& prepared, const WideBand& wide, bool afresh) {
  if (prepared.runs.empty()) {
    learned_ = prepared.blocks.size();
    return;
  }
  forgetBlocks();
  learned_ = followed_ = prepared.blocks.size();
  judged_.assign(static_cast<std::size_t>(learned_), Judged::unused);
  for (std::size_t k = 0; k < judged_.size(); ++k)
    if (prepared.labels[k] == MarkLabel::contact) judged_[k] = Judged::contact;
  for (const auto& run : prepared.runs) std::fill(judged_.begin() + run.from, judged_.begin() + run.to, Judged::free);
  still_ = prepared.still;
  noise_ = prepared.noise;
  weighting_ = bounded(noise_);
  used_ = prepared.usedBlocks;
  // A tool that stands still has no motion to be smoothed.
  const int stride = still_ ? 1 : wide.stride;
  const bool grew = static_cast<double>(used_) > kShortfallGrowth * static_cast<double>(shortfallOf_);
  const bool shrank = static_cast<double>(used_) < static_cast<double>(shortfallOf_) / kShortfallGrowth;
  const bool large = shortfall_ && *shortfall_ > 1.0 + kSmallShortfall;
  if (afresh || stride != stride_ || grew || shrank || large) shortfall_.reset();
  if (!shortfall_) shortfallOf_ = used_;
  stride_ = stride;
  if (stride_ > 1) {
    base_ = narrowFit(prepared, prepared.runs, wide, shortfall_);
  } else {
    if (!shortfall_)
      shortfall_ = shortfallOfLearning(prepared.blocks, noise_, prepared.runs, {prepared.silent, prepared.rounding});
    base_ = honestTriangle(prepared.blocks, noise_, weighting_, prepared.weights, prepared.runs) / *shortfall_;
  }
  total_ = merged({frozen_, base_});
  findings_.clear();
  // A shape that could not be used would have failed when its prior was made.
  chosen_ = *priorFor(*options_, total_, findings_, shape_);
  solution_.v = chosen_.start;
  solve(true);

  std::array<std::vector<double>, 6> residuals;
  for (const auto& run : prepared.runs)
    for (Eigen::Index k = run.from; k < run.to; ++k) {
      const Vector6d r = prepared.blocks.wrench.col(k) - solution_.bias -
                         prepared.blocks.Y[static_cast<std::size_t>(k)] * solution_.phi;
      for (int c = 0; c < 6; ++c) residuals[static_cast<std::size_t>(c)].push_back(std::abs(r(c)));
    }
  for (int c = 0; c < 6; ++c) scatter_(c) = 1.4826 * median(std::move(residuals[static_cast<std::size_t>(c)]));
  estimated_ = true;
}

void BlockLearner::solve(bool sampled) {
  solution_ = solveMap(total_, chosen_.prior, options_->bias, solution_.v);
  // Only to judge residuals by: unexcited directions are held by what a hand-held tool can be.
  Vector10d sd;
  sd << 3.0, 0.3, 0.3, 0.3, 0.1, 0.1, 0.1, 0.1, 0.1, 0.1;
  Eigen::Matrix<double, kColumns, kColumns> H = total_.leftCols<kColumns>().transpose() * total_.leftCols<kColumns>();
  H.diagonal().head<6>().array() += options_->bias ? 1e-4 : 1e8;
  H.diagonal().tail<10>() += sd.cwiseAbs2().cwiseInverse();
  covariance_ = SymmetricSolver(H).solveAll(MatrixXd::Identity(kColumns, kColumns));

  const Vector10d value = componentsOf(fromParameters(solution_.phi));
  const Vector10d half = kNormal95 * curvatureStd(chosen_.prior, solution_);
  if (sampled) {
    interval_ = intervalsFromV(total_, chosen_.prior, options_->bias, solution_);
    const auto list = listed(interval_);
    for (int i = 0; i < 10; ++i) {
      lowerRatio_(i) = (value(i) - list[static_cast<std::size_t>(i)].lower) / half(i);
      upperRatio_(i) = (list[static_cast<std::size_t>(i)].upper - value(i)) / half(i);
    }
    return;
  }
  std::array<Interval, 10> list;
  for (int i = 0; i < 10; ++i)
    list[static_cast<std::size_t>(i)] = {value(i) - lowerRatio_(i) * half(i), value(i) + upperRatio_(i) * half(i)};
  interval_ = unlisted(list);
}

double BlockLearner::score(const Regressor& Y, const Vector6d& wrench) const {
  const Vector6d r = wrench - solution_.bias - Y * solution_.phi;
  Eigen::Matrix<double, 6, kColumns> A;
  A.leftCols<6>().setIdentity();
  A.rightCols<10>() = Y;
  const Vector6d unsure = (A * covariance_ * A.transpose()).diagonal().cwiseMax(0.0).cwiseSqrt();
  double worst = 0.0;
  for (int c = 0; c < 6; ++c)
    worst = std::max(worst, std::abs(r(c)) / (std::max(6.0 * scatter_(c), c < 3 ? kForceAllowed : kTorqueAllowed) +
                                              4.0 * unsure(c)));
  return worst;
}

void BlockLearner::judge(const LaneBlocks& blocks) {
  for (auto k = static_cast<Eigen::Index>(judged_.size()); k < blocks.size(); ++k) {
    const auto i = static_cast<std::size_t>(k);
    const bool fits = score(blocks.Y[i], blocks.wrench[i]) < 1.0;
    // A contact begins before it is seen, and beside one a block may fit by chance.
    const auto near = judged_.begin() + std::max<Eigen::Index>(learned_, k - kMargin);
    if (!fits) {
      std::replace(near, judged_.end(), Judged::free, Judged::unused);
      judged_.push_back(Judged::contact);
    } else {
      const bool beside = std::find(near, judged_.end(), Judged::contact) != judged_.end();
      judged_.push_back(blocks.usable[i] && !beside ? Judged::free : Judged::unused);
    }
  }
}

void BlockLearner::follow(const LaneBlocks& blocks) {
  if (!estimated_) return;
  judge(blocks);
  const Eigen::Index ready = blocks.size() - kMargin;
  if (ready > followed_ && stride_ == 1) {
    // Free runs with the blocks before them that their noise remembers.
    const Eigen::Index from = std::max<Eigen::Index>(0, followed_ - noise_.order);
    WrenchRows rows = blocks.rows(from, ready);
    if (still_)
      for (auto& Y : rows.Y)
        if (standsStill(Y, *still_)) Y = regressorAtRest(*still_);
    std::vector<Run> runs;
    for (Eigen::Index k = from; k < ready; ++k) {
      if (judged_[static_cast<std::size_t>(k)] != Judged::free) continue;
      const Eigen::Index start = k;
      while (k < ready && judged_[static_cast<std::size_t>(k)] == Judged::free) ++k;
      if (k - start <= noise_.order) continue;
      runs.push_back({start - from, k - from});
      freshBlocks_ += k - start - noise_.order;
    }
    Eigen::Matrix<double, 6, Eigen::Dynamic> residual(6, rows.size());
    for (Eigen::Index k = 0; k < rows.size(); ++k)
      residual.col(k) = rows.wrench.col(k) - solution_.bias - rows.Y[static_cast<std::size_t>(k)] * solution_.phi;
    const Eigen::Matrix<double, 6, Eigen::Dynamic> weights =
        innovations(noise_, residual, runs).unaryExpr([](double e) {
          return std::abs(e) > 3.0 ? 3.0 / std::abs(e) : 1.0;
        });
    fresh_->add(whitenedTriangles(rows, weighting_, weights, runs, 1).front() / *shortfall_);
    followed_ = ready;
  }
  total_ = merged({frozen_, base_, fresh_->finish()});
  solve(false);
}

void BlockLearner::freeze(const Prepared& prepared, Eigen::Index count, const WideBand& wide) {
  std::vector<Run> runs;
  TriangleBuilder rows;
  rows.add(frozenRows_);
  for (const auto& run : prepared.runs) {
    const Run part{run.from, std::min(run.to, count)};
    if (part.to - part.from <= kMaxArOrder) continue;
    runs.push_back(part);
    frozenBlocks_ += part.to - part.from;
    for (Eigen::Index k = part.from; k < part.to; ++k) rows.add(blockRows(prepared.blocks, k));
  }
  frozenRows_ = rows.finish();
  std::optional<double> shortfall;
  if (!runs.empty())
    frozen_ = merged({frozen_, wide.stride > 1 ? narrowFit(prepared, runs, wide, shortfall)
                                               : honestTriangle(prepared.blocks, prepared.noise,
                                                                bounded(prepared.noise), prepared.weights, runs)});
  forgetBlocks();
}

void BlockLearner::forgetBlocks() {
  judged_.clear();
  learned_ = followed_ = used_ = freshBlocks_ = 0;
  base_.setZero();
  fresh_.emplace();
}

}  // namespace heft
