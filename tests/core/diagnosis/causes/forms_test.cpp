// Causes whose form is richer than the plainest one: loops, friction and cables along any axis, and what no motion can
// tell apart.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/model/forward_model.h"
#include "core/diagnosis/search/candidate_fits.h"
#include "core/diagnosis/search/search.h"
#include "core/diagnosis/wording/cable_force.h"
#include "core/wrench/regressor.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
using namespace diagnosis;

namespace {

/// Adds the force of the room (B axes) with which the sensor must hold the tool at a place, moving at a velocity.
template <class Force>
void holdBack(Recording& recording, const Force& force) {
  MotionOptions smoothing;
  smoothing.cutoffHz = 25.0;
  const auto motion = motionOf(recording, &RobotModel::panda(), smoothing).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Vector3d f = force(Vector3d(motion.position.col(k)), Vector3d(motion.velocity.col(k)));
    recording.wrench.row(i).head<3>() += (motion.R_BS[static_cast<std::size_t>(k)].transpose() * f).transpose();
  }
}

/// Adds what the sensor must hold (S axes) against something that acts at the tip (S axes).
void addAtTip(Recording& recording, Eigen::Index row, const Vector3d& force, const Vector3d& tip) {
  recording.wrench.row(row).head<3>() += force.transpose();
  recording.wrench.row(row).tail<3>() += tip.cross(force).transpose();
}

/// A part inside the sensor bends with the load and slips early: a loop of 3 % of each channel's range. It looked like
/// a delay.
TEST(Diagnose, ALoopThatTurnsAtOnceIsHysteresis) {
  constexpr double kHeight = 0.03;
  const Recording recording = withLoop(aRecording(MotionKind::excitation, 261), kHeight);
  const auto report = diagnosed(recording);
  ASSERT_FALSE(report.causes.empty()) << said(report);
  EXPECT_EQ(report.causes.front().id, "hysteresis") << said(report);
  EXPECT_EQ(report.causes.size(), 1u) << said(report);
  const auto& parameters = report.causes.front().parameters;
  const auto loop = findParameter(parameters, "loop");
  ASSERT_NE(loop, nullptr) << said(report);
  EXPECT_NEAR(std::abs(loop->value), 100.0 * kHeight, 0.2) << said(report);
}

/// A good sensor with a heavy tool shows a memory of less than a thousandth of its range; the same recording without it
/// shows none.
TEST(Diagnose, ASmallMemoryThatMuchSpeaksForIsNamed) {
  constexpr double kHeight = 0.0008;
  SimulateOptions options;
  options.motion = MotionKind::excitation;
  options.seed = 261;
  options.duration = 12.0;
  options.sensor.forceNoise = 0.01;
  options.sensor.torqueNoise = 0.0004;
  options.sensor.colouredForce = options.sensor.colouredTorque = 0.0;
  Payload heavy = aTool();
  heavy.mass = 2.0;
  const Recording still = simulate(RobotModel::panda(), heavy, options).value().recording;
  const auto report = diagnosed(withLoop(still, kHeight));
  EXPECT_NE(named(report, "hysteresis"), nullptr) << said(report);
  EXPECT_EQ(named(diagnosed(still), "hysteresis"), nullptr);
}

/// A part is picked up while the tool touches: when within the touch does not show, and what stood at its edge came to
/// rest beside it. It was a zero that jumped and drifted beside a gain.
TEST(Diagnose, APartPickedUpDuringATouchIsOne) {
  SimulateOptions options;
  options.motion = MotionKind::pickAndPlace;
  options.seed = 5;
  options.effects = {{"payload_change", "step", 100.0}};
  Payload tool;
  tool.mass = 0.8;
  tool.com = {0.0084, 0.0021, 0.0531};
  tool.inertiaCom = Vector3d(1.24e-3, 1.32e-3, 0.8e-3).asDiagonal();
  const Recording recording = simulate(RobotModel::panda(), tool, options).value().recording;
  const auto report = diagnosed(recording);
  ASSERT_FALSE(report.causes.empty()) << said(report);
  EXPECT_EQ(report.causes.front().id, "payload_change") << said(report);
  const auto mass = findParameter(report.causes.front().parameters, "mass");
  ASSERT_NE(mass, nullptr) << said(report);
  EXPECT_NEAR(mass->value, 100.0, 4.0) << said(report);
}

/// A rail: along it the tool hardly rubs, across it it does. It was drag beside friction.
TEST(Diagnose, FrictionMayDifferAlongEachAxis) {
  Recording recording = aRecording(MotionKind::excitation, 262);
  const Vector3d friction(0.2, 1.0, 0.4);  // [N]
  holdBack(recording, [&](const Vector3d&, const Vector3d& v) {
    return Vector3d(friction.cwiseProduct(v / std::max(v.norm(), 0.002)));
  });
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "coulomb_friction") << said(report);
  const auto& parameters = report.causes.front().parameters;
  for (int i = 0; i < 3; ++i) {
    const auto size = findParameter(parameters, fmt::format("friction_{}", "xyz"[i]));
    ASSERT_NE(size, nullptr) << said(report);
    EXPECT_NEAR(size->value, friction(i), 0.05) << i;
  }
}

/// Where the tool rubs shows once a joint's offset is known, too: the form that did a little less well by itself is
/// tried again then. The search told it as a friction at the flange, a drag, a touch and a walk before it looked back.
TEST(Trials, TakeASiblingOnceOthersAreKnown) {
  Recording recording = aRecording(MotionKind::excitation, 267, {{"joint_offset", "2", 2.0}});
  const Vector3d tip(0.02, -0.03, 0.15);
  const auto truth = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(truth, recording.time(i));
    const Matrix3d& R = truth.R_BS[static_cast<std::size_t>(k)];
    const Vector3d velocity = truth.velocity.col(k) + R * Vector3d(truth.omega.col(k)).cross(tip);
    addAtTip(recording, i, 0.4 * R.transpose() * velocity / std::hypot(velocity.norm(), 0.003), tip);
  }
  MotionOptions smoothing;
  smoothing.cutoffHz = 25.0;
  const auto motion = motionOf(recording, &RobotModel::panda(), smoothing).value();
  const Signals signals = signalsOf(recording, motion, &RobotModel::panda());
  const auto stretches = stretchesOf(signals.usable);
  const auto term = [&](const char* id, std::string_view name) {
    const auto forms = findCause(id)->forms(signals);
    const auto form = std::ranges::find(forms, name, &Form::name);
    VectorXd v = form->start;
    v(0) += form->parameters[0].size;
    return Term{std::make_shared<const Form>(*form), v, {}};
  };
  const auto trialOf = [&](const Term& tried, double gain) {
    CandidateFit out;
    out.cause = causeOf(tried);
    out.fit.model.terms = {tried};
    out.gain = gain;
    return out;
  };
  const Term flange = term("coulomb_friction", ""), away = term("coulomb_friction", "away from the sensor");
  const CandidateFit accepted = trialOf(flange, 3000.0);
  std::vector<CandidateFit> all{accepted, trialOf(away, 2950.0),
                                trialOf(term("coulomb_friction", "moving and turning"), 2000.0),
                                trialOf(term("gravity_tilt", ""), 2990.0)};
  const auto siblings = siblingsOf(accepted, all);
  ASSERT_EQ(siblings.size(), 1u);
  EXPECT_EQ(siblings.front().term.form->name, away.form->name);
  Model known;
  known.terms = {flange, term("joint_offset", "joint 2")};
  const Fit base = fitModel(signals, stretches, known);
  all.clear();
  addSiblings(signals, stretches, base, siblings, all);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_GT(all.front().gain, 10.0 * kThreshold);
  EXPECT_EQ(all.front().fit.model.terms.size(), 2u);
  // In its place already, or beside another of its cause, it is none.
  known.terms.front() = away;
  all.clear();
  addSiblings(signals, stretches, fitModel(signals, stretches, known, 1), siblings, all);
  EXPECT_TRUE(all.empty());
}

/// A hose full of liquid that is dragged along by the tip: it was told as a drag at the flange and a crosstalk.
TEST(Diagnose, ADragMayDifferAlongEachAxisAndActAtTheTip) {
  Recording recording = aRecording(MotionKind::free, 265);
  const Vector3d drag(2.6, 1.1, 0.6), tip(0.02, -0.03, 0.15);  // [N s/m], [m]
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
    const Vector3d velocity = motion.velocity.col(k) + R * Vector3d(motion.omega.col(k)).cross(tip);
    addAtTip(recording, i, R.transpose() * velocity.cwiseProduct(drag), tip);
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "viscous_drag") << said(report);
  EXPECT_EQ(cause.sentence.find("Something resists the tool's motion by up to 2.6"), 0u) << cause.sentence;
  for (int i = 0; i < 3; ++i) {
    const CauseParameter* size = findParameter(cause.parameters, fmt::format("drag_{}", "xyz"[i]));
    const CauseParameter* at = findParameter(cause.parameters, fmt::format("at_{}", "xyz"[i]));
    ASSERT_TRUE(size != nullptr && at != nullptr) << said(report);
    EXPECT_NEAR(size->value, drag(i), 0.1) << i;
    EXPECT_NEAR(at->value, 1e3 * tip(i), 5.0) << i;
  }
}

/// A paddle in a liquid: a drag that grows with the speed left a loop, a joint and a gain to be named, too.
TEST(Diagnose, ADragMayGrowWithTheSquareOfTheSpeed) {
  Recording recording = aRecording(MotionKind::excitation, 272);
  const Vector3d tip(0.03, -0.02, 0.12);  // [m]
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
    const Vector3d velocity = motion.velocity.col(k) + R * Vector3d(motion.omega.col(k)).cross(tip);
    addAtTip(recording, i, R.transpose() * (6.0 * velocity.norm() * velocity), tip);
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "viscous_drag") << said(report);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  const CauseParameter* size = findParameter(cause.parameters, "square_drag");
  ASSERT_NE(size, nullptr) << said(report);
  EXPECT_NEAR(size->value, 6.0, 4.0 * size->std);
  for (int i = 0; i < 3; ++i) {
    const CauseParameter* at = findParameter(cause.parameters, fmt::format("at_{}", "xyz"[i]));
    ASSERT_NE(at, nullptr) << said(report);
    EXPECT_NEAR(at->value, 1e3 * tip(i), 4.0 * at->std + 1.0) << i;
  }
}

/// A flat tool that is moved through a bath: what resists does so across its face. It was a drag along the base's axes,
/// and something unknown.
TEST(Diagnose, ADragMayActAcrossAFaceOfTheTool) {
  Recording recording = aRecording(MotionKind::free, 273);
  const Vector3d face = Vector3d(0.5, -0.7, 0.4).normalized(), tip(0.01, 0.02, 0.14);  // S axes; [m]
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
    const Vector3d velocity = R.transpose() * motion.velocity.col(k) + Vector3d(motion.omega.col(k)).cross(tip);
    addAtTip(recording, i, 4.0 * face.dot(velocity) * face, tip);
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "viscous_drag") << said(report);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  const Matrix3d told = tensorOf("tool_drag", cause.parameters);
  EXPECT_LT((told - 4.0 * face * face.transpose()).cwiseAbs().maxCoeff(), 0.15) << told;
  EXPECT_EQ(cause.sentence.find("Something resists the tool's motion by up to "), 0u) << cause.sentence;
}

/// A rubber cord that grows stiffer as it stretches: a spring of one stiffness left something unknown, and a payload of
/// a sixth.
TEST(Diagnose, ACableMayGrowStiffer) {
  Recording recording = aRecording(MotionKind::excitation, 274);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector3d anchor = Vector3d(motion.position.rowwise().mean()) + Vector3d(0.2, -0.25, 0.3);
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Vector3d way = motion.position.col(k) - anchor;
    const double stretched = way.norm() - 0.1;
    const Vector3d held = (4.0 + 60.0 * stretched * stretched) * stretched * way.normalized();
    recording.wrench.row(i).head<3>() += (motion.R_BS[static_cast<std::size_t>(k)].transpose() * held).transpose();
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "cable_pull") << said(report);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  for (const auto& [name, truth] : {std::pair{"hardening", 60.0}, {"stiffness", 4.0}, {"length", 100.0}}) {
    const CauseParameter* found = findParameter(cause.parameters, name);
    ASSERT_NE(found, nullptr) << name << ": " << said(report);
    EXPECT_NEAR(found->value, truth, 4.0 * found->std) << name;
  }
  EXPECT_NEAR(report.after.payload.mass, aTool().mass, 0.012) << said(report);
}

/// Friction in a guide is more while the tool creeps: it was a friction, a cable and something unknown.
TEST(Diagnose, FrictionMayBeMoreWhileSlow) {
  Recording recording = aRecording(MotionKind::excitation, 275);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector3d tip(0.01, -0.01, 0.02);  // [m]
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
    const Vector3d velocity = motion.velocity.col(k) + R * Vector3d(motion.omega.col(k)).cross(tip);
    const double speed = velocity.norm(), holds = 0.8 + 0.5 * std::exp(-std::pow(speed / 0.05, 2));
    addAtTip(recording, i, R.transpose() * (holds / std::hypot(speed, 0.003) * velocity), tip);
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "coulomb_friction") << said(report);
  for (const auto& [name, truth] : {std::pair{"friction", 0.8}, {"breakaway", 0.5}, {"slow_speed", 50.0}}) {
    const CauseParameter* found = findParameter(cause.parameters, name);
    ASSERT_NE(found, nullptr) << name << ": " << said(report);
    EXPECT_NEAR(found->value, truth, 4.0 * found->std + 0.01 * truth) << name;
  }
}

/// A foot of the robot's table gives way while it moves: it was a constant pull, or a cable and a touch.
TEST(Diagnose, ABaseMaySinkDuringTheRecording) {
  Recording recording = aRecording(MotionKind::free, 277);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector3d about = 0.03 * Vector3d(0.8, -0.6, 0.0);  // [rad]
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Matrix3d R = motion.R_BS[static_cast<std::size_t>(k)].transpose();
    const double sunk = std::clamp((recording.time(i) - 3.0) / 5.0, 0.0, 1.0);
    const Vector3d g = recording.meta.gravity, change = R * (rotationFromVector(sunk * about) * g - g);
    const Vector3d force = -aTool().mass * change;
    recording.wrench.row(i).head<3>() += force.transpose();
    recording.wrench.row(i).tail<3>() += aTool().com.cross(force).transpose();
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "gravity_tilt") << said(report);
  for (const auto& [name, truth] : {std::pair{"sinks_x", 0.8}, {"sinks_y", -0.6}}) {
    const CauseParameter* found = findParameter(cause.parameters, name);
    ASSERT_NE(found, nullptr) << name << ": " << said(report);
    EXPECT_NEAR(found->value, 0.03 * 180.0 / std::numbers::pi * truth, 4.0 * found->std) << name;
  }
}

/// All gauges lose strength as the sensor warms up steadily: that was a load that becomes lighter.
TEST(Diagnose, GainsMayGrowAlikeAllTheTime) {
  Recording recording = aRecording(MotionKind::free, 275);
  const double T = recording.time(recording.rows() - 1);
  // Of the load alone: what the amplifiers are off by stays.
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector10d payload = toParameters(aTool());
  const Wrenches load = payloadWrench({motion.specificForce, motion.omega, motion.alpha, {}}, payload);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    recording.wrench.row(i) -= 0.12 * recording.time(i) / T * load.col(sampleAt(motion, recording.time(i))).transpose();
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_TRUE(cause.id == "gain_error" ||
              std::ranges::find(cause.alternatives, "gain_error") != cause.alternatives.end())
      << said(report);
}

/// Something heavy hangs far out at the tip of a light tool: what it turns shows long before what it pulls.
TEST(Diagnose, APullFarFromTheSensorIsFoundByWhatItTurns) {
  Recording recording = aRecording(MotionKind::free, 276);
  const Vector3d pull(0.10, -0.06, 0.0), place(0.03, -0.12, 0.22);  // [N] on the tool, B axes; [m] S axes
  MotionOptions smoothing;
  smoothing.cutoffHz = 25.0;
  const auto motion = motionOf(recording, &RobotModel::panda(), smoothing).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = static_cast<std::size_t>(sampleAt(motion, recording.time(i)));
    addAtTip(recording, i, -motion.R_BS[k].transpose() * pull, place);
  }
  const auto report = diagnosed(recording);
  ASSERT_FALSE(report.causes.empty()) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "constant_pull") << said(report);
  for (int i = 0; i < 3; ++i) {
    const auto force = findParameter(cause.parameters, fmt::format("force_{}", "xyz"[i]));
    const auto at = findParameter(cause.parameters, fmt::format("at_{}", "xyz"[i]));
    ASSERT_TRUE(force && at) << said(report);
    EXPECT_NEAR(force->value, pull(i), 0.03) << i;
    EXPECT_NEAR(at->value, 1e3 * place(i), 60.0) << i;
  }
}

/// A hose that hangs across the base's axes: stiff along a line that is none of them. Nothing was named, since a drift
/// took the rest.
TEST(Diagnose, ACableMayBeStiffestAlongAnyLine) {
  Recording recording = aRecording(MotionKind::free, 264);
  Matrix3d stiffness;  // [N/m]
  stiffness << 3.3, -3.2, -1.4, -3.2, 6.4, 4.2, -1.4, 4.2, 15.5;
  const Vector3d anchor(0.4, 0.2, 0.6);
  holdBack(recording, [&](const Vector3d& place, const Vector3d&) { return Vector3d(stiffness * (place - anchor)); });
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "cable_pull") << said(report);
  const auto& parameters = report.causes.front().parameters;
  for (int i = 0; i < 3; ++i)
    for (int j = i; j < 3; ++j) {
      const std::string pair = i == j ? std::string(1, "xyz"[i]) : std::string{"xyz"[i], "xyz"[j]};
      const auto size = findParameter(parameters, "stiffness_" + pair);
      ASSERT_NE(size, nullptr) << pair;
      EXPECT_NEAR(size->value, stiffness(i, j), 0.3) << pair;
    }
  const auto seen = witnesses(recording, &RobotModel::panda());
  ASSERT_TRUE(seen.ok());
  const auto pull = pullOf(report.causes.front(), *seen);
  ASSERT_TRUE(pull);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(pull->anchor(i), anchor(i), 4.0 * pull->anchorStd + 0.005) << i;
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  EXPECT_NEAR(pull->force, (stiffness * (motion.position.colwise() - anchor)).colwise().norm().mean(), 0.2);
}

/// Told as one stiffness to all sides with the force in the middle of the motion, as a taut cable is.
TEST(Pull, IsWhereTheForceWouldBeNone) {
  DiagnosedCause cable;
  cable.parameters = {{"stiffness", "N/m", 5.0, 0.1},
                      {"force_x", "N", 1.0, 0.05},
                      {"force_y", "N", -2.0, 0.05},
                      {"force_z", "N", 0.5, 0.05}};
  std::vector<Witness> tool;
  for (int i = 0; i < 3; ++i)
    tool.push_back({std::string("position_") + "xyz"[i], "m", VectorXd::LinSpaced(11, 0.1 * i - 0.2, 0.1 * i + 0.2)});
  const auto pull = pullOf(cable, tool);
  ASSERT_TRUE(pull);
  EXPECT_TRUE(pull->anchor.isApprox(Vector3d(0.2, -0.3, 0.3), 1e-12)) << pull->anchor.transpose();
  EXPECT_NEAR(pull->anchorStd, std::hypot(0.05, 0.4 * 0.1) / 5.0, 1e-12);
  cable.parameters.front().std = 2.0;  // Too soft to tell
  EXPECT_FALSE(pullOf(cable, tool));
  cable.parameters.front().std = 0.1;
  tool.pop_back();
  EXPECT_FALSE(pullOf(cable, tool));
}

/// Somebody hooks a line with a weight over a pulley to the tool. It was a cable fixed 4 m away, or contact to the end.
TEST(Diagnose, APullMayBeginAtSomeMoment) {
  Recording recording = aRecording(MotionKind::free, 266);
  const Vector3d pull(0.4, -0.7, 0.9), tip(0.0, 0.02, 0.1);  // [N], B axes; [m]
  const double begins = recording.time(0) + 0.45 * recording.duration();
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    if (recording.time(i) < begins) continue;
    const auto k = sampleAt(motion, recording.time(i));
    addAtTip(recording, i, motion.R_BS[static_cast<std::size_t>(k)].transpose() * -pull, tip);
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "constant_pull") << said(report);
  ASSERT_EQ(cause.when.size(), 1u);
  EXPECT_NEAR(cause.when.front().first, begins, 0.1);
  EXPECT_EQ(cause.sentence.find("From "), 0u) << cause.sentence;
  for (int i = 0; i < 3; ++i) {
    const auto size = findParameter(cause.parameters, fmt::format("force_{}", "xyz"[i]));
    ASSERT_NE(size, nullptr) << said(report);
    EXPECT_NEAR(size->value, pull(i), 0.05) << i;
  }
}

/// A controller that takes a part of the weight out of the readings, but nothing of what moves, does what a balancer
/// does that holds the tool where its weight acts: the size of gravity is another.
TEST(Diagnose, APullWhereTheWeightActsIsTiedWithGravity) {
  Recording recording = aRecording(MotionKind::excitation, 273);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    addAtTip(recording, i, motion.R_BS[static_cast<std::size_t>(k)].transpose() * Vector3d(0.0, 0.0, -4.0),
             aTool().com);
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "constant_pull") << said(report);
  EXPECT_NE(std::ranges::find(cause.alternatives, "derivative_noise"), cause.alternatives.end()) << said(report);
}

/// The sensor was switched on a minute ago. Its force was told as a load that grows lighter, its torque as a memory.
TEST(Diagnose, GainsMayChangeWhileTheSensorWarmsUp) {
  Recording recording = aRecording(MotionKind::free, 268);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  Vector6d growth;
  growth << 0.05, 0.04, 0.03, 0.02, 0.03, 0.0;
  constexpr double kWarm = 6.0;  // [s]
  const double all = 1.0 - std::exp(-recording.duration() / kWarm);
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Vector6d load =
        predictWrench(aTool(), {motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)});
    const double gone = (1.0 - std::exp((recording.time(0) - recording.time(i)) / kWarm)) / all;
    recording.wrench.row(i) += gone * growth.cwiseProduct(load).transpose();
  }
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "gain_error") << said(report);
  EXPECT_NE(cause.sentence.find("warms up"), std::string::npos) << cause.sentence;
  for (int c = 0; c < 3; ++c) {
    const auto size = findParameter(cause.parameters, fmt::format("growth_f{}", "xyz"[c]));
    ASSERT_NE(size, nullptr) << said(report);
    EXPECT_NEAR(size->value, 100.0 * growth(c), 4.0 * size->std + 0.3) << c;
  }
}

/// The ring of an encoder sits off its axis: the angle is wrong to and fro, once a turn. It was a cable.
TEST(Diagnose, AJointMayBeReadWrongOnceATurn) {
  Recording recording = aRecording(MotionKind::excitation, 269);
  constexpr double kOff = 0.8;  // [deg]
  const Eigen::ArrayXd angle = recording.q.col(3).array();
  recording.q.col(3).array() -= kOff / 180.0 * EIGEN_PI * angle.sin();
  if (recording.dq.rows() > 0) recording.dq.col(3).array() *= 1.0 - kOff / 180.0 * EIGEN_PI * angle.cos();
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  const DiagnosedCause& cause = report.causes.front();
  EXPECT_EQ(cause.id, "joint_offset") << said(report);
  EXPECT_EQ(cause.sentence.find("The angle of joint 4 is off by up to 0.79"), 0u) << cause.sentence;
  const auto sine = findParameter(cause.parameters, "q4_once_sine");
  ASSERT_NE(sine, nullptr) << said(report);
  EXPECT_NEAR(sine->value, kOff, 4.0 * sine->std + 0.02);
}

/// A weight slides to one end of the tool and back: either move alone explains less than a zero that walks. It is a
/// part that is loose as well; a part that was picked up and put down is none.
TEST(Diagnose, AWeightThatSlidesToAndFroIsNoWalk) {
  const auto changedTwice = [](double mass, const Vector3d& moment) {  // [kg], [kg m]
    Recording recording = aRecording(mass > 0.0 ? MotionKind::free : MotionKind::pickAndPlace, 271);
    const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
    for (Eigen::Index i = 0; i < recording.rows(); ++i) {
      const double t = recording.time(i) - recording.time(0),
                   there = 0.5 * (std::tanh((t - 4.0) / 0.1) - std::tanh((t - 8.0) / 0.15));
      const Vector3d s = motion.specificForce.col(sampleAt(motion, recording.time(i)));
      recording.wrench.row(i).head<3>() += there * mass * s.transpose();
      recording.wrench.row(i).tail<3>() += there * moment.cross(s).transpose();
    }
    return recording;
  };
  for (const double mass : {0.0, 0.05}) {
    const auto report = diagnosed(
        changedTwice(mass, mass > 0.0 ? Vector3d(0.0, 0.0, 0.08 * mass) : Vector3d(-2.4e-3, 0.8e-3, -1.1e-3)));
    const DiagnosedCause* changed = named(report, "payload_change");
    ASSERT_NE(changed, nullptr) << said(report);
    EXPECT_GE(changed->when.size(), 2u) << said(report);
    EXPECT_EQ(std::ranges::count(changed->alternatives, "loose_mass"), mass > 0.0 ? 0 : 1) << said(report);
  }
}

/// Exactly the same where the joint's axis goes through the sensor, whatever else there is.
TEST(Diagnose, ATurnedLastJointIsTiedWithATurnedSensor) {
  Recording recording = aRecording(MotionKind::excitation, 263, {{"viscous_drag", "", 3.0}});
  recording.q.col(6).array() -= 0.03;
  const auto report = diagnosed(recording);
  const auto turned = std::ranges::find_if(
      report.causes, [](const auto& c) { return c.id == "sensor_rotation" || c.id == "joint_offset"; });
  ASSERT_NE(turned, report.causes.end()) << said(report);
  const std::string other = turned->id == "joint_offset" ? "sensor_rotation" : "joint_offset";
  EXPECT_NE(std::ranges::find(turned->alternatives, other), turned->alternatives.end()) << said(report);
}

/// What inertia adds to the readings is smoothed, in the sensor's axes: smoothed in the room's, as the robot would, it
/// is another lag.
TEST(Diagnose, WhatInertiaAddsMayComeLate) {
  constexpr double kLag = 0.03;  // [s]
  Recording recording = aRecording(MotionKind::excitation, 642);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Vector10d payload = toParameters(aTool());
  const double dt = recording.time(1) - recording.time(0), keep = std::exp(-dt / kLag);
  Vector6d late = Vector6d::Zero();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const auto k = sampleAt(motion, recording.time(i));
    const Vector3d gravity = motion.R_BS[static_cast<std::size_t>(k)].transpose() * Vector3d(0.0, 0.0, -9.81);
    const Vector6d inertia =
        regressor({motion.specificForce.col(k) + gravity, motion.omega.col(k), motion.alpha.col(k)}) * payload;
    late = keep * late + (1.0 - keep) * inertia;
    recording.wrench.row(i) += (late - inertia).transpose();
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "motion_lag");
  const CauseParameter* lag = findParameter(report.causes.front().parameters, "lag");
  ASSERT_NE(lag, nullptr);
  EXPECT_NEAR(lag->value, 1e3 * kLag, 4.0 * lag->std);
}

/// A hand that guides the tool itself pushes the way it goes; a bent hose pushes away from where it is fixed.
TEST(Diagnose, WhatPushesTheWayTheToolGoes) {
  struct Push {
    const char* cause;
    const char* what;
    double size;
  };
  for (const auto& [cause, what, size] : {Push{"viscous_drag", "drag", 1.5}, Push{"coulomb_friction", "friction", 0.5},
                                          Push{"cable_pull", "stiffness", 3.0}}) {
    Recording recording = aRecording(MotionKind::excitation, 641);
    holdBack(recording, [what = what, size = size](const Vector3d& position, const Vector3d& velocity) -> Vector3d {
      if (what == std::string("drag")) return -size * velocity;
      if (what == std::string("friction")) return -size * velocity / std::sqrt(velocity.squaredNorm() + 1e-5);
      return -size * (position - Vector3d(0.2, -0.3, 0.5));
    });
    const auto report = diagnosed(recording);
    EXPECT_EQ(report.verdict, Verdict::explained) << cause << ": " << said(report);
    const DiagnosedCause* push = named(report, cause);
    ASSERT_NE(push, nullptr) << cause << ": " << said(report);
    const CauseParameter* told = findParameter(push->parameters, what);
    ASSERT_NE(told, nullptr) << cause;
    EXPECT_NEAR(told->value, -size, 4.0 * told->std) << cause;
    EXPECT_NE(push->sentence.find("pushes"), std::string::npos) << push->sentence;
  }
}

}  // namespace
}  // namespace heft::test
