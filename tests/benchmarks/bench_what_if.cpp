// What a step of a knob costs: every cause at three sizes on recordings of 20 s and 2 min at 1 kHz; getting ready, the
// median and the slowest step, in milliseconds by the clock.
//   bench_what_if
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "core/diagnosis/what_if.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void measure(double duration) {
  using namespace heft;
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.duration = duration;
  options.seed = 7;
  const auto made =
      simulate(RobotModel::panda(), test::boxPayload(0.9, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06}), options);
  if (!made) return fmt::print("{}\n", made.error().message);
  const auto start = Clock::now();
  const auto whatIf = WhatIf::make(made->recording, {std::shared_ptr<void>(), &RobotModel::panda()},
                                   {{0.0, duration, MarkLabel::free, ""}});
  if (!whatIf) return fmt::print("{}\n", whatIf.error().message);
  const double ready = millisecondsSince(start);
  std::vector<double> steps;
  std::string slowest;
  double longest = 0.0;
  for (std::size_t k = 0; k < whatIf->knobs().size(); ++k)
    for (const double position : {0.2, 0.5, 1.0}) {
      std::vector<double> positions(whatIf->knobs().size(), 0.0);
      positions[k] = position;
      const auto before = Clock::now();
      const WhatIfState state = whatIf->at(positions);
      steps.push_back(millisecondsSince(before));
      if (steps.back() <= longest || !std::isfinite(state.force)) continue;
      longest = steps.back();
      slowest = whatIf->knobs()[k].cause;
    }
  std::ranges::nth_element(steps, steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2));
  fmt::print("{:5.0f} s: {} knobs ready in {:.0f} ms; a step {:.1f} ms, the slowest {:.1f} ms ({})\n", duration,
             whatIf->knobs().size(), ready, steps[steps.size() / 2], longest, slowest);
}

}  // namespace

int main() {
  for (const double duration : {20.0, 120.0}) measure(duration);
}
