// Prints how often Heft's 95 % intervals hold the truth where data are few, loud or of coarse encoders:
//   interval_study [RECORDINGS=300] [SEED=1] [CLASS]
// RECORDINGS of each class, of four motions in turn; the coloured noise beside the white is 0.03 N in every second one
// and in proportion to it in the others. CLASS: only those whose name contains it.
#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>
#include <thread>

#include "tests/support/coverage.h"

namespace {

using namespace heft;

struct StudyMotion {
  MotionKind kind;
  double speed;
};
constexpr StudyMotion kMotions[] = {
    {MotionKind::excitation, 1.0}, {MotionKind::free, 1.0}, {MotionKind::free, 0.3}, {MotionKind::pickAndPlace, 1.0}};

struct Encoder {
  const char* name;
  double noise, step;  // [rad]
  bool velocities;
};
constexpr Encoder kEncoders[] = {{"exact", 0.0, 0.0, true},
                                 {"noise 1e-5", 1e-5, 0.0, false},
                                 {"noise 1e-4", 1e-4, 0.0, false},
                                 {"step 1e-4", 0.0, 1e-4, false}};

/// What a logger does to a recording of 1 kHz: coarse steps of the sensor, values that are repeated until the next one
/// comes, rows that are missing.
struct Logger {
  const char* name;
  double stepN = 0.0;       ///< Of the forces; the torques' is a twentieth [N m]
  int held = 0;             ///< [rows] Each value of the wrench is repeated so often
  double longestGap = 0.0;  ///< [s] Two gaps a second, of 5 ms to this
  int every = 1;            ///< [rows] One of so many is kept
};
constexpr Logger kLoggers[] = {
    {"steps 1 N", 1.0},         {"steps 0.2 N", 0.2},          {"held 20 ms", 0.0, 20},
    {"held 50 ms", 0.0, 50},    {"gaps 44 ms", 0.0, 0, 0.044}, {"steps 1 N held 20 ms", 1.0, 20},
    {"30 Hz", 0.0, 0, 0.0, 33}, {"50 Hz", 0.0, 0, 0.0, 20},    {"20 Hz", 0.0, 0, 0.0, 50}};

void keepRows(Recording& recording, const std::vector<Eigen::Index>& rows) {
  recording.time = recording.time(rows).eval();
  recording.q = recording.q(rows, Eigen::all).eval();
  if (recording.dq.rows() > 0) recording.dq = recording.dq(rows, Eigen::all).eval();
  recording.wrench = recording.wrench(rows, Eigen::all).eval();
}

void logBy(const Logger& logger, Recording& recording, std::mt19937& random) {
  if (logger.held > 1)
    for (Eigen::Index k = 0; k < recording.rows(); ++k)
      recording.wrench.row(k) = recording.wrench.row(k / logger.held * logger.held).eval();
  if (logger.stepN > 0.0)
    for (Eigen::Index c = 0; c < 6; ++c) {
      const double step = c < 3 ? logger.stepN : logger.stepN / 20.0;
      // Ties, which the simulated sensor's own resolution makes, to even: away from zero they would make all loads
      // larger.
      for (double& reading : recording.wrench.col(c)) reading = std::nearbyint(reading / step) * step;
    }
  std::vector<Eigen::Index> kept;
  for (Eigen::Index k = 0; k < recording.rows() && logger.every > 1; k += logger.every) kept.push_back(k);
  if (!kept.empty()) return keepRows(recording, kept);
  if (logger.longestGap <= 0.0) return;
  std::uniform_real_distribution<double> length(0.005, logger.longestGap), pause(0.2, 0.8);
  double next = pause(random), until = 0.0;
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    const double t = recording.time(k);
    if (t >= next) {
      until = t + length(random);
      next = until + pause(random);
    }
    if (t >= until) kept.push_back(k);
  }
  keepRows(recording, kept);
}

void printClass(const std::string& name, const test::CoverageOptions& options, int recordings, int threads) {
  std::vector<test::CoverageOptions> kinds;
  const int count = 2 * static_cast<int>(std::size(kMotions));
  for (int i = 0; i < count; ++i) {
    const StudyMotion& motion = kMotions[i / 2];
    kinds.push_back(options);
    kinds.back().motion = motion.kind;
    kinds.back().speed = motion.speed;
    kinds.back().colour = i % 2 == 0 ? 1.0 : options.noise;
    kinds.back().recordings = (recordings + count - 1 - i) / count;
    kinds.back().seed += static_cast<unsigned>(1000 * i);
  }
  const auto r = test::measureCoverage(kinds, threads);
  fmt::print(
      "{:<26} {:.3f} {:.3f} {:.3f} {:.3f}   {:5.2f} {:5.2f} {:5.2f}   {:6.3f} {:6.3f} {:6.2f}   {:5} {:.3f} {:4} {:4} "
      "{:4}\n",
      name, r.mass.inside, r.com.inside, r.inertia.inside, r.joint, r.mass.ratio, r.com.ratio, r.inertia.ratio,
      100.0 * r.mass.width, r.com.width, 100.0 * r.inertia.width, r.claims, r.coverageOfClaims, r.beyond4, r.beyond5,
      r.failed);
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  const int recordings = argc > 1 ? std::stoi(argv[1]) : 300;
  test::CoverageOptions options;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 1;
  options.seed = seed;
  const std::string only = argc > 3 ? argv[3] : "";
  const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  fmt::print("{} recordings a class, seed {}\n\n", recordings, options.seed);
  fmt::print(
      "                           inside 95 %               error/std (rms)     median half width      numbers called "
      "measured\n");
  fmt::print(
      "class                      mass  com   inert joint    mass  com inertia   mass %  mm   inertia %  count inside "
      ">4sd >5sd fails\n");
  for (const double duration : {1.5, 3.0, 5.0, 10.0, 20.0})
    for (const double noise : {0.02, 0.1, 0.5})
      for (const Encoder& encoder : kEncoders) {
        const std::string name = fmt::format("{} s, {} N, {}", duration, noise, encoder.name);
        if (name.find(only) == std::string::npos) continue;
        options.duration = duration;
        options.noise = noise / SensorModel{}.forceNoise;
        options.jointNoise = encoder.noise;
        options.jointStep = encoder.step;
        options.velocities = encoder.velocities;
        printClass(name, options, recordings, threads);
      }
  for (const double duration : {5.0, 20.0})
    for (const Logger& logger : kLoggers) {
      const std::string name = fmt::format("{} s, {}", duration, logger.name);
      if (name.find(only) == std::string::npos) continue;
      options = {};
      options.seed = seed;
      options.duration = duration;
      options.alter = [&logger](Recording& recording, std::mt19937& random) { logBy(logger, recording, random); };
      printClass(name, options, recordings, threads);
    }
}
