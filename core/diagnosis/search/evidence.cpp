#include "core/diagnosis/search/evidence.h"

#include <algorithm>
#include <array>

#include "core/diagnosis/causes/catalogue.h"

namespace heft::diagnosis {

bool lags(std::string_view id) { return id == "time_offset" || id == "low_pass_lag" || id == "motion_lag"; }

bool enlarges(std::string_view id) { return id == "flexible_mount" || id == "loose_mass" || id == "derivative_noise"; }

bool isMoreThanWalk(std::string_view cause, double gain, double walk) {
  constexpr double kMost = 0.75;
  constexpr std::array<std::string_view, 5> kLikeAWalk{"bias_drift", "sensor_bias", "payload_change", "contact",
                                                       kWandering};
  return std::ranges::find(kLikeAWalk, cause) == kLikeAWalk.end() && gain > std::max(kFaint, kMost * walk);
}

}  // namespace heft::diagnosis
