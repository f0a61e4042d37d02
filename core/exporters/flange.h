#pragma once
// From an estimate in sensor axes S to the payload that a controller wants, in flange axes F.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/exporters/exporter.h"
#include "core/recording/recording.h"

namespace heft {

struct FlangeOptions {
  std::optional<SensorMount> mount;          ///< Instead of the result's own
  std::optional<Vector3d> xyz;               ///< Position of S in F [m], instead of the mount's
  std::optional<Vector3d> rpy;               ///< Fixed-axis rotation of S in F [rad], likewise
  Isometry3d X_FE = Isometry3d::Identity();  ///< Tool centre point
  std::vector<Payload> add;                  ///< In F: what else is mounted (sensor's tool side, adapter)
  std::vector<std::string> addNames;         ///< Their names for the provenance, as many as `add`
  std::vector<std::string> cautions;         ///< What else may be wrong with the numbers, a sentence each
  bool force = false;                        ///< Even a result that says of itself that nothing in it can be trusted.
  std::string name = "tool";
  std::string sensorFrame;       ///< Its name in ROS, for formats that carry it
  std::string parentLink;        ///< See ExportInput
  std::string program = "Heft";  ///< Writes: "heft 0.2.0"
};

struct FlangePayload {
  ExportInput input;  ///< In F, the added bodies included.
  Isometry3d X_FS = Isometry3d::Identity();
  std::optional<SensorMount> mount;  ///< Whose pose X_FS is; nothing where the pose was stated, or is not known
  Findings findings;                 ///< Which numbers nobody measured, and what was assumed about the mount.
};

/// `result` is a heft.estimate/1 (toJson(EstimateReport); payload in S, "sensor_mount" says where S sits) or a bare
/// payload, which counts as given in F unless the options place it. `where` names it in messages and in the provenance.
/// Fails where there is no payload, or where the mount's parent link moves against the flange.
Result<FlangePayload> toFlange(const nlohmann::json& result, const std::string& where, const FlangeOptions& options);

/// The mount in a setup file's content ("sensor": {"mount": ...}), in a result ("sensor_mount"), or {"xyz_m",
/// "rpy_rad"}.
Result<SensorMount> sensorMountFromJson(const nlohmann::json& content, const std::string& where);

}  // namespace heft
