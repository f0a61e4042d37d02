#include "core/segmentation/sensor_trouble.h"

#include <algorithm>

#include "core/base/say.h"
#include "core/segmentation/flat_tops.h"
#include "core/segmentation/wrench_runs.h"

namespace heft {

namespace {

/// Rows [from, to) that repeat the wrench of the row before for 50 ms, ten rows and twenty times as long as the others
/// do.
std::vector<std::pair<Eigen::Index, Eigen::Index>> hungRows(const Recording& recording) {
  constexpr double kShortest = 0.05, kLonger = 20.0;
  const auto runs = wrenchRuns(recording.wrench);
  std::vector<std::pair<Eigen::Index, Eigen::Index>> out;
  for (const auto& [from, to] : runs) {
    const double others =
        static_cast<double>(recording.rows() - (to - from)) / std::max(1.0, static_cast<double>(runs.size()) - 1.0);
    if (to - from >= 10 && to - from < recording.rows() && recording.time(to - 1) - recording.time(from) >= kShortest &&
        static_cast<double>(to - from) >= kLonger * others)
      out.push_back({from, to});
  }
  return out;
}

}  // namespace

std::vector<Trouble> sensorTrouble(const Recording& recording) {
  std::vector<Trouble> out;
  const auto& wrench = recording.wrench;
  const VectorXd& time = recording.time;
  if (wrench.rows() < 20) return out;
  for (const auto& [from, to] : hungRows(recording))
    out.push_back({time(from), time(to - 1), heft::say("The sensor's values stand still here: it sent nothing new.")});
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
