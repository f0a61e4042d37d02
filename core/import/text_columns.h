#pragma once
// What the text in a table's cells says about the numbers beside it: the names of joints, and whose pose a row holds.
#include <string>
#include <vector>

#include "core/base/findings.h"

namespace heft {

/// A table's columns as they stand in the file; all have the same number of rows.
struct TextTable {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> cells;  ///< By column, then by row.
  /// Name of the stream that a column belongs to, where text in the rows tells it: a child frame. Empty, or by column.
  std::vector<std::string> owners;

  std::size_t rows() const { return cells.empty() ? 0 : cells[0].size(); }
};

/// Lists in cells ("[0.1, 0.2]", "('a', 'b')") become columns; joints get the names that stand beside them, row by row
/// (name0 beside position0), or one joint a row; poses of several child frames in one table become columns of streams
/// that are called as the frames. Rows without a frame beside rows with one are set aside. What was done is in
/// findings.
void useTextColumns(TextTable& table, const std::string& file, Findings& findings);

/// Names for a table without any that "ros2 topic echo --csv" wrote: seconds, nanoseconds, a frame, then the names and
/// values of joints, a transform with its child frame, a pose or a wrench. Says what it is, "sensor_msgs/JointState";
/// empty, and nothing is named, if it is none of these.
std::string nameEchoedColumns(TextTable& table);

}  // namespace heft
