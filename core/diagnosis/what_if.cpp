#include "core/diagnosis/what_if.h"
#include "core/diagnosis/model/linearisation.h"

#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/model/fit.h"
#include "core/estimation/uncertainty.h"
#include "core/math/linear_algebra.h"
#include "core/motion/motion.h"

namespace heft {

using namespace diagnosis;

namespace {

/// Position 1 of a knob, in the realistic sizes that the catalogue gives: 5 ms of delay each, for instance.
constexpr double kReach = 5.0;
constexpr double kNeverSeen = 1e6;  // Position: what does nothing at all
/// [s] at both ends of a recording, where smoothing knows less, as in a check on another recording.
constexpr double kEnds = 0.3;
/// Look-alikes that are taken at their own size, how often, and up to which position.
constexpr std::size_t kLookedAtTwice = 3;
constexpr int kRefinements = 2;
constexpr double kFarthest = 3.0;

std::vector<bool> freeBlocks(const Signals& signals, const std::vector<Segment>& segments) {
  std::vector<bool> out(static_cast<std::size_t>(signals.blocks()));
  for (std::size_t n = 0; n < out.size(); ++n) {
    const double t = signals.blockTime(static_cast<Eigen::Index>(n));
    const auto here = std::ranges::find_if(segments, [&](const Segment& s) { return t >= s.from && t <= s.to; });
    out[n] = t > signals.startTime + kEnds && t < signals.startTime + signals.duration() - kEnds &&
             here != segments.end() && here->label == MarkLabel::free;
  }
  return out;
}

/// Payload and its deviations of bias and parameters with this covariance.
Payload deviationsOf(const Vector10d& phi, const Matrix10d& covariance) {
  const MatrixXd all = congruence(componentsJacobian(phi), covariance);
  return payloadFromComponents(Vector10d(all.diagonal().cwiseMax(0.0).cwiseSqrt()));
}

}  // namespace

struct WhatIf::Parts {
  std::shared_ptr<const RobotModel> robot;
  Signals signals;
  std::vector<Stretch> stretches;
  Fit rest;          ///< Without faults
  Wrenches told;     ///< valueOf(rest.model)
  MatrixXd columns;  ///< 6N x 16, as they are and whitened
  MatrixXd whitenedColumns;
  Payload std;
  double restSquares = 0.0, needed = 0.0;
  std::vector<Knob> knobs;
  std::vector<Term> terms;          ///< One a knob, off
  std::vector<Eigen::Index> turns;  ///< Which of its parameters the knob turns
  std::vector<VectorXd> prints;     ///< What is left of each at position 1, whitened

  Term turned(std::size_t knob, double position) const {
    Term out = terms[knob];
    out.v(turns[knob]) += position * knobs[knob].full;
    return out;
  }
  Wrenches effectOf(std::vector<Term> faults) const {
    Model model = rest.model;
    model.terms = std::move(faults);
    return valueOf(signals, model) - told;
  }
  VectorXd whitenedOf(const Wrenches& w) const { return whitened(MatrixXd(flat(w)), rest.noise, stretches); }
  /// By how much bias and payload follow a change of the whitened readings.
  VectorXd follow(const VectorXd& change) const { return rest.covariance * transposedProduct(whitenedColumns, change); }
  VectorXd leftOf(const VectorXd& change) const { return change - product(whitenedColumns, follow(change)); }

  void addKnob(const Cause& cause);
  /// The cause among those that are off whose footprint is most like what is `left`, at the size that fits best.
  std::optional<WhatIfState::LookAlike> lookAlikeOf(const VectorXd& left, const std::vector<double>& positions) const;
};

/// The cause's main parameter is the first that says how much of it there is. Where it has that along several axes, in
/// several channels or joints, the one counts that this motion shows best.
void WhatIf::Parts::addKnob(const Cause& cause) {
  std::optional<Parameter> main;
  std::size_t length = 0;
  double most = -1.0;
  Knob best;
  Term off;
  VectorXd print;
  Eigen::Index turn = 0;
  for (const Form& form : cause.forms(signals)) {
    if (form.later || form.walk || form.guide || (main && form.parameters.size() != length)) continue;
    Term start{std::make_shared<const Form>(form), form.start, {}};
    if (form.local) start.v(0) = signals.startTime + 0.5 * signals.duration();
    for (const int p : form.scan) {
      const Parameter& parameter = form.parameters[static_cast<std::size_t>(p)];
      if (!parameter.saysHowMuch || (form.local && p == 0)) continue;
      if (main && (parameter.unit != main->unit || parameter.size != main->size)) continue;
      const double from = start.v(p);
      const double full = parameter.upper > from ? std::min(kReach * parameter.size, parameter.upper - from)
                                                 : std::max(-kReach * parameter.size, parameter.lower - from);
      Term on = start;
      on.v(p) += full;
      const Wrenches effect = effectOf({on});
      if (!effect.allFinite()) continue;
      main = parameter;
      length = form.parameters.size();
      VectorXd left = leftOf(whitenedOf(effect));
      const double squares = left.squaredNorm();
      if (squares <= most) continue;
      most = squares;
      best = {std::string(cause.id()),
              parameter.name,
              parameter.unit,
              std::abs(parameter.scale * full),
              parameter.reported,
              full,
              std::min(kNeverSeen, std::sqrt(needed / std::max(squares, 1e-12)))};
      off = start;
      print = std::move(left);
      turn = p;
    }
  }
  // What no motion shows still has its knob: it moves, and nothing else does.
  if (!main) return;
  knobs.push_back(std::move(best));
  terms.push_back(std::move(off));
  turns.push_back(turn);
  prints.push_back(std::move(print));
}

std::optional<WhatIfState::LookAlike> WhatIf::Parts::lookAlikeOf(const VectorXd& left,
                                                                 const std::vector<double>& positions) const {
  std::vector<WhatIfState::LookAlike> all;
  const double squares = left.squaredNorm();
  const auto fitted = [&](std::size_t k, double position, const VectorXd& print) -> WhatIfState::LookAlike {
    const double own = print.squaredNorm(), common = left.dot(print);
    return {k, position * common / own, common * common / (own * squares)};
  };
  for (std::size_t k = 0; k < knobs.size(); ++k)
    if (positions[k] == 0.0 && prints[k].squaredNorm() > 0.0) all.push_back(fitted(k, 1.0, prints[k]));
  if (all.empty()) return std::nullopt;
  // A footprint changes its form with its size: those that come near are taken once more at the size that fits.
  const auto share = [](const WhatIfState::LookAlike& each) { return each.share; };
  std::ranges::sort(all, std::ranges::greater(), share);
  const std::size_t near = std::min(kLookedAtTwice, all.size());
  for (std::size_t i = 0; i < near; ++i)
    for (int again = 0; again < kRefinements; ++again) {
      const double position = all[i].position;
      if (!(position > 0.0 && position < kFarthest)) break;
      const Wrenches effect = effectOf({turned(all[i].knob, position)});
      if (!effect.allFinite() || effect.isZero(0.0)) break;
      const auto better = fitted(all[i].knob, position, leftOf(whitenedOf(effect)));
      if (!(better.share > all[i].share)) break;
      all[i] = better;
    }
  return *std::ranges::max_element(all, {}, share);
}

WhatIf::WhatIf(std::unique_ptr<Parts> parts) : parts_(std::move(parts)) {}
WhatIf::WhatIf(WhatIf&&) noexcept = default;
WhatIf::~WhatIf() = default;

const std::vector<Knob>& WhatIf::knobs() const { return parts_->knobs; }

Result<WhatIf> WhatIf::make(const Recording& recording, std::shared_ptr<const RobotModel> robot,
                            const std::vector<Segment>& segments, const Progress& progress) {
  if (recording.meta.kind == RecordingKind::poses)
    return Error{heft::say("What a fault would do is shown along a motion, not in standing poses.")};
  MotionOptions options;
  options.cutoffHz = kDefaultCutoffHz;
  auto motion = motionOf(recording, robot.get(), options);
  if (!motion) return motion.error();
  auto parts = std::make_unique<Parts>();
  parts->robot = std::move(robot);
  parts->signals = signalsOf(recording, *std::move(motion), parts->robot.get());
  parts->signals.usable = freeBlocks(parts->signals, segments);
  parts->stretches = stretchesOf(parts->signals.usable);
  if (parts->stretches.empty())
    return Error{heft::say("Too little free motion is left to show what a fault would do.")};
  parts->rest = fitModel(parts->signals, parts->stretches, Model{});
  parts->told = valueOf(parts->signals, parts->rest.model);
  parts->columns = CachedJacobian(parts->signals, parts->rest.model).columns().dense();
  parts->whitenedColumns = whitened(parts->columns, parts->rest.noise, parts->stretches);
  parts->restSquares = parts->whitenedOf(parts->rest.residual).squaredNorm();
  // As much evidence as a verdict asks for, and what one parameter costs at most.
  parts->needed = kThreshold + std::log(std::max(2.0, parts->rest.noise.samples));
  parts->std = deviationsOf(parts->rest.model.x.tail<10>(), parts->rest.covariance.bottomRightCorner<10, 10>());
  const auto& causes = catalogue();
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if (progress.cancelled()) return Error{"", true};
    if (causes[i]->id() != kRandomWalk) parts->addKnob(*causes[i]);
    progress(static_cast<double>(i + 1) / static_cast<double>(causes.size()), "");
  }
  return WhatIf(std::move(parts));
}

WhatIfState WhatIf::at(const std::vector<double>& positions) const {
  const Parts& p = *parts_;
  std::vector<Term> faults;
  for (std::size_t k = 0; k < p.knobs.size(); ++k)
    if (positions[k] != 0.0) faults.push_back(p.turned(k, positions[k]));
  const bool any = !faults.empty();
  WhatIfState out;
  out.effect = any ? p.effectOf(std::move(faults)) : Wrenches(Wrenches::Zero(6, p.signals.blocks()));
  const VectorXd change = p.whitenedOf(out.effect), moves = p.follow(change), left = p.leftOf(change);
  const Vector10d before = p.rest.model.x.tail<10>(), after = before + moves.tail<10>();
  out.left = p.rest.residual + out.effect;
  const VectorXd taken = product(p.columns, moves);
  out.left -= Eigen::Map<const Wrenches>(taken.data(), 6, out.left.cols());
  out.time.resize(out.left.cols());
  for (Eigen::Index n = 0; n < out.time.size(); ++n) out.time(n) = p.signals.blockTime(n);
  const WrenchRms rms = rmsOf(p.stretches, out.left);
  out.force = rms.force;
  out.torque = rms.torque;
  out.payload = fromParameters(after);
  const double wider = std::sqrt(std::max(1.0, p.whitenedOf(out.left).squaredNorm() / p.restSquares));
  out.std = payloadFromComponents(Vector10d(wider * componentsOf(p.std)));
  out.moved = (componentsOf(out.payload) - componentsOf(fromParameters(before)))
                  .cwiseQuotient(componentsOf(p.std).cwiseMax(1e-300));
  const double squares = left.squaredNorm();
  out.seen = squares > p.needed;
  if (out.seen) out.lookAlike = p.lookAlikeOf(left, positions);
  return out;
}

}  // namespace heft
