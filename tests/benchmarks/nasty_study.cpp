// Recordings that are valid and nasty: what loggers, sensors and people do to them, one or two things at a time, with
// tools of 5 g to 20 kg.
//   nasty_study [RECORDINGS=200] [SEED=1] [RECORDING [FILE.csv]]
// Of the numbers that are called measured ("data"): how many are more than 4 and 5 standard deviations off, and whether
// a warning stood beside them. With the number of one recording, only that one, which is written to FILE.csv.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "core/estimation/estimate.h"
#include "core/estimation/uncertainty.h"
#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace {

using namespace heft;
using Random = std::mt19937;

double uniform(Random& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) + 0.5) / 4294967296.0;
}
Eigen::Index whole(Random& random, Eigen::Index low, Eigen::Index high) {
  return low + static_cast<Eigen::Index>(random() % static_cast<unsigned long>(high - low));
}
template <class T, std::size_t n>
T oneOf(Random& random, const T (&values)[n]) {
  return values[random() % n];
}

void keepRows(Recording& recording, const std::vector<Eigen::Index>& rows) {
  recording.time = recording.time(rows).eval();
  recording.q = recording.q(rows, Eigen::all).eval();
  if (recording.dq.rows() > 0) recording.dq = recording.dq(rows, Eigen::all).eval();
  recording.wrench = recording.wrench(rows, Eigen::all).eval();
}

void keepRange(Recording& recording, Eigen::Index from, Eigen::Index count) {
  std::vector<Eigen::Index> rows(static_cast<std::size_t>(std::min(count, recording.rows() - from)));
  std::iota(rows.begin(), rows.end(), from);
  keepRows(recording, rows);
}

/// A stretch in the middle of the recording, a tenth to a third of it.
std::pair<Eigen::Index, Eigen::Index> stretch(const Recording& recording, Random& random) {
  const auto n = static_cast<double>(recording.rows());
  const auto from = static_cast<Eigen::Index>(uniform(random, 0.3, 0.6) * n);
  return {from, from + static_cast<Eigen::Index>(uniform(random, 0.1, 0.33) * n)};
}

double quantile(VectorXd values, double share) {
  std::sort(values.begin(), values.end());
  return values(static_cast<Eigen::Index>(share * static_cast<double>(values.size() - 1)));
}

// What happens to a recording; each gets it as it was measured.
void thinned(Recording& r, Random& random) {
  std::vector<Eigen::Index> rows;
  const double share = uniform(random, 0.2, 0.9);
  for (Eigen::Index k = 0; k < r.rows(); ++k)
    if (k < 2 || uniform(random, 0, 1) < share) rows.push_back(k);
  keepRows(r, rows);
}
void withGaps(Recording& r, Random& random) {
  std::vector<char> gone(static_cast<std::size_t>(r.rows()), 0);
  for (Eigen::Index k = whole(random, 3, 30); k > 0; --k) {
    const auto from = whole(random, 2, r.rows()), length = whole(random, 5, 200);
    for (Eigen::Index i = from; i < std::min(r.rows(), from + length); ++i) gone[static_cast<std::size_t>(i)] = 1;
  }
  std::vector<Eigen::Index> rows;
  for (Eigen::Index k = 0; k < r.rows(); ++k)
    if (gone[static_cast<std::size_t>(k)] == 0) rows.push_back(k);
  keepRows(r, rows);
}
void clockJumps(Recording& r, Random& random) {
  r.time.tail(whole(random, r.rows() / 4, 3 * r.rows() / 4)).array() += oneOf(random, {0.5, 5.0, 3600.0});
}
void stampsJitter(Recording& r, Random& random) {
  std::normal_distribution<double> normal(0.0, oneOf(random, {2e-4, 1e-3, 3e-3}));
  for (auto& t : r.time) t += normal(random);
  std::sort(r.time.begin(), r.time.end());
  for (Eigen::Index k = 1; k < r.rows(); ++k) r.time(k) = std::max(r.time(k), r.time(k - 1) + 1e-9);
}
void slow(Recording& r, Random&) {
  std::vector<Eigen::Index> rows;
  const auto step = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(r.rateHz() / 30.0));
  for (Eigen::Index k = 0; k < r.rows(); k += step) rows.push_back(k);
  keepRows(r, rows);
}
void deadChannels(Recording& r, Random& random) {
  for (auto count = whole(random, 1, 3); count > 0; --count) r.wrench.col(whole(random, 0, 6)).setZero();
}
void deadForces(Recording& r, Random&) { r.wrench.leftCols<3>().setZero(); }
void stuckJoint(Recording& r, Random& random) {
  const auto j = whole(random, 0, 7);
  r.q.col(j).setConstant(r.q(0, j));
  if (r.dq.rows() > 0) r.dq.col(j).setZero();
}
void hugeZero(Recording& r, Random& random) {
  const double zero = oneOf(random, {1e3, 1e4, 1e6});
  r.wrench.rowwise() += zero * (Eigen::Matrix<double, 1, 6>() << 1, -1, 1, 0.02, 0.02, -0.02).finished();
}
void coarse(Recording& r, Random& random) {
  const double step = oneOf(random, {0.2, 1.0, 3.0});
  for (Eigen::Index c = 0; c < 6; ++c) {
    const double own = c < 3 ? step : 0.05 * step;
    r.wrench.col(c) = ((r.wrench.col(c).array() / own).round() * own).matrix().eval();
  }
}
void heldWrench(Recording& r, Random& random) {
  const auto rows = oneOf<Eigen::Index>(random, {5, 20, 50});
  for (Eigen::Index k = 0; k < r.rows(); ++k) r.wrench.row(k) = r.wrench.row(k / rows * rows).eval();
}
void heldJoints(Recording& r, Random& random) {
  const auto rows = oneOf<Eigen::Index>(random, {5, 20});
  for (Eigen::Index k = 0; k < r.rows(); ++k) r.q.row(k) = r.q.row(k / rows * rows).eval();
}
void spikes(Recording& r, Random& random) {
  for (auto k = whole(random, 5, 100); k > 0; --k)
    r.wrench(whole(random, 0, r.rows()), whole(random, 0, 6)) +=
        oneOf(random, {-1.0, 1.0}) * oneOf(random, {20.0, 200.0, 1e5});
}
void clippedBothEnds(Recording& r, Random& random) {
  for (int k = 0; k < 2; ++k) {
    auto y = r.wrench.col(whole(random, 0, 6));
    const double low = quantile(y, uniform(random, 0.05, 0.4)), high = quantile(y, uniform(random, 0.6, 0.95));
    y = y.cwiseMax(low).cwiseMin(high).eval();
  }
}
void clippedAtOneEnd(Recording& r, Random& random) {
  auto y = r.wrench.col(whole(random, 0, 6));
  y = y.cwiseMin(quantile(y, uniform(random, 0.5, 0.9))).eval();
}
void fewRows(Recording& r, Random& random) {
  keepRange(r, whole(random, 0, r.rows() / 2), oneOf<Eigen::Index>(random, {3, 5, 10, 20, 40}));
}
void shortOne(Recording& r, Random& random) {
  keepRange(r, whole(random, 0, r.rows() / 2), static_cast<Eigen::Index>(uniform(random, 0.2, 2.0) * r.rateHz()));
}
void standing(Recording& r, Random& random) {
  std::normal_distribution<double> normal;
  const auto at = r.rows() / 2;
  const auto wrench = r.wrench.row(at).eval();
  r.q.rowwise() = r.q.row(at).eval();
  if (r.dq.rows() > 0) r.dq.setZero();
  for (Eigen::Index k = 0; k < r.rows(); ++k)
    for (Eigen::Index c = 0; c < 6; ++c) r.wrench(k, c) = wrench(c) + (c < 3 ? 0.05 : 0.002) * normal(random);
}
void withoutVelocities(Recording& r, Random&) { r.dq.resize(0, r.dq.cols()); }
void repeatedHalf(Recording& r, Random&) {
  const auto half = r.rows() / 2;
  r.q.middleRows(half, half) = r.q.topRows(half).eval();
  if (r.dq.rows() > 0) r.dq.middleRows(half, half) = r.dq.topRows(half).eval();
  r.wrench.middleRows(half, half) = r.wrench.topRows(half).eval();
}
void frozenSensor(Recording& r, Random& random) {
  const auto [from, to] = stretch(r, random);
  for (auto k = from; k < to; ++k) r.wrench.row(k) = r.wrench.row(from).eval();
}
void frozenChannel(Recording& r, Random& random) {
  const auto [from, to] = stretch(r, random);
  const auto c = whole(random, 0, 6);
  r.wrench.col(c).segment(from, to - from).setConstant(r.wrench(from, c));
}
void frozenArm(Recording& r, Random& random) {
  const auto [from, to] = stretch(r, random);
  for (auto k = from; k < to; ++k) r.q.row(k) = r.q.row(from).eval();
  if (r.dq.rows() > 0) r.dq.middleRows(from, to - from).setZero();
}
void taredInBetween(Recording& r, Random& random) {
  const auto from = whole(random, r.rows() / 3, 2 * r.rows() / 3);
  const auto zero = r.wrench.row(from).eval();
  r.wrench.bottomRows(r.rows() - from).rowwise() -= zero;
}
void zerosInBetween(Recording& r, Random& random) {
  const double share = oneOf(random, {0.001, 0.01, 0.05});
  for (Eigen::Index k = 0; k < r.rows(); ++k)
    if (uniform(random, 0, 1) < share) r.wrench.row(k).setZero();
}
void nothing(Recording&, Random&) {}

struct Nastiness {
  const char* name;
  void (*happen)(Recording&, Random&);
};
constexpr Nastiness kAll[] = {{"thinned", thinned},
                              {"gaps", withGaps},
                              {"clock jumps", clockJumps},
                              {"stamps jitter", stampsJitter},
                              {"30 Hz", slow},
                              {"dead channels", deadChannels},
                              {"dead forces", deadForces},
                              {"stuck joint", stuckJoint},
                              {"huge zero", hugeZero},
                              {"coarse", coarse},
                              {"held wrench", heldWrench},
                              {"held joints", heldJoints},
                              {"spikes", spikes},
                              {"clipped, both ends", clippedBothEnds},
                              {"clipped, one end", clippedAtOneEnd},
                              {"few rows", fewRows},
                              {"short", shortOne},
                              {"standing", standing},
                              {"no velocities", withoutVelocities},
                              {"repeated half", repeatedHalf},
                              {"frozen sensor", frozenSensor},
                              {"frozen channel", frozenChannel},
                              {"frozen arm", frozenArm},
                              {"tared in between", taredInBetween},
                              {"zeros in between", zerosInBetween},
                              {"nothing", nothing}};

struct Tally {
  int recordings = 0, refused = 0, claims = 0, beyond4 = 0, beyond5 = 0, silent = 0, notFinite = 0;
  int doubted = 0, doubted4 = 0, good = 0, goodClaims = 0;  ///< good: nothing happened to the recording
  std::vector<std::string> bad;                             ///< Beyond 4
};

/// `what`: which recording, and what happened to it.
void judge(const EstimateReport& report, const Payload& truth, const std::string& what, Tally& tally) {
  constexpr const char* kNames[] = {"mass", "x", "y", "z", "Ixx", "Ixy", "Ixz", "Iyy", "Iyz", "Izz"};
  const Vector10d value = componentsOf(report.payload), std = componentsOf(report.std), right = componentsOf(truth);
  if (!value.allFinite() || !std.allFinite()) ++tally.notFinite;
  const auto& id = report.identifiability;
  const auto& I = id.inertia;
  const Source sources[10] = {id.mass, id.com[0], id.com[1], id.com[2], I[0][0],
                              I[0][1], I[0][2],   I[1][1],   I[1][2],   I[2][2]};
  const bool warned = std::ranges::any_of(report.findings, [](const auto& f) { return f.severity != Severity::info; });
  const bool good = what.ends_with(", nothing") || what.ends_with(", nothing + nothing");
  for (int k = 0; k < 10; ++k) {
    const double off = std::abs(value(k) - right(k)) / std::max(std(k), 1e-12);
    tally.doubted += sources[k] == Source::doubted ? 1 : 0;
    tally.doubted4 += sources[k] == Source::doubted && off > 4.0 ? 1 : 0;
    tally.good += good && sources[k] <= Source::doubted ? 1 : 0;
    tally.goodClaims += good && sources[k] == Source::data ? 1 : 0;
    if (sources[k] != Source::data) continue;
    ++tally.claims;
    if (off <= 4.0) continue;
    ++tally.beyond4;
    tally.beyond5 += off > 5.0 ? 1 : 0;
    tally.silent += warned ? 0 : 1;
    tally.bad.push_back(fmt::format("{}: {} {:.4g} for {:.4g}, {:.1f} sd", what, kNames[k], value(k), right(k), off));
  }
}

void one(unsigned seed, unsigned index, Tally& tally, const char* file = nullptr) {
  Random random(seed * 100003u + index);
  Payload payload = test::randomTool(random).payload;
  const double mass =
      uniform(random, 0, 1) < 0.5 ? payload.mass : std::exp(uniform(random, std::log(0.005), std::log(20.0)));
  payload.inertiaCom *= mass / payload.mass;
  payload.mass = mass;
  SimulateOptions options;
  options.motion = oneOf(random, {MotionKind::excitation, MotionKind::free, MotionKind::pickAndPlace});
  options.duration = oneOf(random, {8.0, 15.0});
  options.rateHz = oneOf(random, {250.0, 1000.0, 1000.0, 4000.0});
  options.speed = uniform(random, 0, 1) < 0.2 ? 0.4 : 1.0;
  options.seed = random();
  auto simulated = simulate(RobotModel::panda(), payload, options);
  if (!simulated) return;
  ++tally.recordings;
  const Nastiness& first = kAll[index % std::size(kAll)];
  std::string what = fmt::format("{}, {}", index, first.name);
  first.happen(simulated->recording, random);
  if (uniform(random, 0, 1) < 0.35 && simulated->recording.rows() > 500) {
    const Nastiness& second = kAll[random() % std::size(kAll)];
    second.happen(simulated->recording, random);
    what += fmt::format(" + {}", second.name);
  }
  const auto checked = checkRecording(std::move(simulated->recording), NumberForm::plain);
  if (!checked) {
    ++tally.refused;
    return;
  }
  if (file) (void)writeRecording(checked->recording, file);
  auto report = estimate(checked->recording, &RobotModel::panda(), {});
  if (!report) {
    ++tally.refused;
    return;
  }
  report->findings.insert(report->findings.end(), checked->findings.begin(), checked->findings.end());
  judge(*report, payload, what, tally);
}

}  // namespace

int main(int argc, char** argv) {
  const int recordings = argc > 1 ? std::atoi(argv[1]) : 200;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::strtoul(argv[2], nullptr, 10)) : 1;
  Tally tally;
  if (argc > 3)
    one(seed, static_cast<unsigned>(std::strtoul(argv[3], nullptr, 10)), tally, argc > 4 ? argv[4] : nullptr);
  else
    for (int k = 0; k < recordings; ++k) one(seed, static_cast<unsigned>(k), tally);
  const double share = 100.0 / std::max(1, tally.claims);
  fmt::print("{} recordings, seed {}: {} refused, {} not finite\n", tally.recordings, seed, tally.refused,
             tally.notFinite);
  fmt::print(
      "{} numbers called measured: {} beyond 4 sd ({:.2f} %), {} beyond 5 sd ({:.2f} %), {} of those beyond 4 without "
      "a warning\n",
      tally.claims, tally.beyond4, share * tally.beyond4, tally.beyond5, share * tally.beyond5, tally.silent);
  fmt::print("{} numbers doubted: {} beyond 4 sd ({:.1f} %); of {} where nothing happened, {} called measured\n",
             tally.doubted, tally.doubted4, 100.0 * tally.doubted4 / std::max(1, tally.doubted), tally.good,
             tally.goodClaims);
  for (const std::string& bad : tally.bad) fmt::print("  {}\n", bad);
  return 0;
}
