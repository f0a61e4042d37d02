// Guesses from the names and types of fields what they measure.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <set>

#include "core/base/say.h"
#include "core/import/mapping.h"
#include "core/import/time_column.h"

namespace heft {

namespace {

using Tokens = std::vector<std::string>;

/// "position[panda_joint1]" gives position, panda, joint, 1.
Tokens tokensOf(std::string_view name) {
  Tokens out;
  std::string current;
  int kind = 0;  // 1 letters, 2 digits
  for (const char c : lowerCase(name)) {
    const int now = c >= '0' && c <= '9' ? 2 : (c >= 'a' && c <= 'z') ? 1 : 0;
    if (now != kind && !current.empty()) {
      out.push_back(current);
      current.clear();
    }
    if (now != 0) current += c;
    kind = now;
  }
  if (!current.empty()) out.push_back(current);
  return out;
}

template <std::size_t N>
bool isOne(const std::string& token, const std::array<const char*, N>& words) {
  return std::find(words.begin(), words.end(), token) != words.end();
}
template <std::size_t N>
bool anyIs(const Tokens& tokens, const std::array<const char*, N>& words) {
  return std::any_of(tokens.begin(), tokens.end(), [&](const std::string& t) { return isOne(t, words); });
}

/// Words of values that nobody measured.
constexpr std::array kCommanded = {"d",       "c",     "cmd",   "command",  "commanded", "desired",   "des",
                                   "target",  "ref",   "goal",  "setpoint", "limit",     "error",     "errors",
                                   "motor",   "theta", "ddq",   "dtau",     "dp",        "ddp",       "collision",
                                   "contact", "std",   "stdev", "finger",   "gripper",   "covariance"};
/// Words of wrenches from which something was taken away, or that no sensor measured.
constexpr std::array kProcessed = {"compensated", "comp",     "bias", "unbiased", "zeroed",   "tared",
                                   "ext",         "external", "hat",  "estimate", "estimated"};

std::optional<int> axis(const std::string& token) {
  if (token == "x") return 0;
  if (token == "y") return 1;
  if (token == "z") return 2;
  return std::nullopt;
}

/// What a field seems to be: 0..5 of a wrench, and which letters make its name's family.
struct WrenchField {
  int index = 0;
  Tokens family;
};

std::optional<WrenchField> asWrench(const Tokens& tokens) {
  static constexpr std::array kForces = {"force", "forces", "f"};
  static constexpr std::array kTorques = {"torque", "torques", "moment", "t", "m", "tau"};
  static constexpr std::array kBoth = {"wrench", "ft", "netft"};
  if (tokens.empty()) return std::nullopt;
  const auto& last = tokens.back();
  // fx, ty, mz
  if (last.size() == 2 && (last[0] == 'f' || last[0] == 't' || last[0] == 'm')) {
    if (const auto a = axis(last.substr(1)))
      return WrenchField{*a + (last[0] == 'f' ? 0 : 3), Tokens(tokens.begin(), tokens.end() - 1)};
  }
  if (tokens.size() < 2) return std::nullopt;
  const auto& before = tokens[tokens.size() - 2];
  const Tokens family(tokens.begin(), tokens.end() - 2);
  std::optional<int> index = axis(last);
  const bool number = last.size() == 1 && last[0] >= '0' && last[0] <= '5';
  if (!index && number) index = last[0] - '0';
  if (!index) return std::nullopt;
  if (isOne(before, kForces) && *index < 3) return WrenchField{*index, family};
  if (isOne(before, kTorques) && *index < 3) return WrenchField{*index + 3, family};
  if (isOne(before, kBoth) && number) return WrenchField{*index, family};
  return std::nullopt;
}

struct PoseField {
  bool quaternion = false;
  int index = 0;
  Tokens family;
};

std::optional<PoseField> asPose(const Tokens& tokens) {
  if (tokens.empty()) return std::nullopt;
  const auto& last = tokens.back();
  if (last.size() == 2 && (last[0] == 'p' || last[0] == 'q')) {
    const auto a = last[1] == 'w' ? std::optional<int>(3) : axis(last.substr(1));
    if (a && (last[0] == 'q' || *a < 3)) return PoseField{last[0] == 'q', *a, Tokens(tokens.begin(), tokens.end() - 1)};
  }
  if (tokens.size() < 2) return std::nullopt;
  const auto& before = tokens[tokens.size() - 2];
  const Tokens family(tokens.begin(), tokens.end() - 2);
  const auto a = last == "w" ? std::optional<int>(3) : axis(last);
  if (!a) return std::nullopt;
  if ((before == "position" || before == "translation") && *a < 3) return PoseField{false, *a, family};
  if (before == "orientation" || before == "quaternion" || before == "rotation" || before == "quat")
    return PoseField{true, *a, family};
  return std::nullopt;
}

struct JointField {
  bool velocity = false;
  int number = 0;
  Tokens family;
};

std::optional<JointField> asJoint(const Tokens& tokens) {
  static constexpr std::array kPositions = {"position", "positions", "pos", "q", "angle", "angles"};
  static constexpr std::array kVelocities = {"velocity", "velocities", "vel", "dq", "qd", "qdot", "speed"};
  static constexpr std::array kOther = {"effort", "torque", "tau", "current", "temperature", "is", "force", "wrench"};
  static constexpr std::array kFillers = {"joint", "joints", "state", "states", "robot", "arm", "panda", "fr", "fer"};
  if (tokens.empty() || anyIs(tokens, kOther)) return std::nullopt;
  // The number that tells the joint: the last one ("fr3_joint1" has another before it).
  const auto number = std::find_if(tokens.rbegin(), tokens.rend(), [](const std::string& t) {
    return t.size() <= 2 && std::isdigit(static_cast<unsigned char>(t[0])) != 0;
  });
  if (number == tokens.rend()) return std::nullopt;
  const auto at = static_cast<std::size_t>(tokens.rend() - number) - 1;
  JointField out;
  out.number = std::stoi(tokens[at]);
  out.family = tokens;
  out.family[at] = "#";
  out.velocity = anyIs(tokens, kVelocities);
  if (out.velocity || anyIs(tokens, kPositions)) return out;
  const bool bare = std::all_of(tokens.begin(), tokens.end(), [&](const std::string& t) {
    return isOne(t, kFillers) || std::isdigit(static_cast<unsigned char>(t[0])) != 0;
  });
  if (bare && (std::find(tokens.begin(), tokens.end(), "joint") != tokens.end() ||
               std::find(tokens.begin(), tokens.end(), "joints") != tokens.end()))
    return out;
  return std::nullopt;
}

const std::array<const char*, 6> kWrenchColumns = {"fx", "fy", "fz", "tx", "ty", "tz"};
const std::array<const char*, 3> kPositionColumns = {"px", "py", "pz"};
const std::array<const char*, 4> kQuaternionColumns = {"qx", "qy", "qz", "qw"};

/// Fields of one family by their index; the first one with an index counts.
using Family = std::map<int, std::size_t>;

class StreamGuess {
 public:
  StreamGuess(const std::vector<Stream>& streams, std::size_t index, std::vector<ColumnCandidate>& out)
      : stream_(streams[index]), index_(index), out_(out) {}

  void run(const std::vector<std::string>& jointNames) {
    std::map<Tokens, Family> wrenches, positions, quaternions, joints, velocities;
    for (std::size_t f = 0; f < stream_.fields.size(); ++f) {
      const Tokens tokens = tokensOf(stream_.fields[f]);
      if (anyIs(tokens, kCommanded)) continue;
      if (const auto wrench = asWrench(tokens)) wrenches[wrench->family].try_emplace(wrench->index, f);
      if (const auto pose = asPose(tokens))
        (pose->quaternion ? quaternions : positions)[pose->family].try_emplace(pose->index, f);
      if (const auto joint = asJoint(tokens))
        (joint->velocity ? velocities : joints)[joint->family].try_emplace(joint->number, f);
    }
    for (const auto& [family, fields] : wrenches)
      if (fields.size() == 6) addWrench(family, fields);
    for (const auto& [family, fields] : quaternions)
      if (fields.size() == 4) add("quaternion", fields, 0, kQuaternionColumns, poseScore(), why());
    for (const auto& [family, fields] : positions)
      if (fields.size() == 3) add("position", fields, 0, kPositionColumns, poseScore(), why());
    for (const auto& [family, fields] : joints) addJoints("joints", "q", family, fields);
    for (const auto& [family, fields] : velocities) addJoints("velocities", "dq", family, fields);
    if (!jointNames.empty()) {
      addNamed("joints", "q", "position", jointNames);
      addNamed("velocities", "dq", "velocity", jointNames);
    }
  }

 private:
  std::string why() const {
    return stream_.type.empty() ? heft::say("names of the columns") : heft::say("type {}", stream_.type);
  }
  int poseScore() const { return stream_.type.starts_with("geometry_msgs/Pose") ? 30 : 10; }

  template <class Names>
  void add(const char* part, const Family& fields, int first, const Names& names, int score, std::string reason) {
    ColumnCandidate candidate{part, {}, score, std::move(reason)};
    for (const auto& [index, field] : fields)
      candidate.columns.push_back({names[static_cast<std::size_t>(index - first)], index_, field, 1.0, candidate.why});
    out_.push_back(std::move(candidate));
  }

  void addWrench(const Tokens& family, const Family& fields) {
    int score = 10;
    std::string reason = why();
    if (stream_.type == "geometry_msgs/WrenchStamped") score = 30;
    if (stream_.type == "geometry_msgs/Wrench") score = 25;
    Tokens all = tokensOf(stream_.name);
    all.insert(all.end(), family.begin(), family.end());
    static constexpr std::array kSensors = {"ft", "netft", "sensor", "ati", "raw", "axia", "gamma"};
    if (anyIs(all, kSensors)) score += 5;
    const bool franka = stream_.type.starts_with("franka_msgs/");
    if (anyIs(all, kProcessed) || franka) {
      score -= 100;
      reason = heft::say("an estimate or a compensated wrench: the tool's own weight may be taken out of it");
    }
    add("wrench", fields, 0, kWrenchColumns, score, reason);
  }

  void addJoints(const char* part, const char* prefix, const Tokens& family, const Family& fields) {
    const int first = fields.begin()->first;
    const int last = fields.rbegin()->first;
    // Joints are numbered without holes, from 0 or 1.
    if (first > 1 || last - first + 1 != static_cast<int>(fields.size()) || fields.size() < 2) return;
    if (fields.size() > 32) return;
    int score = 10;
    if (stream_.type == "sensor_msgs/JointState") score = 30;
    if (stream_.type.starts_with("franka_msgs/")) score = 30;
    if (std::find(family.begin(), family.end(), "measured") != family.end()) score += 3;
    if (fields.size() == 7) score += 2;
    std::vector<std::string> names;
    for (std::size_t j = 1; j <= fields.size(); ++j) names.push_back(fmt::format("{}{}", prefix, j));
    add(part, fields, first, names, score, why());
  }

  /// Joints of a known arm by their names.
  void addNamed(const char* part, const char* prefix, const std::string& quantity,
                const std::vector<std::string>& jointNames) {
    ColumnCandidate candidate{part, {}, 60, heft::say("names of the arm's joints")};
    for (std::size_t j = 0; j < jointNames.size(); ++j) {
      const std::array<std::string, 4> forms = {fmt::format("{}[{}]", quantity, jointNames[j]),
                                                fmt::format("measured_joint_state.{}[{}]", quantity, jointNames[j]),
                                                fmt::format("field.{}[{}]", quantity, jointNames[j]),
                                                fmt::format("/{}/{}", jointNames[j], quantity)};
      std::size_t found = stream_.fields.size();
      for (std::size_t f = 0; f < stream_.fields.size() && found == stream_.fields.size(); ++f)
        if (stream_.fields[f] == forms[0] || stream_.fields[f] == forms[1] || stream_.fields[f] == forms[2] ||
            stream_.fields[f].ends_with(forms[3]))
          found = f;
      if (found == stream_.fields.size()) return;
      candidate.columns.push_back({fmt::format("{}{}", prefix, j + 1), index_, found, 1.0, candidate.why});
    }
    out_.push_back(std::move(candidate));
  }

  const Stream& stream_;
  const std::size_t index_;
  std::vector<ColumnCandidate>& out_;
};

}  // namespace

std::vector<ColumnCandidate> findCandidates(const std::vector<Stream>& streams,
                                            const std::vector<std::string>& jointNames) {
  std::vector<ColumnCandidate> out;
  for (std::size_t s = 0; s < streams.size(); ++s) StreamGuess(streams, s, out).run(jointNames);
  std::stable_sort(out.begin(), out.end(), [&](const ColumnCandidate& a, const ColumnCandidate& b) {
    if (a.score != b.score) return a.score > b.score;
    return streams[a.columns[0].stream].samples > streams[b.columns[0].stream].samples;
  });
  return out;
}

}  // namespace heft
