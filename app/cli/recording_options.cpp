#include "app/cli/recording_options.h"

#include <CLI/CLI.hpp>
#include <array>

#include "app/cli/cli.h"

namespace heft::cli {

namespace {
const char* const kReadingGroup = "Reading the recording";
}  // namespace

void addRecordingOptions(CLI::App& app, ImportOptions& options) {
  app.add_option("--meta", options.metaFile, "Setup file; otherwise the recording's own .meta.json if it exists")
      ->type_name("FILE")
      ->group(kReadingGroup);
  app.add_option("--join", options.join, "Another file recorded at the same time, such as the wrench; repeatable")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->group(kReadingGroup);
  app.add_option("--use", options.use,
                 "Topic or column to use, such as wrench=/ft/raw, q1=TOPIC:FIELD; repeatable.\n"
                 "Groups: joints, velocities, position, quaternion, rotation, wrench; demo: one of several in a file")
      ->type_name("NAME=SOURCE")
      ->allow_extra_args(false)
      ->group(kReadingGroup);
  app.add_option("--map", options.mapFile, "The same, with scales and time offsets, as a JSON file")
      ->type_name("FILE")
      ->group(kReadingGroup);
}

void addConventionChoice(CLI::App& app, std::string& word) {
  app.add_option("--conventions", word,
                 "as-stated: interpret the numbers as the setup file says; suggested: as physics\n"
                 "suggests, where that is unambiguous")
      ->type_name("NAME")
      ->capture_default_str()
      ->group(kReadingGroup);
}

ConventionChoice conventionChoice(const std::string& word) {
  constexpr std::array kChoices{ConventionChoice::asStated, ConventionChoice::suggested};
  std::vector<std::string> words;
  for (const ConventionChoice choice : kChoices) words.emplace_back(toString(choice));
  return kChoices[chooseWord("--conventions", word, words)];
}

std::optional<SegmentMode> segmentChoice(const std::string& word) {
  if (word.empty()) return std::nullopt;
  constexpr std::array kModes{SegmentMode::automatic, SegmentMode::marks, SegmentMode::all};
  return kModes[chooseWord("--segments", word, {"auto", "marks", "all"})];
}

void addRateOption(CLI::App& app, ImportOptions& options) {
  app.add_option("--rate", options.rateHz, "Rate of files without a time column: rows are 1/HZ apart")
      ->type_name("HZ")
      ->check(CLI::Range(1e-3, 1e6))
      ->group("Reading the recording");
}

std::optional<Shape> shapeChoice(const std::string& shape, const std::string& shapeFile) {
  if (!shape.empty() && !shapeFile.empty())
    throw WrongUsage("--shape and --shape-file exclude each other; put all bodies into the file.");
  if (!shapeFile.empty()) return orFail(readShapeFile(shapeFile));
  if (shape.empty()) return std::nullopt;
  auto parsed = parseShape(shape);
  if (!parsed) throw WrongUsage(parsed.error().message);
  return std::move(parsed).value();
}

}  // namespace heft::cli
