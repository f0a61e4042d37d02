#pragma once
// Payload files in the forms that controllers read.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/payload/inertial_parameters.h"

namespace heft {

/// A result to be written, already expressed in the FLANGE frame F.
struct ExportInput {
  Payload payload;            ///< com = p_FPcm_F, inertia about the centre of mass, F axes
  std::string name = "tool";  ///< For formats that carry a name
  std::string provenance;     ///< One line: program, version, recording; written as a comment where there are comments
  std::string uncertainty;    ///< One line with intervals; likewise
};

struct ExportFormat {
  std::string_view id;         ///< "franka-desk"
  std::string_view title;      ///< "Franka Desk end effector (JSON)"
  std::string_view extension;  ///< ".json"
  std::string (*write)(const ExportInput& input);
};

/// Every format that this build writes, in the order shown to a user.
const std::vector<ExportFormat>& exportFormats();
const ExportFormat* findExportFormat(std::string_view id);

/// Refuses unphysical payloads (positive definite and triangle inequality) and names why; warns in `findings` about
/// limits (Panda: 3 kg).
Result<std::string> exportPayload(const ExportFormat& format, const ExportInput& input, Findings& findings);

}  // namespace heft
