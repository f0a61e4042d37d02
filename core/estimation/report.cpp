#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/estimation/estimate.h"

namespace heft {

using nlohmann::json;

namespace {

json jsonOf(const Vector3d& v) { return {v(0), v(1), v(2)}; }
json jsonOf(const Interval& i) { return {i.lower, i.upper}; }

json jsonOf(const PayloadInterval& p) {
  json com = json::array(), inertia = json::array();
  for (const auto& i : p.com) com.push_back(jsonOf(i));
  for (const auto& row : p.inertiaCom) {
    json cells = json::array();
    for (const auto& i : row) cells.push_back(jsonOf(i));
    inertia.push_back(cells);
  }
  return {{"mass_kg", jsonOf(p.mass)}, {"com_m", com}, {"inertia_com_kgm2", inertia}};
}

json jsonOf(const Identifiability& id) {
  json com = json::array(), inertia = json::array();
  for (const Source s : id.com) com.push_back(toString(s));
  for (const auto& row : id.inertia) {
    json cells = json::array();
    for (const Source s : row) cells.push_back(toString(s));
    inertia.push_back(cells);
  }
  json out = {{"mass", toString(id.mass)},
              {"com", com},
              {"inertia", inertia},
              {"data_share", {{"mass", id.massShare}, {"com", id.comShare}, {"inertia", id.inertiaShare}}},
              {"weak_directions", id.weakDirections}};
  // JSON knows no infinity; a motion without any information has no condition number.
  out["condition_number"] = std::isfinite(id.conditionNumber) ? json(id.conditionNumber) : json(nullptr);
  return out;
}

json jsonOf(const Finding& finding) {
  json out = {{"severity", toString(finding.severity)}, {"code", finding.code}, {"text", finding.text}};
  if (!finding.remedy.empty()) out["remedy"] = finding.remedy;
  if (!finding.where.file.empty()) out["file"] = finding.where.file;
  if (finding.where.line > 0) out["line"] = finding.where.line;
  if (finding.where.column > 0) out["column"] = finding.where.column;
  return out;
}

std::string words(Source source) {
  switch (source) {
    case Source::data:
      return "measured";
    case Source::prior:
      return "from what you gave";
    case Source::none:
      return "not known from this motion";
  }
  return "";
}

/// One answer in plain words, before any number.
std::string headline(const EstimateReport& report) {
  const auto& id = report.identifiability;
  if (id.mass == Source::none) return "This motion cannot tell what your tool weighs.";
  std::string line = fmt::format("Your tool weighs {:.2f} kg.", report.payload.mass);
  bool com = true, inertia = true, inertiaPrior = false;
  for (std::size_t i = 0; i < 3; ++i) {
    com = com && id.com[i] == Source::data;
    inertia = inertia && id.inertia[i][i] == Source::data;
    inertiaPrior = inertiaPrior || id.inertia[i][i] == Source::prior;
  }
  if (report.parameters != ParameterSet::full) return line + (com ? " Mass and centre of mass are measured." : "");
  if (com && inertia) return line + " Mass, centre of mass and inertia are measured.";
  if (com)
    return line + (inertiaPrior ? " Mass and centre are measured; inertia leans on your shape."
                                : " Mass and centre are measured; the inertia is not known from this motion.");
  return line + " The centre of mass is not fully known from this motion.";
}

}  // namespace

json toJson(const EstimateReport& report) {
  json segments = json::array(), findings = json::array();
  for (const auto& s : report.segments)
    segments.push_back({{"from_s", s.from}, {"to_s", s.to}, {"label", toString(s.label)}, {"reason", s.reason}});
  for (const auto& f : report.findings) findings.push_back(jsonOf(f));
  json out = {
      {"schema", "heft.estimate/1"},
      {"method", toString(report.method)},
      {"parameters", toString(report.parameters)},
      {"recording",
       {{"file", report.file},
        {"samples", report.samples},
        {"rate_hz", report.rateHz},
        {"duration_s", report.duration},
        {"used_s", report.usedDuration}}},
      {"sensor_mount",
       {{"parent", report.mount.parent}, {"xyz_m", jsonOf(report.mount.xyz)}, {"rpy_rad", jsonOf(report.mount.rpy)}}},
      {"payload", toJson(report.payload)},
      {"std", toJson(report.std)},
      {"interval95", jsonOf(report.interval95)},
      {"bias", {{"force_n", jsonOf(report.forceBias)}, {"torque_nm", jsonOf(report.torqueBias)}}},
      {"physically_consistent", report.physicallyConsistent},
      {"identifiability", jsonOf(report.identifiability)},
      {"residual",
       {{"force_rms_n", report.forceRms},
        {"torque_rms_nm", report.torqueRms},
        {"heldout_force_rms_n", report.heldoutForceRms},
        {"heldout_torque_rms_nm", report.heldoutTorqueRms}}},
      {"segments", segments},
      {"timing_s",
       {{"read", report.timing.read},
        {"prepare", report.timing.prepare},
        {"solve", report.timing.solve},
        {"total", report.timing.total}}},
      {"termination",
       {{"usable", report.termination.usable},
        {"why", report.termination.why},
        {"iterations", report.termination.iterations}}},
      {"findings", findings}};
  if (report.relativeError) {
    const auto& e = *report.relativeError;
    json error = json::object();
    if (e.hasMass) error["mass"] = e.mass;
    if (e.hasCom) error["com"] = e.com;
    if (e.hasInertia) {
      error["inertia"] = e.inertiaOrigin;
      error["inertia_origin"] = e.inertiaOrigin;
      error["inertia_com"] = e.inertiaCom;
    }
    out["relative_error"] = error;
  }
  return out;
}

std::string toText(const EstimateReport& report) {
  const Payload& p = report.payload;
  const bool doubtful = std::any_of(report.findings.begin(), report.findings.end(), [](const Finding& finding) {
    return finding.code == "misfit" || finding.code == "known_disagrees" || finding.code == "wrench_sign";
  });
  const auto& i95 = report.interval95;
  const auto half = [](const Interval& i) { return 0.5 * (i.upper - i.lower); };
  std::string text =
      headline(report) +
      (doubtful ? " Check the warnings below first: the numbers may be off by more than they say." : "") + "\n\n";
  text += fmt::format("  Mass            {:9.4f} kg      +- {:.2g}  {}\n", p.mass, half(i95.mass),
                      words(report.identifiability.mass));
  for (std::size_t i = 0; i < 3; ++i)
    text += fmt::format("  {} {}  {:9.2f} mm      +- {:.2g}  {}\n", i == 0 ? "Centre of mass" : "              ",
                        "xyz"[i], 1e3 * p.com(static_cast<Eigen::Index>(i)), 1e3 * half(i95.com[i]),
                        words(report.identifiability.com[i]));
  static constexpr std::pair<int, int> kOrder[] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  for (const auto& [r, c] : kOrder) {
    const auto row = static_cast<std::size_t>(r), column = static_cast<std::size_t>(c);
    text +=
        fmt::format("  {} {}{} {:9.3f} kg cm2  +- {:.2g}  {}\n", r == 0 && c == 0 ? "Inertia       " : "              ",
                    "xyz"[r], "xyz"[c], 1e4 * p.inertiaCom(r, c), 1e4 * half(i95.inertiaCom[row][column]),
                    words(report.identifiability.inertia[row][column]));
  }
  text +=
      "\n  (+-: 95 % interval. Centre of mass from the sensor's origin, inertia about the centre of mass, sensor "
      "axes.)\n";
  if (report.duration > 0.0)
    text += fmt::format("\n  {:.1f} s of {:.1f} s were used. ", report.usedDuration, report.duration);
  else
    text += fmt::format("\n  {} standing poses were used. ", report.samples);
  text += fmt::format("Unseen parts are predicted to {:.3f} N and {:.4f} N m.\n", report.heldoutForceRms,
                      report.heldoutTorqueRms);
  text += fmt::format("  Sensor bias {:.3f} {:.3f} {:.3f} N, {:.4f} {:.4f} {:.4f} N m.\n", report.forceBias(0),
                      report.forceBias(1), report.forceBias(2), report.torqueBias(0), report.torqueBias(1),
                      report.torqueBias(2));
  if (report.relativeError) {
    const auto& e = *report.relativeError;
    text += "  Against the known values:";
    if (e.hasMass) text += fmt::format(" mass {:.2f} %", 100 * e.mass);
    if (e.hasCom) text += fmt::format(", centre of mass {:.2f} %", 100 * e.com);
    if (e.hasInertia)
      text += fmt::format(", inertia {:.1f} % (about the centre of mass {:.1f} %)", 100 * e.inertiaOrigin,
                          100 * e.inertiaCom);
    text += ".\n";
  }
  if (!report.findings.empty()) {
    text += "\n";
    for (const auto& finding : report.findings) text += "  " + toLine(finding) + "\n";
  }
  return text;
}

}  // namespace heft
