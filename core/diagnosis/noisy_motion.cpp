#include "core/diagnosis/noisy_motion.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/named.h"

namespace heft::diagnosis {

namespace {

WrenchRms leftOver(const Way& way) {
  const auto stretches = stretchesOf(way.signals.usable);
  return rmsOf(stretches, fitModel(way.signals, stretches, Model{}).residual);
}

}  // namespace

std::optional<NoisyMotion> noisyMotion(const Way& usual, const Way& smoothed, double evidence) {
  // Of 260 recordings, whatever was wrong with them, noise became 2.4 times smaller at most, and 1.75 times where a robot reports
  // its angles late and unevenly; noisy angles began at 2.7. Forces changed threefold at most where nobody had made the motion
  // noisy but the sensor was a very quiet one, and 25 times or more where somebody had.
  constexpr double kTimes = 2.2, kPlain = 8.0;
  const auto judged = static_cast<double>(std::ranges::count(usual.signals.usable, true));
  if (evidence < 12.0 * judged * std::log(kTimes)) return {};
  NoisyMotion out{leftOver(usual), leftOver(smoothed), smoothed.cutoffHz, false};
  if (out.usual.force < kTimes * out.smoothed.force) return {};
  out.plain = out.usual.force > kPlain * out.smoothed.force;
  return out;
}

}  // namespace heft::diagnosis
