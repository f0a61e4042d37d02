// How long a Reality check goes on at most after it was asked to stop: the longest work of one thread between two stop
// points, for each recording given, and where it ends.
//   stop_gaps RECORDING ...          (of the Panda, or with poses)
// Processor time of the thread, so that other programs do not count.
#include <execinfo.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/stop.h"
#include "core/diagnosis/diagnose.h"
#include "core/import/import.h"
#include "core/robot/robot_model.h"

namespace {

constexpr double kTold = 0.02;  // [s] Shorter ones are of no interest
constexpr int kDeepest = 40;

struct Gap {
  double seconds = 0.0;
  const void* from = nullptr;
  std::vector<void*> stack;  ///< Where it ends.
};

std::mutex mutex;
std::map<std::pair<const void*, const void*>, Gap> gaps;  ///< The longest of each pair of places.
thread_local const void* last = nullptr;
thread_local double lastAt = 0.0;

double processorTime() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void observe(const void* place) {
  const double seconds = processorTime() - lastAt;
  if (seconds > kTold && last != nullptr) {
    void* stack[kDeepest];
    const int depth = backtrace(stack, kDeepest);
    const std::lock_guard lock(mutex);
    Gap& gap = gaps[{last, place}];
    if (seconds > gap.seconds) gap = {seconds, last, std::vector<void*>(stack, stack + depth)};
  }
  last = place;
  lastAt = processorTime();
}

/// The function that an address lies in, by the program's own symbols.
std::string nameOf(const void* address) {
  const auto command = fmt::format(
      "addr2line -Cfe /proc/{}/exe $(printf 0x%x $(({} - 0x$(grep -m1 -o '^[0-9a-f]*' "
      "/proc/{}/maps))))",
      getpid(), reinterpret_cast<std::size_t>(address) - 1, getpid());
  std::string name;
  FILE* const out = popen(command.c_str(), "r");
  if (out == nullptr) return "?";
  for (int c = std::fgetc(out); c != EOF && c != '\n'; c = std::fgetc(out)) name += static_cast<char>(c);
  while (std::fgetc(out) != EOF) {
  }
  pclose(out);
  for (const std::string_view outside : {"(anonymous namespace)::", "diagnosis::", "heft::"})
    for (auto at = name.find(outside); at != std::string::npos; at = name.find(outside)) name.erase(at, outside.size());
  return name.substr(0, std::min<std::size_t>(name.find_first_of("(<"), 60));
}

void print(const std::string& file) {
  std::vector<Gap> sorted;
  for (const auto& [places, gap] : gaps) sorted.push_back(gap);
  std::ranges::sort(sorted, std::greater<>(), &Gap::seconds);
  if (sorted.empty()) fmt::print("{}: less than {:.0f} ms\n", file, 1e3 * kTold);
  for (std::size_t i = 0; i < std::min<std::size_t>(sorted.size(), 8); ++i) {
    const Gap& gap = sorted[i];
    fmt::print("{}: {:.0f} ms from {} to", file, 1e3 * gap.seconds, nameOf(gap.from));
    // Without the observer and stopPoint(), and without what calls a diagnosis.
    for (std::size_t f = 2; f < std::min<std::size_t>(gap.stack.size(), 8); ++f)
      fmt::print(" < {}", nameOf(gap.stack[f]));
    fmt::print("\n");
    std::fflush(stdout);
  }
}

}  // namespace

int main(int count, char** arguments) {
  using namespace heft;
  for (int i = 1; i < count; ++i) {
    const auto read = openRecording(arguments[i]);
    if (!read) {
      fmt::print(stderr, "{}\n", read.error().message);
      return 1;
    }
    const RobotModel* const robot = read->recording.meta.robot ? &RobotModel::panda() : nullptr;
    gaps.clear();
    observe(&gaps);
    stopObserver = &observe;
    const auto report = diagnose(read->recording, robot, {});
    stopObserver = nullptr;
    observe(&gaps);
    print(arguments[i]);
    if (!report) fmt::print(stderr, "{}\n", report.error().message);
  }
  return 0;
}
