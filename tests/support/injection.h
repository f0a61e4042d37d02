#pragma once
// Effects put into a recording that exists already, measured ones included.
#include "core/simulation/effects/effect.h"

namespace heft::test {

struct Injected {
  Recording recording;
  std::vector<EffectTruth> effects;
};

/// `payload` and `bias` are the best values known for the recording: places are drawn near the tool, and gauges see the
/// load without the zero. Delays are rounded to whole rows, so that the noise keeps its colour. What lies in the
/// geometry (tilt, lever) is put into the meta instead, the other way round. Fails if the motion cannot be computed.
Result<Injected> inject(const Recording& recording, const RobotModel* robot, const Payload& payload,
                        const Vector6d& bias, const std::vector<EffectRequest>& requests, std::uint64_t seed);

/// One effect of random kind and form, `multiple` times the kind's typical size; kinds take turns with the seed. Only
/// kinds that the recording can have: without positions nothing pulls from a place, without joints no joint is wrong.
Result<Injected> drawInjected(const Recording& recording, const RobotModel* robot, const Payload& payload,
                              const Vector6d& bias, std::uint64_t seed, double multiple);

}  // namespace heft::test
