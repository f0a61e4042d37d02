#pragma once
// Reads a recording (CSV + sidecar, CONTRACT form) and says everything that is wrong with it.
#include <filesystem>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/recording/recording.h"

namespace heft {

struct ReadOptions {
  std::filesystem::path metaFile;  ///< Empty: NAME.meta.json beside NAME.csv if it exists.
};

struct ReadRecording {
  Recording recording;
  Findings findings;  ///< Warnings and information; what was repaired or skipped and where.
};

/// The error holds the first fatal defect as one sentence with file:line:column and a remedy.
Result<ReadRecording> readRecording(const std::filesystem::path& csv, const ReadOptions& options = {},
                                    const Progress& progress = {});

/// Same from text in memory; `name` stands in messages. Used by fuzzing and by streams.
Result<ReadRecording> parseRecording(std::string_view csv, const std::string& name, RecordingMeta meta,
                                     const Progress& progress = {});

Result<RecordingMeta> readMeta(const std::filesystem::path& file, Findings& findings);

/// Writes NAME.csv and NAME.meta.json in the file's own wrench sign; numbers survive the round trip bit by bit.
Result<bool> writeRecording(const Recording& recording, const std::filesystem::path& csv);

}  // namespace heft
