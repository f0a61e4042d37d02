// Devices and bridges in the real window: chosen and typed in as a user does, seen, lost, found again, and kept on
// disk.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QDir>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <atomic>
#include <cstring>
#include <thread>

#include <fmt/format.h>

#include "core/live/network.h"
#include "core/simulation/virtual_rig.h"
#include "tests/gl/window_fixture.h"
#include "tests/support/live_servers.h"
#include "ui/live/live_run.h"
#include "ui/record_panel/record_panel.h"
#include "ui/widgets/message_bar.h"
#include "ui/wrench_plots/recording_pane.h"
#include "ui/wrench_plots/wrench_plots.h"

namespace heft {
namespace {

using namespace testing_support;

constexpr int kPatience = 120000;  ///< [ms] A bound against hanging only.
constexpr std::uint64_t kTool = 5;

/// A robot that somebody guides: hands its samples over at about 200 a second until it is destroyed.
class GuidedRobot {
 public:
  using Send = std::function<void(const VirtualSample&)>;
  explicit GuidedRobot(Send send)
      : thread_([this, act = std::move(send)](const std::stop_token& stopping) {
          VirtualRigOptions options;
          options.payload = practiceTool(kTool);
          options.rateHz = 200.0;
          auto rig = VirtualRig::create(RobotModel::panda(), options).value();
          rig.arm().wander();
          while (!stopping.stop_requested()) {
            const VirtualSample& sample = rig.next();
            if (!silent_) act(sample);
            std::this_thread::sleep_for(std::chrono::milliseconds(5));
          }
        }) {}
  /// The cable is pulled, or put in again.
  void setSilent(bool silent) { silent_ = silent; }

 private:
  std::atomic<bool> silent_ = false;
  std::jthread thread_;
};

std::string numbers(const VectorXd& values) {
  std::string out;
  for (const double value : values) out += fmt::format("{}{:.9f}", out.empty() ? "" : ",", value);
  return out;
}

std::string stampOf(double time, const char* fraction) {
  const auto seconds = static_cast<std::int64_t>(time);
  return fmt::format(R"("stamp":{{"sec":{},"{}":{}}})", 100 + seconds, fraction,
                     static_cast<std::int64_t>((time - static_cast<double>(seconds)) * 1e9));
}

std::string jointState(const VirtualSample& s) {
  return fmt::format(
      R"({{"header":{{{}}},"name":["panda_joint1","panda_joint2","panda_joint3","panda_joint4","panda_joint5","panda_joint6",)"
      R"("panda_joint7"],"position":[{}],"velocity":[{}],"effort":[]}})",
      stampOf(s.time, "nanosec"), numbers(s.q), numbers(s.dq));
}

std::string wrenchStamped(const VirtualSample& s) {
  return fmt::format(
      R"({{"header":{{{}}},"wrench":{{"force":{{"x":{},"y":{},"z":{}}},"torque":{{"x":{},"y":{},"z":{}}}}}}})",
      stampOf(s.time, "nanosec"), s.wrench(0), s.wrench(1), s.wrench(2), s.wrench(3), s.wrench(4), s.wrench(5));
}

std::string published(const char* topic, const std::string& message) {
  return fmt::format(R"({{"op":"publish","topic":"{}","msg":{}}})", topic, message);
}

std::string datagram(const VirtualSample& s, bool wrench) {
  std::string out = fmt::format(R"({{"time":{:.6f})", s.time);
  for (int j = 0; j < 7; ++j) out += fmt::format(R"(,"q{}":{:.9f},"dq{}":{:.9f})", j + 1, s.q(j), j + 1, s.dq(j));
  const char* const names[] = {"fx", "fy", "fz", "tx", "ty", "tz"};
  for (int a = 0; wrench && a < 6; ++a) out += fmt::format(R"(,"{}":{:.9f})", names[a], s.wrench(a));
  return out + "}";
}

std::string foxgloveData(std::uint32_t subscription, const std::string& message) {
  std::string out(13, '\0');
  const std::uint64_t logged = 1;
  out[0] = 1;
  std::memcpy(out.data() + 1, &subscription, 4);
  std::memcpy(out.data() + 5, &logged, 8);
  return out + message;
}

const char* const kChannels =
    R"({"op":"advertise","channels":[)"
    R"({"id":4,"topic":"/franka/ft","encoding":"json","schemaName":"geometry_msgs/msg/WrenchStamped","schema":"{}","schemaEncoding":"jsonschema"},)"
    R"({"id":7,"topic":"/joint_states","encoding":"json","schemaName":"sensor_msgs/msg/JointState","schema":"{}","schemaEncoding":"jsonschema"}]})";

const char* const kTopics =
    R"({"op":"service_response","service":"/rosapi/topics","result":true,"values":{"topics":["/ft","/joint_states"],)"
    R"("types":["geometry_msgs/WrenchStamped","sensor_msgs/JointState"]}})";

class SourcesTest : public RealWindowTest {
 protected:
  SourcesTest() : RealWindowTest("sources") { panel = dynamic_cast<RecordPanel*>(window.panel(Step::record)); }
  ~SourcesTest() override { panel->run()->stop(); }

  static bool soon(const std::function<bool()>& done) { return QTest::qWaitFor(done, kPatience); }
  void click(const char* name) {
    QAbstractButton* button = nullptr;
    ASSERT_TRUE(soon([&] {
      for (auto* each : panel->findChildren<QAbstractButton*>(name))
        if (each->isVisible() && each->isEnabled()) button = each;
      return button != nullptr;
    })) << name;
    QTest::qWait(50);  // What was just made gets its place.
    QTest::mouseClick(button, Qt::LeftButton);
  }
  void type(const char* name, const QString& text) {
    QLineEdit* field = nullptr;
    ASSERT_TRUE(soon([&] {
      for (auto* each : panel->findChildren<QLineEdit*>(name))
        if (each->isVisible()) field = each;
      return field != nullptr;
    })) << name;
    QTest::qWait(50);
    QTest::mouseClick(field, Qt::LeftButton);
    QTest::keyClick(field, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(field, text);
    ASSERT_EQ(field->text(), text);
  }
  void connectTo(const char* card, const QString& address) {
    click("wayLive");
    click(card);
    type("sourceAddress", address);
    if (QString(card) != "sourceReplay") click("mountAtFlange");  // Asked, not assumed
    click("mainButton");
    ASSERT_TRUE(panel->run()->running()) << window.messageBar()->text().toStdString();
  }
  /// What a user can read on the panel.
  QString words() const {
    QStringList out;
    for (const auto* label : panel->findChildren<QLabel*>())
      if (label->isVisible()) out << label->text();
    return out.join('\n');
  }
  bool reads(const char* text) const { return words().contains(QLatin1String(text)); }
  std::uint64_t rows() const { return panel->run()->status().recorded; }
  void seeData() {
    ASSERT_TRUE(soon([&] { return panel->run()->view().any && rows() > 300; })) << words().toStdString();
    auto* plots = window.findChild<RecordingPane*>("livePlots");
    ASSERT_TRUE(plots && plots->isVisible());
    EXPECT_TRUE(soon([&] { return plots->plots()->pointsDrawn() > 100; }));
    EXPECT_TRUE(soon([&] { return reads(": connected"); })) << words().toStdString();
    EXPECT_FALSE(reads("Connection lost."));
    ASSERT_TRUE(panel->run()->view().q);
    EXPECT_TRUE(soon([&] {
      return (window.robotView()->sensorPose().translation() - panel->run()->view().X_BS.translation()).norm() < 0.2 &&
             window.robotView()->sensorPose().translation().norm() > 0.2;
    })) << "the arm in the picture stands as the robot does";
  }
  void seeLoss() {
    EXPECT_TRUE(soon([&] { return reads("Connection lost. Reconnecting"); })) << words().toStdString();
    EXPECT_TRUE(reads("Data received so far is kept."));
    EXPECT_TRUE(soon([&] { return reads("connection lost 1 time"); })) << words().toStdString();
  }
  void seeReturn(std::uint64_t before) {
    EXPECT_TRUE(soon([&] { return rows() > before + 200; })) << words().toStdString();
    EXPECT_TRUE(soon([&] { return !reads("Connection lost."); })) << words().toStdString();
    EXPECT_TRUE(panel->run()->running());
  }
  /// Stops by the button; what is on disk is what was opened, and of the tool that was sent.
  void keep() {
    const QString file = panel->run()->file();
    EXPECT_TRUE(file.startsWith(folder.path()));
    click("mainButton");
    ASSERT_TRUE(soon([&] { return workspace.opened() && window.settled(); }));
    const auto read = readRecording(file.toStdString());
    ASSERT_TRUE(read.ok()) << read.error().message;
    const Recording& recording = read->recording;
    EXPECT_GT(recording.rows(), 500);
    EXPECT_EQ(workspace.opened()->recording.rows(), recording.rows());
    EXPECT_TRUE((recording.time.tail(recording.rows() - 1) - recording.time.head(recording.rows() - 1)).minCoeff() > 0);
    EXPECT_EQ(recording.q.cols(), 7);
    // The tool hangs at the sensor: without its bias, of a few newtons, no force is far over its weight.
    EXPECT_LT(recording.wrench.leftCols<3>().cwiseAbs().maxCoeff(), 4.0 * 9.81 * practiceTool(kTool).mass + 12.0);
    EXPECT_GT(recording.wrench.leftCols<3>().cwiseAbs().maxCoeff(), 1.0);
  }

  RecordPanel* panel = nullptr;
};

TEST_F(SourcesTest, AProgramThatSendsDatagrams) {
  // A port that was free a moment ago: two sockets cannot have it.
  const std::uint16_t port = UdpSocket::listening("127.0.0.1", 0)->port();
  connectTo("sourceUdp", QString::number(port));
  auto socket = UdpSocket::connected("127.0.0.1", port);
  ASSERT_TRUE(socket.ok());
  EXPECT_TRUE(soon([&] { return reads("Nothing arrives at 127.0.0.1"); })) << words().toStdString();
  EXPECT_FALSE(panel->findChild<QPushButton*>("mainButton")->isEnabled()) << "there is nothing to keep";
  GuidedRobot robot([&](const VirtualSample& s) { socket->send(datagram(s, true)); });
  seeData();
  robot.setSilent(true);
  seeLoss();
  const auto before = rows();
  robot.setSilent(false);
  seeReturn(before);
  keep();
}

TEST_F(SourcesTest, AFoxgloveBridgeThatBreaksAndComesBack) {
  std::atomic<bool> subscribed = false;
  FakeBridge bridge(
      "foxglove.sdk.v1", [](FakeBridge& self) { self.sendText(kChannels); },
      [&](FakeBridge&, const std::string& text) { subscribed = text.find("subscribe") != std::string::npos; });
  connectTo("sourceFoxglove", QStringLiteral("127.0.0.1:%1").arg(bridge.port()));
  GuidedRobot robot([&](const VirtualSample& s) {
    if (!subscribed) return;
    bridge.sendBinary(foxgloveData(1, wrenchStamped(s)));
    bridge.sendBinary(foxgloveData(2, jointState(s)));
  });
  seeData();
  EXPECT_EQ(panel->run()->status().sources.front().topics, (std::vector<std::string>{"/franka/ft", "/joint_states"}));
  const auto before = rows();
  subscribed = false;
  bridge.drop();
  EXPECT_TRUE(soon([&] { return bridge.connections() == 2; }));
  EXPECT_TRUE(soon([&] { return reads("connection lost 1 time"); })) << words().toStdString();
  seeReturn(before);
  keep();
}

TEST_F(SourcesTest, RosbridgeThatGoesAwayForGoodIsSaidAndWhatCameIsKept) {
  auto bridge = std::make_unique<FakeBridge>("", nullptr, [](FakeBridge& self, const std::string& text) {
    if (text.find("/rosapi/topics") != std::string::npos) self.sendText(kTopics);
  });
  connectTo("sourceRosbridge", QStringLiteral("127.0.0.1:%1").arg(bridge->port()));
  {
    GuidedRobot robot([&](const VirtualSample& s) {
      bridge->sendText(published("/ft", wrenchStamped(s)));
      bridge->sendText(published("/joint_states", jointState(s)));
    });
    seeData();
    ASSERT_TRUE(soon([&] { return rows() > 600; }));
  }
  bridge.reset();
  seeLoss();
  keep();
}

TEST_F(SourcesTest, ANetFtSensorWithTheJointsFromElsewhere) {
  FakeNetFt sensor;
  FakeBridge bridge("", nullptr, [](FakeBridge& self, const std::string& text) {
    if (text.find("/rosapi/topics") != std::string::npos) self.sendText(kTopics);
  });
  click("wayLive");
  click("sourceNetFt");
  type("sourceAddress", QStringLiteral("127.0.0.1:%1?cpf=1000000&cpt=1000000").arg(sensor.port()));
  for (auto* button : panel->findChildren<QPushButton*>())
    if (button->isVisible() && button->text() == "rosbridge") QTest::mouseClick(button, Qt::LeftButton);
  type("jointsAddress", QStringLiteral("127.0.0.1:%1").arg(bridge.port()));
  click("mountAtFlange");
  click("mainButton");
  ASSERT_TRUE(panel->run()->running()) << window.messageBar()->text().toStdString();
  std::atomic<std::uint32_t> number = 0;
  GuidedRobot robot([&](const VirtualSample& s) {
    std::vector<std::int32_t> counts;
    for (const double value : s.wrench) counts.push_back(static_cast<std::int32_t>(1e6 * value));
    sensor.send(rdtRecord(++number, 0, counts));
    bridge.sendText(published("/joint_states", jointState(s)));
  });
  seeData();
  EXPECT_EQ(panel->run()->status().sources.size(), 2u);
  robot.setSilent(true);
  seeLoss();
  const auto before = rows();
  robot.setSilent(false);
  seeReturn(before);
  keep();
  // It was asked for its stream and its end, and nothing else.
  EXPECT_TRUE(eventually([&] { return sensor.requests().back() == std::string("\x12\x34\0\0\0\0\0\0", 8); }));
  for (const auto& request : sensor.requests()) EXPECT_TRUE(request[3] == 0 || request[3] == 2);
}

TEST_F(SourcesTest, ARecordingIsPlayedToItsEnd) {
  Payload payload = practiceTool(kTool);
  SimulateOptions options;
  options.duration = 3.0;
  const auto simulated = simulate(RobotModel::panda(), payload, options);
  ASSERT_TRUE(simulated.ok());
  const QString file = folder.filePath("played.csv");
  ASSERT_TRUE(writeRecording(simulated->recording, file.toStdString()).ok());
  connectTo("sourceReplay", file);
  EXPECT_TRUE(soon([&] { return reads("replay finished"); })) << words().toStdString();
  EXPECT_EQ(rows(), 3000u);
  const QString kept = panel->run()->file();
  click("mainButton");
  ASSERT_TRUE(soon([&] { return workspace.opened() && window.settled(); }));
  const auto read = readRecording(kept.toStdString());
  ASSERT_TRUE(read.ok());
  EXPECT_LT((read->recording.q - simulated->recording.q).cwiseAbs().maxCoeff(), 1e-12);
}

TEST_F(SourcesTest, WhatCannotBeReadOrReachedIsSaidInAPlainSentence) {
  const QString broken = folder.filePath("broken.csv");
  QFile file(broken);
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("this is no recording\n1\n");
  file.close();
  click("wayLive");
  click("sourceReplay");
  type("sourceAddress", broken);
  click("mainButton");
  EXPECT_TRUE(soon([&] { return !panel->run()->running(); }));
  EXPECT_TRUE(window.messageBar()->text().contains("broken.csv")) << window.messageBar()->text().toStdString();
  EXPECT_TRUE(QDir(folder.filePath("heft/recordings")).isEmpty()) << "nothing came, nothing is left";
  // Back at the form; nobody listens at this port.
  std::uint16_t port = 0;
  { port = FakeWebPage("").port(); }
  connectTo("sourceRosbridge", QStringLiteral("127.0.0.1:%1").arg(port));
  EXPECT_TRUE(soon([&] { return reads("No response yet. Still trying"); })) << words().toStdString();
  EXPECT_FALSE(panel->findChild<QPushButton*>("mainButton")->isEnabled());
}

}  // namespace
}  // namespace heft
