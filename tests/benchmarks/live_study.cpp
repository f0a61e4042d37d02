// Whether the numbers that are told while the hand moves hold: recordings fed sample by sample, with what encoders and
// time stamps do to them.
//   live_study [RECORDINGS=20] [SEED=1] [CLASS]
// Of all moments, one a second: how often a number is told; of masses, centres and moments called measured how often
// the 95 % interval holds the truth, and how many are more than 5 standard deviations off; what is said instead.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <numbers>
#include <random>
#include <string>

#include "core/online/online_estimator.h"
#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace {

using namespace heft;
using Random = std::mt19937;

struct Class {
  const char* name;
  double jointNoise, jointStep;                                          ///< [rad]
  void (*stamps)(VectorXd& time, Random& random) = [](auto&, auto&) {};  ///< What happens to the time stamps
};

template <int microseconds>
void jittering(VectorXd& time, Random& random) {
  std::normal_distribution<double> normal(0.0, 1e-6 * microseconds);
  for (auto& t : time) t += normal(random);
}
/// Stamped when they are passed on, which is never too early.
template <int microseconds>
void late(VectorXd& time, Random& random) {
  std::normal_distribution<double> normal(0.0, 1e-6 * microseconds);
  for (auto& t : time) t += std::abs(normal(random));
}
/// Stamps that wander to and fro three times a second, as buffers between two programs make them.
template <int microseconds>
void wandering(VectorXd& time, Random& random) {
  const double phase = 6.0 * static_cast<double>(random()) / 4294967296.0;
  for (auto& t : time) t += 1e-6 * microseconds * std::sin(2.0 * std::numbers::pi * 3.0 * t + phase);
}
/// So many samples are stamped when the last of them came.
template <int count>
void inBursts(VectorXd& time, Random&) {
  for (Eigen::Index k = 0; k < time.size(); ++k)
    time(k) = time(std::min(time.size() - 1, k / count * count + count - 1)) + 1e-6 * static_cast<double>(k % count);
}
/// One in fifty comes late.
template <int microseconds>
void lateNowAndThen(VectorXd& time, Random& random) {
  for (auto& t : time) t += random() % 50 == 0 ? 1e-6 * microseconds : 0.0;
}

const Class kClasses[] = {{"exact", 0.0, 0.0},
                          {"joint noise 1e-5", 1e-5, 0.0},
                          {"joint noise 1e-4", 1e-4, 0.0},
                          {"joint step 1e-4", 0.0, 1e-4},
                          {"jitter 0.5 ms", 1e-5, 0.0, jittering<500>},
                          {"jitter 1 ms", 1e-5, 0.0, jittering<1000>},
                          {"jitter 3 ms", 1e-5, 0.0, jittering<3000>},
                          {"late by 1 ms", 1e-5, 0.0, late<1000>},
                          {"late by 1.5 ms", 1e-5, 0.0, late<1500>},
                          {"late by 2 ms", 1e-5, 0.0, late<2000>},
                          {"wandering 1 ms", 1e-5, 0.0, wandering<1000>},
                          {"wandering 3 ms", 1e-5, 0.0, wandering<3000>},
                          {"wandering 10 ms", 1e-5, 0.0, wandering<10000>},
                          {"bursts of 5", 1e-5, 0.0, inBursts<5>},
                          {"bursts of 20", 1e-5, 0.0, inBursts<20>},
                          {"late 3 ms", 1e-5, 0.0, lateNowAndThen<3000>}};

struct Held {
  int told = 0, inside = 0, beyond5 = 0;
  void count(const Interval& interval, double std, double value, double truth) {
    ++told;
    inside += interval.lower <= truth && truth <= interval.upper ? 1 : 0;
    beyond5 += std::abs(value - truth) > 5.0 * std ? 1 : 0;
  }
};

struct Tally {
  int moments = 0, estimated = 0;
  Held mass, com, inertia;
  std::map<std::string, int> said;
};

void judge(const OnlineState& state, const Payload& truth, Tally& tally) {
  ++tally.moments;
  for (const auto& finding : state.findings) ++tally.said[finding.code];
  if (!state.estimated) return;
  ++tally.estimated;
  const auto& id = state.identifiability;
  const auto& in = state.interval95;
  if (id.mass == Source::data) tally.mass.count(in.mass, state.std.mass, state.payload.mass, truth.mass);
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    if (id.com[k] == Source::data) tally.com.count(in.com[k], state.std.com(i), state.payload.com(i), truth.com(i));
    if (id.inertia[k][k] == Source::data)
      tally.inertia.count(in.inertiaCom[k][k], state.std.inertiaCom(i, i), state.payload.inertiaCom(i, i),
                          truth.inertiaCom(i, i));
  }
}

void one(const Class& kind, unsigned seed, Tally& tally) {
  Random random(seed);
  const Payload payload = test::randomTool(random).payload;
  SimulateOptions options;
  options.motion = seed % 2 == 0 ? MotionKind::free : MotionKind::pickAndPlace;
  options.duration = 12.0;
  options.rateHz = 250.0;
  options.seed = random();
  options.positionNoise = kind.jointNoise;
  options.positionStep = kind.jointStep;
  auto simulated = simulate(RobotModel::panda(), payload, options);
  if (!simulated) return;
  Recording& recording = simulated->recording;
  recording.dq.resize(0, recording.dq.cols());
  kind.stamps(recording.time, random);
  auto online = OnlineEstimator::create(recording.meta, &RobotModel::panda());
  double last = -1.0;
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    OnlineSample sample = sampleOf(recording, k);
    sample.time = last = std::max(sample.time, last + 1e-6);
    online->add(sample);
    if (k % 250 == 249) judge(online->state(), payload, tally);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int recordings = argc > 1 ? std::atoi(argv[1]) : 20;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 1;
  const std::string only = argc > 3 ? argv[3] : "";
  fmt::print("{:<18} {:>6}   {:^17}   {:^17}   {:^17}\n", "", "told", "mass", "centre", "moments");
  for (const auto& kind : kClasses) {
    if (std::string(kind.name).find(only) == std::string::npos) continue;
    Tally tally;
    for (int k = 0; k < recordings; ++k) one(kind, seed * 1009u + static_cast<unsigned>(k), tally);
    fmt::print("{:<18} {:6.2f}", kind.name, static_cast<double>(tally.estimated) / std::max(1, tally.moments));
    for (const Held& held : {tally.mass, tally.com, tally.inertia})
      fmt::print("   {:5} {:.3f} {:5}", held.told, static_cast<double>(held.inside) / std::max(1, held.told),
                 held.beyond5);
    for (const auto& [code, count] : tally.said) fmt::print("  {} {}", code, count);
    fmt::print("\n");
    std::fflush(stdout);
  }
  return 0;
}
