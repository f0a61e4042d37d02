#include "core/segmentation/sensor_trouble.h"

#include <algorithm>

#include "core/base/say.h"
#include "core/recording/frozen.h"
#include "core/segmentation/flat_tops.h"

namespace heft {

std::vector<Trouble> sensorTrouble(const Recording& recording) {
  std::vector<Trouble> out;
  const auto& wrench = recording.wrench;
  const VectorXd& time = recording.time;
  if (wrench.rows() < 20) return out;
  constexpr double kShortest = 0.05;  // [s]
  for (const FrozenStretch& hung : frozenStretches(time, changesOf(wrench), kShortest))
    if (hung.length() < wrench.rows())
      out.push_back({time(hung.from), time(hung.to - 1),
                     heft::say("The sensor's values stand still here: it sent nothing new.")});
  static constexpr const char* kNames[] = {heft::toSay("Force x"),  heft::toSay("Force y"),  heft::toSay("Force z"),
                                           heft::toSay("Torque x"), heft::toSay("Torque y"), heft::toSay("Torque z")};
  for (const FlatTop& flat : flatTops(wrench))
    for (const auto& [from, to] : flat.runs)
      if (to - from >= 10 && time(to - 1) - time(from) >= 0.01)
        out.push_back(
            {time(from), time(to - 1),
             heft::say("{} is cut off at {:.4g} {}: the sensor is at the end of its range.",
                       heft::say(fmt::runtime(kNames[flat.channel])), flat.level, flat.channel < 3 ? "N" : "N m")});
  std::sort(out.begin(), out.end(), [](const Trouble& a, const Trouble& b) { return a.from < b.from; });
  return out;
}

}  // namespace heft
