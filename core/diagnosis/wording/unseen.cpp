#include "core/diagnosis/wording/unseen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/say.h"
#include "core/diagnosis/causes/ids.h"

namespace heft {

std::vector<std::string> couldNotBeSeen(const std::vector<Smallest>& smallest, int most) {
  constexpr std::array kPhrases{std::pair{diagnosis::ids::payloadChange, toSay("load changes under {}")},
                                std::pair{diagnosis::ids::cablePull, toSay("cables softer than {}")},
                                std::pair{diagnosis::ids::timeOffset, toSay("delays under {}")},
                                std::pair{diagnosis::ids::gravityTilt, toSay("tilts under {}")},
                                std::pair{diagnosis::ids::biasDrift, toSay("drifts under {}")},
                                std::pair{diagnosis::ids::looseMass, toSay("loose parts under {}")},
                                std::pair{diagnosis::ids::sensorRotation, toSay("a sensor turned by less than {}")},
                                std::pair{diagnosis::ids::lowPassLag, toSay("smoothing under {}")},
                                std::pair{diagnosis::ids::gainError, toSay("wrong gains under {}")},
                                std::pair{diagnosis::ids::jointOffset, toSay("joint angles off by less than {}")},
                                std::pair{diagnosis::ids::constantPull, toSay("steady pulls under {}")},
                                std::pair{diagnosis::ids::leverArm, toSay("a sensor misplaced by less than {}")}};
  std::vector<std::string> out;
  for (const auto& [id, phrase] : kPhrases)
    for (const Smallest& s : smallest) {
      if (s.cause != id || static_cast<int>(out.size()) >= most || !std::isfinite(s.value) || !(s.value > 0.0))
        continue;
      const int decimals = std::clamp(static_cast<int>(std::ceil(1.0 - std::log10(s.value) - 1e-9)), 0, 5);
      const std::string size = sayNumber(s.value, decimals) + (s.unit == "deg" ? "°" : " " + s.unit);
      out.push_back(heft::say(fmt::runtime(phrase), size));
    }
  return out;
}

}  // namespace heft
