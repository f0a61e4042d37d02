#include "core/simulation/effects/effect.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/text.h"
#include "core/simulation/effects/kinds.h"

namespace heft {

Vector6d Effect::force(const Instant&, double) { return Vector6d::Zero(); }
void Effect::filter(SampledWrench&, double) {}
double Effect::age(double) { return 0.0; }
void Effect::shiftZero(const VectorXd&, SampledWrench&) {}
void Effect::convert(SampledWrench&) {}

void Effect::note(std::string name, const Eigen::Ref<const VectorXd>& values) {
  truth_.parameters.push_back({std::move(name), {values.begin(), values.end()}});
}

const std::vector<EffectKind>& effectKinds() {
  static const std::vector<EffectKind> kinds = [] {
    std::vector<EffectKind> all;
    addGeometryKinds(all);
    addPullKinds(all);
    addDragKinds(all);
    addMassKinds(all);
    addContactKinds(all);
    addGaugeKinds(all);
    addTransportKinds(all);
    addZeroKinds(all);
    addConverterKinds(all);
    addVelocityKinds(all);
    addRowKinds(all);
    addFrameKinds(all);
    return all;
  }();
  return kinds;
}

const EffectKind* findEffectKind(std::string_view id) {
  const auto& kinds = effectKinds();
  const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const EffectKind& kind) { return kind.id == id; });
  return found == kinds.end() ? nullptr : &*found;
}

namespace {

std::string joined(const std::vector<std::string>& words) { return fmt::format("{}", fmt::join(words, ", ")); }

/// An empty string if the request can be met.
std::string whatIsWrong(const EffectRequest& request) {
  const EffectKind* kind = findEffectKind(request.id);
  if (kind == nullptr)
    return fmt::format("There is no effect '{}'; 'heft simulate --list-effects' shows all.", printable(request.id));
  if (!request.form.empty() && std::find(kind->forms.begin(), kind->forms.end(), request.form) == kind->forms.end())
    return fmt::format("The effect {} has no form '{}'; its forms are: {}.", kind->id, printable(request.form),
                       joined(kind->forms));
  if (!std::isfinite(request.size) || std::abs(request.size) > kind->largest || (request.size < 0.0 && !kind->either))
    return fmt::format("The size of the effect {} is {} {}; it can be {:g} to {:g} {}.", kind->id, request.size,
                       kind->unit, kind->either ? -kind->largest : 0.0, kind->largest, kind->unit);
  return {};
}

}  // namespace

Result<EffectRequest> parseEffect(std::string_view text) {
  const std::size_t equals = text.rfind('=');
  if (equals == std::string_view::npos)
    return Error{fmt::format("An effect is ID=SIZE or ID/FORM=SIZE, not '{}'.", printable(text))};
  const std::string_view name = text.substr(0, equals), number = text.substr(equals + 1);
  EffectRequest request;
  const std::size_t slash = name.find('/');
  request.id = name.substr(0, slash);
  if (slash != std::string_view::npos) request.form = name.substr(slash + 1);
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), request.size);
  if (error != std::errc() || end != number.data() + number.size())
    return Error{fmt::format("The size of the effect '{}' is not a number: '{}'.", printable(name), printable(number))};
  if (const std::string wrong = whatIsWrong(request); !wrong.empty()) return Error{wrong};
  return request;
}

Result<Effects> makeEffects(const std::vector<EffectRequest>& requests, std::uint64_t seed, const EffectScene& scene) {
  Effects effects;
  for (const EffectRequest& request : requests)
    if (const std::string wrong = whatIsWrong(request); !wrong.empty()) return Error{wrong};
  const auto& kinds = effectKinds();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    std::uint64_t channel = i << 8;  // a second effect of a kind has a place of its own
    for (const EffectRequest& request : requests) {
      if (request.id != kinds[i].id) continue;
      RandomStream random(seed, RandomPurpose::effect, channel++);
      if (request.size == 0.0) continue;
      const std::string form = request.form.empty() ? kinds[i].forms.front() : request.form;
      auto effect = kinds[i].make({scene, request.size, form, random});
      EffectTruth& truth = effect->truth();
      truth.id = kinds[i].id;
      truth.form = form;
      truth.size = request.size;
      truth.unit = kinds[i].unit;
      effects.push_back(std::move(effect));
    }
  }
  return effects;
}

nlohmann::json toJson(const EffectTruth& truth) {
  nlohmann::json parameters = nlohmann::json::object(), when = nlohmann::json::array();
  for (const EffectParameter& p : truth.parameters) {
    if (p.values.size() == 1) {
      parameters[p.name] = p.values.front();
    } else {
      parameters[p.name] = p.values;
    }
  }
  for (const auto& [from, to] : truth.when) when.push_back({from, to});
  return {{"effect", truth.id}, {"form", truth.form},       {"size", truth.size},
          {"unit", truth.unit}, {"parameters", parameters}, {"when", when}};
}

Vector3d drawDirection(RandomStream& random) {
  Vector3d v;
  do {
    v = {random.normal(), random.normal(), random.normal()};
  } while (v.norm() < 1e-6);
  return v.normalized();
}

Vector3d drawSideways(RandomStream& random, const Vector3d& gravity) {
  const Vector3d up = gravity.norm() > 1e-6 ? Vector3d(-gravity.normalized()) : Vector3d::UnitZ();
  Vector3d flat;
  do {
    flat = drawDirection(random);
    flat -= flat.dot(up) * up;
  } while (flat.norm() < 0.1);
  return (flat.normalized() + random.uniform(-0.5, 0.5) * up).normalized();
}

Vector3d drawToolPoint(RandomStream& random, const Payload& payload, double reach) {
  const double distance = reach * random.uniform(0.3, 1.0);
  return payload.com + distance * drawDirection(random);
}

Vector6d against(const Instant& now, const Vector3d& F_B, const Vector3d& p_SoP_S) {
  const Vector3d F_S = now.motion.X_BS.linear().transpose() * F_B;
  Vector6d wrench;
  wrench << -F_S, -p_SoP_S.cross(F_S);
  return wrench;
}

Vector3d pointPosition(const FrameMotion& motion, const Vector3d& p_SoP_S) { return motion.X_BS * p_SoP_S; }

Vector3d pointVelocity(const FrameMotion& motion, const Vector3d& p_SoP_S) {
  return motion.v_BSo_B + motion.w_BS_B.cross(motion.X_BS.linear() * p_SoP_S);
}

Vector3d middleOf(const EffectScene& scene) {
  Vector3d sum = Vector3d::Zero();
  for (const auto& pose : scene.path) sum += pose.X_BS.translation();
  return scene.path.empty() ? sum : Vector3d(sum / static_cast<double>(scene.path.size()));
}

}  // namespace heft
