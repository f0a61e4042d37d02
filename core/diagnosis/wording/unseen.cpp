#include "core/diagnosis/wording/unseen.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/numbers.h"
#include "core/base/say.h"

namespace heft {

std::vector<std::string> couldNotBeSeen(const std::vector<Smallest>& smallest, int most) {
  constexpr std::array kPhrases{std::pair{"payload_change", toSay("load changes under {}")},
                                std::pair{"cable_pull", toSay("cables softer than {}")},
                                std::pair{"time_offset", toSay("delays under {}")},
                                std::pair{"gravity_tilt", toSay("tilts under {}")},
                                std::pair{"bias_drift", toSay("drifts under {}")},
                                std::pair{"loose_mass", toSay("loose parts under {}")},
                                std::pair{"sensor_rotation", toSay("a sensor turned by less than {}")},
                                std::pair{"low_pass_lag", toSay("smoothing under {}")},
                                std::pair{"gain_error", toSay("wrong gains under {}")},
                                std::pair{"joint_offset", toSay("joint angles off by less than {}")},
                                std::pair{"constant_pull", toSay("steady pulls under {}")},
                                std::pair{"lever_arm", toSay("a sensor misplaced by less than {}")}};
  std::vector<std::string> out;
  for (const auto& [id, phrase] : kPhrases)
    for (const Smallest& s : smallest) {
      if (s.cause != id || static_cast<int>(out.size()) >= most || !std::isfinite(s.value) || !(s.value > 0.0)) continue;
      const int decimals = std::clamp(static_cast<int>(std::ceil(1.0 - std::log10(s.value) - 1e-9)), 0, 5);
      const std::string size = sayNumber(s.value, decimals) + (s.unit == "deg" ? "°" : " " + s.unit);
      out.push_back(heft::say(fmt::runtime(phrase), size));
    }
  return out;
}

}  // namespace heft
