#include "core/import/text_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/array_streams.h"
#include "core/import/field_name.h"
#include "core/import/mapping.h"
#include "core/import/time_column.h"
#include "core/recording/number.h"

namespace heft {

namespace {

constexpr std::size_t kMostNames = 64;  ///< More different texts in a column are no names of joints or frames.

using TextColumn = std::vector<std::string>;

bool isNumberCell(const std::string& cell) {
  double value = 0.0;
  return !cell.empty() && csv::parseNumber(cell.data(), cell.data() + cell.size(), value) == cell.data() + cell.size();
}

/// Whether a column holds text: of its first cells that are not empty none is a number.
bool holdsText(const TextColumn& cells) {
  std::size_t seen = 0;
  for (const auto& cell : cells) {
    if (cell.empty()) continue;
    if (isNumberCell(cell)) return false;
    if (++seen == 20) break;
  }
  return seen > 0;
}

/// Different texts in the order in which they come; too many are cut.
std::vector<std::string> differentTexts(const TextColumn& cells) {
  std::vector<std::string> out;
  for (const auto& cell : cells)
    if (!cell.empty() && out.size() <= kMostNames && std::find(out.begin(), out.end(), cell) == out.end())
      out.push_back(cell);
  return out;
}

/// Items of "[0.1, 0.2]", "(0.1, 0.2)", "[0.1 0.2]" or "['a', 'b']"; false for any other text.
bool splitList(std::string_view cell, std::vector<std::string>& items) {
  items.clear();
  if (cell.size() < 2) return false;
  const bool list = (cell.front() == '[' && cell.back() == ']') || (cell.front() == '(' && cell.back() == ')');
  if (!list) return false;
  std::string item;
  const auto close = [&] {
    if (!item.empty()) items.push_back(item);
    item.clear();
  };
  for (const char c : cell.substr(1, cell.size() - 2)) {
    if (c == '[' || c == '(') return false;
    if (c == ',' || c == ' ' || c == '\n')
      close();
    else if (c != '\'' && c != '"')
      item += c;
  }
  close();
  return items.size() <= kMostArrayChannels;
}

void expandLists(TextTable& table) {
  TextTable out;
  std::vector<std::string> items;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    auto& cells = table.cells[c];
    const auto first = std::find_if(cells.begin(), cells.end(), [](const auto& cell) { return !cell.empty(); });
    if (first == cells.end() || !splitList(*first, items) || items.empty()) {
      out.names.push_back(table.names[c]);
      out.cells.push_back(std::move(cells));
      continue;
    }
    std::vector<TextColumn> columns;
    for (std::size_t r = 0; r < cells.size(); ++r) {
      if (!splitList(cells[r], items)) items.clear();
      if (items.size() > columns.size()) columns.resize(items.size(), TextColumn(cells.size()));
      for (std::size_t i = 0; i < items.size(); ++i) columns[i][r] = std::move(items[i]);
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      out.names.push_back(fmt::format("{}[{}]", table.names[c], i));
      out.cells.push_back(std::move(columns[i]));
    }
  }
  table = std::move(out);
}

/// "field.name0" is "field." and "0"; "name[2]", "name_2" and "joint_states.name.2" alike. Nothing for other names.
struct NameColumn {
  std::string before, after;
};
std::optional<NameColumn> asNameColumn(const std::string& name) {
  const auto at = name.rfind("name");
  if (at == std::string::npos) return std::nullopt;
  if (at > 0 && name[at - 1] != '.' && name[at - 1] != '/') return std::nullopt;
  const auto after = name.substr(at + 4);
  if (after.find_first_of("0123456789") == std::string::npos) return std::nullopt;
  if (after.find_first_not_of("0123456789_[].") != std::string::npos) return std::nullopt;
  return NameColumn{name.substr(0, at), after};
}

/// Columns name0, name1, ... beside position0, position1, ...: each value is of the joint that its own row names.
void nameJoints(TextTable& table) {
  std::map<std::string, std::vector<std::pair<std::size_t, std::string>>> groups;  // before: name's column, after
  for (std::size_t c = 0; c < table.names.size(); ++c)
    if (const auto found = asNameColumn(table.names[c]); found && holdsText(table.cells[c]))
      groups[found->before].emplace_back(c, found->after);
  std::map<std::string, std::size_t> byName;
  for (std::size_t c = 0; c < table.names.size(); ++c) byName.try_emplace(table.names[c], c);
  std::set<std::size_t> gone;
  for (const auto& [before, members] : groups)
    for (const char* const quantity : {"position", "velocity", "effort"}) {
      std::map<std::string, TextColumn> labelled;
      std::vector<std::string> order;
      for (const auto& [nameColumn, after] : members) {
        const auto values = byName.find(before + quantity + after);
        if (values == byName.end()) continue;
        gone.insert(values->second);
        for (std::size_t r = 0; r < table.rows(); ++r) {
          const auto& label = table.cells[nameColumn][r];
          if (label.empty()) continue;
          const auto [entry, fresh] = labelled.try_emplace(label);
          if (fresh) {
            if (labelled.size() > kMostNames) return;
            entry->second.resize(table.rows());
            order.push_back(label);
          }
          entry->second[r] = table.cells[values->second][r];
        }
      }
      for (const auto& label : order) {
        table.names.push_back(fmt::format("{}{}[{}]", before, quantity, printable(label)));
        table.cells.push_back(std::move(labelled[label]));
      }
    }
  TextTable kept;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    if (gone.contains(c)) continue;
    kept.names.push_back(std::move(table.names[c]));
    kept.cells.push_back(std::move(table.cells[c]));
  }
  table = std::move(kept);
}

/// A name's last part, and what stands before it without the message's header: "/ft/header/frame_id" is "frame_id" and
/// "/ft/".
std::pair<std::string, std::string> lastPart(const std::string& name) {
  const auto cut = name.find_last_of("./");
  const auto last = lowerCase(cut == std::string::npos ? name : std::string_view(name).substr(cut + 1));
  std::string before = cut == std::string::npos ? "" : name.substr(0, cut + 1);
  constexpr std::string_view kHeader = "header";
  if (before.size() > kHeader.size() &&
      before.compare(before.size() - 1 - kHeader.size(), kHeader.size(), kHeader) == 0)
    before.resize(before.size() - 1 - kHeader.size());
  return {last, before};
}

/// The first text column that is called so.
std::optional<std::size_t> columnCalled(const TextTable& table, std::initializer_list<std::string_view> names) {
  for (std::size_t c = 0; c < table.names.size(); ++c)
    if (const auto last = lastPart(table.names[c]).first;
        std::find(names.begin(), names.end(), last) != names.end() && holdsText(table.cells[c]))
      return c;
  return std::nullopt;
}

/// Columns that hold the time or a part of it.
std::set<std::size_t> timesIn(const TextTable& table) {
  std::set<std::size_t> out;
  if (const auto time = findTime(table.names, {})) {
    out.insert(time->index);
    if (time->fraction) out.insert(*time->fraction);
  }
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    const auto words = wordsOf(table.names[c]);
    if (std::find(words.begin(), words.end(), "stamp") != words.end()) out.insert(c);
  }
  return out;
}

/// One joint a row (time, joint, position, velocity): the rows of one time become one.
void gatherJoints(TextTable& table) {
  const auto label = columnCalled(table, {"name", "joint", "joint_name", "jointname"});
  if (!label) return;
  const auto joints = differentTexts(table.cells[*label]);
  const auto times = timesIn(table);
  if (joints.size() < 2 || joints.size() > kMostNames || times.empty()) return;
  const auto quantityOf = [&](std::size_t c) -> std::string {
    const auto read = readFieldName(table.names[c]);
    const std::string unit = read.unit.empty() ? "" : fmt::format(" ({})", read.unit);
    static constexpr std::array kPositions = {"position", "pos", "q", "angle"};
    static constexpr std::array kVelocities = {"velocity", "vel", "dq", "qd"};
    if (read.words.empty()) return {};
    const auto& word = read.words.back();
    const std::string joint = "[{}]" + unit;
    if (std::find(kPositions.begin(), kPositions.end(), word) != kPositions.end()) return "position" + joint;
    if (std::find(kVelocities.begin(), kVelocities.end(), word) != kVelocities.end()) return "velocity" + joint;
    return {};
  };
  bool values = false;
  for (std::size_t c = 0; c < table.names.size(); ++c)
    values = values || (!times.contains(c) && !quantityOf(c).empty());
  if (!values) return;
  std::vector<std::size_t> rowOf(table.rows());
  std::size_t rows = 0;
  std::set<std::string> seen;
  for (std::size_t r = 0; r < table.rows(); ++r) {
    const bool same = r > 0 && std::all_of(times.begin(), times.end(),
                                           [&](std::size_t c) { return table.cells[c][r] == table.cells[c][r - 1]; });
    const auto& joint = table.cells[*label][r];
    if (!same || (!joint.empty() && seen.contains(joint))) {
      ++rows;
      seen.clear();
    }
    if (!joint.empty()) seen.insert(joint);
    rowOf[r] = rows - 1;
  }
  TextTable out;
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    if (c == *label) continue;
    const auto form = times.contains(c) ? std::string() : quantityOf(c);
    const std::size_t first = out.names.size();
    for (std::size_t j = 0; j < (form.empty() ? 1 : joints.size()); ++j) {
      out.names.push_back(form.empty() ? table.names[c] : fmt::format(fmt::runtime(form), printable(joints[j])));
      out.cells.emplace_back(rows);
    }
    for (std::size_t r = 0; r < table.rows(); ++r) {
      std::size_t j = 0;
      if (!form.empty()) {
        j = static_cast<std::size_t>(std::find(joints.begin(), joints.end(), table.cells[*label][r]) - joints.begin());
        if (j == joints.size()) continue;
      }
      auto& cell = out.cells[first + j][rowOf[r]];
      if (cell.empty()) cell = table.cells[c][r];
    }
  }
  table = std::move(out);
}

/// Columns that are split where rows are of several frames: of poses for child frames, else of any part.
std::set<std::size_t> columnsOfFrames(const TextTable& table, const std::string& before, bool child) {
  std::vector<Stream> stream(1);
  stream[0].fields = table.names;
  std::set<std::size_t> out;
  for (const auto& candidate : findCandidates(stream, {})) {
    const auto& part = candidate.part;
    const bool pose = part == "position" || part == "quaternion" || part == "rotation";
    if (child ? !pose : !pose && part != "wrench") continue;
    for (const auto& column : candidate.columns)
      if (table.names[column.field].starts_with(before)) out.insert(column.field);
  }
  return out;
}

/// Rows of several frames in one table become columns of one stream for each.
void splitFrames(TextTable& table, const std::string& file, Findings& findings) {
  auto label = columnCalled(table, {"child_frame_id", "child_frame", "childframeid"});
  const bool child = label.has_value();
  if (!child) label = columnCalled(table, {"frame_id", "frame", "frameid"});
  if (!label) return;
  const auto frames = differentTexts(table.cells[*label]);
  const auto& of = table.cells[*label];
  const bool gaps = std::any_of(of.begin(), of.end(), [](const auto& cell) { return cell.empty(); });
  if (frames.size() > kMostNames || (frames.size() < 2 && !gaps)) return;
  auto columns = columnsOfFrames(table, lastPart(table.names[*label]).second, child);
  for (const auto time : timesIn(table)) columns.erase(time);
  // What has its numbers in the rows of no frame only belongs to something else.
  std::erase_if(columns, [&](std::size_t c) {
    for (std::size_t r = 0; r < table.rows(); ++r)
      if (!of[r].empty() && !table.cells[c][r].empty()) return false;
    return true;
  });
  if (columns.empty()) return;
  std::size_t aside = 0;
  for (std::size_t r = 0; r < table.rows(); ++r)
    if (of[r].empty() &&
        std::any_of(columns.begin(), columns.end(), [&](std::size_t c) { return !table.cells[c][r].empty(); }))
      ++aside;
  if (frames.size() < 2 && aside == 0) return;
  TextTable out;
  const auto append = [&](std::string name, TextColumn cells, const std::string& owner) {
    out.names.push_back(std::move(name));
    out.cells.push_back(std::move(cells));
    out.owners.push_back(owner);
  };
  for (std::size_t c = 0; c < table.names.size(); ++c) {
    if (!columns.contains(c)) append(table.names[c], table.cells[c], "");
    if (!columns.contains(c)) continue;
    for (const auto& frame : frames) {
      TextColumn cells(table.rows());
      for (std::size_t r = 0; r < table.rows(); ++r)
        if (of[r] == frame) cells[r] = table.cells[c][r];
      const auto owner = printable(frame);
      append(frames.size() > 1 ? owner + "/" + table.names[c] : table.names[c], std::move(cells),
             frames.size() > 1 ? owner : "");
    }
  }
  if (frames.size() > 1)
    findings.push_back({Severity::warning,
                        "several_frames",
                        heft::say("The rows are of {} frames, each a source of its own: {}.", frames.size(),
                                  printable(fmt::format("{}", fmt::join(frames, ", ")), 200)),
                        remedy(Remedy::chooseSource, child ? "quaternion" : "wrench"),
                        {file, 0, 0}});
  if (aside > 0)
    findings.push_back({Severity::warning,
                        "frame_missing",
                        heft::say("{} rows have no {} and were left out.", aside, printable(table.names[*label])),
                        {},
                        {file, 0, 0}});
  table = std::move(out);
}

}  // namespace

void useTextColumns(TextTable& table, const std::string& file, Findings& findings) {
  if (table.rows() == 0) return;
  expandLists(table);
  nameJoints(table);
  gatherJoints(table);
  splitFrames(table, file, findings);
}

std::string nameEchoedColumns(TextTable& table) {
  const std::size_t columns = table.names.size();
  if (columns < 9 || table.rows() == 0) return {};
  const auto& frame = table.cells[2];
  const bool noFrame = std::all_of(frame.begin(), frame.end(), [](const auto& cell) { return cell.empty(); });
  if (!noFrame && !holdsText(frame)) return {};
  for (std::size_t r = 0; r < table.rows(); ++r)
    for (std::size_t c = 0; c < 2; ++c)
      if (const auto& cell = table.cells[c][r];
          cell.empty() || cell.find_first_not_of("0123456789") != std::string::npos)
        return {};
  std::size_t texts = 0;
  while (3 + texts < columns && holdsText(table.cells[3 + texts])) ++texts;
  for (std::size_t c = 3 + texts; c < columns; ++c)
    if (holdsText(table.cells[c])) return {};
  const std::size_t numbers = columns - 3 - texts;
  std::vector<std::string> names = {"header.stamp.sec", "header.stamp.nanosec", "header.frame_id"};
  const auto append = [&](const std::string& prefix, std::initializer_list<const char*> more) {
    for (const char* const each : more) names.push_back(prefix + each);
  };
  std::string type;
  if (texts == 1 && numbers == 7) {
    type = "geometry_msgs/TransformStamped";
    names.emplace_back("child_frame_id");
    append("transform.translation.", {"x", "y", "z"});
    append("transform.rotation.", {"x", "y", "z", "w"});
  } else if (texts == 0 && numbers == 7) {
    type = "geometry_msgs/PoseStamped";
    append("pose.position.", {"x", "y", "z"});
    append("pose.orientation.", {"x", "y", "z", "w"});
  } else if (texts == 0 && numbers == 6) {
    type = "geometry_msgs/WrenchStamped";
    append("wrench.force.", {"x", "y", "z"});
    append("wrench.torque.", {"x", "y", "z"});
  } else if (texts > 1 && numbers >= texts && numbers % texts == 0 && numbers <= 3 * texts) {
    type = "sensor_msgs/JointState";
    // With two values a joint the second is its velocity or its effort, and nothing tells which.
    const std::size_t kinds = numbers / texts;
    const std::array<const char*, 4> quantities = {"name", "position", kinds == 3 ? "velocity" : "second", "effort"};
    for (std::size_t k = 0; k <= kinds; ++k)
      for (std::size_t j = 0; j < texts; ++j) names.push_back(fmt::format("{}[{}]", quantities[k], j));
  } else {
    return {};
  }
  table.names = std::move(names);
  return type;
}

}  // namespace heft
