// Text in a table's cells: names of joints and frames.
#include <fmt/format.h>

#include <algorithm>

#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;
using testing::HasSubstr;
using TextColumns = InFolder;

constexpr int kTextRows = 100;
constexpr double kEchoStart = 1700000000.0;

std::string panda(int joint) { return fmt::format("panda_joint{}", joint + 1); }

/// Which joint stands in place `place` of row k: in another order in each row.
int inPlace(int k, int place) { return (place + 3 * k) % 7; }

std::string wrenchCells(double t) {
  std::string out;
  for (int a = 0; a < 6; ++a) out += fmt::format(",{:.9f}", wrenchAt(t, a));
  return out;
}

const std::string kSixNames = ",fx,fy,fz,tx,ty,tz\n";

TEST_F(TextColumns, JointsHaveTheNamesOfTheirOwnRow) {
  for (const char* const form : {"field.{}{}", "{}_{}", "{}[{}]", "joint_states.{}.{}"}) {
    std::string text = "time";
    for (const char* const what : {"name", "position", "velocity"})
      for (int j = 0; j < 7; ++j) text += "," + fmt::format(fmt::runtime(form), what, j);
    text += kSixNames;
    for (int k = 0; k < kTextRows; ++k) {
      const double t = 0.01 * k;
      text += fmt::format("{:.2f}", t);
      for (int j = 0; j < 7; ++j) text += "," + panda(inPlace(k, j));
      for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", jointAt(t, inPlace(k, j)));
      for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", 0.6 * std::cos(3.0 * t + inPlace(k, j)));
      text += wrenchCells(t) + "\n";
    }
    const auto read = openRecording(write("names.csv", text));
    ASSERT_TRUE(read.ok()) << form << ": " << read.error().message;
    expectFormula(read->recording);
    ASSERT_EQ(read->recording.dq.cols(), 7) << form;
    EXPECT_NEAR(read->recording.dq(50, 2), 0.6 * std::cos(1.5 + 2), 1e-6) << form;
  }
}

TEST_F(TextColumns, ListsInCellsAsPandasWritesThem) {
  for (const bool tuple : {false, true}) {
    std::string text = "time,name,position" + kSixNames;
    for (int k = 0; k < kTextRows; ++k) {
      const double t = 0.01 * k;
      std::string names, values;
      for (int j = 0; j < 7; ++j) {
        names += fmt::format("{}'{}'", j > 0 ? ", " : "", panda(inPlace(k, j)));
        values += fmt::format("{}{:.9f}", j > 0 ? ", " : "", jointAt(t, inPlace(k, j)));
      }
      text += tuple ? fmt::format("{:.2f},\"({})\",\"({})\"", t, names, values)
                    : fmt::format("{:.2f},\"[{}]\",\"[{}]\"", t, names, values);
      text += wrenchCells(t) + "\n";
    }
    const auto read = openRecording(write("lists.csv", text));
    ASSERT_TRUE(read.ok()) << read.error().message;
    expectFormula(read->recording);
  }
}

TEST_F(TextColumns, ListsWithBlanksBetweenTabs) {
  std::string text = "index\tt_sec\tjoint_positions\tft\n";
  for (int k = 0; k < kTextRows; ++k) {
    const double t = 0.01 * k;
    std::string joints, wrench;
    for (int j = 0; j < 7; ++j) joints += fmt::format("{}{:.9f}", j > 0 ? " " : "", jointAt(t, j));
    for (int a = 0; a < 6; ++a) wrench += fmt::format("{}{:.9f}", a > 0 ? " " : "", wrenchAt(t, a));
    text += fmt::format("{}\t{:.2f}\t[{}]\t[{}]\n", k, t, joints, wrench);
  }
  const auto read = openRecording(write("lists.tsv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
}

TEST_F(TextColumns, GermanNamesAndDecimalCommas) {
  std::string text = "Zeit [ms]";
  for (int j = 1; j <= 7; ++j) text += fmt::format(";Achse {} [Grad]", j);
  text += ";Fx [N];Fy [N];Fz [N];Mx [Nmm];My [Nmm];Mz [Nmm]\n";
  for (int k = 0; k < kTextRows; ++k) {
    const double t = 0.01 * k;
    std::string row = fmt::format("{:.2f}", 1000.0 * t);
    for (int j = 0; j < 7; ++j) row += fmt::format(";{:.8f}", jointAt(t, j) * 180.0 / 3.14159265358979323846);
    for (int a = 0; a < 6; ++a) row += fmt::format(";{:.6f}", wrenchAt(t, a) * (a < 3 ? 1.0 : 1000.0));
    std::replace(row.begin(), row.end(), '.', ',');
    text += row + "\n";
  }
  const auto read = openRecording(write("robot.csv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
}

TEST_F(TextColumns, OneJointARow) {
  std::string text = "timestamp,joint_name,position_deg\n";
  std::string wrench = "timestamp" + kSixNames;
  for (int k = 0; k < kTextRows; ++k) {
    const double t = 0.01 * k;
    for (int j = 0; j < 7; ++j)
      text += fmt::format("{:.2f},{},{:.9f}\n", kEchoStart + t, panda(inPlace(k, j)),
                          jointAt(t, inPlace(k, j)) * 180.0 / 3.14159265358979323846);
    wrench += fmt::format("{:.2f}", kEchoStart + t) + wrenchCells(t) + "\n";
  }
  ImportOptions options;
  options.join = {write("ft.csv", wrench)};
  const auto read = openRecording(write("joints.csv", text), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
}

TEST_F(TextColumns, EchoOfRos2IsKnownByItsTexts) {
  std::string joints, wrench;
  for (int k = 0; k < kTextRows; ++k) {
    const double t = 0.01 * k;
    const auto stamp = fmt::format("{:.0f},{}", kEchoStart, 10000000 * k);
    joints += stamp + ",";
    for (int j = 0; j < 7; ++j) joints += "," + panda(inPlace(k, j));
    for (int j = 0; j < 7; ++j) joints += fmt::format(",{:.9f}", jointAt(t, inPlace(k, j)));
    joints += "\n";
    wrench += stamp + ",ft_frame" + wrenchCells(t) + "\n";
  }
  ImportOptions options;
  options.join = {write("wrench.csv", wrench)};
  const auto read = openRecording(write("joints.csv", joints), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_THAT(allTexts(read->findings), HasSubstr("looks like data"));
  expectFormula(read->recording);
}

/// Poses of tool0 (turning about z by 0.5 sin t) and of a camera that stands still, alternating; every tenth row of no
/// frame.
std::string transforms() {
  std::string text =
      "time,header.frame_id,child_frame_id,transform.translation.x,transform.translation.y,transform.translation.z,"
      "transform.rotation.x,transform.rotation.y,transform.rotation.z,transform.rotation.w\n";
  for (int k = 0; k < kTextRows; ++k) {
    const double t = 0.01 * k;
    const double half = 0.25 * std::sin(t);
    text += fmt::format("{:.2f},base,camera_link,1,2,3,0,0,0,1\n", t);
    text += fmt::format("{:.2f},base,tool0,0.1,0.2,{:.9f},0,0,{:.9f},{:.9f}\n", t, t, std::sin(half), std::cos(half));
    if (k % 10 == 0) text += fmt::format("{:.2f},base,,7,7,7,1,0,0,0\n", t);
  }
  return text;
}

std::string plainWrench() {
  std::string text = "time" + kSixNames;
  for (int k = 0; k < kTextRows; ++k) text += fmt::format("{:.2f}", 0.01 * k) + wrenchCells(0.01 * k) + "\n";
  return text;
}

TEST_F(TextColumns, ChildFramesAreToldApartAndChosen) {
  const auto poses = write("tf.csv", transforms());
  ImportOptions options;
  options.join = {write("ft.csv", plainWrench())};
  options.wishes = MappingWishes{};
  options.wishes->offset["ft.csv"] = 0.0;
  const auto read = openRecording(poses, options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_THAT(allTexts(read->findings), HasSubstr("camera_link, tool0"));
  EXPECT_THAT(allTexts(read->findings), HasSubstr("10 rows have no child_frame_id"));
  const auto& recording = read->recording;
  ASSERT_EQ(recording.position.rows(), recording.rows());
  for (Eigen::Index k = 0; k < recording.rows(); ++k)
    ASSERT_NEAR(recording.position(k, 2), recording.time(k), 1e-6) << "the tool is taken, not the camera";

  options.use = {"quaternion=camera_link"};
  const auto camera = openRecording(poses, options);
  ASSERT_TRUE(camera.ok()) << camera.error().message;
  EXPECT_NEAR(camera->recording.position(5, 2), 3.0, 1e-9);

  const auto contents = inspectRecording(poses, {});
  ASSERT_TRUE(contents.ok());
  std::string names;
  for (const auto& stream : contents->streams) names += stream.name + " ";
  EXPECT_THAT(names, HasSubstr("camera_link"));
  EXPECT_THAT(names, HasSubstr("tool0"));
}

TEST_F(TextColumns, AChildFrameThatIsEmptyThroughoutSaysNothing) {
  std::string text = "time,child_frame_id,px,py,pz,qx,qy,qz,qw" + kSixNames;
  for (int k = 0; k < kTextRows; ++k)
    text += fmt::format("{:.2f},,0.1,0.2,{:.9f},0,0,0,1", 0.01 * k, 0.01 * k) + wrenchCells(0.01 * k) + "\n";
  const auto read = openRecording(write("empty.csv", text));
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_EQ(read->recording.rows(), kTextRows);
}

TEST_F(TextColumns, TwoSensorsInOneTableByTheirFrames) {
  std::string text = "time,q1,q2,q3,q4,q5,q6,q7\n", wrench = "time,frame_id" + kSixNames;
  for (int k = 0; k < kTextRows; ++k) {
    const double t = 0.01 * k;
    text += fmt::format("{:.2f}", t);
    for (int j = 0; j < 7; ++j) text += fmt::format(",{:.9f}", jointAt(t, j));
    text += "\n";
    wrench += fmt::format("{:.2f},left_ft,0,0,0,0,0,0\n{:.2f},right_ft", t, t) + wrenchCells(t) + "\n";
  }
  ImportOptions options;
  options.wishes = MappingWishes{};
  options.wishes->offset["ft.csv"] = 0.0;
  options.join = {write("ft.csv", wrench)};
  options.use = {"wrench=right_ft"};
  const auto read = openRecording(write("q.csv", text), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  expectFormula(read->recording);
}

}  // namespace
}  // namespace heft
