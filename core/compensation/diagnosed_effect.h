#pragma once
// What heft diagnose found, taken out of the wrench before the payload's share.
#include <memory>

#include "core/compensation/compensation.h"
#include "core/diagnosis/diagnose.h"

namespace heft {

/// The causes of a result of heft diagnose (its member "model"), for one recording of the same rig. Causes with a place
/// in time belong to the recording that they were found in and are left out elsewhere. Fails if the result holds no
/// model.
Result<std::shared_ptr<const WrenchEffect>> diagnosedEffect(const nlohmann::json& found, const Recording& recording,
                                                            const RobotModel* robot, const std::string& where);

}  // namespace heft
