#pragma once
// What can be wrong with the numbers of a recording: each check repairs what is clear, notes what is odd, and fails
// where the data would mislead.
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/recording/columns.h"
#include "core/recording/csv_reader.h"
#include "core/recording/recording.h"

namespace heft {

/// A recording while it is examined, with the way back to the file.
struct Examined {
  Recording& recording;
  const ColumnMap& map;
  const std::string& file;
  std::vector<std::uint32_t>& lines;  ///< Line of each row.
  Findings& findings;
  bool table = true;  ///< False: joined from messages, so that rows and fields of the file mean nothing.

  Location at(Eigen::Index row, long field = 0) const {
    if (!table) return {file, 0, 0};
    return {file, static_cast<long>(lines[static_cast<std::size_t>(row)]), field};
  }
  Location column(long field) const { return {file, 0, table ? field : 0}; }
  void note(Severity severity, const char* code, Location where, std::string text, std::string remedy = {}) const {
    findings.push_back({severity, code, std::move(text), std::move(remedy), std::move(where)});
  }
};

/// "34 %", "3.2 %", "0.05 %".
std::string percent(double share);

/// All checks below in order, and the numbers brought to the plain form unless they come in it.
std::optional<Error> checkAll(const Examined& examined, NumberForm form);

/// Seven joints without a named robot are a Panda's; other numbers of joints need a name or poses. `header` is the line
/// of the header, `field` that of the first joint.
std::optional<Error> assumeRobot(const Examined& examined, long header);

/// Shortens every series and `lines` to the first `rows` rows.
void truncateRows(Recording& recording, std::vector<std::uint32_t>& lines, Eigen::Index rows);

/// Keeps the rows whose flag is set.
void keepRows(Recording& recording, std::vector<std::uint32_t>& lines, const std::vector<char>& keep);

/// Time that falls is an error; repeated stamps are dropped; unit, gaps, jitter and rate are noted. For standing poses
/// a time that is missing or does not rise becomes 0, 1, 2, ...
std::optional<Error> checkTime(const Examined& examined);

/// Brings quaternions to unit length and neighbours to the same sign; fails if one is far from a rotation.
std::optional<Error> checkQuaternions(const Examined& examined);

/// Joint angles in degrees are an error, found from their size; turns are taken out of those that wrap. In [rad].
std::optional<Error> checkAngles(const Examined& examined);

/// Millimetres are errors, found from the size of values, and so are velocities that do not fit their positions.
std::optional<Error> checkUnits(const Examined& examined);

/// Channels without life, stretches in which a logger hung, rows that repeat, jumps, a wrench that looks tared. Never
/// fails.
void checkSignals(const Examined& examined);

}  // namespace heft
