// Thousands of damaged recordings and setup files: none may crash, hang, or come back with numbers that are none.
#include <algorithm>
#include <random>

#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;

/// Changes a few places of the text the way transfers, editors and broken loggers do, and worse.
std::string mutated(std::string text, std::mt19937& random) {
  static const std::vector<std::string> kPieces = {",",
                                                   ";",
                                                   "\t",
                                                   "\n",
                                                   "\r",
                                                   "\r\n",
                                                   "\"",
                                                   "\"\"",
                                                   "-",
                                                   "+",
                                                   "e",
                                                   "e999",
                                                   ".",
                                                   "nan",
                                                   "inf",
                                                   "1e308",
                                                   "-1e-320",
                                                   "0",
                                                   "{",
                                                   "}",
                                                   "[",
                                                   "]",
                                                   ":",
                                                   "null",
                                                   " ",
                                                   "\xFF",
                                                   "\xEF\xBB\xBF",
                                                   std::string(1, '\0'),
                                                   "time",
                                                   "q1",
                                                   "fx",
                                                   "label",
                                                   "999999999999999999999999",
                                                   "\"a,b",
                                                   "true",
                                                   "-0.0"};
  const auto count = 1 + random() % 6;
  for (unsigned i = 0; i < count && !text.empty(); ++i) {
    const auto at = random() % text.size();
    const auto length = std::min<std::size_t>(1 + random() % 30, text.size() - at);
    switch (random() % 6) {
      case 0:
        text[at] = static_cast<char>(random() % 256);
        break;
      case 1:
        text.erase(at, length);
        break;
      case 2:
        text.insert(at, kPieces[random() % kPieces.size()]);
        break;
      case 3:
        text.insert(random() % text.size(), text.substr(at, length));
        break;
      case 4:
        text.replace(at, 1, kPieces[random() % kPieces.size()]);
        break;
      default:
        if (random() % 4 == 0) text.resize(at);
        break;
    }
  }
  return text;
}

void expectSound(const Recording& recording, const std::string& text) {
  const auto rows = recording.rows();
  ASSERT_GT(rows, 0) << text;
  ASSERT_TRUE(recording.time.allFinite()) << text;
  for (Eigen::Index k = 1; k < rows; ++k) ASSERT_GT(recording.time(k), recording.time(k - 1)) << text;
  ASSERT_EQ(recording.wrench.rows(), rows) << text;
  ASSERT_TRUE(recording.wrench.allFinite()) << text;
  const auto series = [&](const auto& values) {
    ASSERT_TRUE(values.rows() == 0 || values.rows() == rows) << text;
    ASSERT_TRUE(values.allFinite()) << text;
  };
  series(recording.q);
  series(recording.dq);
  series(recording.position);
  series(recording.quaternion);
  series(recording.twist);
  ASSERT_TRUE(recording.hasJoints() || recording.hasOrientation()) << text;
  for (Eigen::Index k = 0; k < recording.quaternion.rows(); ++k)
    ASSERT_NEAR(recording.quaternion.row(k).norm(), 1.0, 1e-14) << text;
  ASSERT_TRUE(recording.labels.empty() || recording.labels.size() == static_cast<std::size_t>(rows)) << text;
  for (const auto& extra : recording.extra) ASSERT_EQ(extra.cells.size(), static_cast<std::size_t>(rows)) << text;
}

TEST(Fuzz, DamagedTables) {
  std::mt19937 random(2024);
  std::vector<std::string> seeds;
  for (const auto form : {Form::joints, Form::pose, Form::orientation})
    for (const bool rates : {false, true}) {
      auto table = goodTable(form, 30, rates);
      seeds.push_back(table.text());
      table.addColumn("label", "free");
      table.addColumn("note", "\"x;y\"");
      seeds.push_back(table.text(";", "\r\n"));
    }
  int read = 0;
  for (int round = 0; round < 6000; ++round) {
    const auto text = mutated(seeds[random() % seeds.size()], random);
    RecordingMeta meta;
    if (random() % 2 == 0) meta.robot = "panda";
    if (random() % 4 == 0) meta.kind = RecordingKind::poses;
    if (random() % 2 == 0) meta.wrenchSign = WrenchSign::payloadOnSensor;
    const auto result = parseRecording(text, "rec.csv", meta);
    if (!result) {
      EXPECT_EQ(result.error().message.rfind("rec.csv", 0), 0u) << result.error().message;
      EXPECT_EQ(result.error().message.find('\n'), std::string::npos) << result.error().message;
      continue;
    }
    ++read;
    ASSERT_NO_FATAL_FAILURE(expectSound(result->recording, text));
    for (const auto& finding : result->findings) EXPECT_FALSE(finding.text.empty() || finding.code.empty());
  }
  EXPECT_GT(read, 500) << "the damage is so great that the checks behind the parser are never reached";
}

TEST(Fuzz, RandomBytes) {
  std::mt19937 random(99);
  for (int round = 0; round < 3000; ++round) {
    std::string text = round % 2 == 0 ? "time,qx,qy,qz,qw,fx,fy,fz,tx,ty,tz\n" : "";
    const std::string alphabet = "0123456789.,-+e\n\r\";\t naif";
    for (auto length = random() % 400; length > 0; --length)
      text += round % 3 == 0 ? static_cast<char>(random() % 256) : alphabet[random() % alphabet.size()];
    const auto result = parseRecording(text, "rec.csv", {});
    if (!result) continue;
    ASSERT_NO_FATAL_FAILURE(expectSound(result->recording, text));
  }
}

TEST(Fuzz, DamagedMetaFiles) {
  const std::string seed = R"({"robot": "panda", "kind": "motion",
    "sensor": {"mount": {"parent": "panda_link8", "xyz_m": [0, 0, 0.1], "rpy_rad": [0, 0, 0]}, "model": "x", "wrench_sign": "sensor_on_payload",
      "wrench_axes": "base", "wrench_point": [0, 0.01, 0.1], "torque_sign": "opposite", "mirrored_axis": "x", "torque_unit": 0.5},
    "angle_unit": "deg", "pose": "base_in_sensor",
    "gravity_m_s2": [0, 0, -9.81],
    "known_payload": {"mass_kg": 0.5, "com_m": [0, 0, 0.1], "inertia_com_kgm2": [[1e-3, 0, 0], [0, 1e-3, 0], [0, 0, 1e-3]]},
    "marks": [{"from_s": 0, "to_s": 1, "label": "free"}], "note": ""})";
  std::mt19937 random(7);
  int read = 0;
  for (int round = 0; round < 6000; ++round) {
    Findings findings;
    const auto text = mutated(seed, random);
    const auto result = parseMeta(text, "rec.meta.json", "/data", findings);
    if (!result) {
      EXPECT_EQ(result.error().message.rfind("rec.meta.json:", 0), 0u) << result.error().message;
      continue;
    }
    ++read;
    EXPECT_TRUE(result->gravity.allFinite()) << text;
    EXPECT_TRUE(result->conventions.wrenchPoint.offset.allFinite() && result->conventions.torque.si > 0.0) << text;
    EXPECT_TRUE(result->mount.xyz.allFinite() && result->mount.rpy.allFinite()) << text;
    EXPECT_GT(result->knownPayload.mass.value_or(1.0), 0.0) << text;
    EXPECT_TRUE(result->knownPayload.com.value_or(Vector3d::Zero()).allFinite()) << text;
    for (const auto& mark : result->marks) EXPECT_LE(mark.from, mark.to) << text;
  }
  EXPECT_GT(read, 100);
}

}  // namespace
}  // namespace heft
