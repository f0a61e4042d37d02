#pragma once
// Options for topics and columns, common to all commands that read a recording.
#include <optional>
#include <string>

#include "core/estimation/options.h"
#include "core/import/import.h"

namespace CLI {
class App;
}

namespace heft::cli {

/// Adds --meta, --map, --join and --use.
void addRecordingOptions(CLI::App& app, ImportOptions& options);

/// Adds --rate, the rate of files without a clock.
void addRateOption(CLI::App& app, ImportOptions& options);

/// Adds --conventions; `word` holds its default.
void addConventionChoice(CLI::App& app, std::string& word);
/// Throws WrongUsage.
ConventionChoice conventionChoice(const std::string& word);

/// What --segments says: auto, marks or all; nothing where it was not given. Throws WrongUsage.
std::optional<SegmentMode> segmentChoice(const std::string& word);

/// What --shape or --shape-file says; nothing where neither was given. Throws WrongUsage and Failed.
std::optional<Shape> shapeChoice(const std::string& shape, const std::string& shapeFile);

}  // namespace heft::cli
