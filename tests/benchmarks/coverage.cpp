// Prints how often Heft's 95 % intervals hold the truth, and how large its errors are, for each kind of motion:
//   coverage [RECORDINGS=300] [SEED=1]
// Recordings are simulated with the Gamma's white and coloured noise, resolution and biases, tools of 0.2-1.5 kg; it
// says nothing about effects that the simulator leaves out.
#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <thread>

#include "tests/support/coverage.h"

int main(int argc, char** argv) {
  using namespace heft;
  test::CoverageOptions options;
  if (argc > 1) options.recordings = std::stoi(argv[1]);
  if (argc > 2) options.seed = static_cast<unsigned>(std::stoul(argv[2]));
  const int threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  struct Row {
    const char* name;
    MotionKind motion;
    double speed;
    bool shape;
  };
  const Row rows[] = {{"excitation", MotionKind::excitation, 1.0, false},
                      {"pick-and-place", MotionKind::pickAndPlace, 1.0, false},
                      {"free", MotionKind::free, 1.0, false},
                      {"slow", MotionKind::free, 0.3, false},
                      {"slow + shape", MotionKind::free, 0.3, true}};
  fmt::print("{} recordings of 20 s each, seed {}\n\n", options.recordings, options.seed);
  fmt::print("                 inside 95 % interval      error/std (rms)      median error               \n");
  fmt::print(
      "motion           mass   com    inertia    mass  com   inertia  mass %  com %  I_S %  I_C %  fails unphys  "
      "s/estimate\n");
  for (const Row& row : rows) {
    options.motion = row.motion;
    options.speed = row.speed;
    options.shape = row.shape;
    const auto r = test::measureCoverage(options, threads);
    fmt::print(
        "{:<16} {:.3f}  {:.3f}  {:.3f}      {:.2f}  {:.2f}  {:.2f}     {:6.3f} {:6.3f} {:6.2f} {:6.2f} {:5} {:5}    "
        "{:.3f}\n",
        row.name, r.mass.inside, r.com.inside, r.inertia.inside, r.mass.ratio, r.com.ratio, r.inertia.ratio,
        100 * r.massError, 100 * r.comError, 100 * r.inertiaOriginError, 100 * r.inertiaComError, r.failed,
        r.unphysical, r.seconds);
    std::fflush(stdout);
  }
}
