// Prints how often Heft's 95 % intervals hold the truth where data are few, loud or of coarse encoders:
//   interval_study [RECORDINGS=300] [SEED=1] [CLASS]
// RECORDINGS of each class, of four motions in turn; the coloured noise beside the white is 0.03 N in every second one
// and in proportion to it in the others. CLASS: only those whose name contains it.
#include <fmt/format.h>

#include <cstdlib>
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
  options.seed = argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 1;
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
}
