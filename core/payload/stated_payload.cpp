#include "core/payload/stated_payload.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/text.h"

namespace heft {

namespace {

using nlohmann::json;

/// Thinner than this [m] no tool is taken to be: a flat plate's spread has no inverse.
constexpr double kThinnest = 1e-3;

struct Trust {
  double mass, centre, shape;
};

Trust trustIn(Certainty certainty) {
  switch (certainty) {
    case Certainty::rough:
      return {0.20, 0.30, 0.20};
    case Certainty::good:
      return {0.03, 0.10, 0.05};
    case Certainty::exact:
      break;
  }
  return {0.005, 0.02, 0.01};
}

/// Takes `text` as a number from its front; false if none stands there.
bool takeNumber(std::string_view& text, double& value) {
  const auto [next, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) return false;
  text.remove_prefix(static_cast<std::size_t>(next - text.data()));
  return true;
}

bool takeWord(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

}  // namespace

Result<StatedPayload> parseScaleMass(const std::string& text) {
  const auto wrong = [&](const char* what) {
    return Error{fmt::format(
        "A mass from a scale is written KG or KG+-SD, for instance 0.812, 0.812+-0.004 or 0.812+-1%; in '{}' {}.",
        printable(text), what)};
  };
  std::string_view rest = text;
  double mass = 0.0;
  if (!takeNumber(rest, mass)) return wrong("no number stands first");
  if (!(mass > 0.0)) return wrong("the mass is not above zero");
  StatedPayload stated;
  stated.mass = mass;
  stated.source = "the scale";
  if (rest.empty()) return stated;
  double deviation = 0.0;
  if (!takeWord(rest, "+-") && !takeWord(rest, "\u00b1")) return wrong("something else than +- follows the mass");
  if (!takeNumber(rest, deviation)) return wrong("no number follows +-");
  stated.massStd = takeWord(rest, "%") ? 0.01 * deviation : deviation / mass;
  if (!rest.empty()) return wrong("something follows the standard deviation");
  if (!(stated.massStd >= 1e-6 && stated.massStd <= 1.0))
    return wrong("the standard deviation is not between a millionth of the mass and the mass itself");
  return stated;
}

Result<StatedPayload> statedPayloadFromJson(const json& object, const std::string& where) {
  auto partial = partialPayloadFromJson(object, where);
  if (!partial) return partial.error();
  if (partial->empty())
    return Error{fmt::format("{} states neither mass_kg, com_m nor inertia_com_kgm2; at least one is needed.", where)};
  StatedPayload stated;
  stated.source = where;
  stated.mass = partial->mass;
  stated.com = partial->com;
  if (partial->inertiaCom) {
    if (!partial->mass)
      return Error{
          fmt::format("{}: inertia_com_kgm2 needs mass_kg beside it; give that mass the weight 0 if it is not "
                      "to be trusted.",
                      where)};
    const Matrix3d& I = *partial->inertiaCom;
    if (const auto check = checkPhysical({*partial->mass, Vector3d::Zero(), I}); !check.physical)
      return Error{fmt::format("{}: these values are physically impossible: {}", where, check.reason)};
    stated.spread = (0.5 * I.trace() * Matrix3d::Identity() - I) / *partial->mass;
    *stated.spread += kThinnest * kThinnest * Matrix3d::Identity();
  }

  auto certainty = certaintyFromJson(object, where);
  if (!certainty) return certainty.error();
  const Trust trust = trustIn(certainty->value_or(Certainty::rough));
  double weights[3] = {1.0, 1.0, 1.0};
  constexpr const char* kParts[3] = {"mass", "centre", "shape"};
  if (const auto it = object.find("weights"); it != object.end() && !it->is_null()) {
    const auto wrong = [&] {
      return Error{fmt::format(
          "{}: weights must be an object with the numbers mass, centre and shape, each from 0 to 1e6, not {}.", where,
          printable(it->dump()))};
    };
    if (!it->is_object()) return wrong();
    for (const auto& [key, value] : it->items()) {
      const auto part = std::find(std::begin(kParts), std::end(kParts), key);
      if (part == std::end(kParts) || !value.is_number()) return wrong();
      const double weight = value.get<double>();
      if (!(weight >= 0.0 && weight <= 1e6)) return wrong();
      weights[part - std::begin(kParts)] = weight;
    }
  }
  if (weights[0] == 0.0) stated.mass.reset();
  if (weights[1] == 0.0) stated.com.reset();
  if (weights[2] == 0.0) stated.spread.reset();
  if (!stated.mass && !stated.com && !stated.spread)
    return Error{fmt::format("{}: every part that is stated has the weight 0; nothing is left.", where)};
  stated.massStd = trust.mass / std::sqrt(std::max(weights[0], 1e-12));
  stated.centreStd = trust.centre / std::sqrt(std::max(weights[1], 1e-12));
  stated.shapeStd = trust.shape / std::sqrt(std::max(weights[2], 1e-12));
  return stated;
}

}  // namespace heft
