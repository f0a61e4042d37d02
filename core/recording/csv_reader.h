#pragma once
// Reads a recording (CSV + sidecar, contract form) and says everything that is wrong with it.
//
// What cannot be trusted is an error that names file, line and field: text in a number, rows of a wrong length, time
// that falls, values missing in more than 5 % of the rows, degrees or millimetres, quaternions that are none. What can
// be repaired without guessing is repaired and said in a finding: rows with missing values or a repeated time stamp are
// left out, quaternions brought to length 1 and one sign, turns taken out of angles that wrap, a line cut off at the
// end dropped. Units, axes and signs are converted where the setup file states them (conventions.h), never by a guess.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/recording/recording.h"

namespace heft {

/// Larger files are refused before they are read: some eight hours of text at 1 kHz.
inline constexpr std::size_t kMaxRecordingBytes = std::size_t{8} << 30;

struct ReadOptions {
  std::filesystem::path metaFile;  ///< Empty: NAME.meta.json beside NAME.csv if it exists.
  std::string robot = {};          ///< Instead of the setup file's; empty: the setup file's.
};

struct ReadRecording {
  Recording recording;
  Findings findings;  ///< Warnings and information; what was repaired or skipped and where.
};

/// NAME.meta.json beside NAME.csv.
std::filesystem::path metaFileOf(const std::filesystem::path& csv);

/// Why a text is no recording in the contract's form, judged by its beginning `head`: its names, their units, and
/// whether the first row's cells are numbers of such a size as the contract's seconds. Nothing where it is one.
std::optional<Error> contractMisfit(std::string_view head, const std::string& name, const RecordingMeta& meta);

/// The error holds the first fatal defect as one sentence with file:line:column and a remedy.
Result<ReadRecording> readRecording(const std::filesystem::path& csv, const ReadOptions& options = {},
                                    const Progress& progress = {});

/// Same from text in memory; `name` stands in messages. Used by fuzzing and by streams.
Result<ReadRecording> parseRecording(std::string_view csv, const std::string& name, RecordingMeta meta,
                                     const Progress& progress = {});

/// In which form the numbers of a recording come: as the meta states, or with all undone that takes no pose.
enum class NumberForm { asStated, plain };

/// The same checks for a recording that was joined from messages or streams: time, rotations, units, signals, marks.
/// The numbers come in the sign and the conventions that the meta states, or in the plain form, and leave in the plain
/// form; where that takes the sensor's pose, toSensorAxes() is to follow. All numbers must be finite.
Result<ReadRecording> checkRecording(Recording recording, NumberForm form = NumberForm::asStated);

Result<RecordingMeta> readMeta(const std::filesystem::path& file, Findings& findings);

/// Same from text in memory; `name` stands in messages, a relative robot path is taken against `folder`.
Result<RecordingMeta> parseMeta(std::string_view json, const std::string& name, const std::filesystem::path& folder,
                                Findings& findings);

/// Writes a setup file alone.
Result<bool> writeMeta(const RecordingMeta& meta, const std::filesystem::path& file);

/// The CSV that writeRecording() writes.
Result<std::string> recordingText(const Recording& recording);

/// Writes NAME.csv and NAME.meta.json in the file's own wrench sign and otherwise in the plain form, without any key of
/// Conventions; numbers survive the round trip bit by bit. "-" writes the CSV alone to stdout. Refuses NaN, infinities
/// and series of unequal length.
Result<bool> writeRecording(const Recording& recording, const std::filesystem::path& csv);

}  // namespace heft
