#include "ui/models/proof_text.h"

#include <QCoreApplication>
#include <QFileInfo>
#include <cmath>
#include <nlohmann/json.hpp>

#include "ui/models/numbers.h"
#include "ui/models/units.h"

namespace heft {
namespace {

using nlohmann::json;

struct ProofWords {
  Q_DECLARE_TR_FUNCTIONS(Proof)
};

constexpr double kSameNumbers = 1e-6;  // Relative: what a file's rounding leaves

/// Sessions are files that anybody may have written.
json at(const json& object, const char* key) { return object.is_object() ? object.value(key, json()) : json(); }

QString textAt(const json& object, const char* key) {
  const json value = at(object, key);
  return value.is_string() ? QString::fromStdString(value.get<std::string>()) : QString();
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

QStringList factsOf(const json& proof, bool passed) {
  QStringList out;
  const QString file = QFileInfo(textAt(at(proof, "recording"), "file")).fileName();
  if (!file.isEmpty()) out << ProofWords::tr("Checked on %1.").arg(file);
  const json left = at(proof, "left_rms"), noise = at(proof, "noise_rms");
  const double force = meanOf(left, "force_n"), torque = meanOf(left, "torque_nm");
  if (std::isfinite(force) && std::isfinite(torque) && force > 0.0)
    out << ProofWords::tr("Left over in free motion: %1 N and %2 N m; the sensor’s own scatter is %3 N and %4 N m.")
               .arg(numberText(force, 3), numberText(torque, 4), numberText(meanOf(noise, "force_n"), 3),
                    numberText(meanOf(noise, "torque_nm"), 4));
  const json seen = at(proof, "would_see");
  const double mass = numberAt(seen, "mass_kg"), centre = numberAt(seen, "com_m");
  if (passed && std::isfinite(mass) && std::isfinite(centre)) {
    const ShownUnit unit = lengthUnit();
    out << ProofWords::tr("An error of %1 or %2 %3 would have shown.")
               .arg(massText(mass, 3), numberText(unit.scale * centre, 1 + unit.decimals), unit.name);
  }
  return out;
}

}  // namespace

std::optional<ProofText> describeProof(const std::string& text, const Payload* now) {
  const json proof = json::parse(text, nullptr, false);
  if (at(proof, "schema") != json("heft.prove/1")) return std::nullopt;
  ProofText out;
  const QString verdict = textAt(proof, "verdict");
  out.passed = verdict == QLatin1String("pass");
  out.headline = out.passed ? ProofWords::tr("PASS: with these numbers taken off, only the sensor’s noise is left.")
                 : verdict == QLatin1String("not_yet") ? ProofWords::tr("NOT YET")
                                                       : ProofWords::tr("NOT YET: this recording is not sufficient.");
  const json reasons = at(proof, "reasons");
  if (reasons.is_array())
    for (const json& reason : reasons) out.reasons.push_back({textAt(reason, "text"), textAt(reason, "remedy")});
  out.facts = factsOf(proof, out.passed);
  const auto of = payloadFromJson(proof, "proof");
  out.outdated = now && (!of || !toParameters(*of).isApprox(toParameters(*now), kSameNumbers));
  return out;
}

}  // namespace heft
