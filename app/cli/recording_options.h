#pragma once
// How every command that reads a recording is told which topics and columns to take.
#include "core/import/import.h"

namespace CLI {
class App;
}

namespace heft::cli {

/// Adds --meta, --map, --join and --use.
void addRecordingOptions(CLI::App& app, ImportOptions& options);

/// Adds --rate, the rate of files without a clock.
void addRateOption(CLI::App& app, ImportOptions& options);

}  // namespace heft::cli
