#pragma once
// Small recordings as tables of text, to be broken in one place by each test.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "core/recording/csv_reader.h"

namespace heft::testing_support {

struct Table {
  std::vector<std::string> names;
  std::vector<std::vector<std::string>> rows;

  std::size_t column(const std::string& name) const {
    for (std::size_t c = 0; c < names.size(); ++c)
      if (names[c] == name) return c;
    throw std::logic_error("no column " + name);
  }
  std::string& cell(std::size_t row, const std::string& name) { return rows.at(row)[column(name)]; }
  double number(std::size_t row, const std::string& name) { return std::stod(cell(row, name)); }
  void setColumn(const std::string& name, const std::string& value) {
    for (std::size_t r = 0; r < rows.size(); ++r) cell(r, name) = value;
  }
  void scaleColumn(const std::string& name, double factor) {
    for (std::size_t r = 0; r < rows.size(); ++r) cell(r, name) = fmt::format("{}", factor * number(r, name));
  }
  void addColumn(const std::string& name, const std::string& value = "0") {
    names.push_back(name);
    for (auto& row : rows) row.push_back(value);
  }
  void removeColumn(const std::string& name) {
    const auto c = static_cast<std::ptrdiff_t>(column(name));
    names.erase(names.begin() + c);
    for (auto& row : rows) row.erase(row.begin() + c);
  }
  std::string text(const std::string& separator = ",", const std::string& newline = "\n") const {
    std::string out = fmt::format("{}{}", fmt::join(names, separator), newline);
    for (const auto& row : rows) out += fmt::format("{}{}", fmt::join(row, separator), newline);
    return out;
  }
};

enum class Form { joints, pose, orientation };

/// A smooth motion at 100 Hz with a living wrench; without a single defect.
inline Table goodTable(Form form, std::size_t rows = 200, bool rates = false) {
  Table table;
  table.names = {"time"};
  if (form == Form::joints)
    for (int j = 1; j <= 7; ++j) table.names.push_back(fmt::format("q{}", j));
  if (form == Form::joints && rates)
    for (int j = 1; j <= 7; ++j) table.names.push_back(fmt::format("dq{}", j));
  if (form == Form::pose) table.names.insert(table.names.end(), {"px", "py", "pz"});
  if (form != Form::joints) table.names.insert(table.names.end(), {"qx", "qy", "qz", "qw"});
  if (form == Form::pose && rates) table.names.insert(table.names.end(), {"vx", "vy", "vz", "wx", "wy", "wz"});
  table.names.insert(table.names.end(), {"fx", "fy", "fz", "tx", "ty", "tz"});

  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  const Eigen::Vector3d axis = Eigen::Vector3d(0.3, -0.5, 0.8).normalized();
  for (std::size_t r = 0; r < rows; ++r) {
    const double t = 0.01 * static_cast<double>(r);
    std::vector<double> values = {t};
    if (form == Form::joints)
      for (int j = 0; j < 7; ++j) values.push_back(0.8 * std::sin(1.3 * t + j));
    if (form == Form::joints && rates)
      for (int j = 0; j < 7; ++j) values.push_back(0.8 * 1.3 * std::cos(1.3 * t + j));
    if (form == Form::pose)
      for (int i = 0; i < 3; ++i) values.push_back(0.5 + 0.2 * std::sin(t + i));
    if (form != Form::joints) {
      const double half = 0.5 * std::sin(2.0 * t);
      for (int i = 0; i < 3; ++i) values.push_back(std::sin(half) * axis(i));
      values.push_back(std::cos(half));
    }
    if (form == Form::pose && rates) {
      for (int i = 0; i < 3; ++i) values.push_back(0.2 * std::cos(t + i));
      for (int i = 0; i < 3; ++i) values.push_back(2.0 * std::cos(2.0 * t) * axis(i));
    }
    for (int i = 0; i < 6; ++i)
      values.push_back((i < 3 ? 5.0 : 0.5) + (i < 3 ? 1.0 : 0.1) * (std::sin(t + i) + 0.1 * noise(random)));
    table.rows.emplace_back();
    for (const double value : values) table.rows.back().push_back(fmt::format("{}", value));
  }
  return table;
}

inline RecordingMeta pandaMeta() {
  RecordingMeta meta;
  meta.robot = "panda";
  return meta;
}

inline Result<ReadRecording> parse(const std::string& text, RecordingMeta meta = pandaMeta()) {
  return parseRecording(text, "rec.csv", std::move(meta));
}

/// The message of a failure, or of a wrong success.
inline std::string failureOf(const std::string& text, RecordingMeta meta = pandaMeta()) {
  const auto result = parse(text, std::move(meta));
  return result ? "(was read without failure)" : result.error().message;
}

inline const Finding* findCode(const Findings& findings, const std::string& code) {
  for (const auto& finding : findings)
    if (finding.code == code) return &finding;
  return nullptr;
}

inline std::string allLines(const Findings& findings) {
  std::string out;
  for (const auto& finding : findings) out += "[" + finding.code + "] " + toLine(finding) + "\n";
  return out;
}

}  // namespace heft::testing_support
