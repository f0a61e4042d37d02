#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/estimation/configured.h"
#include "core/estimation/estimate.h"
#include "core/estimation/report_text.h"
#include "core/recording/meta_file.h"

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

/// Ten numbers in the places of a payload's; null where nothing can be said (JSON knows no NaN).
json jsonOf(const Vector10d& components) {
  const auto number = [&](int i) { return std::isfinite(components(i)) ? json(components(i)) : json(nullptr); };
  return {{"mass_kg", number(0)},
          {"com_m", {number(1), number(2), number(3)}},
          {"inertia_com_kgm2",
           {{number(4), number(5), number(6)}, {number(5), number(7), number(8)}, {number(6), number(8), number(9)}}}};
}

json jsonOf(const Evidence& evidence) {
  json out = {{"data", jsonOf(evidence.data)}, {"data_std", jsonOf(evidence.dataStd)}};
  if (!evidence.hasPrior) return out;
  out["prior"] = jsonOf(evidence.prior);
  out["prior_std"] = jsonOf(evidence.priorStd);
  out["prior_shift_sigma"] = jsonOf(evidence.shift);
  out["disagreement_sigma"] = jsonOf(evidence.disagreement);
  return out;
}

/// What would be "data" if no finding doubted it.
json doubtedJson(const Identifiability& id) {
  json com = json::array(), inertia = json::array();
  for (const Source s : id.com) com.push_back(s == Source::doubted);
  for (const auto& row : id.inertia) {
    json cells = json::array();
    for (const Source s : row) cells.push_back(s == Source::doubted);
    inertia.push_back(cells);
  }
  return {{"mass", id.mass == Source::doubted}, {"com", com}, {"inertia", inertia}};
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
              {"weak_directions", id.weakDirections},
              {"doubted", doubtedJson(id)}};
  json directions = json::array();
  for (const auto& d : id.directions) directions.push_back({{"data_share", d.dataShare}, {"about", d.about}});
  out["directions"] = directions;
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
    case Source::doubted:
      return "doubtful";
    case Source::prior:
      return "from what you gave";
    case Source::none:
      return "not known from this motion";
  }
  return "";
}

/// What the motion alone said, what was told and how far that pulled, a line a number.
std::string evidenceText(const Evidence& e) {
  struct Row {
    const char* name;
    int component;
    double unit;
  };
  static constexpr Row kRows[] = {{"Mass [kg]", 0, 1.0},           {"Centre x [mm]", 1, 1e3},
                                  {"Centre y [mm]", 2, 1e3},       {"Centre z [mm]", 3, 1e3},
                                  {"Inertia xx [kg cm2]", 4, 1e4}, {"Inertia yy [kg cm2]", 7, 1e4},
                                  {"Inertia zz [kg cm2]", 9, 1e4}};
  const auto cell = [](double value, double std, double unit) {
    return std::isfinite(value) ? fmt::format("{:.4g} +- {:.2g}", unit * value, 1.96 * unit * std) : std::string("-");
  };
  std::string text =
      fmt::format("\n  {:<20} {:<24} {:<24} {}\n", "", "data only", "your input", "shift of the result [sigma]");
  for (const Row& row : kRows) {
    const int i = row.component;
    if (!std::isfinite(e.prior(i)) && !(std::abs(e.shift(i)) > 0.05)) continue;
    text += fmt::format("  {:<20} {:<24} {:<24} {}\n", row.name, cell(e.data(i), e.dataStd(i), row.unit),
                        cell(e.prior(i), e.priorStd(i), row.unit),
                        std::isfinite(e.shift(i)) ? fmt::format("{:+.1f}", e.shift(i)) : std::string("-"));
  }
  return text;
}

/// The standard deviations that this motion can give at best, in one sentence.
std::string bestText(const EstimateReport& report) {
  const Vector10d& best = report.evidence.best;
  if (!std::isfinite(best(0))) return "";
  const Vector3d moments(best(4), best(7), best(9));
  std::string text = fmt::format("  Best achievable with this motion (95 %): mass +- {:.2g} kg", 1.96 * best(0));
  if (best.segment<3>(1).allFinite())
    text += fmt::format(", centre +- {:.2g} mm", 1.96e3 * best.segment<3>(1).maxCoeff());
  const double trace = report.payload.inertiaCom.trace();
  if (report.parameters == ParameterSet::full && trace > 0.0)
    text += moments.allFinite() && moments.maxCoeff() < trace
                ? fmt::format(", moments of inertia +- {:.2g} kg cm2", 1.96e4 * moments.maxCoeff())
                : ", not all moments of inertia";
  return text + ".\n";
}

/// One answer in plain words, before any number.
std::string headline(const EstimateReport& report) {
  const auto& id = report.identifiability;
  if (report.trust == Trust::none)
    return heft::say("The weight cannot be determined from these readings as they are interpreted. {}",
                     report.whyNoTrust);
  if (id.mass == Source::none) return "This motion does not determine the mass of your tool.";
  std::string line =
      id.mass == Source::prior && report.evidence.hasPrior && !std::isfinite(report.evidence.data(0))
          ? fmt::format("This motion does not determine the mass of your tool; {:.2f} kg is your own value.",
                        report.payload.mass)
      : id.mass == Source::doubted ? fmt::format("Your tool seems to weigh {:.2f} kg.", report.payload.mass)
                                   : fmt::format("Your tool weighs {:.2f} kg.", report.payload.mass);
  bool com = true, inertia = true, comPrior = false, inertiaPrior = false, comDoubted = id.mass == Source::doubted,
       inertiaDoubted = false;
  for (std::size_t i = 0; i < 3; ++i) {
    comDoubted = comDoubted || id.com[i] == Source::doubted;
    inertiaDoubted = inertiaDoubted || id.inertia[i][i] == Source::doubted;
    com = com && id.com[i] == Source::data;
    comPrior = comPrior || id.com[i] == Source::prior;
    inertia = inertia && id.inertia[i][i] == Source::data;
    inertiaPrior = inertiaPrior || id.inertia[i][i] == Source::prior;
  }
  if (comDoubted || inertiaDoubted)
    return line + (id.mass != Source::data ? ""
                   : com                   ? " Mass and centre of mass are measured."
                                           : " The mass is measured.");
  if (report.parameters != ParameterSet::full) return line + (com ? " Mass and centre of mass are measured." : "");
  if (com && inertia) return line + " Mass, centre of mass and inertia are measured.";
  if (com)
    return line + (inertiaPrior ? " Mass and centre are measured; inertia relies on your shape."
                                : " Mass and centre are measured; the inertia is not known from this motion.");
  return line + (comPrior ? " The centre of mass relies on your input, too."
                          : " The centre of mass is not fully determined by this motion.");
}

}  // namespace

json toJson(const EstimateReport& report) {
  json findings = json::array();
  for (const auto& f : report.findings) findings.push_back(jsonOf(f));
  json out = {{"schema", "heft.estimate/1"},
              {"method", toString(report.method)},
              {"parameters", toString(report.parameters)},
              {"recording",
               {{"file", report.file},
                {"samples", report.samples},
                {"rate_hz", report.rateHz},
                {"duration_s", report.duration},
                {"used_s", report.usedDuration}}},
              {"sensor_mount", toJson(report.mount)},
              {"payload", toJson(report.payload)},
              {"std", toJson(report.std)},
              {"interval95", jsonOf(report.interval95)},
              {"bias", {{"force_n", jsonOf(report.forceBias)}, {"torque_nm", jsonOf(report.torqueBias)}}},
              {"physically_consistent", report.physicallyConsistent},
              {"trust", toString(report.trust)},
              {"conventions", conventions::toJson(report.conventions, report.mount, report.motionFromJoints)},
              {"identifiability", jsonOf(report.identifiability)},
              {"evidence", jsonOf(report.evidence)},
              {"residual",
               {{"force_rms_n", report.forceRms},
                {"torque_rms_nm", report.torqueRms},
                {"heldout_force_rms_n", report.heldoutForceRms},
                {"heldout_torque_rms_nm", report.heldoutTorqueRms},
                {"heldout_share", {{"force", report.unseenForceShare}, {"torque", report.unseenTorqueShare}}}}},
              {"segments", toJson(report.segments)},
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
  out["conventions"]["used"] = report.readAsSuggested ? "suggested" : "as-stated";
  out["identifiability"]["best_std"] = jsonOf(report.evidence.best);
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
  if (report.configured && report.configured->payload.mass) out["configured"] = configuredJson(report);
  return out;
}

std::string numbersText(const EstimateReport& report) {
  const Payload& p = report.payload;
  const auto& i95 = report.interval95;
  const auto half = [](const Interval& i) { return 0.5 * (i.upper - i.lower); };
  std::string text = fmt::format("  Mass            {:9.4f} kg      +- {:.2g}  {}\n", p.mass, half(i95.mass),
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
  return text;
}

std::string toText(const EstimateReport& report) {
  if (report.trust == Trust::none) {
    std::string text = headline(report) + "\n\n";
    if (!report.whatToDo.empty()) text += "  " + report.whatToDo + "\n";
    for (const auto& finding : report.findings)
      if (finding.code != "no_trust") text += "  " + toLine(finding) + "\n";
    return text;
  }
  const bool doubtful = report.trust == Trust::low;
  std::string text = headline(report) +
                     (doubtful ? " Check the warnings below first: the errors may be larger than the intervals." : "") +
                     "\n\n";
  text += numbersText(report);
  text +=
      "\n  (+-: 95 % interval. Centre of mass from the sensor's origin, inertia about the centre of mass, sensor "
      "axes.)\n";
  if (report.duration > 0.0)
    text += fmt::format("\n  Used {:.1f} of {:.1f} s. ", report.usedDuration, report.duration);
  else
    text += fmt::format("\n  Used {} standing poses. ", report.samples);
  text += fmt::format("Held-out error: {:.3f} N, {:.4f} N m.\n", report.heldoutForceRms, report.heldoutTorqueRms);
  text += fmt::format("  Sensor bias {:.3f} {:.3f} {:.3f} N, {:.4f} {:.4f} {:.4f} N m.\n", report.forceBias(0),
                      report.forceBias(1), report.forceBias(2), report.torqueBias(0), report.torqueBias(1),
                      report.torqueBias(2));
  text += bestText(report);
  if (report.evidence.hasPrior) text += evidenceText(report.evidence);
  if (report.relativeError) {
    const auto& e = *report.relativeError;
    text += "  Deviation from the known values:";
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
