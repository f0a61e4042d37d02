#pragma once
// Payload files in the forms that controllers and simulators read.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/payload/inertial_parameters.h"

namespace heft {

/// The estimate as the sensor feels it, for files that take its weight off the readings.
struct SensorSide {
  Payload payload;                           ///< In S, without what else is mounted
  Isometry3d X_FS = Isometry3d::Identity();  ///< Pose of the sensor on the flange
  std::optional<Vector6d> bias;              ///< Force [N], torque [N m], sensor on payload, S axes; nothing: not known
  std::string frame;                         ///< Name of S in ROS; empty: not stated
};

/// A result to be written, already expressed in the FLANGE frame F.
struct ExportInput {
  Payload payload;            ///< com = p_FPcm_F, inertia about the centre of mass, F axes
  std::string name = "tool";  ///< For formats that carry a name
  std::string provenance;     ///< One line: program, version, recording; written as a comment where there are comments
  std::string uncertainty;    ///< One line with intervals; likewise
  std::vector<std::string> cautions;  ///< Why these numbers may be wrong, a line each; likewise, before all others
  Isometry3d X_FE = Isometry3d::Identity();  ///< Pose of the tool centre point; only Franka's tool files carry it
  std::string parentLink;            ///< URDF: of a massless link above the tool's; empty: the tool's is the root
  std::optional<SensorSide> sensor;  ///< Nothing: S is F and the bias is not known
};

struct ExportFormat {
  std::string_view id;         ///< "franka-desk"
  std::string_view title;      ///< "Franka Desk end effector (JSON)"
  std::string_view extension;  ///< ".json"
  std::string (*write)(const ExportInput& input);
  std::string_view unverified = {};  ///< What about this format Heft's authors could not check; empty: all checked
  double heaviest = 0.0;             ///< Largest mass that its controller is made for [kg]; 0: not known
};

/// The format states a tool centre point, which a controller takes over with the payload.
bool carriesTool(const ExportFormat& format);

/// Every format that this build writes, in the order shown to a user.
const std::vector<ExportFormat>& exportFormats();
/// Null if there is none of that id.
const ExportFormat* findExportFormat(std::string_view id);

/// Refuses unphysical payloads (positive definite and triangle inequality) and names why. `findings` gets warnings
/// about limits (Panda: 3 kg), about what the format cannot hold and about what is unverified in it.
///
/// Numbers are rounded to what an estimate can carry (mass 10 mg, centre of mass 1 um, inertia to six digits of its
/// largest entry), finer where coarse rounding would make the body impossible; what is written is always physical.
Result<std::string> exportPayload(const ExportFormat& format, const ExportInput& input, Findings& findings);

/// The payload with the rounding described above.
Payload roundedForExport(const Payload& payload);

}  // namespace heft
