#include "core/diagnosis/verdict/description.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/diagnosis/causes/ids.h"

namespace heft::diagnosis {

namespace {

/// The terms of a cause, events in the order of time.
std::vector<IndexedTerm> termsOf(std::string_view cause, const Model& model) {
  std::vector<IndexedTerm> out = indexedTerms(model);
  std::erase_if(out, [&](const IndexedTerm& p) { return causeOf(*p.term) != cause; });
  std::ranges::stable_sort(out, {}, [](const IndexedTerm& p) { return p.term->form->local ? p.term->v(0) : -1e300; });
  return out;
}

/// `event`: which of the cause's events it is, from 1 on; its names end so from the second one on. Other names end like
/// that where they were taken.
void describeTerm(DiagnosedCause& cause, const Term& term, int event, VectorXd deviation, const Signals& signals) {
  std::vector<CauseParameter>& out = cause.parameters;
  // When something happened is not known better than to a part of a sample, whatever a smooth step says.
  if (term.form->local) deviation(0) = std::hypot(deviation(0), 0.25 / signals.rateHz);
  for (Eigen::Index p = 0; p < term.v.size(); ++p) {
    if (!term.moves(p)) continue;
    const Parameter& parameter = term.form->parameters[static_cast<std::size_t>(p)];
    // A step shorter than the blocks show: how long it takes is less than usual, and no more is known.
    if (parameter.lowerIsFine && term.v(p) <= parameter.lower) deviation(p) = std::min(deviation(p), parameter.size);
    std::string name = event > 1 ? fmt::format("{}_{}", parameter.name, event) : parameter.name;
    for (int i = 2; findParameter(out, name); ++i) name = fmt::format("{}_{}", parameter.name, i);
    const auto told = [&](double value) {
      return parameter.reported != nullptr ? parameter.reported(value) : value * parameter.scale;
    };
    const double little = 1e-3 * parameter.size;
    const double slope = std::abs(told(term.v(p) + little) - told(term.v(p) - little)) / (2.0 * little);
    out.push_back({name, parameter.unit, told(term.v(p)), deviation(p) * slope});
  }
  for (const auto& stretch : term.form->cause->when(*term.form, term.v, signals)) cause.when.push_back(stretch);
}

/// How far the parameter `at` (in Model::packed()) may move, on average of either way, before the judged blocks notice:
/// of what changes between two samples, or where nothing is judged, derivatives say nothing. Half a block at least.
double unnoticed(const Fit& fit, Eigen::Index at, const Parameter& parameter, const Signals& signals,
                 const std::vector<Stretch>& stretches) {
  constexpr int kMostHalfBlocks = 100;
  const double step = 0.5 / signals.blockRate();
  const VectorXd packed = fit.model.packed();
  const Wrenches value = valueOf(signals, fit.model);
  Model model = fit.model;
  double sum = 0.0, candidates = 0.0;
  for (const double candidate : {-step, step})
    for (int k = 1; k <= kMostHalfBlocks; ++k) {
      VectorXd moved = packed;
      moved(at) += k * candidate;
      if (moved(at) < parameter.lower || moved(at) > parameter.upper) break;
      model.unpack(moved);
      const Wrenches change = valueOf(signals, model) - value;
      if (k < kMostHalfBlocks && whitened(flat(change), fit.noise, stretches).squaredNorm() < 1.0) continue;
      sum += (k - 0.5) * step;
      candidates += 1.0;
      break;
    }
  return candidates > 0.0 ? std::max(step, sum / candidates) : parameter.size;
}

}  // namespace

void describe(DiagnosedCause& cause, const Fit& fit, const VectorXd& spread, const Signals& signals,
              const std::vector<Stretch>& stretches) {
  const VectorXd std = fit.std();
  int events = 0;
  for (const auto& [term, at] : termsOf(cause.id, fit.model)) {
    VectorXd deviation = std.segment(at, term->v.size());
    for (Eigen::Index p = 0; term->form->atOnce && p < deviation.size(); ++p)
      if (!isAmplitude(*term->form, p) && deviation(p) * signals.blockRate() > 1.0)
        deviation(p) =
            std::min(deviation(p),
                     unnoticed(fit, at + p, term->form->parameters[static_cast<std::size_t>(p)], signals, stretches));
    for (const VectorXd& more : {term->form->cause->modelStd(*term->form, term->v), spread})
      if (more.size() == deviation.size()) deviation = (deviation.cwiseAbs2() + more.cwiseAbs2()).cwiseSqrt();
    if (term->form->local) ++events;
    describeTerm(cause, *term, term->form->local ? events : 0, std::move(deviation), signals);
  }
}

DiagnosedCause fromDirect(const Direct& direct) {
  DiagnosedCause out;
  out.id = direct.cause;
  for (const auto& p : direct.parameters) out.parameters.push_back({p.name, p.unit, p.value, p.std});
  out.when = direct.when;
  out.direct = true;
  out.ofVelocities = direct.ofVelocities;
  out.pValue = direct.pValue;
  out.alternatives = direct.alternatives;
  return out;
}

namespace {

void setGain(DiagnosedCause& cause, const WrenchRms& before, const WrenchRms& after) {
  cause.gain.forceBefore = before.force;
  cause.gain.forceAfter = after.force;
  cause.gain.torqueBefore = before.torque;
  cause.gain.torqueAfter = after.torque;
  cause.gain.explainedFraction = 1.0 - std::pow(after.force / std::max(1e-12, before.force), 2);
}

}  // namespace

DiagnosedCause fromMistake(const FrameMistake& mistake, const WrenchRms& before, const WrenchRms& after) {
  using conventions::Change;
  DiagnosedCause out;
  constexpr double kDegrees = 180.0 / 3.14159265358979323846;
  // A half turn is a mix-up of frames; anything else is how somebody bolted the sensor on.
  const bool turned = mistake.only(Change::turned),
             mount = turned && std::abs(vectorFromRotation(mistake.turn()).norm() * kDegrees - 180.0) > 4.0;
  out.id = mount ? ids::sensorRotation : ids::frameError;
  out.ofMistake = true;
  out.direct = true;
  if (turned) {
    constexpr double kKnown = 0.1;  // [deg] Whatever the fit says
    const Vector3d v = vectorFromRotation(mistake.turn()) * kDegrees;
    for (Eigen::Index i = 0; i < 3; ++i)
      out.parameters.push_back(
          {std::string("r") + "xyz"[i], "deg", v(i), std::hypot(mistake.turnStd(i) * kDegrees, kKnown)});
    out.alternatives = {std::string(mount ? ids::frameError : ids::sensorRotation)};
  }
  if (mistake.only(Change::gravityTurned)) out.alternatives = {std::string(ids::gravityTilt)};
  setGain(out, before, after);
  return out;
}

DiagnosedCause fromNoisyMotion(const NoisyMotion& noisy) {
  DiagnosedCause out;
  out.id = ids::derivativeNoise;
  out.direct = true;
  out.parameters = {{"force_noise", "N", noisy.usual.force, std::max(noisy.smoothed.force, 0.05 * noisy.usual.force)},
                    {"corner", "Hz", noisy.cutoffHz, 0.0}};
  setGain(out, noisy.usual, noisy.smoothed);
  return out;
}

namespace {

double chanceOf(double evidence) { return std::exp(-0.5 * std::min(1000.0, evidence)); }

}  // namespace

DiagnosedCause fromRinging(const Ringing& ringing) {
  DiagnosedCause out;
  out.id = ids::flexibleMount;
  out.direct = true;
  out.parameters = {{"frequency", "Hz", ringing.frequencyHz, ringing.frequencyStd},
                    {"damping", "", ringing.damping, ringing.dampingStd}};
  if (ringing.struck) out.parameters.push_back({"strikes", "", static_cast<double>(ringing.when.size()), 0.0});
  out.when = ringing.when;
  out.deltaBic = ringing.evidence;
  out.pValue = chanceOf(out.deltaBic);
  return out;
}

DiagnosedCause fromCarriedLoad(const CarriedLoad& carried) {
  DiagnosedCause out;
  out.id = ids::payloadChange;
  out.direct = true;
  out.parameters = {{"mass", "g", 1e3 * carried.mass, 1e3 * carried.massStd}};
  out.when = carried.when;
  out.deltaBic = carried.evidence;
  out.pValue = chanceOf(out.deltaBic);
  return out;
}

DiagnosedCause fromContacts(const std::vector<Contact>& contacts, const Wrenches& left,
                            const std::string& contactAlternative, double noise) {
  DiagnosedCause out;
  out.id = ids::contact;
  double peak = 0.0;
  for (const auto& contact : contacts) {
    out.when.push_back({contact.from, contact.to});
    const auto& [from, to] = contact.blocks;
    const Eigen::Index width = std::min<Eigen::Index>(3, to - from);
    for (Eigen::Index n = from; n + width <= to; ++n)
      peak = std::max(peak, left.middleCols(n, width).topRows<3>().rowwise().mean().norm());
    out.deltaBic += contact.evidence;
  }
  out.parameters = {{"peak_force", "N", peak, noise}};
  out.pValue = chanceOf(out.deltaBic);
  out.direct = true;
  if (!contactAlternative.empty()) out.alternatives = {contactAlternative};
  return out;
}

}  // namespace heft::diagnosis
