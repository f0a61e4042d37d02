#include "core/estimation/comparison.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace heft {

using nlohmann::json;

namespace {

/// Why a row deserves no trust, or "yes".
std::string verdict(const EstimateReport& report) {
  if (!report.termination.usable) return "no: " + report.termination.why;
  return report.physicallyConsistent ? "yes" : "no: no real body has these numbers";
}

/// The numbers mean nothing, whatever the method.
bool saysConventions(const EstimateReport& report) {
  return !report.readAsSuggested && report.conventions.verdict != conventions::Verdict::asStated;
}

std::string percent(bool known, double error) { return known ? fmt::format("{:.3g}", 100.0 * error) : "-"; }

}  // namespace

Result<std::vector<ComparedMethod>> compareMethods(const Recording& recording, const RobotModel* robot,
                                                   const EstimateOptions& options, const Progress& progress) {
  std::vector<ComparedMethod> methods;
  std::optional<Error> failure;
  bool any = false;
  for (const Method method : kAllMethods) {
    if (progress.cancelled()) return Error{"Stopped.", true};
    progress(static_cast<double>(methods.size()) / kAllMethods.size(), toString(method));
    EstimateOptions each = options;
    each.method = method;
    auto report = estimate(recording, robot, each, Progress{progress.stop, {}});
    ComparedMethod row{method, std::nullopt, {}};
    if (report) {
      row.report = std::move(report).value();
      any = true;
    } else {
      if (report.error().cancelled) return report.error();
      row.failure = report.error().message;
      failure = report.error();
    }
    methods.push_back(std::move(row));
  }
  progress(1.0, "Done");
  if (!any) return *failure;
  return methods;
}

std::string toText(const std::vector<ComparedMethod>& methods) {
  bool known = false;
  for (const auto& row : methods) known = known || (row.report && row.report->relativeError);
  std::string text = fmt::format("{:<12}{:>9} {:>9}{:>8}{:>8}{:>8}{:>9}{:>10}{:>10}", "method", "mass", "+-", "com x",
                                 "com y", "com z", "inertia", "held out", "held out");
  if (known) text += fmt::format("{:>9}{:>9}{:>9}", "mass", "com", "inertia");
  text += fmt::format("{:>9}{:>9}  {}\n", "solve", "total", "usable");
  text += fmt::format("{:<12}{:>9} {:>9}{:>8}{:>8}{:>8}{:>9}{:>10}{:>10}", "", "kg", "kg", "mm", "mm", "mm", "kg cm2",
                      "N", "N m");
  if (known) text += fmt::format("{:>9}{:>9}{:>9}", "err. %", "err. %", "err. %");
  text += fmt::format("{:>9}{:>9}\n", "ms", "ms");
  for (const auto& row : methods) {
    if (!row.report) {
      text += fmt::format("{:<12}no result: {}\n", toString(row.method), row.failure);
      continue;
    }
    const EstimateReport& r = *row.report;
    if (saysConventions(r)) {
      text += fmt::format("{:<12}no weight: {}\n", toString(row.method), r.whyNoTrust);
      continue;
    }
    const Payload& p = r.payload;
    text +=
        fmt::format("{:<12}{:>9.4f} {:>9.2g}{:>8.2f}{:>8.2f}{:>8.2f}{:>9.2f}{:>10.4f}{:>10.5f}", toString(row.method),
                    p.mass, 0.5 * (r.interval95.mass.upper - r.interval95.mass.lower), 1e3 * p.com.x(), 1e3 * p.com.y(),
                    1e3 * p.com.z(), 1e4 * p.inertiaCom.trace(), r.heldoutForceRms, r.heldoutTorqueRms);
    if (known) {
      const RelativeError e = r.relativeError.value_or(RelativeError{});
      text += fmt::format("{:>9}{:>9}{:>9}", percent(e.hasMass, e.mass), percent(e.hasCom, e.com),
                          percent(e.hasInertia, e.inertiaOrigin));
    }
    text += fmt::format("{:>9.2f}{:>9.1f}  {}\n", 1e3 * r.timing.solve, 1e3 * r.timing.total, verdict(r));
  }
  text +=
      "\n(+-: 95 % interval. Inertia: trace about the centre of mass; its error is that about the sensor's origin. "
      "Solve:\nfrom the prepared motion to the numbers; total: with preparing and checking, without reading the "
      "file.)\n";
  return text;
}

json toJson(const std::vector<ComparedMethod>& methods) {
  json list = json::array();
  for (const auto& row : methods) {
    json item = {{"schema", "heft.estimate/1"}, {"method", toString(row.method)}};
    if (row.report) {
      const json full = toJson(*row.report);
      for (const char* key : {"parameters", "trust", "payload", "std", "interval95", "bias", "physically_consistent",
                              "residual", "timing_s", "termination", "relative_error"})
        if (full.contains(key)) item[key] = full[key];
    } else {
      item["termination"] = {{"usable", false}, {"why", row.failure}, {"iterations", 0}};
    }
    list.push_back(std::move(item));
  }
  return list;
}

}  // namespace heft
