#include "core/diagnosis/report/report.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/say.h"
#include "core/diagnosis/correction/check_on_other.h"
#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/correction/model_json.h"
#include "core/diagnosis/wording/words.h"
#include "core/estimation/uncertainty.h"
#include "core/recording/meta_file.h"

namespace heft {

using nlohmann::json;

namespace {

/// JSON knows no infinity.
json number(double value) { return std::isfinite(value) ? json(value) : json(nullptr); }

json listOf(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

json payloadJson(const EstimateReport& report) {
  json out = toJson(report.payload);
  out["std"] = toJson(report.std);
  out["interval95"] = toJson(report)["interval95"];
  out["physically_consistent"] = report.physicallyConsistent;
  return out;
}

json jsonOf(const DiagnosedCause& cause) {
  json parameters = json::object(), when = json::array();
  for (const auto& p : cause.parameters)
    parameters[p.name] = {{"value", number(p.value)}, {"std", number(p.std)}, {"unit", p.unit}};
  for (const auto& [from, to] : cause.when) when.push_back({from, to});
  const auto& g = cause.gain;
  return {{"cause", cause.id},
          {"title", cause.title},
          {"text", cause.sentence},
          {"check", cause.check},
          {"direct", cause.direct},
          {"parameters", parameters},
          {"when", when},
          {"evidence", {{"delta_bic", number(cause.deltaBic)}, {"p_value", number(cause.pValue)}}},
          {"gain",
           {{"force_rms_before_n", g.forceBefore},
            {"force_rms_after_n", g.forceAfter},
            {"torque_rms_before_nm", g.torqueBefore},
            {"torque_rms_after_nm", g.torqueAfter},
            {"explained_fraction", g.explainedFraction},
            {"explained_interval95", {g.lower, g.upper}},
            {"blocks_better", g.blocksBetter},
            {"blocks", g.blocks}}},
          {"alternatives", cause.alternatives},
          {"tell_apart", cause.tellApart}};
}

std::string payloadLine(const EstimateReport& report) {
  const auto& p = report.payload;
  return fmt::format("{:.4f} ± {:.4f} kg, centre of mass ({:.1f}, {:.1f}, {:.1f}) mm{}", p.mass, 1.96 * report.std.mass,
                     p.com.x() * 1e3, p.com.y() * 1e3, p.com.z() * 1e3,
                     report.trust == Trust::none ? " (not reliable)" : "");
}

}  // namespace

nlohmann::json toJson(const DiagnosisReport& report) {
  json causes = json::array(), smallest = json::array(), findings = json::array();
  for (const auto& cause : report.causes) causes.push_back(jsonOf(cause));
  for (const auto& s : report.smallest)
    if (std::isfinite(s.value))
      smallest.push_back({{"cause", s.cause}, {"parameter", s.parameter}, {"value", s.value}, {"unit", s.unit}});
    else
      smallest.push_back({{"cause", s.cause}, {"parameter", s.parameter}, {"value", nullptr}, {"unit", s.unit}});
  for (const auto& finding : report.findings) {
    json f = {{"severity", toString(finding.severity)}, {"code", finding.code}, {"text", finding.text}};
    if (!finding.remedy.empty()) f["remedy"] = finding.remedy;
    findings.push_back(f);
  }
  const Vector10d moved = payloadShift(report);
  json out = {
      {"schema", "heft.diagnose/1"},
      {"file", report.file},
      {"verdict", toString(report.verdict)},
      {"text", report.sentence},
      {"baseline",
       {{"force_rms_n", report.baseline.force},
        {"torque_rms_nm", report.baseline.torque},
        {"noise_force_rms_n", report.noise.force},
        {"noise_torque_rms_nm", report.noise.torque}}},
      {"causes", causes},
      {"remaining",
       {{"goes_with", report.remaining.goesWith.english()},
        {"delta_bic", number(report.remaining.gain)},
        {"share", report.remaining.share}}},
      {"threshold", report.threshold},
      {"surrogates", report.surrogates},
      {"payload_before", payloadJson(report.before)},
      {"payload_after", payloadJson(report.after)},
      {"payload_shift_sigmas",
       {{"mass", moved(0)},
        {"com", {moved(1), moved(2), moved(3)}},
        {"inertia", {moved(4), moved(5), moved(6), moved(7), moved(8), moved(9)}}}},
      {"smallest_visible", smallest},
      {"meta_changes", report.metaChanges()},
      {"sensor_mount", toJson(report.meta.mount)},
      {"gravity_m_s2", listOf(report.meta.gravity)},
      {"sensor_noise",
       {{"force_n", listOf(report.after.noiseStd.head<3>())}, {"torque_nm", listOf(report.after.noiseStd.tail<3>())}}},
      {"model", modelToJson(report.model)},
      {"timing_s", {{"total", report.seconds}}},
      {"findings", findings}};
  if (report.mistake) out["frame_mistake"] = mistakeToJson(*report.mistake, report.meta, !report.ofPoses);
  if (report.check)
    out["check"] = {{"file", report.check->file},
                    {"force_rms_before_n", report.check->before.force},
                    {"force_rms_after_n", report.check->after.force},
                    {"torque_rms_before_nm", report.check->before.torque},
                    {"torque_rms_after_nm", report.check->after.torque},
                    {"delta_bic", report.check->gain},
                    {"holds", report.check->holds()},
                    {"checked", report.check->checked},
                    {"of_one_moment", report.check->ofOneMoment},
                    {"sentence", checkText(*report.check)}};
  return out;
}

Vector10d payloadShift(const DiagnosisReport& report) {
  const Vector10d moved = (componentsOf(report.after.payload) - componentsOf(report.before.payload)).cwiseAbs(),
                  std = componentsOf(report.before.std);
  return (std.array() > 0.0).select(moved.array() / std.array().max(1e-300), 0.0);
}

std::string unknownText(const DiagnosisReport& report) {
  if (report.verdict != Verdict::unexplained) return {};
  const std::string related = report.remaining.goesWith.words();
  return report.remaining.share > 0.0
             ? heft::say(
                   "{:.1f} % of the remaining difference is related to {}; no cause in the catalogue accounts for "
                   "it.",
                   100.0 * report.remaining.share, related)
             : heft::say("The remaining difference is related to {}; no cause in the catalogue accounts for it.",
                         related);
}

namespace {

/// The other readings that fit, and the payload to each.
std::string tiesText(const diagnosis::FrameMistake& mistake) {
  std::string out;
  for (const auto& tie : mistake.ties)
    out += fmt::format("   Fits equally well: {} Payload {:.4g} kg, centre of mass ({:.1f}, {:.1f}, {:.1f}) mm\n",
                       tie.sentence, tie.payload.mass, tie.payload.com.x() * 1e3, tie.payload.com.y() * 1e3,
                       tie.payload.com.z() * 1e3);
  return out;
}

}  // namespace

std::string toText(const DiagnosisReport& report) {
  std::string out = report.sentence + "\n\n";
  out +=
      fmt::format("Misfit of the plain model  {:.3f} N  {:.4f} N m\nNoise floor                {:.3f} N  {:.4f} N m\n",
                  report.baseline.force, report.baseline.torque, report.noise.force, report.noise.torque);
  int number = 0;
  for (const auto& cause : report.causes) {
    // Some titles hold the term already: "Coarse readings (quantisation)"
    const std::string term = fmt::format(" ({})", cause.id);
    out += fmt::format("\n{}. {}{}\n   {}\n", ++number, cause.title,
                       std::string_view(cause.title).ends_with(term) ? "" : term, cause.sentence);
    for (const auto& p : cause.parameters)
      out += p.std > 0.0 ? fmt::format("   {:<18} {}\n", p.name, parameterWords(p))
                         : fmt::format("   {:<18} {:.4g} {}\n", p.name, p.value, p.unit);
    for (const auto& [from, to] : cause.when) out += fmt::format("   from {:.2f} to {:.2f} s\n", from, to);
    if (cause.gain.blocks > 0)
      out += fmt::format("   Held-out segments: {:.3f} -> {:.3f} N, {:.4f} -> {:.4f} N m; better in {} of {}\n",
                         cause.gain.forceBefore, cause.gain.forceAfter, cause.gain.torqueBefore, cause.gain.torqueAfter,
                         cause.gain.blocksBetter, cause.gain.blocks);
    if (!cause.direct && report.surrogates > 0)
      out += fmt::format("   Evidence {:.0f}; 95 % false-alarm threshold from {} simulations: {:.1f}\n", cause.deltaBic,
                         report.surrogates, report.threshold);
    if (!cause.alternatives.empty())
      out += fmt::format("   Not distinguishable with this motion: {}\n   To decide: {}\n",
                         fmt::join(cause.alternatives, ", "), cause.tellApart);
    if (cause.ofMistake) out += tiesText(*report.mistake);
    out += fmt::format("   Check: {}\n", cause.check);
  }
  if (const std::string unknown = unknownText(report); !unknown.empty()) out += fmt::format("\nUnknown: {}\n", unknown);
  if (!report.causes.empty()) {
    const Vector10d moved = payloadShift(report);
    out += fmt::format("\nPayload before  {}\nPayload after   {}\n", payloadLine(report.before),
                       payloadLine(report.after));
    out += report.after.trust == Trust::none
               ? report.after.whyNoTrust + "\n"
               : fmt::format("Change: {:.1f} sigma (mass), {:.1f} sigma (centre of mass), {:.1f} sigma (inertia)\n",
                             moved(0), moved.segment<3>(1).maxCoeff(), moved.tail<6>().maxCoeff());
  }
  if (report.check)
    out += fmt::format("\nChecked on {}: {:.3f} -> {:.3f} N, {:.4f} -> {:.4f} N m\n{}\n", report.check->file,
                       report.check->before.force, report.check->after.force, report.check->before.torque,
                       report.check->after.torque, checkText(*report.check));
  std::string unseen;
  for (const auto& s : report.smallest)
    if (std::isfinite(s.value))
      unseen += fmt::format("  {:<18} below {:.2g} {} ({})\n", s.cause, s.value, s.unit, s.parameter);
  if (!unseen.empty()) out += "\nNot detectable with this motion:\n" + unseen;
  return out;
}

}  // namespace heft
