#include "core/diagnosis/search/evidence.h"

#include <algorithm>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"

namespace heft::diagnosis {

bool lags(std::string_view id) { return infoOf(id).family == Family::timing; }

bool enlarges(std::string_view id) { return infoOf(id).family == Family::dynamicGain; }

bool isMoreThanWalk(std::string_view cause, double gain, double walk) {
  const Family family = infoOf(cause).family;
  const bool likeAWalk = family == Family::sensorZero || family == Family::load || family == Family::contact;
  return !likeAWalk && gain > std::max(kFaint, kLargeShare * walk);
}

}  // namespace heft::diagnosis
