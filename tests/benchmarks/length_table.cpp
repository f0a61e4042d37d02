// Time and memory of estimate and diagnose against a recording's length:
// `length_table HEFT FOLDER [estimate|diagnose] [SECONDS ...]`.
// Each length is simulated once at 1 kHz and kept in FOLDER. The reference stands for the limit: a program that maps
// the file, turns each number into a double once and adds up normal equations of 17 columns.
#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <Eigen/Core>
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace {

constexpr int kColumns = 17;  // Bias, ten inertial parameters and the wrench's own column

/// Sum of the normal equations' diagonal, so that nothing of the work may be left out.
double referenceOf(const std::string& path) {
  const int file = open(path.c_str(), O_RDONLY);
  const auto size = static_cast<std::size_t>(std::filesystem::file_size(path));
  void* mapped = mmap(nullptr, size, PROT_READ, MAP_PRIVATE, file, 0);
  if (file < 0 || mapped == MAP_FAILED) throw std::runtime_error(path + ": cannot be mapped");
  const char *at = static_cast<const char*>(mapped), *const end = at + size;
  Eigen::Matrix<double, kColumns, kColumns> normal = Eigen::Matrix<double, kColumns, kColumns>::Zero();
  Eigen::Matrix<double, kColumns, 1> row = Eigen::Matrix<double, kColumns, 1>::Zero();
  for (int column = 0; at < end;) {
    double value = 0.0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error == std::errc{}) row(column++ % kColumns) = value;
    at = error == std::errc{} ? next : at + 1;
    if (at == end || *at == '\n') {
      normal.selfadjointView<Eigen::Lower>().rankUpdate(row);
      column = 0;
    }
    if (at < end && (*at == ',' || *at == '\n')) ++at;
  }
  munmap(mapped, size);
  close(file);
  return normal.trace();
}

struct Cost {
  double seconds = 0.0, processor = 0.0;  ///< [s]
  double megabytes = 0.0;                 ///< Most resident at once, the mapped file with it
  bool worked = false;
};

Cost costOf(const std::vector<std::string>& command) {
  const auto start = std::chrono::steady_clock::now();
  const pid_t child = fork();
  if (child == 0) {
    std::vector<char*> arguments;
    for (const std::string& each : command) arguments.push_back(const_cast<char*>(each.c_str()));
    arguments.push_back(nullptr);
    if (std::freopen("/dev/null", "w", stdout) == nullptr) _exit(126);
    execv(arguments[0], arguments.data());
    _exit(127);
  }
  int status = 0;
  rusage usage{};
  if (child < 0 || wait4(child, &status, 0, &usage) != child) throw std::runtime_error("cannot start " + command[0]);
  const auto secondsOf = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          secondsOf(usage.ru_utime) + secondsOf(usage.ru_stime), static_cast<double>(usage.ru_maxrss) / 1024.0,
          WIFEXITED(status) && WEXITSTATUS(status) <= 1};
}

void printRow(const std::string& length, const std::string& what, const Cost& cost, const Cost& reference) {
  fmt::print("| {} | {} | {:.2f} | {:.2f} | {:.1f} | {:.0f} |\n", length, what, cost.seconds, cost.processor,
             cost.processor / reference.processor, cost.megabytes);
  std::fflush(stdout);
  if (!cost.worked) fmt::print(stderr, "{}: {} failed\n", length, what);
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> given(arguments + 1, arguments + count);
  if (given.size() == 2 && given[0] == "reference") return referenceOf(given[1]) > 0.0 ? 0 : 2;
  if (given.size() < 2) {
    fmt::print(stderr, "length_table HEFT FOLDER [estimate|diagnose] [SECONDS ...]\n");
    return 2;
  }
  const std::string heft = given[0];
  std::vector<std::string> commands{"estimate", "diagnose"}, lengths(given.begin() + 2, given.end());
  if (!lengths.empty() && std::ranges::count(commands, lengths.front()) > 0) {
    commands = {lengths.front()};
    lengths.erase(lengths.begin());
  }
  if (lengths.empty()) lengths = {"20", "60", "600", "3600"};
  std::filesystem::create_directories(given[1]);
  fmt::print("| length | | s | s of processor time | x reference | MB |\n|---|---|---|---|---|---|\n");
  std::fflush(stdout);  // Lest each child prints it again
  for (const std::string& length : lengths) {
    const std::string file = given[1] + "/free_" + length + "s.csv";
    if (!std::filesystem::exists(file) &&
        !costOf({heft, "simulate", "-o", file, "--duration", length, "--motion", "free", "--seed", "1"}).worked) {
      fmt::print(stderr, "{} s: not simulated\n", length);
      return 1;
    }
    const Cost reference = costOf({"/proc/self/exe", "reference", file});
    const double megabytes = static_cast<double>(std::filesystem::file_size(file)) / 1048576.0;
    printRow(length + " s", fmt::format("reference, of {:.0f} MB", megabytes), reference, reference);
    for (const std::string& command : commands)
      printRow(length + " s", command, costOf({heft, command, file}), reference);
  }
  return 0;
}
