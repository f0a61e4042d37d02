#include "core/segmentation/sensor_trouble.h"

#include <algorithm>

#include "core/base/say.h"

namespace heft {

namespace {

/// Calls found(from, to) for each run of rows [from, to) that `same` says to equal the row before, if it lasts
/// `shortest` seconds, ten rows and `factor` times the mean length of the other runs.
template <class Same, class Found>
void longRuns(const VectorXd& time, double shortest, double factor, const Same& same, const Found& found) {
  const Eigen::Index rows = time.size();
  double runs = 0.0;
  for (Eigen::Index k = 0; k < rows; ++k) runs += k == 0 || !same(k) ? 1.0 : 0.0;
  for (Eigen::Index from = 0; from < rows;) {
    Eigen::Index to = from + 1;
    while (to < rows && same(to)) ++to;
    const double others = runs > 1.0 ? static_cast<double>(rows - (to - from)) / (runs - 1.0) : 1.0;
    if (to - from >= 10 && time(to - 1) - time(from) >= shortest && static_cast<double>(to - from) >= factor * others)
      found(from, to);
    from = to;
  }
}

}  // namespace

std::vector<Trouble> sensorTrouble(const Recording& recording) {
  std::vector<Trouble> out;
  const auto& wrench = recording.wrench;
  const VectorXd& time = recording.time;
  if (wrench.rows() < 20) return out;
  longRuns(
      time, 0.05, 20.0, [&](Eigen::Index k) { return wrench.row(k) == wrench.row(k - 1); },
      [&](Eigen::Index from, Eigen::Index to) {
        if (to - from == wrench.rows()) return;
        out.push_back(
            {time(from), time(to - 1), heft::say("The sensor's values stand still here: it sent nothing new.")});
      });
  static constexpr const char* kNames[] = {heft::toSay("Force x"),  heft::toSay("Force y"),  heft::toSay("Force z"),
                                           heft::toSay("Torque x"), heft::toSay("Torque y"), heft::toSay("Torque z")};
  for (int c = 0; c < 6; ++c) {
    const double low = wrench.col(c).minCoeff(), high = wrench.col(c).maxCoeff();
    if (low == high) continue;
    longRuns(
        time, 0.01, 8.0, [&](Eigen::Index k) { return wrench(k, c) == wrench(k - 1, c); },
        [&](Eigen::Index from, Eigen::Index to) {
          const double value = wrench(from, c);
          if (value != low && value != high) return;
          Eigen::Index alive = 0;
          for (Eigen::Index k = from + 1; k < to; ++k) alive += wrench.row(k) != wrench.row(k - 1) ? 1 : 0;
          if (2 * alive < to - from) return;
          out.push_back(
              {time(from), time(to - 1),
               heft::say("{} is cut off at {:.4g} {}: the sensor is at the end of its range.",
                         heft::say(fmt::runtime(kNames[c])), value, c < 3 ? "N" : "N m")});
        });
  }
  std::sort(out.begin(), out.end(), [](const Trouble& a, const Trouble& b) { return a.from < b.from; });
  return out;
}

}  // namespace heft
