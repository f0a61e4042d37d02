#pragma once
// What the recordings of tests/data/recordings hold (make_fixtures.py), and files for single tests.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>

#include "core/import/import.h"

namespace heft::testing_support {

inline constexpr double kDegree = 3.14159265358979323846 / 180.0;  // [rad]

/// Why a recording could not be read; empty where it could.
inline std::string failureOf(const Result<ReadRecording>& read) {
  return read.ok() ? std::string() : read.error().message;
}

inline std::filesystem::path fixture(const std::string& name) {
  return std::filesystem::path(HEFT_SOURCE_DIR) / "tests/data/recordings" / name;
}

inline double jointAt(double t, int joint) {
  constexpr double kHome[] = {0.0, -0.785, 0.0, -2.356, 0.0, 1.571, 0.785};
  return kHome[joint] + 0.2 * std::sin(3.0 * t + joint);
}
inline double wrenchAt(double t, int axis) {
  const double values[] = {std::sin(5.0 * t), 2.0 * std::cos(4.0 * t), -5.0 + t, 0.1 * t, -0.2 * std::sin(t), 0.05};
  return values[axis];
}

/// `first`: time in the formula of the recording's time zero.
inline void expectFormula(const Recording& recording, double first = 0.0) {
  ASSERT_GT(recording.rows(), 0);
  ASSERT_EQ(recording.q.cols(), 7);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    const double t = recording.time(k) + first;
    for (int j = 0; j < 7; ++j) ASSERT_NEAR(recording.q(k, j), jointAt(t, j), 2e-6) << "row " << k << " joint " << j;
    for (int a = 0; a < 6; ++a)
      ASSERT_NEAR(recording.wrench(k, a), wrenchAt(t, a), 1e-3) << "row " << k << " axis " << a;
  }
}

inline bool hasCode(const Findings& findings, const std::string& code) {
  for (const auto& finding : findings)
    if (finding.code == code) return true;
  return false;
}

inline std::string allTexts(const Findings& findings) {
  std::string out;
  for (const auto& finding : findings) out += finding.code + ": " + finding.text + "\n";
  return out;
}

/// A folder of its own for each test, removed afterwards.
class InFolder : public ::testing::Test {
 protected:
  InFolder() {
    const auto* const test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() / (std::string("heft_import_") + test->test_suite_name() + "_" +
                                                        test->name() + "_" + std::to_string(::getpid()));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~InFolder() override {
    std::error_code code;
    std::filesystem::remove_all(folder_, code);
  }
  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    std::ofstream(folder_ / name, std::ios::binary) << bytes;
    return folder_ / name;
  }
  static std::string read(const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::filesystem::path folder_;
};

}  // namespace heft::testing_support
