// Runs kept inputs through the parsers, in any build: replay_corpora CORPUS [CUTS]
// CORPUS has a folder of inputs for each parser. Besides the input itself CUTS damaged ones are read (default 20): cut
// off, and with bytes changed, the same in every run.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>

#include "tests/fuzz/parsers.h"

namespace {

std::string damaged(std::string bytes, std::mt19937& random) {
  if (bytes.empty()) return bytes;
  const auto place = [&] { return random() % bytes.size(); };
  for (unsigned k = random() % 4; k > 0; --k) bytes[place()] = static_cast<char>(random());
  if (random() % 2 == 0) bytes.resize(place());
  return bytes;
}

}  // namespace

int main(int count, char** arguments) {
  if (count < 2) {
    std::fputs("replay_corpora CORPUS [CUTS]\n", stderr);
    return 2;
  }
  const int cuts = count > 2 ? std::atoi(arguments[2]) : 20;
  int missing = 0;
  for (const auto& parser : heft::fuzz::parsers()) {
    const auto folder = std::filesystem::path(arguments[1]) / parser.name;
    std::size_t inputs = 0;
    std::error_code code;
    for (const auto& entry : std::filesystem::directory_iterator(folder, code)) {
      std::ifstream in(entry.path(), std::ios::binary);
      const std::string bytes{std::istreambuf_iterator<char>(in), {}};
      std::mt19937 random(static_cast<unsigned>(bytes.size()));
      parser.run(bytes);
      for (int k = 0; k < cuts; ++k) parser.run(damaged(bytes, random));
      inputs += 1 + static_cast<std::size_t>(cuts);
    }
    std::printf("%-12.*s %zu inputs\n", static_cast<int>(parser.name.size()), parser.name.data(), inputs);
    std::fflush(stdout);
    missing += inputs == 0 ? 1 : 0;
  }
  if (missing > 0) std::fprintf(stderr, "%d parsers have no corpus.\n", missing);
  return missing > 0 ? 1 : 0;
}
