#include "core/import/mapping.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/demonstrations.h"
#include "core/import/field_name.h"
#include "core/import/target.h"

namespace heft {

namespace {

std::string shown(const Stream& stream) {
  if (stream.name.empty() || stream.name == "/") return stream.file;
  return stream.name;
}

class Chooser {
 public:
  Chooser(const std::vector<Stream>& streams, const MappingWishes& wishes, const std::vector<std::string>& jointNames,
          Findings& findings, bool poseForUnnamed)
      : streams_(streams),
        wishes_(wishes),
        findings_(findings),
        candidates_(findCandidates(streams, jointNames)),
        poseForUnnamed_(poseForUnnamed && jointNames.empty()) {}

  Result<std::vector<ColumnSource>> run() {
    if (auto failure = keepDemonstration()) return *failure;
    for (const auto& [target, source] : wishes_.use) {
      if (target == "time" || target == kDemonstration) continue;
      if (auto failure = grant(target, source)) return *failure;
    }
    // What the user names in part is completed from the same stream.
    for (const char* const part : {"wrench", "joints", "quaternion", "rotation", "accelerometer"})
      if (has(part)) takeFrom(part, streamOf(part));
    if (!has("wrench")) take("wrench");
    if (!hasMotion()) takeMotion();
    for (const char* const part : {"quaternion", "rotation"})
      if (has(part) && !has("joints") && !has("position")) takeFrom("position", streamOf(part));
    if (has("joints") && !has("velocities")) takeFrom("velocities", streamOf("joints"));
    if (has("accelerometer") || take("accelerometer")) takeFrom("gyroscope", streamOf("accelerometer"));
    if (auto failure = requireAll()) return *failure;
    scale();
    say();
    return std::move(chosen_);
  }

 private:
  bool has(const std::string& part) const {
    return std::any_of(chosen_.begin(), chosen_.end(), [&](const auto& c) { return partOf(c.column) == part; });
  }
  bool hasMotion() const { return has("joints") || has("quaternion") || has("rotation"); }
  std::size_t streamOf(const std::string& part) const {
    for (const auto& column : chosen_)
      if (partOf(column.column) == part) return column.stream;
    return streams_.size();
  }

  void use(const ColumnCandidate& candidate) {
    for (const auto& column : candidate.columns) {
      const bool there =
          std::any_of(chosen_.begin(), chosen_.end(), [&](const auto& other) { return other.column == column.column; });
      if (!there) chosen_.push_back(column);
    }
  }

  /// Two parts of one demonstration belong together, whatever the others score. Topics are no demonstrations.
  bool ofAnotherDemonstration(std::size_t stream) const {
    if (chosen_.empty() || !streams_[stream].type.empty()) return false;
    const auto& mine = streams_[chosen_[0].stream];
    return mine.type.empty() && mine.file == streams_[stream].file && !demonstrationOf(streams_[stream], mine).empty();
  }

  /// 'l' or 'r' where a field's name says on which of two arms it is; 0 where it does not.
  char sideOf(const ColumnSource& column) const {
    for (const auto& word : wordsOf(nameOf(column)))
      if (word == "left" || word == "right") return word[0];
    return 0;
  }

  /// Two arms in one recording: the other one's candidates do not go with what was chosen for `part`.
  bool ofAnotherSide(const ColumnCandidate& candidate, const std::string& part) const {
    const auto chosen = std::ranges::find(chosen_, part, [](const auto& c) { return partOf(c.column); });
    const char mine = chosen == chosen_.end() ? 0 : sideOf(*chosen), other = sideOf(candidate.columns[0]);
    return mine != 0 && other != 0 && mine != other;
  }

  /// Joints of two arms in one stream, where nothing says which one carries the sensor.
  void sayOtherJoints() {
    const auto mine = std::ranges::find(chosen_, "joints", [](const auto& c) { return partOf(c.column); });
    if (mine == chosen_.end() || mine->why == kSaidByUser || sideOf(*mine) == 0) return;
    for (const auto& candidate : candidates_) {
      const auto& first = candidate.columns[0];
      if (candidate.part != "joints" || first.stream != mine->stream || candidate.score < 0 ||
          !ofAnotherSide(candidate, "joints") || ofAnotherSide(candidate, "wrench"))
        continue;
      findings_.push_back({Severity::warning,
                           "joints_of_several",
                           heft::say("Joints of two arms are there; {} was used, and it could also be {}.",
                                     nameOf(*mine), nameOf(first)),
                           heft::say("Choose the joints one by one, for instance --use q1={}.", nameOf(first)),
                           {streams_[mine->stream].file, 0, 0}});
      return;
    }
  }

  bool take(const std::string& part) {
    const ColumnCandidate* best = nullptr;
    for (const auto& candidate : candidates_) {
      if (candidate.part != part || candidate.score < 0) continue;
      if (best == nullptr) best = &candidate;
      if (ofAnotherDemonstration(candidate.columns[0].stream) || ofAnotherSide(candidate, "wrench")) continue;
      best = &candidate;
      break;
    }
    if (best == nullptr) return false;
    use(*best);
    return true;
  }

  /// Joints of a robot that is not named tell nothing; a whole pose in their stream does. Seven are a Panda's.
  void takeMotion() {
    const auto best = [&](const char* part) {
      return std::ranges::find_if(candidates_, [&](const auto& c) { return c.part == part && c.score >= 0; });
    };
    const auto joints = best("joints");
    if (joints != candidates_.end() && poseForUnnamed_ && joints->columns.size() != 7 &&
        best("position") != candidates_.end())
      for (const char* const part : {"quaternion", "rotation"})
        if (best(part) != candidates_.end() && take(part)) {
          findings_.push_back(
              {Severity::warning,
               "pose_for_joints",
               heft::say("There are {} joints but no robot is named, so the pose is read instead and taken for the "
                         "sensor's.",
                         joints->columns.size()),
               remedy(Remedy::nameRobot),
               {streams_[joints->columns[0].stream].file, 0, 0}});
          return;
        }
    if (!take("joints") && !take("quaternion")) take("rotation");
  }

  /// --use demo=/data/demo_1: only what lies there.
  std::optional<Error> keepDemonstration() {
    const auto wished = wishes_.use.find(kDemonstration);
    if (wished == wishes_.use.end()) return std::nullopt;
    std::string name = wished->second;
    if (!name.starts_with('/')) name = "/" + name;
    const auto within = [&](std::size_t stream) {
      const auto& other = streams_[stream].name;
      return other == name || other.starts_with(name + "/") || other.find(name + "/") != std::string::npos ||
             other.ends_with(name);
    };
    std::erase_if(candidates_, [&](const auto& candidate) { return !within(candidate.columns[0].stream); });
    if (!candidates_.empty()) return std::nullopt;
    return errorAt({streams_.empty() ? "" : streams_[0].file, 0, 0},
                   heft::say("there is no demonstration \"{}\".", printable(wished->second)),
                   remedy(Remedy::showContents));
  }

  const std::string& nameOf(const ColumnSource& column) const { return streams_[column.stream].fields[column.field]; }

  /// Velocities belong to the joints' own stream, and are as many; of several transforms, a place to its own turn.
  void takeFrom(const std::string& part, std::size_t stream) {
    const auto joints =
        std::count_if(chosen_.begin(), chosen_.end(), [](const auto& c) { return partOf(c.column) == "joints"; });
    const auto turn = std::ranges::find(chosen_, "quaternion", [](const auto& c) { return partOf(c.column); });
    const std::string frame = turn == chosen_.end() ? std::string() : transformOf(nameOf(*turn));
    for (const auto& candidate : candidates_) {
      if (candidate.part != part || candidate.score < 0 || candidate.columns[0].stream != stream) continue;
      if (part == "position" && transformOf(nameOf(candidate.columns[0])) != frame) continue;
      if (part == "velocities" && static_cast<long>(candidate.columns.size()) != joints) continue;
      if (ofAnotherSide(candidate, part == "velocities" ? "joints" : "wrench")) continue;
      use(candidate);
      return;
    }
  }

  /// "/tf:tool0": the transform in a topic of several that is called so.
  bool isLabelled(const ColumnCandidate& candidate, const std::string& source) const {
    const auto& stream = streams_[candidate.columns[0].stream];
    if (source.size() <= stream.name.size() + 1 || !source.starts_with(stream.name + ":")) return false;
    const auto label = "[" + source.substr(stream.name.size() + 1) + "]";
    return std::ranges::all_of(candidate.columns, [&](const ColumnSource& column) {
      return stream.fields[column.field].find(label) != std::string::npos;
    });
  }

  /// "observation.state" of "observation.state.0" and so on: the numbered fields that begin so, in their order.
  bool grantNumbered(const std::string& target, const std::string& source) {
    static const std::map<std::string, std::vector<std::string>> kColumns = {
        {"wrench", {"fx", "fy", "fz", "tx", "ty", "tz"}},
        {"position", {"px", "py", "pz"}},
        {"quaternion", {"qx", "qy", "qz", "qw"}},
        {"rotation", rotationForms().front()},
        {"accelerometer", {"ax", "ay", "az"}},
        {"gyroscope", {"imu_wx", "imu_wy", "imu_wz"}}};
    const auto fixed = kColumns.find(target);
    const auto wished = wordsOf(source);
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      std::map<int, std::size_t> members;
      for (std::size_t f = 0; f < streams_[s].fields.size(); ++f) {
        auto words = readFieldName(streams_[s].fields[f]).words;
        if (words.size() < 2 || words.back().size() > 2 || words.back()[0] < '0' || words.back()[0] > '9') continue;
        const int number = std::stoi(words.back());
        words.pop_back();
        if (words == wished) members.try_emplace(number, f);
      }
      const auto count = fixed != kColumns.end() ? fixed->second.size() : members.size();
      if (members.size() < 2 || members.size() != count ||
          members.rbegin()->first - members.begin()->first + 1 != static_cast<int>(count))
        continue;
      std::size_t k = 0;
      for (const auto& [number, field] : members) {
        const auto column = fixed != kColumns.end() ? fixed->second[k]
                                                    : fmt::format("{}{}", target == "velocities" ? "dq" : "q", k + 1);
        chosen_.push_back(columnFrom(streams_, s, field, column, kSaidByUser));
        ++k;
      }
      return true;
    }
    return false;
  }

  std::optional<Error> grant(const std::string& target, const std::string& source) {
    if (std::find(kParts.begin(), kParts.end(), target) != kParts.end()) {
      for (const auto& candidate : candidates_) {
        const auto& stream = streams_[candidate.columns[0].stream];
        if (candidate.part != target ||
            (stream.name != source && stream.file != source &&
             std::filesystem::path(stream.file).filename() != source && !isLabelled(candidate, source)))
          continue;
        ColumnCandidate wished = candidate;
        for (auto& column : wished.columns) column.why = kSaidByUser;
        use(wished);
        return std::nullopt;
      }
      if (grantNumbered(target, source)) return std::nullopt;
      return errorAt({streams_.empty() ? "" : streams_[0].file, 0, 0},
                     heft::say("\"{}\" has no {} that Heft can find by name.", printable(source), partName(target)),
                     heft::say("Name its columns one by one, for instance fx=TOPIC:FIELD."));
    }
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      for (std::size_t f = 0; f < streams_[s].fields.size(); ++f) {
        const auto& field = streams_[s].fields[f];
        if (field != source && streams_[s].name + ":" + field != source && streams_[s].file + ":" + field != source)
          continue;
        chosen_.push_back(columnFrom(streams_, s, f, target, kSaidByUser));
        return std::nullopt;
      }
    }
    return errorAt({streams_.empty() ? "" : streams_[0].file, 0, 0},
                   heft::say("there is no \"{}\", which {} was to be read from.", printable(source), target),
                   remedy(Remedy::showContents));
  }

  std::optional<Error> requireAll() const {
    std::vector<std::string> missing;
    for (const char* const name : {"fx", "fy", "fz", "tx", "ty", "tz"})
      if (std::none_of(chosen_.begin(), chosen_.end(), [&](const auto& c) { return c.column == name; }))
        missing.emplace_back(name);
    const std::string file = streams_.empty() ? "" : streams_[0].file;
    if (!missing.empty()) {
      std::string other;
      for (const auto& candidate : candidates_)
        if (candidate.part == "wrench" && candidate.score < 0 && other.empty())
          other = " " +
                  heft::say("{} has one, but it is {}.", shown(streams_[candidate.columns[0].stream]), candidate.why) +
                  " " + remedy(Remedy::takeSource, shown(streams_[candidate.columns[0].stream]));
      return errorAt({file, 0, 0},
                     missing.size() == 6 ? heft::say("no wrench of a sensor was found.")
                                         : heft::say("of the wrench {} is missing.", fmt::join(missing, ", ")),
                     remedy(Remedy::addFile) + other);
    }
    if (!hasMotion())
      return errorAt({file, 0, 0}, heft::say("no motion was found: neither joint positions nor a pose of the sensor."),
                     remedy(Remedy::addFile));
    for (const auto& part : kParts) {
      std::size_t stream = streams_.size();
      for (const auto& column : chosen_) {
        if (partOf(column.column) != part) continue;
        if (stream != streams_.size() && column.stream != stream)
          return errorAt({file, 0, 0},
                         heft::say("the columns of the {} come from {} and from {}.", partName(part),
                                   shown(streams_[stream]), shown(streams_[column.stream])),
                         heft::say("They must share their times."));
        stream = column.stream;
      }
    }
    return std::nullopt;
  }

  void scale() {
    for (auto& column : chosen_) {
      for (const auto& target : {partOf(column.column), column.column}) {
        const auto found = wishes_.scale.find(target);
        if (found == wishes_.scale.end()) continue;
        column.scale = found->second;
        column.unitNamed = false;
      }
    }
  }

  void say() {
    std::vector<std::string> texts;
    for (const auto& part : kParts) {
      if (!has(part)) continue;
      const auto first =
          std::find_if(chosen_.begin(), chosen_.end(), [&](const auto& c) { return partOf(c.column) == part; });
      const auto& stream = streams_[first->stream];
      const bool said = first->why == kSaidByUser;
      texts.push_back(heft::say("{} from {} ({})", partName(part), shown(stream),
                                said ? heft::say("chosen by the user") : first->why));
      std::vector<std::string> others;
      for (const auto& candidate : candidates_) {
        const auto other = candidate.columns[0].stream;
        if (candidate.part == part && candidate.score >= 0 && other != first->stream && others.size() < 4 &&
            candidate.score + 10 >= 30 && !ofAnotherDemonstration(other))
          others.push_back(shown(streams_[other]));
      }
      if (!others.empty() && !said)
        findings_.push_back(
            {Severity::info,
             "other_source",
             heft::say("The {} could also be {}.", partName(part), fmt::join(others, heft::say(" or "))),
             remedy(Remedy::chooseSource, part),
             {stream.file, 0, 0}});
    }
    sayDemonstrations();
    sayOtherJoints();
    sayTransform();
    findings_.push_back({Severity::info,
                         "sources",
                         heft::say("Read {}.", fmt::join(texts, ", ")),
                         "",
                         {streams_[chosen_[0].stream].file, 0, 0}});
  }

  /// A transform is from its own parent: that this is the robot's base, and no chain of them, is an assumption.
  void sayTransform() {
    const auto turn = std::ranges::find(chosen_, "quaternion", [](const auto& c) { return partOf(c.column); });
    const std::string frame = turn == chosen_.end() ? std::string() : transformOf(nameOf(*turn));
    if (frame.empty()) return;
    findings_.push_back({Severity::info,
                         "transform_as_pose",
                         heft::say("The transform of {} alone was taken for the sensor's pose in the robot's base; "
                                   "transforms are not chained.",
                                   printable(frame)),
                         heft::say("If it begins elsewhere, record the joints, or the whole pose as one transform."),
                         {streams_[turn->stream].file, 0, 0}});
  }

  void sayDemonstrations() {
    std::vector<std::string> others;
    const auto& chosen = streams_[chosen_[0].stream];
    std::string mine;
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      if (!ofAnotherDemonstration(s)) continue;
      mine = demonstrationOf(chosen, streams_[s]);
      const auto name = demonstrationOf(streams_[s], chosen);
      if (std::find(others.begin(), others.end(), name) == others.end()) others.push_back(name);
    }
    if (others.empty() || wishes_.use.contains(kDemonstration)) return;
    const auto count = others.size();
    if (count > 4) others.resize(4);
    findings_.push_back({Severity::warning,
                         "several_demonstrations",
                         heft::say("The file holds {} demonstrations; {} was read, not {}{}.", count + 1, mine,
                                   fmt::join(others, ", "), count > 4 ? ", ..." : ""),
                         remedy(Remedy::chooseSource, kDemonstration),
                         {streams_[chosen_[0].stream].file, 0, 0}});
  }

  const std::vector<Stream>& streams_;
  const MappingWishes& wishes_;
  Findings& findings_;
  std::vector<ColumnCandidate> candidates_;
  bool poseForUnnamed_;
  std::vector<ColumnSource> chosen_;
};

}  // namespace

Result<std::vector<ColumnSource>> chooseColumns(const std::vector<Stream>& streams, const MappingWishes& wishes,
                                                const std::vector<std::string>& jointNames, Findings& findings,
                                                bool poseForUnnamed) {
  return Chooser(streams, wishes, jointNames, findings, poseForUnnamed).run();
}

}  // namespace heft
