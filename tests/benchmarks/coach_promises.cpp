// What the coach promises and what comes of it: after a dull demonstration its advice is followed for at most ten
// seconds, with random tools.
//   coach_promises [TOOLS=12] [SEED=1] [steps]
// Printed for each quantity: how many tools had its interval at least halved, how wide it is then, and the width after
// the first and after every piece of advice over the width that was promised (1: kept; above 1: promised too much).
// With "steps" each piece of advice is told: the widths of the three moments where it began, and what was advised.
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "core/online/online_information.h"
#include "tests/core/coach/perform.h"
#include "tests/support/random_tool.h"

namespace {

using namespace heft;

double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(std::lround(share * static_cast<double>(values.size() - 1)))];
}

struct Outcome {
  double share = 1.0;            ///< Width at the end over that at the beginning
  std::vector<double> promises;  ///< Width over the promised one, after each piece of advice
};

Outcome follow(const Payload& payload, unsigned seed, CoachGoal want, bool tell) {
  test::Performer arm(payload, seed);
  const GuidedTool tool = *guidedTool(RobotModel::panda(), arm.mount());
  Recording data = arm.perform(test::dullMotion(), 0.0);
  OnlineEstimator online = test::estimatorFor(data);
  test::feed(online, data);
  online.finish();
  const double before = test::width(online.state(), want);
  Outcome out;
  double moved = 0.0, time = data.time(data.rows() - 1) + 0.2;
  VectorXd q = test::dullMotion().q.bottomRows(1).transpose();
  for (;;) {
    CoachOptions options;
    options.want = want;
    const auto advice = advise(online.information(), tool, arm.gravity(), q, options);
    if (!advice || !advice->needed || moved + advice->motion.duration() > 10.0) break;
    if (tell) {
      const OnlineState& s = online.state();
      const Vector3d moments = s.std.inertiaCom.diagonal().cwiseQuotient(s.payload.inertiaCom.diagonal());
      fmt::print(
          "  {:<8} {:.4f}: {:<16} {:.1f} s, promises {:.4f}; {:.2f} kg, moments {:.3f} {:.3f} {:.3f}; {:.2f} of {}\n",
          toString(want), test::width(s, want), advice->id, advice->motion.duration(), advice->after.of(want),
          s.payload.mass, moments.x(), moments.y(), moments.z(), advice->use.largest(), advice->use.worst());
    }
    data = arm.perform(advice->motion, time);
    test::feed(online, data);
    online.finish();
    out.promises.push_back(test::width(online.state(), want) / advice->after.of(want));
    moved += advice->motion.duration();
    time += advice->motion.duration() + 0.2;
    q = advice->motion.q.bottomRows(1).transpose();
  }
  out.share = test::width(online.state(), want) / before;
  if (tell)
    fmt::print("  {:<8} {:.4f}: after {:.1f} s {:.3f} of before\n", toString(want), test::width(online.state(), want),
               moved, out.share);
  return out;
}

}  // namespace

int main(int argc, char** argv) {
  const int tools = argc > 1 ? std::stoi(argv[1]) : 12;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 1;
  const bool tell = argc > 3 && std::string(argv[3]) == "steps";
  fmt::print("{} tools, seed {}\n\n", tools, seed);
  fmt::print("          halved   width after/before    reached/promised, first     reached/promised, all\n");
  fmt::print("want               median   worst        10 %   median   90 %        10 %   median   90 %\n");
  for (const CoachGoal want : {CoachGoal::mass, CoachGoal::com, CoachGoal::inertia}) {
    int halved = 0;
    std::vector<double> shares, first, all;
    for (int i = 0; i < tools; ++i) {
      std::mt19937 random(seed * 1009u + static_cast<unsigned>(i));
      const Outcome outcome = follow(test::randomTool(random).payload, random(), want, tell);
      halved += outcome.share < 0.5 ? 1 : 0;
      shares.push_back(outcome.share);
      if (!outcome.promises.empty()) first.push_back(outcome.promises.front());
      all.insert(all.end(), outcome.promises.begin(), outcome.promises.end());
    }
    fmt::print(
        "{:<8} {:>3}/{:<3}   {:6.3f}  {:6.3f}       {:5.2f}   {:6.2f}  {:5.2f}       {:5.2f}   {:6.2f}  {:5.2f}\n",
        toString(want), halved, tools, quantile(shares, 0.5), quantile(shares, 1.0), quantile(first, 0.1),
        quantile(first, 0.5), quantile(first, 0.9), quantile(all, 0.1), quantile(all, 0.5), quantile(all, 0.9));
    std::fflush(stdout);
  }
}
