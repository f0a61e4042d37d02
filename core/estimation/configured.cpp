// The estimate beside what the controller was told.
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/estimation/configured.h"

namespace heft {

namespace {

/// The estimate in the flange's axes, where the sensor's mount tells them.
std::optional<Payload> inFlange(const EstimateReport& report) {
  if (!report.mount.parent.ends_with(report.configured->flange)) return std::nullopt;
  return transformed(report.payload, poseFromXyzRpy(report.mount.xyz, report.mount.rpy));
}

}  // namespace

void compareWithConfigured(EstimateReport& report) {
  if (!report.configured || !report.configured->payload.mass || report.trust == Trust::none) return;
  const PartialPayload& told = report.configured->payload;
  const double more = *told.mass - report.payload.mass;
  std::string text =
      heft::say("The controller was set to {:.3f} kg ({}), {:.3f} kg {} than estimated.", *told.mass,
                report.configured->source, std::abs(more), more < 0.0 ? heft::say("less") : heft::say("more"));
  if (const auto own = inFlange(report); own && told.com && *told.mass > 0.0)
    text += " " + heft::say("Its centre of mass is set {:.1f} mm from the estimated one.",
                            1e3 * (*told.com - own->com).norm());
  if (report.configured->changed)
    text += " " + heft::say("It was changed during the recording; this is the value set for longest.");
  report.findings.push_back({Severity::info,
                             "configured_payload",
                             std::move(text),
                             heft::say("The controller's values include what sits between flange and sensor, the "
                                       "estimate does not: 'heft export --add' adds it."),
                             {}});
}

nlohmann::json configuredJson(const EstimateReport& report) {
  const ConfiguredPayload& configured = *report.configured;
  const PartialPayload& told = configured.payload;
  const auto vector = [](const Vector3d& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
  nlohmann::json payload{{"mass_kg", *told.mass}};
  nlohmann::json difference{{"mass_kg", *told.mass - report.payload.mass}};
  if (told.com) payload["com_m"] = vector(*told.com);
  if (told.inertiaCom) {
    nlohmann::json rows = nlohmann::json::array();
    for (int i = 0; i < 3; ++i) rows.push_back(vector(told.inertiaCom->row(i).transpose()));
    payload["inertia_com_kgm2"] = std::move(rows);
  }
  if (const auto own = inFlange(report); own && told.com) difference["com_m"] = vector(*told.com - own->com);
  return {{"source", configured.source},
          {"frame", "flange"},
          {"changed", configured.changed},
          {"payload", std::move(payload)},
          {"difference", std::move(difference)}};
}

}  // namespace heft
