#include "core/import/pose_names.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "core/base/say.h"
#include "core/import/name_guess.h"

namespace heft {

namespace {

using Single = std::map<std::string, std::size_t>;

Family threeOf(const Single& from, const char* a, const char* b, const char* c) {
  if (!from.contains(a) || !from.contains(b) || !from.contains(c)) return {};
  return {{0, from.at(a)}, {1, from.at(b)}, {2, from.at(c)}};
}

/// "actual_TCP_pose_0" to "..._5".
void addUrVectors(const std::vector<FieldName>& names, std::vector<SpelledPose>& out) {
  std::map<Words, Family> vectors;
  for (std::size_t f = 0; f < names.size(); ++f) {
    const Words& words = names[f].words;
    if (words.size() >= 3 && isDigits(words.back()) && words.back().size() == 1 && !isCommanded(words) &&
        anyIs(words, std::array{"tcp"}) && anyIs(words, std::array{"pose"}))
      vectors[Words(words.begin(), words.end() - 1)].try_emplace(std::stoi(words.back()), f);
  }
  for (const auto& [family, fields] : vectors) {
    if (fields.size() != 6 || fields.begin()->first != 0 || fields.rbegin()->first != 5) continue;
    SpelledPose pose{{}, {}, SpelledPose::Turn::vector, 8, heft::say("pose of a UR with a rotation vector"), false};
    for (const auto& [index, field] : fields) (index < 3 ? pose.place : pose.turn)[index % 3] = field;
    out.push_back(std::move(pose));
  }
}

/// "X", "Y", "Z" beside the three angles of some controller, all with the same words before them: none, or such as say
/// whose pose it is ("TCP_X", "tool.rx").
void addLettered(const std::vector<FieldName>& names, std::vector<SpelledPose>& out) {
  static constexpr std::array kOwners = {"tcp",  "pose",     "ee",  "eef",    "tool",   "flange",  "cartesian",
                                         "cart", "effector", "end", "robot",  "actual", "current", "measured",
                                         "act",  "ist",      "pos", "sensor", "hand"};
  using Turn = SpelledPose::Turn;
  std::map<Words, Single> families;
  Single turns;
  std::set<Words> turned;  // whose names beside it are a rotation's
  for (std::size_t f = 0; f < names.size(); ++f) {
    const Words& words = names[f].words;
    if (words.empty() || isCommanded(words)) continue;
    const Words before(words.begin(), words.end() - 1);
    if (anyIs({words.back()}, std::array{"roll", "pitch", "yaw"})) turns.try_emplace(words.back(), f);
    if (anyIs({words.back()}, std::array{"roll", "qx"})) turned.insert(before);
    const bool owned =
        std::all_of(before.begin(), before.end(), [&](const std::string& word) { return anyIs({word}, kOwners); });
    if (words.back().size() <= 2 && (owned || anyIs({words.back()}, std::array{"x", "y", "z"})))
      families[before].try_emplace(words.back(), f);
  }
  for (const auto& [before, single] : families) {
    const auto place = threeOf(single, "x", "y", "z");
    const auto vector = threeOf(single, "rx", "ry", "rz");
    const auto abc = place.empty() ? Family() : threeOf(single, "a", "b", "c");
    const auto wpr = place.empty() ? Family() : threeOf(single, "w", "p", "r");
    if (!abc.empty())
      out.push_back({place, abc, Turn::abc, 8, heft::say("pose of a KUKA: mm, and A, B, C in degrees"), true});
    if (!wpr.empty())
      out.push_back(
          {place, wpr, Turn::rollPitchYaw, 8, heft::say("pose of a FANUC: mm, and W, P, R in degrees"), true});
    if (!vector.empty() && (before.empty() || !place.empty()))
      out.push_back({place, vector, Turn::vector, 7, heft::say("rotation vector"), false});
    else if (!place.empty() && abc.empty() && wpr.empty() && (before.empty() || turned.contains(before)))
      out.push_back({place, {}, Turn::none, 7, {}, false});
  }
  if (const auto rpy = threeOf(turns, "roll", "pitch", "yaw"); !rpy.empty())
    out.push_back({{}, rpy, Turn::rollPitchYaw, 7, {}, false});
}

/// "O_T_EE[0]" to "O_T_EE[15]", one column after the other.
void addFrankas(const std::vector<FieldName>& names, std::vector<SpelledPose>& out) {
  Family elements;
  for (std::size_t f = 0; f < names.size(); ++f) {
    const Words& words = names[f].words;
    const auto n = words.size();
    if (n < 4 || words[n - 4] != "o" || words[n - 3] != "t" || words[n - 2] != "ee") continue;
    if (isDigits(words[n - 1]) && words[n - 1].size() <= 2) elements.try_emplace(std::stoi(words[n - 1]), f);
  }
  if (elements.size() != 16 || elements.rbegin()->first != 15) return;
  SpelledPose pose{
      {}, {}, SpelledPose::Turn::matrix, 8, heft::say("libfranka's end-effector pose, a matrix by columns"), false};
  for (int row = 0; row < 3; ++row) {
    pose.place[row] = elements.at(12 + row);
    for (int column = 0; column < 3; ++column) pose.turn[3 * row + column] = elements.at(4 * column + row);
  }
  out.push_back(std::move(pose));
}

/// "T_00" to "T_23" (or "T_11" to "T_34"), "pose[0][3]": row, then column.
void addMatrices(const std::vector<FieldName>& names, std::vector<SpelledPose>& out) {
  static constexpr std::array kNames = {"t", "tf", "pose", "matrix", "transform", "htm", "h"};
  std::map<Words, std::map<std::pair<int, int>, std::size_t>> families;
  for (std::size_t f = 0; f < names.size(); ++f) {
    const Words& words = names[f].words;
    const auto n = words.size();
    if (n < 2 || isCommanded(words) || !isDigits(words[n - 1])) continue;
    const bool pair = words[n - 1].size() == 2;
    if (!pair && (n < 3 || words[n - 1].size() != 1 || words[n - 2].size() != 1 || !isDigits(words[n - 2]))) continue;
    const std::string digits = pair ? words[n - 1] : words[n - 2] + words[n - 1];
    Words family(words.begin(), words.end() - (pair ? 1 : 2));
    if (!family.empty() && anyIs({family.front(), family.back()}, kNames))
      families[std::move(family)].try_emplace({digits[0] - '0', digits[1] - '0'}, f);
  }
  for (const auto& [family, elements] : families) {
    const int first = elements.contains({0, 3}) ? 0 : 1;
    SpelledPose pose{{}, {}, SpelledPose::Turn::matrix, 8, heft::say("a matrix of 4 x 4, row by row"), false};
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        if (const auto found = elements.find({first + row, first + column}); found != elements.end())
          (column < 3 ? pose.turn[3 * row + column] : pose.place[row]) = found->second;
    if (pose.place.size() == 3 && pose.turn.size() == 9) out.push_back(std::move(pose));
  }
}

}  // namespace

std::optional<SpelledPose> abbPose(const std::vector<FieldName>& names, const std::vector<std::vector<double>>& values,
                                   const Words& family, const Family& fields) {
  constexpr double kFartherThanAnyArm = 10.0;  // [m]: ABB counts in mm
  if (fields.size() != 4 || family.size() < 2 || family[family.size() - 2] != "q" || family.back() != "#")
    return std::nullopt;
  const Words before(family.begin(), family.end() - 2);
  SpelledPose pose{{}, {}, SpelledPose::Turn::quaternion, 8, {}, false};
  for (std::size_t f = 0; f < names.size(); ++f) {
    const Words& words = names[f].words;
    if (words.empty() || words.back().size() != 1 || Words(words.begin(), words.end() - 1) != before) continue;
    if (const int axis = words.back()[0] - 'x'; axis >= 0 && axis < 3) pose.place.try_emplace(axis, f);
  }
  if (pose.place.size() != 3 || values.size() != names.size()) return std::nullopt;
  const std::size_t rows = values[fields.begin()->second].size();
  const auto whole = [&](const auto& entry) { return values[entry.second].size() == rows; };
  if (!std::ranges::all_of(pose.place, whole) || !std::ranges::all_of(fields, whole)) return std::nullopt;
  std::size_t unit = 0;
  double farthest = 0.0;
  for (std::size_t k = 0; k < rows; ++k) {
    double squares = 0.0;
    for (const auto& [index, field] : fields) squares += values[field][k] * values[field][k];
    unit += std::abs(squares - 1.0) < 0.01 ? 1 : 0;
    for (const auto& [axis, field] : pose.place) farthest = std::max(farthest, std::abs(values[field][k]));
  }
  if (rows < 2 || 20 * unit < 19 * rows) return std::nullopt;
  const int first = fields.begin()->first;
  for (const auto& [index, field] : fields) pose.turn[(index - first + 3) % 4] = field;
  pose.millimetresAndDegrees = farthest > kFartherThanAnyArm;
  pose.why = heft::say("pose of an ABB, the quaternion's real part first");
  return pose;
}

std::vector<SpelledPose> spelledPoses(const std::vector<FieldName>& names) {
  std::vector<SpelledPose> out;
  addUrVectors(names, out);
  addLettered(names, out);
  addFrankas(names, out);
  addMatrices(names, out);
  return out;
}

}  // namespace heft
