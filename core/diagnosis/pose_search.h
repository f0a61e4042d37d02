#pragma once
// Which causes standing poses ask for, one after the other.
#include <string>
#include <vector>

#include "core/base/progress.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/pose_fit.h"

namespace heft::diagnosis {

/// Evidence that poses need for a cause: as motions, and 2 ln 10 for the ten kinds that there are.
constexpr double kNeededOfPoses = kThreshold + 4.6;

struct NamedSuspect {
  Suspect candidate;
  double gain = 0.0;                      ///< Evidence
  std::vector<std::string> alternatives;  ///< IDs of causes that explain the poses as well
};

struct PoseSearch {
  std::vector<Suspect> candidates;  ///< All that were tried
  PoseFit null;                     ///< Zero and payload alone
  PoseFit fit;                      ///< With the causes
  std::vector<NamedSuspect> named;  ///< In the order in which they were accepted
};

/// Forward selection among all that poses may show but `hidden`, a list of IDs.
PoseSearch searchPoses(const PosesSeen& poses, const std::vector<std::string>& hidden, const Progress& progress);

/// Poses that do not fit the others; `fit` is then one to the others.
std::vector<bool> badPoses(const PosesSeen& poses, PoseFit& fit);

}  // namespace heft::diagnosis
