#pragma once
// What an on-line estimate knows so far in the form that predictions need (core/coach).
#include "core/estimation/linear_problem.h"
#include "core/estimation/map.h"
#include "core/estimation/noise_model.h"
#include "core/estimation/prior.h"

namespace heft {

struct OnlineInformation {
  Triangle whitened = Triangle::Zero();  ///< Rows so far, with honest variances
  MapPrior prior;
  MapSolution solution;
  ToldParts told;
  bool bias = true;
  NoiseModel noise, weighting;  ///< As found, and as used for weighting; of blocks at `blockRateHz`
  double blockRateHz = 0.0;
};

}  // namespace heft
