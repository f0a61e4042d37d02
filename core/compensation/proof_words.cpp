#include "core/compensation/proof_words.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/base/numbers.h"
#include "core/base/said_again.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {
namespace {

using nlohmann::json;

constexpr double kSameNumbers = 1e-6;  // Relative: what a file's rounding leaves

/// Sessions are files that anybody may have written.
json at(const json& object, const char* key) { return object.is_object() ? object.value(key, json()) : json(); }

std::string textAt(const json& object, const char* key) {
  const json value = at(object, key);
  return value.is_string() ? value.get<std::string>() : std::string();
}

double numberAt(const json& object, const char* key) {
  const json value = at(object, key);
  return value.is_number() ? value.get<double>() : NAN;
}

/// Root mean square over three channels of {"force_n", "torque_nm"}.
double meanOf(const json& six, const char* key) {
  const json three = at(six, key);
  double sum = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
    sum += three.is_array() && i < three.size() && three[i].is_number() ? std::pow(three[i].get<double>(), 2) : NAN;
  return std::sqrt(sum / 3.0);
}

std::string shown(double value, int decimals, const PageUnits::Unit& unit) {
  return sayNumber(unit.scale * value, std::max(0, decimals + unit.decimals)) + " " + unit.name;
}

std::vector<std::string> factsOf(const json& proof, bool passed, const PageUnits& units) {
  std::vector<std::string> out;
  const std::string file = textAt(at(proof, "recording"), "file");
  if (!file.empty())
    out.push_back(heft::say("Checked on {}.", printable(std::filesystem::path(file).filename().string(), 200)));
  const json left = at(proof, "left_rms"), noise = at(proof, "noise_rms");
  const double force = meanOf(left, "force_n"), torque = meanOf(left, "torque_nm");
  if (std::isfinite(force) && std::isfinite(torque) && force > 0.0)
    out.push_back(heft::say("Residual in free motion: {} N and {}; sensor noise: {} N and {}.", sayNumber(force, 3),
                            shown(torque, 4, units.torque), sayNumber(meanOf(noise, "force_n"), 3),
                            shown(meanOf(noise, "torque_nm"), 4, units.torque)));
  const json seen = at(proof, "would_see");
  const double mass = numberAt(seen, "mass_kg"), centre = numberAt(seen, "com_m");
  if (passed && std::isfinite(mass) && std::isfinite(centre))
    out.push_back(heft::say("An error of {} or {} would have been detected.", shown(mass, 3, units.mass),
                            shown(centre, 1, units.length)));
  return out;
}

}  // namespace

std::optional<ProofText> proofText(const json& proof, const Payload* now, const PageUnits& units) {
  if (at(proof, "schema") != json("heft.prove/1")) return std::nullopt;
  ProofText out;
  const std::string verdict = textAt(proof, "verdict");
  out.passed = verdict == "pass";
  out.headline = out.passed             ? heft::say("PASS: with these numbers subtracted, only sensor noise remains.")
                 : verdict == "not_yet" ? heft::say("NOT YET")
                                        : heft::say("NOT YET: this recording is not sufficient.");
  const json reasons = at(proof, "reasons");
  if (reasons.is_array())
    for (const json& reason : reasons) {
      const json said = at(reason, "said");
      out.reasons.push_back({sayFrom(at(said, "text"), sayAgain(textAt(reason, "text"))),
                             sayFrom(at(said, "remedy"), sayAgain(textAt(reason, "remedy")))});
    }
  out.facts = factsOf(proof, out.passed, units);
  const auto of = payloadFromJson(proof, "proof");
  out.outdated = now && (!of || !toParameters(*of).isApprox(toParameters(*now), kSameNumbers));
  return out;
}

}  // namespace heft
