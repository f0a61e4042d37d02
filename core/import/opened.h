#pragma once
// The first half of an import: files, meta, map and wishes are read, and the streams of all files with them.
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/base/findings.h"
#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/import/import.h"

namespace heft {

/// Files, wishes and streams of one import.
struct Opened {
  std::vector<std::pair<std::filesystem::path, FileKind>> files;
  MappingWishes wishes;
  std::vector<Stream> streams;
  std::vector<std::string> timeCandidates;
  Findings findings;
  Findings look;  ///< Of the first look, as long as nothing was read: what explains a failure.
  RecordingMeta meta;
  std::set<std::string> stated;  ///< Keys of conventions that the user states.
  std::vector<std::string> jointNames;
};

/// `options.robot` as it stands in a meta: "panda", or the URDF's full path.
Result<std::string> robotWished(const ImportOptions& options);

/// Reads the streams of all files: the fields that pass `filter`, or with an empty one the names alone.
Result<bool> readAll(Opened& opened, const FieldFilter& filter, const Progress& progress);

/// What the user says, and a first look at the file at `path`, which is of `kind`, and at those that join it.
Result<Opened> openAll(const std::filesystem::path& path, FileKind kind, const ImportOptions& options,
                       const Progress& progress);

/// What a field's name says of its unit holds before a unit that is stated for all.
void settleUnits(std::vector<ColumnSource>& columns, Opened& opened);

/// UR's actual_TCP_force stands in the base's axes, whatever the default says.
void settleAxes(const std::vector<ColumnSource>& columns, Opened& opened, const std::string& file);

}  // namespace heft
