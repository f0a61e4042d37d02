// How well hidden faults are named, for any seed. The truth is kept in a folder that the diagnosis is never given:
//   diagnosis_study write FOLDER [CASES=20] [SEED=1]   recordings in FOLDER/recordings, truths in FOLDER/truths
//   heft diagnose FOLDER/recordings/NAME.csv --json FOLDER/answers/NAME.json   for each
//   diagnosis_study score FOLDER                       confusion, detection by size, false alarms, gain, errors
//   diagnosis_study compare ANSWERS OTHERS             whether two builds answer bit for bit alike, times aside
// CASES is the number of recordings of each case: clean, walking, single (1, 2 and 4 times and a third of the visible
// size), variant, pair, unlisted, triple. diagnosis_answers.sh diagnoses them all.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/base/json_file.h"
#include "core/recording/csv_reader.h"
#include "tests/support/diagnosis_score.h"

namespace {

using namespace heft;
using namespace heft::test;
namespace fs = std::filesystem;

template <class T>
T orThrow(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().message);
  return std::move(*result);
}

/// None, and says so, where no motion shows what was drawn.
std::optional<HiddenRecording> drawn(HiddenCase kind, std::uint64_t seed, double multiple) {
  try {
    return drawHidden(kind, seed, multiple);
  } catch (const std::exception& error) {
    fmt::print("left out ({}, draw {}): {}\n", toString(kind), seed, error.what());
    return std::nullopt;
  }
}

void write(const fs::path& folder, std::uint64_t cases, std::uint64_t seed) {
  fs::create_directories(folder / "recordings");
  fs::create_directories(folder / "truths");
  fs::create_directories(folder / "answers");
  struct Kind {
    HiddenCase kind;
    double multiple;  // 0: drawn
  };
  const std::vector<Kind> kinds{{HiddenCase::clean, 0.0},    {HiddenCase::walking, 0.0},      {HiddenCase::single, 0.0},
                                {HiddenCase::variant, 0.0},  {HiddenCase::single, 1.0 / 3.0}, {HiddenCase::pair, 2.0},
                                {HiddenCase::unlisted, 0.0}, {HiddenCase::triple, 2.0}};
  std::size_t number = 0;  // File names must not tell what is hidden.
  for (std::uint64_t i = 0; i < cases; ++i) {
    for (const Kind& kind : kinds) {
      const std::string name = fmt::format("{:05}", ++number);
      const auto hidden = drawn(kind.kind, seed * 100000 + i, kind.multiple);
      if (!hidden) continue;
      orThrow(writeRecording(hidden->recording, folder / "recordings" / (name + ".csv")));
      orThrow(writeTextFile(folder / "truths" / (name + ".json"), toJson(hidden->truth).dump(1)));
    }
    fmt::print("{} of {}\n", (i + 1) * kinds.size(), cases * kinds.size());
  }
}

void score(const fs::path& folder) {
  DiagnosisScore total;
  int missing = 0;
  std::vector<fs::path> truths;
  for (const auto& entry : fs::directory_iterator(folder / "truths")) truths.push_back(entry.path());
  std::sort(truths.begin(), truths.end());
  for (const fs::path& file : truths) {
    const fs::path answer = folder / "answers" / file.filename();
    if (!fs::exists(answer)) {
      ++missing;
      continue;
    }
    const HiddenTruth truth = orThrow(hiddenTruthFromJson(orThrow(readJsonFile(file)), file.string()));
    const nlohmann::json said = orThrow(readJsonFile(answer));
    total.add(truth, said, said.value("timing_s", nlohmann::json::object()).value("total", 0.0));
  }
  fmt::print("{}", total.text());
  if (missing > 0) fmt::print("\n{} recordings have no answer.\n", missing);
}

/// How many answers of one folder differ from those of the same name in another; says which and where.
int compare(const fs::path& folder, const fs::path& others) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  if (files.empty()) throw std::runtime_error(folder.string() + " has no answers");
  int differ = 0;
  for (const fs::path& file : files) {
    nlohmann::json one = orThrow(readJsonFile(file)), other = orThrow(readJsonFile(others / file.filename()));
    one.erase("timing_s");
    other.erase("timing_s");
    const nlohmann::json changes = nlohmann::json::diff(one, other);
    if (changes.empty()) continue;
    ++differ;
    fmt::print("{}: {}\n", file.stem().string(), changes.front().dump());
  }
  fmt::print("{} of {} answers differ.\n", differ, files.size());
  return differ;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string what = argc > 2 ? argv[1] : "";
    if (what == "write") {
      write(argv[2], argc > 3 ? std::stoull(argv[3]) : 20, argc > 4 ? std::stoull(argv[4]) : 1);
    } else if (what == "score") {
      score(argv[2]);
    } else if (what == "compare" && argc > 3) {
      return compare(argv[2], argv[3]) > 0 ? 1 : 0;
    } else {
      fmt::print(stderr, "diagnosis_study write FOLDER [CASES] [SEED] | score FOLDER | compare ANSWERS OTHERS\n");
      return 2;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "diagnosis_study: {}\n", error.what());
    return 1;
  }
}
