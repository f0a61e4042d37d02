#pragma once
// What each column of a recording means, by its name in the header.
#include <array>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/base/result.h"
#include "core/recording/recording.h"

namespace heft {

enum class Role {
  time,
  joint,
  jointVelocity,
  position,
  quaternion,
  twist,
  accelerometer,
  gyroscope,
  wrench,
  label,
  extra
};

struct Column {
  Role role = Role::extra;
  int index = 0;  ///< Within the role, from 0.
};

/// Fields counted from 1 as in messages; 0 = the file has no such column.
struct ColumnMap {
  std::vector<Column> columns;  ///< By field.
  long time = 0;
  std::vector<long> joints;      ///< As many as the arm has.
  std::vector<long> velocities;  ///< Empty, or as many as joints.
  std::array<long, 3> position{};
  std::array<long, 4> quaternion{};
  std::array<long, 6> twist{};
  std::array<long, 3> accelerometer{};
  std::array<long, 3> gyroscope{};
  std::array<long, 6> wrench{};
  long label = 0;

  bool hasJoints() const { return !joints.empty(); }
  bool hasVelocities() const { return !velocities.empty(); }
  bool hasPosition() const { return position[0] > 0; }
  bool hasOrientation() const { return quaternion[0] > 0; }
  bool hasTwist() const { return twist[0] > 0; }
  bool hasAccelerometer() const { return accelerometer[0] > 0; }
  bool hasGyroscope() const { return gyroscope[0] > 0; }

  /// Keeps the columns of a role as text only.
  void setAside(Role role);
};

/// The column's name in CONTRACT form, for instance "q3" or "tx".
std::string columnName(Role role, int index);

/// Fails if a column is there twice, states another unit than SI, or is needed and missing; `header` is the header's
/// place. Incomplete optional groups are set aside with a warning.
Result<ColumnMap> mapColumns(const std::vector<std::string>& names, const RecordingMeta& meta, const Location& header,
                             Findings& findings);

}  // namespace heft
