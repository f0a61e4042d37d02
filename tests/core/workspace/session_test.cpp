#include "core/workspace/session.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"

namespace heft {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class SessionTest : public testing::Test {
 protected:
  SessionTest() : folder(fs::temp_directory_path() / ("heft_session_" + std::to_string(::getpid()))) {
    fs::create_directories(folder / "data");
  }
  ~SessionTest() override { fs::remove_all(folder); }

  Session example() const {
    Session session;
    session.recordings.push_back(
        {folder / "data" / "a.csv", {{1.5, 2.5, MarkLabel::contact}}, R"({"schema":"x"})", "", {}});
    session.recordings.push_back({folder / "b.csv", {}, "", "", {}});
    session.recordings.back().corrections = {{"cable_pull", "contact"}, R"({"schema":"heft.diagnose/1"})"};
    session.recordings[0].name = "first try";
    session.joined = true;
    session.active = 1;
    session.shape.answer = ShapeChoice::Answer::given;
    session.shape.picture = "gripper";
    ShapeBody body;
    body.dims = {0.074, 0.12, 0.064};
    body.X_SB.translation() = Vector3d(0, 0, 0.032);
    session.shape.shape.bodies = {body};
    session.shape.shape.certainty = Certainty::good;
    session.shape.shape.totalMass = 0.815;
    session.settings.method = Method::wls;
    session.settings.trim = 0.05;
    session.settings.known.mass = 0.815;
    session.exporting.format = "ur";
    session.exporting.role = ExportChoice::Role::extraLoad;
    Payload sensor;
    sensor.mass = 0.26;
    sensor.inertiaCom = Vector3d(1e-4, 1e-4, 1e-4).asDiagonal();
    session.exporting.mounted = {{"Sensor body", sensor, true}};
    session.controller.told = {0.5, Vector3d(0.0, 0.0, 0.04), {}};
    session.controller.source = "tool.json";
    session.controller.collisionForce = 25.0;
    session.room = folder / "rooms" / "cell.json";
    session.proof = R"({"schema":"heft.prove/1"})";
    session.step = "mark";
    return session;
  }
  fs::path folder;
};

TEST_F(SessionTest, ComesBackAsItWasSaved) {
  const Session before = example();
  const fs::path file = folder / "work.heft";
  ASSERT_TRUE(writeSession(before, file).ok());
  const auto after = readSession(file);
  ASSERT_TRUE(after.ok()) << after.error().message;
  ASSERT_EQ(after->recordings.size(), 2u);
  EXPECT_EQ(after->recordings[0].name, "first try");
  EXPECT_TRUE(after->recordings[1].name.empty());
  EXPECT_TRUE(after->joined);
  EXPECT_EQ(after->recordings[0].file, before.recordings[0].file);
  ASSERT_EQ(after->recordings[0].marks.size(), 1u);
  EXPECT_EQ(after->recordings[0].marks[0].label, MarkLabel::contact);
  EXPECT_EQ(after->recordings[0].result, before.recordings[0].result);
  EXPECT_TRUE(after->recordings[0].corrections.causes.empty());
  EXPECT_EQ(after->recordings[1].corrections, before.recordings[1].corrections);
  EXPECT_EQ(after->active, 1);
  EXPECT_EQ(after->shape.picture, "gripper");
  ASSERT_EQ(after->shape.shape.bodies.size(), 1u);
  EXPECT_EQ(after->shape.shape.bodies[0].dims, before.shape.shape.bodies[0].dims);
  EXPECT_EQ(after->shape.shape.totalMass, before.shape.shape.totalMass);
  EXPECT_EQ(after->settings.method, Method::wls);
  EXPECT_EQ(after->settings.trim, 0.05);
  EXPECT_EQ(after->settings.known.mass, 0.815);
  EXPECT_FALSE(after->settings.known.com);
  EXPECT_EQ(after->exporting.format, "ur");
  EXPECT_EQ(after->exporting.role, ExportChoice::Role::extraLoad);
  ASSERT_EQ(after->exporting.mounted.size(), 1u);
  EXPECT_TRUE(after->exporting.mounted[0].present);
  EXPECT_EQ(after->controller.told.mass, 0.5);
  EXPECT_EQ(after->controller.told.com, before.controller.told.com);
  EXPECT_FALSE(after->controller.told.inertiaCom);
  EXPECT_EQ(after->controller.source, "tool.json");
  EXPECT_EQ(after->controller.collisionForce, 25.0);
  EXPECT_EQ(after->controller.stiffness, ControllerChoice().stiffness);
  EXPECT_EQ(after->room, before.room);
  EXPECT_EQ(after->proof, before.proof);
  EXPECT_EQ(after->step, "mark");
  EXPECT_EQ(after->home, file);
  EXPECT_EQ(sessionText(*after, folder), sessionText(before, folder));
}

TEST_F(SessionTest, PathsAreRelativeSoThatAFolderCanBeMoved) {
  std::ofstream(folder / "data" / "a.csv") << "x";
  ASSERT_TRUE(writeSession(example(), folder / "work.heft").ok());
  EXPECT_NE(readTextFile(folder / "work.heft")->find("\"file\": \"data/a.csv\""), std::string::npos);
  const fs::path moved = folder.string() + "_moved";
  fs::rename(folder, moved);
  const auto session = readSession(moved / "work.heft");
  EXPECT_EQ(session->recordings[0].file, moved / "data" / "a.csv");
  fs::rename(moved, folder);
  // The session alone was moved: the absolute path still leads to the recording.
  fs::create_directories(folder / "elsewhere");
  fs::rename(folder / "work.heft", folder / "elsewhere" / "work.heft");
  EXPECT_EQ(readSession(folder / "elsewhere" / "work.heft")->recordings[0].file, folder / "data" / "a.csv");
}

TEST_F(SessionTest, KeysOfANewerVersionAreKept) {
  json file = json::parse(sessionText(example(), folder));
  file["later"] = {{"a", 1}};
  file["shape"]["colour"] = "red";
  file["recordings"][0]["note"] = "first";
  file["view"]["camera"] = {1, 2, 3};
  auto session = parseSession(file.dump(), "s.heft", folder);
  ASSERT_TRUE(session.ok());
  session->shape.answer = ShapeChoice::Answer::unknown;
  session->recordings[0].marks.clear();
  const json again = json::parse(sessionText(*session, folder));
  EXPECT_EQ(again["later"]["a"], 1);
  EXPECT_EQ(again["shape"]["colour"], "red");
  EXPECT_EQ(again["shape"]["answer"], "unknown");
  EXPECT_EQ(again["recordings"][0]["note"], "first");
  EXPECT_TRUE(again["recordings"][0]["marks"].empty());
  EXPECT_EQ(again["view"]["camera"].size(), 3u);
}

TEST_F(SessionTest, ANewerFormatIsRefusedPolitely) {
  json file = json::parse(sessionText(example(), folder));
  file["schema"] = "heft.session/2";
  file["recordings"] = "something else";
  const auto session = parseSession(file.dump(), "s.heft", folder);
  ASSERT_FALSE(session.ok());
  EXPECT_NE(session.error().message.find("newer Heft"), std::string::npos) << session.error().message;
  EXPECT_NE(session.error().message.find("not changed"), std::string::npos);
}

TEST_F(SessionTest, DamagedFilesGiveOneSentence) {
  for (const char* text :
       {"", "{", "[]", "3", "{\"schema\": 7}", R"({"schema":"heft.estimate/1"})", R"({"schema":"heft.session/x"})",
        R"({"schema":"heft.session/"})", R"({"schema":"heft.session/1","recordings":{}})",
        R"({"schema":"heft.session/1","recordings":[3]})",
        R"({"schema":"heft.session/1","recordings":[{"file":"a.csv","marks":[{"from_s":2,"to_s":1,"label":"free"}]}]})",
        R"({"schema":"heft.session/1","shape":{"answer":"given","shape":{"bodies":[{"kind":"egg"}]}}})",
        R"({"schema":"heft.session/1","settings":{"trim":7}})",
        R"({"schema":"heft.session/1","controller":{"stiffness_n_m":0}})",
        R"({"schema":"heft.session/1","controller":{"payload":{"mass_kg":-1}}})",
        R"({"schema":"heft.session/1","export":{"mounted":[{"name":"x"}]}})"}) {
    const auto session = parseSession(text, "s.heft", folder);
    ASSERT_FALSE(session.ok()) << text;
    EXPECT_NE(session.error().message.find("s.heft"), std::string::npos) << session.error().message;
    EXPECT_EQ(session.error().message.find('\n'), std::string::npos);
  }
  EXPECT_TRUE(parseSession(R"({"schema":"heft.session/1"})", "s.heft", folder).ok());
}

TEST_F(SessionTest, MutatedFilesNeverCrash) {
  const std::string good = sessionText(example(), folder);
  unsigned state = 12345;
  const auto next = [&] { return state = state * 1664525u + 1013904223u; };
  for (int trial = 0; trial < 3000; ++trial) {
    std::string text = good;
    for (int k = 0; k < 3; ++k) text[next() % text.size()] = static_cast<char>(next() % 256);
    const auto session = parseSession(text, "s.heft", folder);
    if (session) sessionText(*session, folder);
  }
}

TEST_F(SessionTest, OptionsTakeTheShapeOnlyWhereOneWasGiven) {
  Session session = example();
  EXPECT_TRUE(estimateOptions(session).shape);
  EXPECT_EQ(estimateOptions(session).method, Method::wls);
  session.shape.answer = ShapeChoice::Answer::unknown;
  EXPECT_FALSE(estimateOptions(session).shape);
}

}  // namespace
}  // namespace heft
