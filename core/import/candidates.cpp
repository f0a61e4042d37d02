// Guesses from the names and types of fields what they measure.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>

#include "core/base/say.h"
#include "core/import/field_name.h"
#include "core/import/mapping.h"
#include "core/import/name_guess.h"
#include "core/import/pose_names.h"
#include "core/import/target.h"

namespace heft {

namespace {

Quantity quantityOf(const std::string& column) {
  if (column[0] == 'f') return Quantity::force;
  if (column[0] == 't') return Quantity::torque;
  if (column[0] == 'a') return Quantity::acceleration;
  if (column[0] == 'i') return Quantity::angularRate;
  if (column[0] == 'p' && column.size() == 2) return Quantity::length;
  return column.starts_with("dq") ? Quantity::angularRate : Quantity::angle;
}

/// What the name says of the column's unit [SI]; nothing if it says none.
std::optional<double> scaleInName(const std::string& column, const FieldName& name) {
  const bool quaternion = column[0] == 'q' && column.size() == 2 && column[1] >= 'w';
  const bool matrix = column[0] == 'r' && isDigits(column.substr(1));
  if (name.unit.empty() || quaternion || matrix) return std::nullopt;
  return unitSi(name.unit, quantityOf(column));
}

const std::array<const char*, 6> kWrenchColumns = {"fx", "fy", "fz", "tx", "ty", "tz"};
const std::array<const char*, 3> kPositionColumns = {"px", "py", "pz"};
const std::array<const char*, 4> kQuaternionColumns = {"qx", "qy", "qz", "qw"};
const std::array<const char*, 3> kAccelerationColumns = {"ax", "ay", "az"};
const std::array<const char*, 3> kRateColumns = {"imu_wx", "imu_wy", "imu_wz"};
const std::array<const char*, 3> kVectorColumns = {"rvx", "rvy", "rvz"};
const std::array<const char*, 3> kAbcColumns = {"kuka_a", "kuka_b", "kuka_c"};
const std::array<const char*, 3> kRpyColumns = {"roll", "pitch", "yaw"};
const std::array<const char*, 9> kMatrixColumns = {"r11", "r12", "r13", "r21", "r22", "r23", "r31", "r32", "r33"};

using Families = std::map<Words, Family>;  ///< Of each family the first field with an index counts.

class StreamGuess {
 public:
  StreamGuess(const std::vector<Stream>& streams, std::size_t index, std::vector<ColumnCandidate>& out)
      : stream_(streams[index]), index_(index), out_(out) {}

  void run(const std::vector<std::string>& jointNames) {
    Families wrenches, fromOne, arrays, positions, quaternions, matrices, joints, velocities, accelerations, rates;
    for (const auto& field : stream_.fields) names_.push_back(readFieldName(field));
    for (std::size_t f = 0; f < names_.size(); ++f) {
      const Words& words = names_[f].words;
      if (isCommanded(words)) continue;
      const auto put = [&](Families& families, const Member& member) {
        families[member.family].try_emplace(member.index, f);
      };
      if (const auto wrench = asWrench(names_[f])) put(wrenches, *wrench);
      if (const auto wrench = asWrenchFromOne(words)) put(fromOne, *wrench);
      if (const auto array = asWrenchArray(words)) put(arrays, *array);
      if (const auto pose = asPose(words)) put(pose->quaternion ? quaternions : positions, *pose);
      if (const auto matrix = asMatrix(words)) put(matrices, *matrix);
      if (const auto felt = asInertial(words)) put(felt->rates ? rates : accelerations, *felt);
      if (const auto joint = asJoint(names_[f])) put(joint->velocity ? velocities : joints, *joint);
    }
    mergeWrenches(wrenches);
    // Where counting from zero does not give six, which it would with one more at the front.
    for (auto& [family, fields] : fromOne)
      if (fields.size() == 6 && wrenches[family].size() < 6) wrenches[family] = std::move(fields);
    for (const auto& [family, fields] : wrenches)
      if (fields.size() == 6) addWrench(family, fields, 0);
    for (const auto& [family, fields] : arrays)
      if (fields.size() == 6 && fields.rbegin()->first - fields.begin()->first == 5 && fields.begin()->first <= 1)
        addWrench(family, fields, fields.begin()->first);
    for (const auto& [family, fields] : quaternions)
      if (fields.size() == 4) addPose("quaternion", family, fields, kQuaternionColumns);
    for (const auto& [family, fields] : positions)
      if (fields.size() == 3) addPose("position", family, fields, kPositionColumns);
    for (const auto& [family, fields] : matrices)
      if (fields.size() == 9) add("rotation", fields, 0, kMatrixColumns, 9, why());
    addInertial(accelerations, rates);
    addOtherPoses();
    std::erase_if(joints, [&](const auto& entry) { return addAbbPose(entry.first, entry.second); });
    for (const auto& [family, fields] : joints) addJoints("joints", "q", family, fields);
    for (const auto& [family, fields] : velocities) addJoints("velocities", "dq", family, fields);
    if (!jointNames.empty()) {
      addNamed("joints", "q", "position", jointNames);
      addNamed("velocities", "dq", "velocity", jointNames);
    } else if (stream_.type == "sensor_msgs/JointState") {
      addInOrder("joints", "q", "position", 20);
      addInOrder("velocities", "dq", "velocity", 20);
    } else if (stream_.type.empty()) {  // a table whose cells named the joints, none of them by a number
      for (const auto& before : beforeLabelled("position")) {
        addInOrder("joints", "q", before + "position", 9);
        addInOrder("velocities", "dq", before + "velocity", 9);
      }
    }
  }

 private:
  std::string why() const {
    return stream_.type.empty() ? heft::say("names of the columns") : heft::say("type {}", stream_.type);
  }

  ColumnSource source(const std::string& column, std::size_t field, const std::string& reason) const {
    ColumnSource out{column, index_, field, 1.0, reason, false, false};
    if (const auto si = scaleInName(column, names_[field])) {
      out.scale = *si;
      out.unitNamed = true;
    }
    return out;
  }

  template <class Names>
  void add(const char* part, const Family& fields, int first, const Names& names, int score, std::string reason) {
    ColumnCandidate candidate{part, {}, score, std::move(reason)};
    for (const auto& [index, field] : fields)
      candidate.columns.push_back(source(names[static_cast<std::size_t>(index - first)], field, candidate.why));
    out_.push_back(std::move(candidate));
  }

  /// A place or a quaternion. Of a topic's transforms the ones that say whose they are come first; what never moves,
  /// and what an inertial sensor makes of its own readings, is no pose of the arm.
  template <class Names>
  void addPose(const char* part, const Words& family, const Family& fields, const Names& names) {
    int score = stream_.type.starts_with("geometry_msgs/Pose") ? 30 : 10;
    std::string reason = why();
    if (anyIs(family, std::array{"camera", "object", "marker"})) score -= 5;
    const auto frame = transformOf(stream_.fields[fields.begin()->second]);
    if (isDigits(frame)) score -= 6;
    if (anyIs(wordsOf(stream_.name), std::array{"static"})) {
      score -= 100;
      reason = heft::say("judging by its name, it does not move");
    }
    if (stream_.type == "sensor_msgs/Imu") {
      score -= 100;
      reason = heft::say("an inertial sensor's own estimate, which knows nothing of the robot's base");
    }
    add(part, fields, 0, names, score, reason);
  }

  /// Forces and torques whose names differ in more than that word ("wrench__fts_fx" beside "wrench_fts_mx" are alike,
  /// "Force1.x" beside "Torque1.x" too): what has three of one kind joins the only one with three of the other.
  static void mergeWrenches(Families& wrenches) {
    std::vector<const Words*> forces, torques;
    for (const auto& [family, fields] : wrenches) {
      if (fields.size() != 3) continue;
      if (fields.rbegin()->first == 2) forces.push_back(&family);
      if (fields.begin()->first == 3) torques.push_back(&family);
    }
    if (forces.size() != 1 || torques.size() != 1) return;
    const Words from = *torques[0];
    const Words to = *forces[0];
    for (const auto& [index, field] : wrenches[from]) wrenches[to].try_emplace(index, field);
    wrenches.erase(from);
  }

  void addWrench(const Words& family, const Family& fields, int first) {
    int score = 10;
    std::string reason = why();
    if (stream_.type == "geometry_msgs/WrenchStamped") score = 30;
    if (stream_.type == "geometry_msgs/Wrench") score = 25;
    Words all = wordsOf(stream_.name);
    all.insert(all.end(), family.begin(), family.end());
    static constexpr std::array kSensors = {"ft", "fts", "netft", "sensor", "ati", "raw", "axia", "gamma"};
    if (anyIs(all, kSensors)) score += 5;
    if (anyIs(all, std::array{"raw", "reading", "readings", "measured"})) score += 2;
    const bool ur = isTcpForce(family);
    score -= ur ? 5 : std::min(doubtOf(all), 20);
    const bool franka = stream_.type.starts_with("franka_msgs/");
    if (isProcessed(all) || franka) {
      score -= 100;
      reason = heft::say("an estimate or a compensated wrench: the tool's own weight may be taken out of it");
    }
    add("wrench", fields, first, kWrenchColumns, score, reason);
    for (auto& column : out_.back().columns) column.inBaseAxes = ur;
  }

  /// An accelerometer with the gyroscope beside it. "wx" beside "vx" is a body's velocity, and what the robot's base or
  /// a camera feels is not the tool's.
  void addInertial(const Families& accelerations, const Families& rates) {
    const bool twist = std::any_of(names_.begin(), names_.end(),
                                   [](const FieldName& name) { return anyIs(name.words, std::array{"vx"}); });
    for (const auto& [family, fields] : accelerations) {
      if (fields.size() != 3) continue;
      Words all = wordsOf(stream_.name);
      all.insert(all.end(), family.begin(), family.end());
      int score = stream_.type == "sensor_msgs/Imu" ? 20 : 10;
      if (anyIs(all, std::array{"tool", "ft", "sensor", "wrist", "hand", "gripper", "flange"})) score += 5;
      std::string reason = why();
      if (anyIs(all, std::array{"base", "camera", "lidar", "head", "chassis", "mobile", "odom", "realsense"})) {
        score -= 100;
        reason = heft::say("judging by its name, it is not on the tool");
      }
      add("accelerometer", fields, 0, kAccelerationColumns, score, reason);
      for (const auto& [turning, rateFields] : rates)
        if (rateFields.size() == 3 && !twist && (turning.empty() || turning == family || rates.size() == 1))
          add("gyroscope", rateFields, 0, kRateColumns, score, reason);
    }
  }

  void addOtherPoses() {
    using Turn = SpelledPose::Turn;
    for (const auto& pose : spelledPoses(names_)) {
      const std::size_t before = out_.size();
      const std::string reason = pose.why.empty() ? why() : pose.why;
      if (!pose.place.empty()) add("position", pose.place, 0, kPositionColumns, pose.score, reason);
      if (pose.form == Turn::vector) add("rotation", pose.turn, 0, kVectorColumns, pose.score, reason);
      if (pose.form == Turn::abc) add("rotation", pose.turn, 0, kAbcColumns, pose.score, reason);
      if (pose.form == Turn::rollPitchYaw) add("rotation", pose.turn, 0, kRpyColumns, pose.score, reason);
      if (pose.form == Turn::matrix) add("rotation", pose.turn, 0, kMatrixColumns, pose.score, reason);
      for (std::size_t c = before; pose.millimetresAndDegrees && c < out_.size(); ++c)
        for (auto& column : out_[c].columns) {
          const bool place = out_[c].part == "position";
          if (!column.unitNamed) column.scale = place ? 0.001 : std::numbers::pi / 180.0;
          column.unitNamed = true;
        }
    }
  }

  bool addAbbPose(const Words& family, const Family& fields) {
    const auto pose = abbPose(names_, stream_.values, family, fields);
    if (!pose) return false;
    add("quaternion", pose->turn, 0, kQuaternionColumns, pose->score, pose->why);
    add("position", pose->place, 0, kPositionColumns, pose->score, pose->why);
    for (auto& column : out_.back().columns) {
      if (!column.unitNamed && pose->millimetresAndDegrees) column.scale = 0.001;
      column.unitNamed = column.unitNamed || pose->millimetresAndDegrees;
    }
    return true;
  }

  void addJoints(const char* part, const char* prefix, const Words& family, const Family& fields) {
    const int first = fields.begin()->first;
    const int last = fields.rbegin()->first;
    // Joints are numbered without holes, from 0 or 1.
    if (first > 1 || last - first + 1 != static_cast<int>(fields.size()) || fields.size() < 2) return;
    if (fields.size() > 32) return;
    int score = 10;
    if (stream_.type == "sensor_msgs/JointState") score = 30;
    if (stream_.type.starts_with("franka_msgs/")) score = 30;
    static constexpr std::array kMeasured = {"measured", "actual", "act", "meas", "msr", "ist"};
    if (anyIs(family, kMeasured)) score += 3;
    if (fields.size() == 7) score += 2;
    score -= std::min(doubtOf(family), 9);
    // An arm has not also joints without a number: "wrist_1" to "wrist_3" are half of a UR.
    if (fields.size() < 6 && std::ranges::any_of(beforeLabelled("position"), [&](const std::string& before) {
          return inOrder(before + "position").size() > fields.size();
        }))
      return;
    std::vector<std::string> names;
    for (std::size_t j = 1; j <= fields.size(); ++j) names.push_back(fmt::format("{}{}", prefix, j));
    add(part, fields, first, names, score, why());
  }

  /// Fields "position[NAME]" in the file's order, without a gripper's; UR's own names in the order of its chain.
  std::vector<std::size_t> inOrder(const std::string& quantity) const {
    static constexpr std::array kUr = {"shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"};
    std::vector<std::size_t> found, chain;
    for (std::size_t f = 0; f < stream_.fields.size(); ++f) {
      const auto& field = stream_.fields[f];
      static constexpr std::array kHands = {"finger", "gripper", "knuckle", "hand", "jaw", "wheel"};
      if (field.starts_with(quantity + "[") && !anyIs(names_[f].words, kHands)) found.push_back(f);
    }
    for (const char* const name : kUr)
      for (const auto f : found)
        if (stream_.fields[f].find(name) != std::string::npos) chain.push_back(f);
    return chain.size() == kUr.size() && found.size() == kUr.size() ? chain : found;
  }

  void addInOrder(const char* part, const char* prefix, const std::string& quantity, int score) {
    const auto fields = inOrder(quantity);
    if (fields.size() < 2 || fields.size() > 32) return;
    const auto numbered = [&](std::size_t f) { return isDigits(names_[f].words.back()); };
    if (stream_.type.empty() && std::all_of(fields.begin(), fields.end(), numbered)) return;
    ColumnCandidate candidate{part, {}, score, why()};
    for (std::size_t j = 0; j < fields.size(); ++j)
      candidate.columns.push_back(source(fmt::format("{}{}", prefix, j + 1), fields[j], candidate.why));
    out_.push_back(std::move(candidate));
  }

  /// The field of joint `name`: exactly, or with a prefix before it on either side ("left_" of one of two arms), where
  /// only one fits.
  std::size_t fieldOfJoint(const std::string& quantity, const std::string& name) const {
    const auto none = stream_.fields.size();
    const std::array<std::string, 3> forms = {fmt::format("{}[{}]", quantity, name),
                                              fmt::format("measured_joint_state.{}[{}]", quantity, name),
                                              fmt::format("field.{}[{}]", quantity, name)};
    const std::string path = fmt::format("/{}/{}", name, quantity);
    for (std::size_t f = 0; f < none; ++f)
      if (std::find(forms.begin(), forms.end(), stream_.fields[f]) != forms.end() || stream_.fields[f].ends_with(path))
        return f;
    // By the label alone, then with a prefix on either side.
    for (const bool whole : {true, false}) {
      std::size_t found = none;
      for (std::size_t f = 0; f < none; ++f) {
        const auto label = labelOf(quantity, stream_.fields[f]);
        if (label.empty() || isCommanded(names_[f].words) ||
            (whole ? label != name : !endsWith(label, name) && !endsWith(name, label)))
          continue;
        if (found != none) return none;
        found = f;
      }
      if (found != none) return found;
    }
    return none;
  }

  /// What stands before "position[elbow]" in the stream's fields: nothing, "field.", a topic and the like.
  std::set<std::string> beforeLabelled(const std::string& quantity) const {
    std::set<std::string> out;
    for (std::size_t f = 0; f < stream_.fields.size(); ++f)
      if (const auto& field = stream_.fields[f]; !isCommanded(names_[f].words) && !labelOf(quantity, field).empty())
        if (const auto before = field.substr(0, field.rfind(quantity + "["));
            before.empty() || before.back() == '.' || before.back() == '/')
          out.insert(before);
    return out;
  }

  /// "elbow" of "position[elbow]", whatever stands before it; empty for other fields.
  static std::string labelOf(const std::string& quantity, const std::string& field) {
    const auto open = field.rfind(quantity + "[");
    if (open == std::string::npos || field.back() != ']') return {};
    return field.substr(open + quantity.size() + 1, field.size() - open - quantity.size() - 2);
  }

  static bool endsWith(const std::string& longer, const std::string& shorter) {
    if (longer.size() <= shorter.size() || !longer.ends_with(shorter)) return false;
    const char mark = longer[longer.size() - shorter.size() - 1];
    return mark == '_' || mark == '/' || mark == '-' || mark == '.';
  }

  /// Joints of a known arm by their names.
  void addNamed(const char* part, const char* prefix, const std::string& quantity,
                const std::vector<std::string>& jointNames) {
    ColumnCandidate candidate{part, {}, 60, heft::say("names of the arm's joints")};
    for (std::size_t j = 0; j < jointNames.size(); ++j) {
      const auto found = fieldOfJoint(quantity, jointNames[j]);
      if (found == stream_.fields.size()) return;
      candidate.columns.push_back(source(fmt::format("{}{}", prefix, j + 1), found, candidate.why));
    }
    out_.push_back(std::move(candidate));
  }

  const Stream& stream_;
  const std::size_t index_;
  std::vector<ColumnCandidate>& out_;
  std::vector<FieldName> names_;
};

}  // namespace

ColumnSource columnFrom(const std::vector<Stream>& streams, std::size_t stream, std::size_t field,
                        const std::string& column, const std::string& why) {
  ColumnSource out{column, stream, field, 1.0, why, false, false};
  const auto name = readFieldName(streams[stream].fields[field]);
  if (const auto si = scaleInName(column, name)) {
    out.scale = *si;
    out.unitNamed = true;
  }
  out.inBaseAxes = (column[0] == 'f' || column[0] == 't') && isTcpForce(name.words);
  return out;
}

double scaleWithin(const ColumnSource& column, const Conventions& conventions) {
  const char first = column.column[0];
  const bool matrix = column.column.size() == 3 && first == 'r' && column.column[1] >= '1' && column.column[1] <= '3';
  const bool rotation = isRotation(column.column) && !matrix;
  // Only a quaternion's or a joint's numbers pass through the stated unit of angles; other rotations do not.
  if (rotation) return column.unitNamed ? column.scale : column.scale * conventions.radPerAngle;
  if (!column.unitNamed) return column.scale;
  if (first == 'q' || first == 'd' || first == 'i') return column.scale / conventions.radPerAngle;
  if (first == 'p') return column.scale / conventions.mPerLength;
  if (first == 'f') return column.scale / conventions.force.si;
  if (first == 't') return column.scale / conventions.torque.si;
  if (first == 'a') return column.scale / conventions.mPerS2PerAcceleration;
  return column.scale;
}

std::vector<ColumnCandidate> findCandidates(const std::vector<Stream>& streams,
                                            const std::vector<std::string>& jointNames) {
  std::vector<ColumnCandidate> out;
  for (std::size_t s = 0; s < streams.size(); ++s) StreamGuess(streams, s, out).run(jointNames);
  std::stable_sort(out.begin(), out.end(), [&](const ColumnCandidate& a, const ColumnCandidate& b) {
    const bool clockA = !streams[a.columns[0].stream].clockless, clockB = !streams[b.columns[0].stream].clockless;
    if (clockA != clockB) return clockA;
    if (a.score != b.score) return a.score > b.score;
    return streams[a.columns[0].stream].samples > streams[b.columns[0].stream].samples;
  });
  return out;
}

}  // namespace heft
