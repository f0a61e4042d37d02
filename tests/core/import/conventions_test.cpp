// Conventions and angles that wrap, in recordings of other programs.
#include <fmt/format.h>

#include <numbers>

#include "core/motion/sensor_axes.h"
#include "tests/core/import/fixtures.h"
#include "tests/support/in_conventions.h"

namespace heft {
namespace {

using namespace testing_support;
using ::testing::HasSubstr;
using ImportedConventions = InFolder;

TEST_F(ImportedConventions, EveryOneReadsAsThePlainForm) {
  const PlainMotion motion;
  for (const auto& conventions : conventionsToTry()) {
    for (const auto form : {MotionForm::joints, MotionForm::poses}) {
      SCOPED_TRACE(conventions.dump() + (form == MotionForm::joints ? " joints" : " poses"));
      const auto numbers = numbersIn(conventions, motion, form);
      write("rec.meta.json", withRig(conventions, motion.recording.meta).dump());
      // JSON lines, and a table of the plain kind that a map file makes an import.
      const auto lines = write("rec.jsonl", numbers.jsonLines());
      write("rec.csv", numbers.csv());
      for (const auto& [name, map] : {std::pair("rec.jsonl", ""), std::pair("rec.csv", "{\"clock\": \"received\"}")}) {
        ImportOptions options;
        options.metaFile = folder_ / "rec.meta.json";
        if (*map != '\0') options.mapFile = write("some.map.json", map);
        auto read = openRecording(folder_ / name, options);
        ASSERT_TRUE(read) << read.error().message;
        ASSERT_TRUE(toSensorAxes(read->recording));
        EXPECT_LT(differenceFrom(motion, read->recording), 1e-12) << name;
      }
    }
  }
}

TEST_F(ImportedConventions, AMapFileStatesThemAndCountsMore) {
  const PlainMotion motion;
  const nlohmann::json conventions = {{"sensor", {{"torque_unit", "N mm"}, {"wrench_axes", "base"}}},
                                      {"angle_unit", "deg"}};
  const auto file = write("rec.csv", numbersIn(conventions, motion, MotionForm::joints).csv());
  nlohmann::json meta =
      withRig({{"sensor", {{"torque_unit", "lbf in"}, {"mirrored_axis", "x"}}}}, motion.recording.meta);
  write("rec.meta.json", meta.dump());
  nlohmann::json map = conventions;
  map["sensor"]["mirrored_axis"] = nullptr;
  const auto mapFile = write("rec.map.json", map.dump());
  auto read = openRecording(file);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_TRUE(toSensorAxes(read->recording));
  EXPECT_LT(differenceFrom(motion, read->recording), 1e-12);
  EXPECT_EQ(toJson(read->recording.meta.conventions),
            nlohmann::json({{"torque_unit", "N mm"}, {"wrench_axes", "base"}, {"angle_unit", "deg"}}));

  const auto wishes = readMapFile(mapFile);
  ASSERT_TRUE(wishes);
  EXPECT_EQ(nlohmann::json::parse(mapText(*wishes, folder_)), map) << "what a window writes back";
}

TEST_F(ImportedConventions, AWrongMapFileIsRefused) {
  const auto file = write("rec.csv", numbersIn(nlohmann::json::object(), PlainMotion(), MotionForm::joints).csv());
  const std::pair<const char*, const char*> cases[] = {
      {R"({"sensor": {"wrench_axes": "tool"}})", "rec.map.json: sensor.wrench_axes: must be \"sensor\" or \"base\""},
      {R"({"sensor": {"mount": {}}})", "\"sensor.mount\" is not known"},
      {R"({"sensor": "base"})", "\"sensor\" is not an object"},
      {R"({"angle_units": "deg"})", "\"angle_units\" is not known"},
      {R"({"angle_unit": "deg", "scale": {"joints": 0.0174532925}})", "scales joints by 0.0174532925, and angle_unit"},
      {R"({"length_unit": "mm", "scale": {"px": 0.001}})", "length_unit"},
      {R"({"sensor": {"torque_unit": "N mm"}, "scale": {"tx": 0.001}})", "torque_unit"}};
  for (const auto& [map, expected] : cases) {
    write("rec.map.json", map);
    const auto read = openRecording(file);
    ASSERT_FALSE(read) << map;
    EXPECT_THAT(read.error().message, HasSubstr(expected));
  }
  write("rec.map.json", R"({"angle_unit": "deg", "scale": {"qx": 1.0, "quaternion": 1.0, "time": 1.0}})");
  EXPECT_THAT(allTexts(inspectRecording(file)->findings), ::testing::Not(HasSubstr("scales")));
}

TEST_F(ImportedConventions, PosesOfTheFlangeMayBeInvertedToo) {
  PlainMotion motion;
  const Isometry3d X_FS = poseFromXyzRpy(motion.recording.meta.mount.xyz, motion.recording.meta.mount.rpy);
  PlainMotion flange = motion;
  for (Eigen::Index k = 0; k < motion.recording.rows(); ++k) {
    const Isometry3d X_BF = motion.X_BS[static_cast<std::size_t>(k)] * X_FS.inverse();
    flange.recording.position.row(k) = X_BF.translation().transpose();
    flange.recording.quaternion.row(k) = Quaterniond(X_BF.linear()).coeffs().transpose();
  }
  const nlohmann::json conventions = {{"pose", "base_in_sensor"},
                                      {"quaternion_order", "wxyz"},
                                      {"length_unit", "mm"},
                                      {"sensor", {{"wrench_axes", "base"}}}};
  const auto file = write("rec.csv", numbersIn(conventions, flange, MotionForm::poses).csv());
  write("rec.meta.json", withRig(conventions, motion.recording.meta).dump());
  write("rec.map.json", R"({"pose_of": "flange"})");
  auto read = openRecording(file);
  ASSERT_TRUE(read) << read.error().message;
  ASSERT_TRUE(toSensorAxes(read->recording));
  EXPECT_LT((read->recording.position - motion.recording.position).cwiseAbs().maxCoeff(), 1e-12);
  EXPECT_LT((read->recording.wrench - motion.recording.wrench).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(ImportedConventions, AnglesAreUnwrappedBeforeTheyAreAveraged) {
  // Joints at 1 kHz, within -180 to 180 degrees, and a wrench of another file at 97 Hz on the same clock.
  std::string joints = "time,q1,q2,q3,q4,q5,q6,q7\n";
  std::string wrench = "time,fx,fy,fz,tx,ty,tz\n";
  const auto angle = [](double t, int j) { return jointAt(t, j) + (j == 2 ? 3.0 : j == 4 ? -2.0 * t : 0.0); };
  constexpr double kStartSeconds = 1700000000.0;
  for (int k = 0; k < 5000; ++k) {
    const double t = 0.001 * k;
    joints += fmt::format("{:.6f}", kStartSeconds + t);
    for (int j = 0; j < 7; ++j)
      joints += fmt::format(",{:.12f}", std::remainder(angle(t, j), 2.0 * std::numbers::pi) * 180.0 / std::numbers::pi);
    joints += "\n";
  }
  for (int k = 0; k < 480; ++k) {
    const double t = k / 97.0;
    wrench += fmt::format("{:.6f}", kStartSeconds + t);
    for (int a = 0; a < 6; ++a) wrench += fmt::format(",{:.9f}", wrenchAt(t, a));
    wrench += "\n";
  }
  const auto file = write("joints.csv", joints);
  write("joints.meta.json", R"({"robot": "panda", "angle_unit": "deg"})");
  ImportOptions options;
  options.join = {write("wrench.csv", wrench)};
  const auto read = openRecording(file, options);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_THAT(allTexts(read->findings),
              HasSubstr("angles_unwrapped: Angles that wrap around: whole turns were removed from q3 and q5."));
  const Recording& recording = read->recording;
  ASSERT_GT(recording.rows(), 400);
  for (const int j : {2, 4}) {
    const double shift = recording.q(0, j) - angle(recording.time(0), j);
    EXPECT_NEAR(std::remainder(shift, 2.0 * std::numbers::pi), 0.0, 1e-3);
    for (Eigen::Index k = 0; k < recording.rows(); ++k)
      ASSERT_NEAR(recording.q(k, j) - shift, angle(recording.time(k), j), 1e-3) << "row " << k;
  }
}

TEST_F(ImportedConventions, ClocksAreAlignedByForcesInBaseAxesToo) {
  constexpr double kLate = 3.217;  // [s]
  const PlainMotion motion(4000, 200.0);
  const auto& p = motion.recording.position;
  std::string joints = "time,q1,q2,q3,q4,q5,q6,q7\n";
  std::string wrench = "time,fx,fy,fz,tx,ty,tz\n";
  std::vector<Vector3d> expected;
  for (Eigen::Index k = 1; k + 1 < p.rows(); ++k) {
    const double t = motion.recording.time(k);
    joints += fmt::format("{:.6f}", 1700000000.0 + t);
    for (int j = 0; j < 7; ++j) joints += fmt::format(",{:.12f}", motion.recording.q(k, j));
    joints += "\n";
    const Vector3d a = (p.row(k + 1) - 2.0 * p.row(k) + p.row(k - 1)).transpose() * 200.0 * 200.0;
    const Vector3d f = 1.5 * (a + Vector3d(0.0, 0.0, 9.81));
    wrench += fmt::format("{:.6f},{:.9f},{:.9f},{:.9f},0.1,0.2,{:.9f}\n", t + 40.0 + kLate, f.x(), f.y(), f.z(), f.x());
    expected.push_back(motion.X_BS[static_cast<std::size_t>(k)].linear().transpose() * f);
  }
  const auto file = write("joints.csv", joints);
  write("joints.meta.json", withRig({{"sensor", {{"wrench_axes", "base"}}}}, motion.recording.meta).dump());
  ImportOptions options;
  options.join = {write("wrench.csv", wrench)};
  auto read = openRecording(file, options);
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_TRUE(hasCode(read->findings, "clock_offset")) << allTexts(read->findings);
  ASSERT_TRUE(toSensorAxes(read->recording));
  ASSERT_GT(read->recording.rows(), 3000);
  for (Eigen::Index k = 0; k < read->recording.rows(); k += 100) {
    const auto row = static_cast<std::size_t>(std::lround(read->recording.time(k) * 200.0));
    ASSERT_LT(row, expected.size());
    EXPECT_LT((read->recording.wrench.row(k).head<3>().transpose() - expected[row]).norm(), 0.1) << k;
  }
}

}  // namespace
}  // namespace heft
