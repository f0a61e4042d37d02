#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/said_again.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/compensation/proof.h"
#include "core/estimation/uncertainty.h"

namespace heft {

namespace {

nlohmann::json six(const Vector6d& v) { return {{"force_n", {v(0), v(1), v(2)}}, {"torque_nm", {v(3), v(4), v(5)}}}; }

double meanOf(const Vector6d& channels, int first) { return std::sqrt(channels.segment(first, 3).cwiseAbs2().mean()); }

}  // namespace

nlohmann::json toJson(const Proof& proof) {
  const nlohmann::json own = toJson(proof.own);
  auto reasons = nlohmann::json::array();
  for (const auto& f : proof.reasons) {
    reasons.push_back({{"code", f.code}, {"text", f.text}, {"remedy", f.remedy}});
    // A session may be opened in another language.
    const nlohmann::json text = makingOf(f.text), remedy = makingOf(f.remedy);
    if (!text.is_null() || !remedy.is_null()) reasons.back()["said"] = {{"text", text}, {"remedy", remedy}};
  }
  const auto off = toJson(payloadFromComponents(proof.off)), std = toJson(payloadFromComponents(proof.offStd));
  return {{"schema", "heft.prove/1"},
          {"verdict", toString(proof.verdict)},
          {"passed", proof.verdict == ProofVerdict::pass},
          {"reasons", reasons},
          {"payload_file", proof.entered.file},
          {"payload", toJson(proof.entered.payload)},
          {"std", toJson(proof.entered.std)},
          {"recording", own["recording"]},
          {"own_payload", own["payload"]},
          {"own_trust", own["trust"]},
          {"off", off},
          {"off_std", std},
          {"chi2", {{"mass_and_centre", proof.massCentreChi2}, {"inertia", proof.inertiaChi2}}},
          {"would_see", {{"mass_kg", proof.smallestMass}, {"com_m", proof.smallestCentre}}},
          {"bias", six(proof.bias)},
          {"left_rms", six(proof.left)},
          {"noise_rms", six(proof.noise)},
          {"segments", own["segments"]},
          {"findings", own["findings"]}};
}

std::string toText(const Proof& proof) {
  std::string text;
  switch (proof.verdict) {
    case ProofVerdict::pass:
      text = heft::say("PASS. With this payload subtracted, only sensor noise remains.");
      break;
    case ProofVerdict::notYet:
      text = heft::say("NOT YET.");
      break;
    case ProofVerdict::cannotTell:
      text = heft::say("NOT YET. This recording is not sufficient.");
      break;
  }
  text += "\n\n";
  for (const auto& reason : proof.reasons) text += "  " + reason.text + "\n    " + reason.remedy + "\n";
  if (!proof.reasons.empty()) text += "\n";
  text += fmt::format("  Entered: {:.3f} kg ({})\n", proof.entered.payload.mass, printable(proof.entered.file, 200));
  if (proof.own.trust == Trust::none) return text;
  text += fmt::format("  This recording by itself: {:.3f} +- {:.2g} kg, {:.1f} s used\n", proof.own.payload.mass,
                      1.96 * proof.own.std.mass, proof.own.usedDuration);
  text += fmt::format("  Residual in free motion: {:.3f} N and {:.4f} N m; sensor noise: {:.3f} N and {:.4f} N m\n",
                      meanOf(proof.left, 0), meanOf(proof.left, 3), meanOf(proof.noise, 0), meanOf(proof.noise, 3));
  if (proof.verdict != ProofVerdict::cannotTell)
    text += fmt::format("  An error of {:.3f} kg or {:.1f} mm would be detected.\n", proof.smallestMass,
                        1e3 * proof.smallestCentre);
  return text;
}

}  // namespace heft
