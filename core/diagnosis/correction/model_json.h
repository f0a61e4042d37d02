#pragma once
// The extended model outside the search: its effect on any recording, and its JSON.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/diagnosis/model/forward_model.h"

namespace heft {

/// What the causes add to the wrench [N, N m] at each row of the recording: measured minus this is what the rigid
/// payload and the bias alone would read. `causes`: IDs to apply; empty: all.
Result<Eigen::Matrix<double, Eigen::Dynamic, 6>> effectOf(const diagnosis::Model& model, const Recording& recording,
                                                          const RobotModel* robot,
                                                          const std::vector<std::string>& causes = {});

/// The extended model as it stands in toJson(report)["model"].
nlohmann::json modelToJson(const diagnosis::Model& model);
/// A cause in a form of another version that this one does not know is an error, or, where `unknown` is given, left out
/// and its ID put there.
Result<diagnosis::Model> modelFromJson(const nlohmann::json& model, const Recording& recording, const RobotModel* robot,
                                       std::vector<std::string>* unknown = nullptr);

}  // namespace heft
