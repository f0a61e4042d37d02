#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/base/text.h"
#include "core/estimation/carried_object.h"
#include "core/estimation/report_text.h"

namespace heft {

namespace {

std::string weight(const EstimateReport& report) {
  return fmt::format("{:.4f} +- {:.2g} kg ({})", report.payload.mass, 1.96 * report.std.mass,
                     printable(report.file, 200));
}

std::string objectHeadline(const CarriedObject& carried) {
  const EstimateReport& object = carried.object;
  if (object.trust == Trust::none) return heft::say("The object cannot be weighed. {}", object.whyNoTrust);
  const double half = 0.5 * (object.interval95.mass.upper - object.interval95.mass.lower);
  if (carried.verdict == ObjectVerdict::nothing)
    return heft::say("No object detected: the two recordings differ by {:.4f} +- {:.2g} kg.", object.payload.mass,
                     half);
  const auto& id = object.identifiability;
  const bool com = std::ranges::all_of(id.com, [](Source s) { return s == Source::data; });
  bool inertia = true;
  for (std::size_t i = 0; i < 3; ++i) inertia = inertia && id.inertia[i][i] == Source::data;
  if (object.trust == Trust::low) return heft::say("The object seems to weigh {:.3f} kg.", object.payload.mass);
  const std::string line = heft::say("The object weighs {:.3f} kg.", object.payload.mass);
  if (com && inertia) return line + " " + heft::say("Its mass, centre of mass and inertia are measured.");
  if (com)
    return line + " " + heft::say("Its mass and centre are measured; these motions do not determine its inertia.");
  return line + " " + heft::say("Its centre of mass is not fully determined by these motions.");
}

}  // namespace

nlohmann::json toJson(const CarriedObject& carried) {
  nlohmann::json out = toJson(carried.with);
  const nlohmann::json whole = toJson(carried.object);
  nlohmann::json object = whole["payload"];
  for (const char* key :
       {"std", "interval95", "trust", "physically_consistent", "identifiability", "evidence", "findings"})
    object[key] = whole[key];
  object["verdict"] = toString(carried.verdict);
  if (carried.verdict != ObjectVerdict::found)
    for (nlohmann::json* part : {&object, &object["std"], &object["interval95"]})
      for (const char* key : {"com_m", "inertia_com_kgm2"}) (*part)[key] = nullptr;
  out["object"] = std::move(object);
  const nlohmann::json without = toJson(carried.without);
  for (const char* key : {"recording", "payload", "std", "interval95", "bias", "trust", "residual", "findings"})
    out["without"][key] = without[key];
  return out;
}

std::string toText(const CarriedObject& carried) {
  const EstimateReport& object = carried.object;
  std::string text = objectHeadline(carried);
  if (object.trust == Trust::low)
    text += " " + heft::say("Check the warnings below first: the errors may be larger than the intervals.");
  text += "\n\n";
  if (object.trust == Trust::none) {
    if (!object.whatToDo.empty()) text += "  " + object.whatToDo + "\n";
  } else if (carried.verdict == ObjectVerdict::found) {
    text += numbersText(object);
    text +=
        "\n  (+-: 95 % interval. Centre of mass from the sensor's origin, inertia about the centre of mass, sensor "
        "axes.)\n\n";
  }
  text += fmt::format("  With it    {}\n  Without it {}\n", weight(carried.with), weight(carried.without));
  for (const auto& finding : object.findings)
    if (finding.code != "no_trust") text += "  " + toLine(finding) + "\n";
  for (const EstimateReport* report : {&carried.with, &carried.without})
    for (const auto& finding : report->findings)
      if (finding.severity != Severity::info && finding.code != "no_trust")
        text += "  " + printable(report->file, 200) + ": " + toLine(finding) + "\n";
  return text;
}

}  // namespace heft
