// The whole simulator: deterministic, honest about contact, free of the truth, and clear about bad input.
#include "core/simulation/simulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/wrench/regressor.h"
#include "tests/core/simulation/sample.h"

namespace heft {
namespace {

using testing::HasSubstr;

Simulated simulateOrDie(const SimulateOptions& options, const Payload& payload = sampleTool()) {
  auto simulated = simulate(RobotModel::panda(), payload, options);
  if (!simulated) throw std::runtime_error(simulated.error().message);
  return std::move(*simulated);
}

TEST(Simulate, SameSeedSameBytesOtherSeedOtherBytes) {
  for (const MotionKind kind : kKinds) {
    const Simulated a = simulateOrDie(optionsFor(kind, 9, 5.0)), b = simulateOrDie(optionsFor(kind, 9, 5.0)),
                    c = simulateOrDie(optionsFor(kind, 10, 5.0));
    EXPECT_EQ(a.recording.wrench, b.recording.wrench);
    EXPECT_EQ(a.recording.q, b.recording.q);
    EXPECT_EQ(a.recording.dq, b.recording.dq);
    EXPECT_EQ(toJson(a.truth), toJson(b.truth));
    EXPECT_NE(a.recording.wrench, c.recording.wrench);
    EXPECT_GT((a.q - c.q).cwiseAbs().maxCoeff(), 0.05);
  }
}

/// What a seed means is kept, whatever compiler chooses the order in which the arguments of a call are worked out.
TEST(Simulate, ASeedMeansTheSameMotionWithEveryCompiler) {
  const std::array<double, 3> shoulder{-0.444048494, -0.153464243, -0.862721437};  // [rad] at four fifths
  for (std::size_t i = 0; i < shoulder.size(); ++i) {
    const Simulated a = simulateOrDie(optionsFor(kKinds[i], 9, 5.0));
    EXPECT_NEAR(a.q(a.q.rows() * 4 / 5, 1), shoulder[i], 1e-8);
    if (kKinds[i] == MotionKind::pickAndPlace) EXPECT_NEAR(a.contactWrench.cwiseAbs().sum(), 6367.95063, 1e-3);
  }
}

TEST(Simulate, OneOptionDoesNotReshuffleTheOthers) {
  const SimulateOptions plain = optionsFor(MotionKind::pickAndPlace, 4, 8.0);
  SimulateOptions noisy = plain;
  noisy.sensor.colouredForce = 0.0;
  noisy.sensor.forceNoise = 0.2;
  noisy.positionNoise = 0.0;
  const Simulated a = simulateOrDie(plain), b = simulateOrDie(noisy);
  EXPECT_EQ(a.q, b.q);
  EXPECT_EQ(a.truth.forceBias, b.truth.forceBias);
  EXPECT_EQ(a.contactWrench, b.contactWrench);
  EXPECT_EQ(a.recording.wrench.rightCols(3), b.recording.wrench.rightCols(3));
}

TEST(Simulate, PayloadWrenchMatchesTheRegressor) {
  const SimulateOptions options = optionsFor(MotionKind::free, 6, 4.0);
  const Simulated simulated = simulateOrDie(options);
  const RobotModel& robot = RobotModel::panda();
  const int link = robot.findLink("panda_link8").value();
  const Isometry3d X_LS = poseFromXyzRpy(options.mount.xyz, options.mount.rpy);
  const Vector10d phi = toParameters(simulated.truth.payload);
  for (Eigen::Index k = 0; k < simulated.q.rows(); k += 37) {
    const FrameMotion m = robot.frameMotion(link, X_LS, simulated.q.row(k).transpose(), simulated.dq.row(k).transpose(),
                                            simulated.ddq.row(k).transpose());
    const Matrix3d R = m.X_BS.linear();
    const WrenchState state{R.transpose() * (m.a_BSo_B - options.gravity), R.transpose() * m.w_BS_B,
                            R.transpose() * m.alpha_BS_B};
    EXPECT_LT((regressor(state) * phi - simulated.payloadWrench.row(k).transpose()).norm(), 1e-10);
  }
}

TEST(Simulate, AtRestTheSensorCarriesTheWeight) {
  SimulateOptions options = optionsFor(MotionKind::free, 6, 4.0);
  options.gravity = {1.0, 2.0, -9.0};
  options.mount.rpy = {0.4, -0.3, 0.2};
  const Simulated simulated = simulateOrDie(options);
  const RobotModel& robot = RobotModel::panda();
  const Isometry3d X_BL = robot.linkPose(simulated.q.row(0), robot.findLink("panda_link8").value());
  const Matrix3d R_BS = X_BL.linear() * rotationFromRpy(options.mount.rpy);
  const Payload& payload = simulated.truth.payload;
  const Vector3d expected = -payload.mass * (R_BS.transpose() * options.gravity);
  EXPECT_LT((simulated.payloadWrench.row(0).head<3>().transpose() - expected).norm(), 1e-12);
  EXPECT_LT((simulated.payloadWrench.row(0).tail<3>().transpose() - payload.com.cross(expected)).norm(), 1e-12);
}

TEST(Simulate, MarksMatchTheContactWrench) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    const Simulated simulated = simulateOrDie(optionsFor(MotionKind::pickAndPlace, seed));
    const auto& marks = simulated.truth.marks;
    const VectorXd& time = simulated.recording.time;
    int contacts = 0;
    EXPECT_EQ(marks.front().from, 0.0);
    EXPECT_EQ(marks.back().to, time(time.size() - 1));
    for (std::size_t i = 0; i < marks.size(); ++i) {
      EXPECT_LT(marks[i].from, marks[i].to);
      if (i > 0) {
        EXPECT_EQ(marks[i].from, marks[i - 1].to);
        EXPECT_NE(marks[i].label, marks[i - 1].label);
      }
      double peak = 0.0;
      for (Eigen::Index k = 0; k < time.size(); ++k) {
        if (time(k) <= marks[i].from || time(k) >= marks[i].to) continue;
        const double force = simulated.contactWrench.row(k).head<3>().norm();
        if (marks[i].label == MarkLabel::free) {
          EXPECT_EQ(force, 0.0);
        } else {
          EXPECT_GT(force, 0.0);
        }
        // One contact point: force and torque are perpendicular.
        EXPECT_NEAR(simulated.contactWrench.row(k).head<3>().dot(simulated.contactWrench.row(k).tail<3>()), 0.0, 1e-12);
        peak = std::max(peak, force);
      }
      if (marks[i].label == MarkLabel::contact) {
        ++contacts;
        EXPECT_GE(marks[i].to - marks[i].from, 0.3);
        EXPECT_LE(marks[i].to - marks[i].from, 2.0);
        EXPECT_GT(peak, 1.5);
        EXPECT_LT(peak, 12.0);
      }
    }
    EXPECT_GE(contacts, 2);
  }
  for (const MotionKind kind : {MotionKind::excitation, MotionKind::free}) {
    const Simulated simulated = simulateOrDie(optionsFor(kind, 1, 3.0));
    EXPECT_EQ(simulated.contactWrench.cwiseAbs().maxCoeff(), 0.0);
    ASSERT_EQ(simulated.truth.marks.size(), 1u);
    EXPECT_EQ(simulated.truth.marks[0].label, MarkLabel::free);
  }
}

TEST(Simulate, RecordingHidesTheTruth) {
  SimulateOptions options = optionsFor(MotionKind::pickAndPlace, 2);
  options.rateHz = 500.0;
  const Simulated simulated = simulateOrDie(options);
  const Recording& recording = simulated.recording;
  EXPECT_TRUE(recording.meta.marks.empty());
  EXPECT_TRUE(recording.labels.empty());
  EXPECT_TRUE(recording.meta.knownPayload.empty());
  EXPECT_TRUE(recording.meta.note.empty());
  EXPECT_TRUE(recording.extra.empty());
  EXPECT_EQ(recording.rows(), 10000);
  EXPECT_DOUBLE_EQ(recording.time(1), 0.002);
  EXPECT_EQ(recording.meta.robot, "panda");
  EXPECT_EQ(recording.meta.mount.parent, "panda_link8");
  EXPECT_EQ(recording.meta.sensorModel, "Schunk FT Gamma SI-32-2.5");
  EXPECT_EQ(recording.meta.wrenchSign, WrenchSign::sensorOnPayload);
  EXPECT_EQ(recording.meta.gravity, options.gravity);
  EXPECT_FALSE(recording.hasOrientation());
}

TEST(Simulate, TruthReadsBackAsAPayload) {
  const Simulated simulated = simulateOrDie(optionsFor(MotionKind::pickAndPlace, 2, 12.0));
  const nlohmann::json json = nlohmann::json::parse(toJson(simulated.truth).dump());
  EXPECT_EQ(json.at("schema"), "heft.truth/1");
  const auto payload = payloadFromJson(json.at("payload"), "truth");
  ASSERT_TRUE(payload.ok()) << payload.error().message;
  EXPECT_EQ(payload->mass, simulated.truth.payload.mass);
  EXPECT_EQ(payload->com, simulated.truth.payload.com);
  EXPECT_EQ(payload->inertiaCom, simulated.truth.payload.inertiaCom);
  EXPECT_EQ(json.at("marks").size(), simulated.truth.marks.size());
  EXPECT_EQ(json.at("bias").at("force_n").at(1).get<double>(), simulated.truth.forceBias.y());
  EXPECT_EQ(json.at("options").at("seed"), 2);
  EXPECT_EQ(motionKindFromString(json.at("options").at("motion").get<std::string>()), MotionKind::pickAndPlace);
  EXPECT_FALSE(motionKindFromString("dancing"));
}

TEST(Simulate, RefusesNonsenseWithOneClearSentence) {
  const RobotModel& robot = RobotModel::panda();
  auto messageFor = [&](auto change) {
    SimulateOptions options = optionsFor(MotionKind::free, 1, 2.0);
    Payload payload = sampleTool();
    change(options, payload);
    const auto result = simulate(robot, payload, options);
    return result.ok() ? std::string("(no error)") : result.error().message;
  };
  using O = SimulateOptions;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(messageFor([](O& o, Payload&) { o.duration = -1.0; }), HasSubstr("duration of the simulation is -1 s"));
  EXPECT_THAT(messageFor([&](O& o, Payload&) { o.duration = nan; }), HasSubstr("duration"));
  EXPECT_THAT(messageFor([](O& o, Payload&) { o.rateHz = 0.0; }), HasSubstr("rate of the simulation is 0 Hz"));
  EXPECT_THAT(messageFor([](O& o, Payload&) { o.duration = 1e9; }), HasSubstr("change the duration or the rate"));
  EXPECT_THAT(messageFor([](O& o, Payload&) { o.rateHz = 1.0; }), HasSubstr("change the duration or the rate"));
  EXPECT_THAT(messageFor([](O& o, Payload&) { o.speed = 0.0; }), HasSubstr("speed"));
  EXPECT_THAT(messageFor([](O& o, Payload&) { o.sensor.forceNoise = -0.1; }), HasSubstr("force noise"));
  EXPECT_THAT(messageFor([&](O& o, Payload&) { o.sensor.forceRange.z() = nan; }), HasSubstr("force range"));
  EXPECT_THAT(messageFor([&](O& o, Payload&) { o.gravity.x() = nan; }), HasSubstr("gravity"));
  EXPECT_THAT(messageFor([&](O& o, Payload&) { o.mount.rpy.x() = nan; }), HasSubstr("mount"));
  EXPECT_THAT(messageFor([](O& o, Payload&) { o.mount.parent = "tool0"; }), HasSubstr("no link 'tool0'"));
  EXPECT_THAT(messageFor([](O&, Payload& p) { p.mass = -1.0; }), HasSubstr("cannot exist"));
  EXPECT_THAT(messageFor([](O&, Payload& p) { p.inertiaCom(0, 0) = 1.0; }), HasSubstr("cannot exist"));
}

TEST(Simulate, CanBeStoppedAndTellsHowFarItIs) {
  std::stop_source source;
  std::vector<double> fractions;
  Progress progress{source.get_token(), [&](double fraction, std::string_view) {
                      fractions.push_back(fraction);
                      if (fraction > 0.3) source.request_stop();
                    }};
  const auto result = simulate(RobotModel::panda(), sampleTool(), optionsFor(MotionKind::free, 1), progress);
  ASSERT_FALSE(result.ok());
  EXPECT_TRUE(result.error().cancelled);
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
}

constexpr const char* kOddArm = R"(<robot name="odd">
  <link name="base"/><link name="a"/><link name="b"/><link name="tool"/>
  <joint name="turn" type="continuous"><parent link="base"/><child link="a"/><axis xyz="0 0 1"/></joint>
  <joint name="slide" type="prismatic"><parent link="a"/><child link="b"/><origin xyz="0.3 0 0.2"/><axis xyz="1 0 0"/>
    <limit lower="-0.1" upper="0.4" velocity="0.3" effort="10"/></joint>
  <joint name="bend" type="revolute"><parent link="b"/><child link="tool"/><origin xyz="0.2 0 0"/><axis xyz="0 1 0"/>
    <limit lower="-1" upper="1" velocity="1.5" effort="10"/></joint>
</robot>)";

TEST(Simulate, AnySerialArmWithLimitsMissing) {
  Findings findings;
  const auto robot = RobotModel::fromUrdfText(kOddArm, ".", findings);
  ASSERT_TRUE(robot.ok()) << robot.error().message;
  for (const MotionKind kind : kKinds) {
    SCOPED_TRACE(toString(kind));
    SimulateOptions options = optionsFor(kind, 3);
    options.mount.parent = "tool";
    options.robotReference = "odd.urdf";
    const auto simulated = simulate(*robot, sampleTool(), options);
    ASSERT_TRUE(simulated.ok()) << simulated.error().message;
    ASSERT_EQ(simulated->q.cols(), 3);
    EXPECT_TRUE(simulated->recording.wrench.allFinite());
    EXPECT_EQ(simulated->recording.meta.robot, "odd.urdf");
    EXPECT_GE(simulated->q.col(1).minCoeff(), -0.1);
    EXPECT_LE(simulated->q.col(1).maxCoeff(), 0.4);
    EXPECT_LE(simulated->dq.col(0).cwiseAbs().maxCoeff(), 2.0);
    EXPECT_LE(simulated->dq.col(1).cwiseAbs().maxCoeff(), 0.3);
    EXPECT_LE(simulated->ddq.col(1).cwiseAbs().maxCoeff(), 3.0);
    EXPECT_LE(simulated->dq.col(2).cwiseAbs().maxCoeff(), 1.5);
    EXPECT_LE(simulated->ddq.col(2).cwiseAbs().maxCoeff(), 10.0);
    for (int j = 0; j < 3; ++j) EXPECT_GT(simulated->dq.col(j).cwiseAbs().maxCoeff(), 0.02) << "joint " << j;
  }
}

TEST(Simulate, RobotWithoutJointsIsRefused) {
  const auto result = simulate(RobotModel(), sampleTool(), SimulateOptions());
  ASSERT_FALSE(result.ok());
  EXPECT_THAT(result.error().message, HasSubstr("no moving joint"));
}

}  // namespace
}  // namespace heft
