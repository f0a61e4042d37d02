// What is written reads back to the same bits.
#include <unistd.h>

#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/base/json_file.h"
#include "tests/core/recording/sample.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::HasSubstr;

class RoundTrip : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() / ("heft_roundtrip_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }
  std::filesystem::path folder_;
};

template <class A, class B>
bool sameBits(const A& a, const B& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() &&
         (a.size() == 0 || std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0);
}

/// Any finite double, with emphasis on the awkward ones.
double anyDouble(std::mt19937_64& random) {
  switch (random() % 6) {
    case 0:
      return -0.0;
    case 1:
      return std::numeric_limits<double>::denorm_min() * static_cast<double>(random() % 100);
    case 2:
      return static_cast<double>(static_cast<std::int64_t>(random())) * 1e-19;
    default: {
      double value = 0.0;
      do value = std::bit_cast<double>(random());
      while (!std::isfinite(value));
      return value;
    }
  }
}

Recording randomRecording(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  Recording recording;
  const auto rows = static_cast<Eigen::Index>(1 + random() % 40);
  recording.meta.robot = "panda";
  recording.meta.kind = random() % 3 == 0 ? RecordingKind::poses : RecordingKind::motion;
  recording.meta.wrenchSign = random() % 2 == 0 ? WrenchSign::payloadOnSensor : WrenchSign::sensorOnPayload;
  recording.meta.gravity = {0.1 * normal(random), 0.1 * normal(random), -9.8};
  recording.meta.mount.xyz = Vector3d::Random();
  recording.meta.mount.rpy = Vector3d::Random();
  recording.meta.sensorModel = "Gamma \"SI-32\"\n\\ µ";
  if (random() % 2 == 0) recording.meta.knownPayload.mass = 0.1 + std::abs(normal(random));
  if (random() % 2 == 0) recording.meta.knownPayload.com = 0.1 * Vector3d::Random();
  if (random() % 2 == 0) recording.meta.knownPayload.inertiaCom = Matrix3d(Vector3d(1e-3, 1.1e-3, 1.2e-3).asDiagonal());
  for (auto i = random() % 3; i > 0; --i)
    recording.meta.marks.push_back(
        {0.25 * static_cast<double>(i), 0.25 * static_cast<double>(i) + 0.1, MarkLabel::contact});

  recording.time.resize(rows);
  double time = 1e3 * normal(random);
  for (auto& t : recording.time) t = time += 1e-3 * (1.0 + 0.1 * std::abs(normal(random)));
  const bool joints = random() % 2 == 0;
  if (joints) {
    recording.q = MatrixXd::Random(rows, 7) * 3.0;
    if (random() % 2 == 0) recording.dq = MatrixXd::Random(rows, 7);
  }
  if (!joints || random() % 2 == 0) {
    recording.quaternion.resize(rows, 4);
    Eigen::Vector4d latest(0, 0, 0, 1);
    for (Eigen::Index k = 0; k < rows; ++k) {
      latest = (latest + 0.1 * Eigen::Vector4d::Random()).normalized();
      recording.quaternion.row(k) = latest.transpose();
    }
    if (random() % 2 == 0) {
      recording.position = Eigen::Matrix<double, Eigen::Dynamic, 3>::Random(rows, 3);
      if (random() % 2 == 0) recording.twist = Eigen::Matrix<double, Eigen::Dynamic, 6>::Random(rows, 6);
    }
  }
  recording.wrench.resize(rows, 6);
  for (Eigen::Index c = 0; c < 6; ++c)
    for (Eigen::Index k = 0; k < rows; ++k) recording.wrench(k, c) = anyDouble(random);
  if (random() % 2 == 0)
    for (Eigen::Index k = 0; k < rows; ++k)
      recording.labels.push_back(random() % 2 == 0 ? std::nullopt : std::optional(MarkLabel::ignore));
  if (random() % 2 == 0) {
    recording.extra.push_back({"odd \"name\", with ; all\ttabs", {}});
    recording.extra.push_back({"plain", {}});
    const std::vector<std::string> cells = {"",    "x",  " blanks ",     "\"",  "a,b",
                                            "1;2", "\t", "\"\"quoted\"", "nan", "\xFF\xE9"};
    for (auto& extra : recording.extra)
      for (Eigen::Index k = 0; k < rows; ++k) extra.cells.push_back(cells[random() % cells.size()]);
  }
  return recording;
}

TEST_F(RoundTrip, EveryBitSurvives) {
  std::mt19937_64 random(42);
  for (int round = 0; round < 300; ++round) {
    const auto written = randomRecording(random);
    const auto file = folder_ / "rec.csv";
    const auto done = writeRecording(written, file);
    ASSERT_TRUE(done) << done.error().message;
    const auto result = readRecording(file);
    ASSERT_TRUE(result) << result.error().message;
    const auto& read = result->recording;
    ASSERT_TRUE(sameBits(read.time, written.time));
    ASSERT_TRUE(sameBits(read.q, written.q));
    ASSERT_TRUE(sameBits(read.dq, written.dq));
    ASSERT_TRUE(sameBits(read.position, written.position));
    ASSERT_TRUE(sameBits(read.quaternion, written.quaternion));
    ASSERT_TRUE(sameBits(read.twist, written.twist));
    ASSERT_TRUE(sameBits(read.wrench, written.wrench));
    ASSERT_EQ(read.labels, written.labels);
    ASSERT_EQ(read.extra.size(), written.extra.size());
    for (std::size_t e = 0; e < read.extra.size(); ++e) {
      ASSERT_EQ(read.extra[e].name, written.extra[e].name);
      for (std::size_t k = 0; k < read.extra[e].cells.size(); ++k) {
        auto expected = written.extra[e].cells[k];
        ASSERT_EQ(read.extra[e].cells[k], expected);
      }
    }
    const auto& a = read.meta;
    const auto& b = written.meta;
    ASSERT_EQ(a.robot, b.robot);
    ASSERT_EQ(a.kind, b.kind);
    ASSERT_EQ(a.wrenchSign, b.wrenchSign);
    ASSERT_TRUE(sameBits(a.gravity, b.gravity));
    ASSERT_TRUE(sameBits(a.mount.xyz, b.mount.xyz));
    ASSERT_TRUE(sameBits(a.mount.rpy, b.mount.rpy));
    ASSERT_EQ(a.sensorModel, b.sensorModel);
    ASSERT_EQ(a.knownPayload.mass, b.knownPayload.mass);
    ASSERT_EQ(a.knownPayload.com, b.knownPayload.com);
    ASSERT_EQ(a.knownPayload.inertiaCom, b.knownPayload.inertiaCom);
    ASSERT_EQ(a.marks.size(), b.marks.size());
  }
}

TEST_F(RoundTrip, FileKeepsItsOwnWrenchSign) {
  auto table = goodTable(Form::pose, 20);
  auto meta = pandaMeta();
  meta.wrenchSign = WrenchSign::payloadOnSensor;
  const auto result = parse(table.text(), meta);
  ASSERT_TRUE(result);
  ASSERT_TRUE(writeRecording(result->recording, folder_ / "rec.csv"));
  const auto text = readTextFile(folder_ / "rec.csv");
  EXPECT_THAT(*text, HasSubstr("," + table.cell(0, "fx") + ","));
  EXPECT_THAT(*readTextFile(folder_ / "rec.meta.json"), HasSubstr("payload_on_sensor"));
}

TEST_F(RoundTrip, WritingTwiceGivesTheSameFile) {
  auto table = goodTable(Form::joints, 50, true);
  table.names[0] = "Time [s]";
  table.addColumn("note", "\"a,b\"");
  const auto first = parse(table.text(";"));
  ASSERT_TRUE(first) << first.error().message;
  ASSERT_TRUE(writeRecording(first->recording, folder_ / "a.csv"));
  const auto second = readRecording(folder_ / "a.csv");
  ASSERT_TRUE(second) << second.error().message;
  EXPECT_EQ(findCode(second->findings, "names_normalised"), nullptr) << "the header is normalised";
  ASSERT_TRUE(writeRecording(second->recording, folder_ / "b.csv"));
  EXPECT_EQ(*readTextFile(folder_ / "a.csv"), *readTextFile(folder_ / "b.csv"));
  EXPECT_EQ(*readTextFile(folder_ / "a.meta.json"), *readTextFile(folder_ / "b.meta.json"));
}

TEST_F(RoundTrip, RobotBelowTheFolderIsWrittenRelative) {
  auto recording = parse(goodTable(Form::joints, 20).text())->recording;
  recording.meta.robot = (folder_ / "arms" / "arm.urdf").string();
  ASSERT_TRUE(writeRecording(recording, folder_ / "rec.csv"));
  EXPECT_THAT(*readTextFile(folder_ / "rec.meta.json"), HasSubstr("\"arms/arm.urdf\""));
  EXPECT_EQ(readRecording(folder_ / "rec.csv")->recording.meta.robot, recording.meta.robot);
  recording.meta.robot = "/elsewhere/arm.urdf";
  ASSERT_TRUE(writeRecording(recording, folder_ / "rec.csv"));
  EXPECT_THAT(*readTextFile(folder_ / "rec.meta.json"), HasSubstr("\"/elsewhere/arm.urdf\""));
}

TEST_F(RoundTrip, BrokenRecordingsAreNotWritten) {
  const auto good = parse(goodTable(Form::joints, 20).text())->recording;
  const auto refused = [&](const char* what, auto change) {
    auto recording = good;
    change(recording);
    const auto result = writeRecording(recording, folder_ / "bad.csv");
    ASSERT_FALSE(result) << what;
    EXPECT_THAT(result.error().message, HasSubstr("cannot be written")) << what;
    EXPECT_FALSE(std::filesystem::exists(folder_ / "bad.csv")) << what;
  };
  refused("NaN", [](Recording& r) { r.wrench(3, 3) = std::nan(""); });
  refused("infinite", [](Recording& r) { r.q(0, 0) = std::numeric_limits<double>::infinity(); });
  refused("length", [](Recording& r) { r.wrench.conservativeResize(10, 6); });
  refused("labels", [](Recording& r) { r.labels.resize(3); });
  refused("extra", [](Recording& r) { r.extra.push_back({"x", {"1"}}); });
  refused("empty", [](Recording& r) { r = Recording(); });
  EXPECT_FALSE(writeRecording(good, folder_ / "no" / "such" / "rec.csv"));
}

}  // namespace
}  // namespace heft
