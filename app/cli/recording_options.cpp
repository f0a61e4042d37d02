#include "app/cli/recording_options.h"

#include <CLI/CLI.hpp>

namespace heft::cli {

void addRecordingOptions(CLI::App& app, ImportOptions& options) {
  const char* const kGroup = "Reading the recording";
  app.add_option("--meta", options.metaFile, "Meta file; otherwise the recording's own .meta.json if it exists")
      ->type_name("FILE")
      ->group(kGroup);
  app.add_option("--join", options.join, "Further file recorded at the same time, such as the wrench; may be repeated")
      ->type_name("FILE")
      ->allow_extra_args(false)
      ->group(kGroup);
  app.add_option("--use", options.use,
                 "Topic or column to take, such as wrench=/ft/raw, q1=TOPIC:FIELD; may be repeated.\n"
                 "Groups: joints, velocities, position, quaternion, rotation, wrench; demo: one of several in a file")
      ->type_name("NAME=SOURCE")
      ->allow_extra_args(false)
      ->group(kGroup);
  app.add_option("--map", options.mapFile, "The same, with scales and time offsets, as a JSON file")
      ->type_name("FILE")
      ->group(kGroup);
}

void addRateOption(CLI::App& app, ImportOptions& options) {
  app.add_option("--rate", options.rateHz, "Rate of files without a clock: rows are 1/HZ apart, whatever stands there")
      ->type_name("HZ")
      ->check(CLI::Range(1e-3, 1e6))
      ->group("Reading the recording");
}

}  // namespace heft::cli
