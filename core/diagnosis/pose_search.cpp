#include "core/diagnosis/pose_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/math/linear_algebra.h"

namespace heft::diagnosis {

namespace {

/// Everything that poses may show.
std::vector<Suspect> suspectsFor(const PosesSeen& poses, const std::vector<std::string>& hidden) {
  constexpr std::pair<const char*, bool> kForms[] = {
      {"sensor_rotation", false}, {"gravity_tilt", false}, {"constant_pull", false}, {"cable_pull", false},
      {"gain_error", true},       {"crosstalk", true},     {"joint_offset", true}};
  std::vector<Suspect> out;
  const auto isHidden = [&](std::string_view id) { return std::ranges::find(hidden, id) != hidden.end(); };
  const auto price = [&](std::size_t from) {
    const auto count = static_cast<double>(out.size() - from);
    for (std::size_t i = from; i < out.size(); ++i) out[i].price = 2.0 * std::log(count);
  };
  for (const auto& [id, several] : kForms) {
    if (isHidden(id)) continue;
    const std::size_t from = out.size();
    const std::vector<Form> forms = findCause(id)->forms(poses.signals);
    for (const Form& form : forms) {
      // The simple ones: a spring towards one spot, one channel's gain, one joint's zero.
      const bool simple =
          !form.local && !form.later && !form.guide && !form.rare &&
          (several ? form.parameters.size() == 1 && form.name != "all forces" : &form == &forms.front());
      if (!simple || (form.cause->id() == "cable_pull" && !poses.signals.positionKnown)) continue;
      out.push_back({id, std::make_shared<const Form>(form), {}});
    }
    price(from);
  }
  constexpr auto kBeside = static_cast<Eigen::Index>(kAgainAndAgain);  // Poses on either side of a change
  if (!isHidden("bias_drift")) out.push_back({"bias_drift", nullptr, {Course::drift, 0, {}}});
  for (const auto& [id, course] : {std::pair{"sensor_bias", Course::jump}, {"payload_change", Course::load}}) {
    if (isHidden(id)) continue;
    const std::size_t from = out.size();
    for (Eigen::Index k = kBeside; k + kBeside <= poses.count(); ++k) out.push_back({id, nullptr, {course, k, {}}});
    price(from);
  }
  return out;
}

struct PoseTrial {
  const Suspect* candidate;
  double promise = 0.0;
  std::optional<PoseFit> fit;
  double gain = 0.0, plain = 0.0;  ///< Evidence with prices, and without
};

/// The few candidates that promise most beside `base`, fitted, best first.
std::vector<PoseTrial> trialsBeside(const PosesSeen& poses, const PoseFit& base,
                                    const std::vector<Suspect>& candidates) {
  constexpr std::size_t kTried = 14, kOfOne = 3;
  const VectorXd scale = scalesOf(base), r = scale.cwiseProduct(flat(base.residual));
  const MatrixXd Q = orthonormal(base.jacobian);
  const double n = static_cast<double>(r.size()), all = r.squaredNorm();
  std::vector<PoseTrial> out;
  for (const Suspect& candidate : candidates) {
    const bool known = std::ranges::any_of(base.state.terms, [&](const auto& term) {
      return term.first.cause == candidate.cause && (candidate.form == nullptr || term.first.form == candidate.form);
    });
    if (known) continue;
    PoseState with = base.state;
    with.add(candidate);
    MatrixXd C = scale.asDiagonal() * jacobianOf(poses, with).rightCols(candidate.size());
    const VectorXd norms = C.colwise().norm().transpose();
    C -= Q * (Q.transpose() * C);
    // What mass, centre and zero do as well, nobody sees.
    if (!((C.colwise().norm().transpose() - 1e-4 * norms).maxCoeff() > 0.0)) continue;
    const double left = (r - C * solved(C, r)).squaredNorm();
    const double promise = n * std::log(all / std::max(1e-12 * all, left)) -
                           static_cast<double>(candidate.size()) * std::log(n) - candidate.price;
    out.push_back({&candidate, promise, {}});
  }
  std::ranges::sort(out, std::greater{}, &PoseTrial::promise);
  std::map<std::string, std::size_t> tried;
  std::erase_if(out, [&](const PoseTrial& trial) { return tried[trial.candidate->cause]++ >= kOfOne; });
  if (out.size() > kTried) out.resize(kTried);
  for (PoseTrial& trial : out) {
    PoseState with = base.state;
    with.add(*trial.candidate);
    trial.fit = fitted(poses, std::move(with));
    // What is fitted leaves fewer numbers to judge by: that counts where the poses are few.
    const double numbers = static_cast<double>(trial.candidate->size()),
                 left = std::max(1.0, n - static_cast<double>(trial.fit->state.size()));
    trial.plain = left / n * (trial.fit->evidence - base.evidence + numbers * std::log(n));
    trial.gain = trial.plain - numbers * std::log(n) - trial.candidate->price;
  }
  std::ranges::sort(out, std::greater{}, &PoseTrial::gain);
  return out;
}

bool isBelievable(const PoseFit& fit) {
  for (const auto& [candidate, v] : fit.state.terms)
    for (Eigen::Index p = 0; candidate.form && p < v.size(); ++p) {
      const Parameter& parameter = candidate.form->parameters[static_cast<std::size_t>(p)];
      if (!(v(p) > parameter.lower && v(p) < parameter.upper)) return false;
    }
  return fit.state.model.x(6) > 0.0;
}

}  // namespace

PoseSearch searchPoses(const PosesSeen& poses, const std::vector<std::string>& hidden, const Progress& progress) {
  constexpr double kTied = 6.0;  // Strong, by Kass and Raftery (1995)
  PoseSearch out;
  out.candidates = suspectsFor(poses, hidden);
  out.null = fitted(poses, PoseState{});
  out.fit = out.null;
  while (std::ssize(out.named) < kOverfitted - 1 && !progress.cancelled() &&
         out.fit.state.size() + 8 < 3 * poses.count()) {
    auto trials = trialsBeside(poses, out.fit, out.candidates);
    std::erase_if(trials, [](const PoseTrial& trial) { return !isBelievable(*trial.fit); });
    if (trials.empty() || trials.front().gain < kNeededOfPoses) break;
    const PoseTrial& best = trials.front();
    NamedSuspect next{*best.candidate, best.gain, {}};
    for (const PoseTrial& other : trials) {
      const std::string& id = other.candidate->cause;
      // More numbers always fit as well; as many or fewer say that the poses do not tell.
      const bool ties = best.gain - other.gain < kTied || best.plain - other.plain < kTied;
      if (id != next.candidate.cause && ties && std::ranges::find(next.alternatives, id) == next.alternatives.end())
        next.alternatives.push_back(id);
    }
    out.named.push_back(std::move(next));
    out.fit = *best.fit;
  }
  return out;
}

std::vector<bool> badPoses(const PosesSeen& poses, PoseFit& fit) {
  constexpr double kChance = 1e-4;  // Of one in a whole recording by chance
  constexpr int kRounds = 5;
  const Eigen::Index K = poses.count();
  // The median of |e|^2 of three normal numbers is 2.366.
  const auto scale = [&](bool torque) {
    std::vector<double> squares;
    for (Eigen::Index k = 0; k < K; ++k)
      squares.push_back((torque ? fit.residual.col(k).tail<3>() : fit.residual.col(k).head<3>()).squaredNorm());
    std::ranges::nth_element(squares, squares.begin() + K / 2);
    return std::max(1e-6, std::sqrt(squares[static_cast<std::size_t>(K / 2)] / 2.366));
  };
  double force = scale(false), torque = scale(true);
  std::vector<bool> bad(static_cast<std::size_t>(K), false);
  for (int round = 0; round < kRounds; ++round) {
    VectorXd used = VectorXd::Ones(K);
    for (Eigen::Index k = 0; k < K; ++k) {
      const double x = fit.residual.col(k).head<3>().squaredNorm() / (force * force) +
                       fit.residual.col(k).tail<3>().squaredNorm() / (torque * torque);
      // Of six normal numbers.
      if (static_cast<double>(K) * std::exp(-0.5 * x) * (1.0 + 0.5 * x + 0.125 * x * x) < kChance) used(k) = 0.0;
    }
    // Where more than a third does not fit, nobody knows which poses are bad.
    if (3.0 * used.sum() < 2.0 * static_cast<double>(K)) used.setOnes();
    std::vector<bool> now;
    for (Eigen::Index k = 0; k < K; ++k) now.push_back(used(k) == 0.0);
    fit = fitted(poses, fit.state, used);
    force = fit.force;
    torque = fit.torque;
    if (round > 0 && now == bad) break;
    bad = std::move(now);
  }
  return bad;
}

}  // namespace heft::diagnosis
