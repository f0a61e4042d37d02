#pragma once
// Recordings that go into an on-line estimator as if they were live.
#include <stdexcept>

#include "core/online/online_estimator.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft::test {

inline Payload onlineTool() { return boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06}); }

inline Recording simulated(MotionKind motion, const Payload& payload, unsigned seed, double duration = 20.0,
                           double speed = 1.0, double rate = 1000.0) {
  SimulateOptions options;
  options.motion = motion;
  options.seed = seed;
  options.duration = duration;
  options.speed = speed;
  options.rateHz = rate;
  auto out = simulate(RobotModel::panda(), payload, options);
  if (!out) throw std::runtime_error(out.error().message);
  return std::move(out->recording);
}

inline OnlineEstimator estimatorFor(const Recording& recording, const OnlineOptions& options = {}) {
  auto created = OnlineEstimator::create(recording.meta, &RobotModel::panda(), options);
  if (!created) throw std::runtime_error(created.error().message);
  return std::move(*created);
}

/// Rows [from, to) of the recording; to = -1: to the end.
inline void feed(OnlineEstimator& online, const Recording& recording, Eigen::Index from = 0, Eigen::Index to = -1) {
  if (to < 0) to = recording.rows();
  for (Eigen::Index k = from; k < to; ++k) online.add(sampleOf(recording, k));
}

}  // namespace heft::test
