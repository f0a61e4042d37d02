#pragma once
// From an estimate in sensor axes S to the payload that a controller wants, in flange axes F.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/exporters/exporter.h"
#include "core/recording/recording.h"

namespace heft::cli {

struct FlangeOptions {
  std::optional<Vector3d> xyz;               ///< Position of S in F [m], instead of the mount's
  std::optional<Vector3d> rpy;               ///< Fixed-axis rotation of S in F [rad], likewise
  Isometry3d X_FE = Isometry3d::Identity();  ///< Tool centre point
  std::string mountFile;                     ///< A meta file, or an object {"parent","xyz_m","rpy_rad"}
  std::vector<std::string> add;              ///< Payload files in F: what else is mounted (sensor's tool side, adapter)
  std::string name = "tool";
};

struct FlangePayload {
  ExportInput input;  ///< In F, the added bodies included.
  Isometry3d X_FS = Isometry3d::Identity();
  Findings findings;  ///< What of it is not measured, and what was assumed about the mount.
};

/// `result` is a heft.estimate/1 (payload in S, "sensor_mount" says where S sits) or a bare payload, which counts as
/// given in F unless the options place it. `where` names it in messages. Throws Failed.
FlangePayload toFlange(const nlohmann::json& result, const std::string& where, const FlangeOptions& options);

}  // namespace heft::cli
