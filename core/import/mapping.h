#pragma once
// Which topic or column is which quantity: guessed from types and names, or said by the user.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/import/streams.h"
#include "core/recording/conventions.h"

namespace heft {

/// Where one column of a recording comes from.
struct ColumnSource {
  std::string column;  ///< Contract name: q1, dq1, px, qx, fx, tx, ax, ...; or one of a rotation, see rotationForms().
  std::size_t stream = 0;   ///< Index into the streams.
  std::size_t field = 0;    ///< Index into the stream's fields.
  double scale = 1.0;       ///< Factor to SI units.
  std::string why;          ///< In words: "type geometry_msgs/WrenchStamped", "chosen by the user".
  bool unitNamed = false;   ///< `scale` is what the field's own name says, and stronger than a unit that is stated.
  bool inBaseAxes = false;  ///< Of a wrench that is known to be given in the robot's base axes (UR's actual_TCP_force).
};

/// ColumnSource::why of what the user named.
inline constexpr const char* kSaidByUser = "chosen by the user";

/// A set of columns that belong together, found in one stream.
struct ColumnCandidate {
  std::string part;  ///< joints, velocities, position, quaternion, rotation, wrench,
                     ///< accelerometer or gyroscope
  std::vector<ColumnSource> columns;
  int score = 0;    ///< Higher is better; below zero it is not taken without being asked for.
  std::string why;  ///< For or against it.
};

/// What the user says: all that a map file may hold.
struct MappingWishes {
  std::map<std::string, std::string> use;   ///< Column or part: "STREAM", "STREAM:FIELD" or "FIELD"; and "time".
  std::map<std::string, double> scale;      ///< Column or part: factor to SI units; and "time" in s.
  std::map<std::string, double> offset;     ///< Stream or file: seconds added to its times.
  std::vector<std::filesystem::path> join;  ///< Further files.
  bool poseOfFlange = false;                ///< Poses are the flange's, not the sensor's.
  std::string clock;                        ///< "header", "received", or empty: whichever is better.
  double rateHz = 0.0;                      ///< Of files without a clock; 0: the file's own times.
  StatedConventions conventions;            ///< Stronger than the setup file's.

  bool operator==(const MappingWishes&) const = default;
};

/// Reads a map file (JSON): {"use": {"wrench": "/ft/raw", "q1": "/arm:position[j1]"}, "scale": {"torque": 0.001},
/// "offset_s": {"/ft/raw": 0.01}, "join": ["wrench.csv"], "pose_of": "flange", "clock": "header", "rate_hz": 125}, and
/// the conventions as in a setup file: {"sensor": {"torque_unit": "N mm"}, "angle_unit": "deg"}. Relative files count
/// from the map file's folder. Unknown keys fail.
Result<MappingWishes> readMapFile(const std::filesystem::path& file);

/// The map file that is read with a recording where no other is given: NAME.map.json beside it.
std::filesystem::path mapFileOf(const std::filesystem::path& recording);

/// The text of a map file that says this; files to join relative to `folder` where they stand in it.
std::string mapText(const MappingWishes& wishes, const std::filesystem::path& folder);

/// Adds "NAME=SOURCE" as it stands on a command line.
Result<bool> addWish(MappingWishes& wishes, const std::string& text);

/// Columns that hold a rotation otherwise than as a quaternion, each set complete and in order: a rotation vector (rvx,
/// rvy, rvz), KUKA's A, B, C (turns about z, then y, then x), roll, pitch, yaw (about fixed axes), all in rad, and a
/// matrix by rows (r11 to r33), each of the sensor in the base.
const std::vector<std::vector<std::string>>& rotationForms();

/// Every set of columns that may be a part of a recording, best first. `jointNames`: of the arm, if it is known.
std::vector<ColumnCandidate> findCandidates(const std::vector<Stream>& streams,
                                            const std::vector<std::string>& jointNames);

/// A column that the user names, with the unit that the field's name says.
ColumnSource columnFrom(const std::vector<Stream>& streams, std::size_t stream, std::size_t field,
                        const std::string& column, const std::string& why);

/// Factor with which a column's numbers enter where `conventions` are undone later on: what a field's name says of its
/// unit holds before a unit that is stated for all.
double scaleWithin(const ColumnSource& column, const Conventions& conventions);

/// Other wrenches that names and types speak for as much as for the chosen one, unless the user named it.
std::vector<ColumnCandidate> rivalWrenches(const std::vector<Stream>& streams, const MappingWishes& wishes,
                                           const std::vector<ColumnSource>& chosen);

/// The columns to read: wishes first, then the best candidates. Fails if a wish names nothing that is there, or if
/// wrench or motion are missing; says in findings what was chosen and what else might have been. `poseForUnnamed`: a
/// whole pose stands in for joints of a robot that is not named.
Result<std::vector<ColumnSource>> chooseColumns(const std::vector<Stream>& streams, const MappingWishes& wishes,
                                                const std::vector<std::string>& jointNames, Findings& findings,
                                                bool poseForUnnamed = false);

}  // namespace heft
