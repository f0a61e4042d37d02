// How well hidden faults are named, for any seed. The truth is kept in a folder that the diagnosis is never given:
//   diagnosis_study write FOLDER [CASES=20] [SEED=1]   recordings in FOLDER/recordings, truths in FOLDER/truths
//   heft diagnose FOLDER/recordings/NAME.csv --json FOLDER/answers/NAME.json   for each
//   diagnosis_study score FOLDER                       confusion, detection by size, false alarms, gain, errors
//   diagnosis_study compare ANSWERS OTHERS             whether two builds answer bit for bit alike, times aside
//   diagnosis_study twins [RECORDINGS=100] [SEED=1]    one or two effects: whether the twin of what was found, on
//                                                      another motion, is diagnosed as the recording was
// CASES is the number of recordings of each case: clean, walking, single (1, 2 and 4 times and a third of the visible
// size), variant, pair, unlisted, triple. diagnosis_answers.sh diagnoses them all.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <vector>

#include "core/base/json_file.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/report/report.h"
#include "core/recording/csv_reader.h"
#include "core/robot/robot_model.h"
#include "core/twin/twin.h"
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

/// Whether `said` has `id` as a cause, or as what explains a cause of it as well.
bool names(const nlohmann::json& said, const std::string& id) {
  return std::ranges::any_of(said.at("causes"), [&](const nlohmann::json& cause) {
    const auto& others = cause.at("alternatives");
    return cause.at("cause") == id || std::ranges::find(others, nlohmann::json(id)) != others.end();
  });
}

/// What the twin's diagnosis says otherwise than the recording's; empty where they agree: the same causes, ties
/// counted, and sizes within three standard deviations of both.
std::string disagreement(const nlohmann::json& rig, const nlohmann::json& twin) {
  constexpr double kWithin = 3.0;
  std::string out;
  for (const auto& [said, by, other] :
       {std::tuple{"not in the twin: ", &rig, &twin}, std::tuple{"only in the twin: ", &twin, &rig}})
    for (const auto& cause : by->at("causes")) {
      const auto ids = [&] {
        std::vector<std::string> all{cause.at("cause")};
        for (const auto& id : cause.at("alternatives")) all.push_back(id);
        return all;
      }();
      if (std::ranges::none_of(ids, [against = other](const std::string& id) { return names(*against, id); }))
        out += said + ids.front() + "; ";
    }
  for (const auto& cause : rig.at("causes"))
    for (const auto& again : twin.at("causes")) {
      if (cause.at("cause") != again.at("cause")) continue;
      for (const auto& [name, parameter] : cause.at("parameters").items()) {
        if (!again.at("parameters").contains(name)) continue;
        const auto& other = again.at("parameters").at(name);
        const double std = std::hypot(parameter.at("std").get<double>(), other.at("std").get<double>());
        const double apart = std::abs(parameter.at("value").get<double>() - other.at("value").get<double>());
        if (std > 0.0 && apart > kWithin * std)
          out += fmt::format("{} {} {:.1f} standard deviations apart; ", cause.at("cause").get<std::string>(), name,
                             apart / std);
      }
    }
  return out;
}

/// Without the causes of `twin` that have no model and so are not in it.
nlohmann::json simulatedOnly(nlohmann::json said, const Twin& twin) {
  auto& causes = said.at("causes");
  for (auto cause = causes.begin(); cause != causes.end();) {
    const bool left = std::ranges::any_of(
        twin.causes, [&](const TwinCause& each) { return !each.simulated && cause->at("cause") == each.id; });
    cause = left ? causes.erase(cause) : cause + 1;
  }
  return said;
}

/// One after the other; recordings in which no cause was found that can be simulated, or something unknown, do not
/// count. Contacts of the task are none of the twin's matter.
void twins(int recordings, std::uint64_t seed) {
  const RobotModel& panda = RobotModel::panda();
  int counted = 0, agreed = 0;
  for (std::uint64_t i = 0; counted < recordings; ++i) {
    const auto hidden = drawn(i % 2 == 0 ? HiddenCase::single : HiddenCase::pair, seed * 100000 + i, 2.0);
    if (!hidden) continue;
    const auto found = diagnose(hidden->recording, &panda, {});
    if (!found) continue;
    const nlohmann::json rig = toJson(*found);
    if (rig.at("causes").empty() || rig.at("verdict") == "unexplained") continue;
    TwinOptions options;
    options.simulate = hidden->truth.simulation.options;
    options.simulate.effects.clear();
    options.simulate.seed += 7919;  // Another motion and another noise
    options.fixed = true;
    const Twin twin = orThrow(simulateTwin(rig, "rig", panda, options));
    if (std::ranges::none_of(twin.causes, [](const TwinCause& cause) { return cause.simulated; })) continue;
    const auto again = diagnose(twin.simulated.recording, &panda, {});
    const std::string apart =
        again ? disagreement(simulatedOnly(rig, twin), simulatedOnly(toJson(*again), twin)) : again.error().message;
    ++counted;
    if (apart.empty()) ++agreed;
    fmt::print("{} {}: {}\n", i, fmt::join(hidden->truth.ids, " "), apart.empty() ? "the same" : apart);
    std::fflush(stdout);
  }
  fmt::print("{} of {} twins are diagnosed as their recordings.\n", agreed, counted);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const std::string what = argc > 1 ? argv[1] : "";
    if (what == "twins") {
      twins(argc > 2 ? std::stoi(argv[2]) : 100, argc > 3 ? std::stoull(argv[3]) : 1);
    } else if (what == "write" && argc > 2) {
      write(argv[2], argc > 3 ? std::stoull(argv[3]) : 20, argc > 4 ? std::stoull(argv[4]) : 1);
    } else if (what == "score" && argc > 2) {
      score(argv[2]);
    } else if (what == "compare" && argc > 3) {
      return compare(argv[2], argv[3]) > 0 ? 1 : 0;
    } else {
      fmt::print(stderr,
                 "diagnosis_study write FOLDER [CASES] [SEED] | score FOLDER | compare ANSWERS OTHERS | twins "
                 "[RECORDINGS] [SEED]\n");
      return 2;
    }
  } catch (const std::exception& error) {
    fmt::print(stderr, "diagnosis_study: {}\n", error.what());
    return 1;
  }
}
