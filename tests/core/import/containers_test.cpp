// Bags, MCAP and HDF5 made by other programs: the numbers that come out are those that went in.
#include "tests/core/import/fixtures.h"

namespace heft {
namespace {

using namespace testing_support;

struct Container {
  const char* file;
  FileKind kind;
};

class Containers : public ::testing::TestWithParam<Container> {};

TEST_P(Containers, GiveWhatWasRecorded) {
  const auto path = fixture(GetParam().file);
  const auto kind = recognise(path);
  ASSERT_TRUE(kind.ok()) << kind.error().message;
  EXPECT_EQ(*kind, GetParam().kind);
  const auto read = openRecording(path);
  ASSERT_TRUE(read.ok()) << read.error().message;
  const auto& recording = read->recording;
  EXPECT_EQ(recording.rows(), 100) << allTexts(read->findings);  // the joints' times: they are the slower ones
  EXPECT_NEAR(recording.rateHz(), 100.0, 0.1);
  EXPECT_NEAR(recording.time(0), 0.0, 1e-9);
  expectFormula(recording);
  EXPECT_TRUE(hasCode(read->findings, "streams_joined")) << allTexts(read->findings);
  EXPECT_TRUE(hasCode(read->findings, "sources"));
  EXPECT_FALSE(hasErrors(read->findings));
}

INSTANTIATE_TEST_SUITE_P(Fixtures, Containers,
                         ::testing::Values(Container{"ros1_none.bag", FileKind::rosBag},
                                           Container{"ros1_bz2.bag", FileKind::rosBag},
                                           Container{"ros1_lz4.bag", FileKind::rosBag},
                                           Container{"ros2_bag/ros2_bag_0.db3", FileKind::sqliteBag},
                                           Container{"ros2_compressed.db3.zstd", FileKind::sqliteBag},
                                           Container{"ros2_bag", FileKind::ros2Folder},
                                           Container{"plain.mcap", FileKind::mcap},
                                           Container{"zstd.mcap", FileKind::mcap},
                                           Container{"lz4.mcap", FileKind::mcap}, Container{"log.h5", FileKind::hdf5}),
                         [](const auto& each) {
                           std::string name = each.param.file;
                           for (char& c : name)
                             if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
                           return name;
                         });

TEST(Inspect, NamesTopicsFieldsAndTheGuess) {
  const auto contents = inspectRecording(fixture("ros1_lz4.bag"));
  ASSERT_TRUE(contents.ok()) << contents.error().message;
  EXPECT_TRUE(contents->missing.empty()) << contents->missing;
  ASSERT_EQ(contents->streams.size(), 2u);
  for (const auto& stream : contents->streams) {
    const bool joints = stream.name == "/joint_states";
    EXPECT_EQ(stream.type, joints ? "sensor_msgs/JointState" : "geometry_msgs/WrenchStamped");
    EXPECT_EQ(stream.samples, joints ? 100u : 200u);
    EXPECT_NEAR(stream.rateHz(), joints ? 100.0 : 200.0, 0.5);
    EXPECT_THAT(stream.fields, ::testing::Contains(joints ? "position[panda_joint7]" : "wrench.torque.z"));
  }
  ASSERT_EQ(contents->chosen.size(), 20u);  // 7 joints, 7 velocities, 6 of the wrench
  for (const auto& column : contents->chosen) {
    EXPECT_FALSE(column.why.empty());
    EXPECT_EQ(contents->streams[column.stream].fields[column.field].find("finger"), std::string::npos);
  }
}

TEST(Inspect, OfAListingCostsNoValues) {
  const auto contents = inspectRecording(fixture("plain.mcap"));
  ASSERT_TRUE(contents.ok());
  for (const auto& stream : contents->streams) EXPECT_TRUE(stream.values.empty());
}

TEST(Velocities, AreReadWithTheJoints) {
  const auto read = openRecording(fixture("ros1_none.bag"));
  ASSERT_TRUE(read.ok());
  ASSERT_EQ(read->recording.dq.cols(), 7);
  EXPECT_NEAR(read->recording.dq(10, 3), 0.6 * std::cos(0.3 + 3.0), 1e-9);
}

TEST(Use, OverridesTheGuess) {
  ImportOptions options;
  options.use = {"fx=/ft/wrench:wrench.torque.x", "fy=/ft/wrench:wrench.force.y"};
  const auto read = openRecording(fixture("zstd.mcap"), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_NEAR(read->recording.wrench(50, 0), 0.05, 1e-3);
  EXPECT_NEAR(read->recording.wrench(50, 1), 2.0 * std::cos(2.0), 1e-3);

  options.use = {"wrench=/joint_states"};
  const auto wrong = openRecording(fixture("zstd.mcap"), options);
  ASSERT_FALSE(wrong.ok());
  EXPECT_THAT(wrong.error().message, ::testing::HasSubstr("/joint_states"));
  options.use = {"fq=/joint_states"};
  EXPECT_FALSE(openRecording(fixture("zstd.mcap"), options).ok());
}

using Folders = InFolder;

TEST_F(Folders, SplitBagsAreOneRecording) {
  // The same messages twice, the second half later: two files of one bag.
  const auto bytes = read(fixture("plain.mcap"));
  std::filesystem::create_directories(folder_ / "bag");
  write("bag/a.mcap", bytes);
  write("bag/b.mcap", bytes);
  const auto read = openRecording(folder_ / "bag");
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_TRUE(hasCode(read->findings, "no_metadata"));
  EXPECT_TRUE(hasCode(read->findings, "time_repeated")) << allTexts(read->findings);
  EXPECT_EQ(read->recording.rows(), 100);
  expectFormula(read->recording);
}

TEST_F(Folders, WithoutBagSaySo) {
  const auto read = openRecording(folder_);
  ASSERT_FALSE(read.ok());
  EXPECT_THAT(read.error().message, ::testing::HasSubstr("folder"));
}

TEST_F(Folders, ScalesComeFromTheMapFile) {
  write("map.json", R"({"scale": {"wrench": 0.5, "fz": 2.0}, "clock": "received"})");
  ImportOptions options;
  options.mapFile = folder_ / "map.json";
  const auto read = openRecording(fixture("ros1_bz2.bag"), options);
  ASSERT_TRUE(read.ok()) << read.error().message;
  EXPECT_NEAR(read->recording.wrench(50, 1), std::cos(2.0), 2e-3);
  EXPECT_NEAR(read->recording.wrench(50, 2), -9.0, 3e-3);
  for (const char* const bad : {"[]", R"({"uses": {}})", R"({"scale": {"fx": 0}})", R"({"use": {"fx": 3}})",
                                R"({"join": "x"})", R"({"pose_of": "hand"})", R"({"clock": 1})", "{"}) {
    write("map.json", bad);
    EXPECT_FALSE(openRecording(fixture("ros1_bz2.bag"), options).ok()) << bad;
  }
}

}  // namespace
}  // namespace heft
