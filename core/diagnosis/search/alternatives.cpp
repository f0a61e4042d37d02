#include "core/diagnosis/search/alternatives.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"

namespace heft::diagnosis {

namespace {

/// First parameter of the terms of `cause`, together.
double firstOf(const Fit& fit, std::string_view cause) {
  double out = 0.0;
  for (const auto& term : fit.model.terms)
    if (causeOf(term) == cause) out += term.v(0);
  return out;
}

/// Of the payload's mass, how much may swing as far as anybody knows.
double swingingShare(const Fit& fit, const Found& found) {
  const double more = found.spread.size() > 0 ? found.spread(0) : 0.0;
  return (firstOf(fit, found.cause) + more) / std::max(0.02, fit.model.x(6));
}

/// The force of a pull, `cause`, that acts at the payload's centre of mass, or closer to it than `near` [m]; none if
/// there is no such pull.
std::optional<Vector3d> pullAtCentre(const Fit& fit, std::string_view cause, double near) {
  const Vector3d com = fit.model.x.segment<3>(7) / std::max(0.02, fit.model.x(6));
  for (const Term& term : fit.model.terms) {
    if (causeOf(term) != cause || term.form->local) continue;
    const auto vectorFrom = [&](const char* first) -> std::optional<Vector3d> {
      const auto& all = term.form->parameters;
      const auto found = std::ranges::find(all, first, &Parameter::name);
      if (found == all.end()) return std::nullopt;
      return term.v.segment<3>(found - all.begin());
    };
    auto place = vectorFrom("at_x"), force = vectorFrom("force_x");
    if (place && force && (*place - com).norm() < near) return force;
  }
  return std::nullopt;
}

/// Whether a pull acts up or down where the tool's weight does: then gravity may be another than stated, or be taken
/// out of the readings already, which no motion can tell from it. One that acts across gravity, too, is both.
bool pullsAsWeightDoes(const Fit& fit, const Vector3d& gravity) {
  const auto near = pullAtCentre(fit, ids::constantPull, 2.0 * kSamePlace);
  return (near && near->cross(gravity).norm() < kFormError * near->norm() * gravity.norm()) ||
         (near && std::abs(near->dot(gravity)) > kSmallShare * near->norm() * gravity.norm());
}

/// Whether it acts across gravity there: then the base may be tilted, which no motion can tell from it either, or give
/// under the arm as it reaches out, as no cable does that is tied to the tool anywhere else.
bool pullsAsTiltDoes(const Fit& fit, std::string_view cause, const Vector3d& gravity) {
  const auto force = pullAtCentre(fit, cause, 2.0 * kSamePlace);
  if (!force) return false;
  const double size = force->norm() * gravity.norm();
  return std::abs(force->dot(gravity)) < kSmallShare * size ||
         (cause == ids::constantPull && force->cross(gravity).norm() > kFormError * size);
}

/// What the scanned parameters of each term of `cause`, whose first one is a time, come to over what is realistic, in
/// the order of time.
std::vector<VectorXd> eventsOf(const Fit& fit, std::string_view cause) {
  std::vector<std::pair<double, VectorXd>> all;
  for (const Term& term : fit.model.terms) {
    if (causeOf(term) != cause) continue;
    VectorXd size(std::ssize(term.form->scan));
    for (Eigen::Index i = 0; i < size.size(); ++i) {
      const int p = term.form->scan[static_cast<std::size_t>(i)];
      size(i) = term.v(p) / term.form->parameters[static_cast<std::size_t>(p)].size;
    }
    all.emplace_back(term.v(0), std::move(size));
  }
  std::ranges::stable_sort(all, {}, [](const auto& event) { return event.first; });
  std::vector<VectorXd> out;
  for (auto& event : all) out.push_back(std::move(event.second));
  return out;
}

/// Whether events one after the other take back what they did: so does whoever touches the tool and lets go, and a part
/// that slides to and fro.
bool comesBack(const std::vector<VectorXd>& events) {
  for (std::size_t i = 0; i < events.size(); ++i) {
    VectorXd all = events[i];
    double largest = all.norm();
    for (std::size_t j = i + 1; j < events.size(); ++j) {
      all += events[j];
      largest = std::max(largest, events[j].norm());
      if (all.norm() < kMinorShare * largest) return true;
    }
  }
  return false;
}

/// Whether the load only ever moves on the tool, and back: nothing was picked up or put down.
bool slidesBack(const Fit& fit) {
  auto events = eventsOf(fit, ids::payloadChange);
  const bool moves = std::ranges::all_of(fit.model.terms, [&](const Term& term) {
    return causeOf(term) != ids::payloadChange ||
           std::abs(term.v(1)) * kGrip < kMinorShare * term.v.segment<3>(2).norm();
  });
  for (VectorXd& event : events) event(0) = 0.0;  // Its mass: noise beside how far it moves
  return moves && comesBack(events);
}

}  // namespace

std::vector<std::string> alternativesOf(const Found& found, const Fit& fit, bool held, const Vector3d& gravity) {
  std::vector<std::string> out;
  const auto has = [&](std::string_view id) { return std::ranges::find(out, id) != out.end(); };
  const auto add = [&](std::string_view id) {
    if (id != found.cause && !has(id)) out.emplace_back(id);
  };
  // To whoever mends the rig a wandering zero is one that drifts.
  for (const auto& rival : found.rivals) add(rival.cause == kRandomWalk ? ids::biasDrift : rival.cause);
  // A jump is a drift that took no time.
  if (found.cause == ids::sensorBias || has(ids::sensorBias)) add(ids::biasDrift);
  if (found.cause == ids::sensorBias && comesBack(eventsOf(fit, found.cause))) add(ids::contact);
  if (found.cause == ids::payloadChange && slidesBack(fit)) add(ids::looseMass);
  // No reading comes before what it is about: then the motion is late.
  if (found.cause == ids::timeOffset && firstOf(fit, found.cause) < 0.0) add(ids::motionLag);
  // What weighs as much as the tool is the tool on its mount.
  if (found.cause == ids::looseMass && swingingShare(fit, found) > kMajority) add(ids::flexibleMount);
  if (found.cause == ids::constantPull && pullsAsWeightDoes(fit, gravity)) add(ids::derivativeNoise);
  if ((found.cause == ids::constantPull || found.cause == ids::cablePull) && pullsAsTiltDoes(fit, found.cause, gravity))
    add(ids::gravityTilt);
  // What is held until the next reading comes late and cut down at once.
  if (held && found.cause == ids::timeOffset) add(ids::lowPassLag);
  if (held && found.cause == ids::lowPassLag) add(ids::timeOffset);
  return out;
}

}  // namespace heft::diagnosis
