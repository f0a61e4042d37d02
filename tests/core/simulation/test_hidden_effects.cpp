// The generator of hidden effects: reproducible, as visible as it says, and silent about the truth.
#include "tests/support/hidden_effects.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "core/recording/csv_reader.h"
#include "tests/core/simulation/effect_sample.h"
#include "tests/support/diagnosis_score.h"
#include "tests/support/injection.h"
#include "tests/support/unlisted_effects.h"

namespace heft::test {
namespace {

TEST(HiddenEffects, SameDrawSameBytes) {
  for (const HiddenCase kind : kHiddenCases) {
    SCOPED_TRACE(toString(kind));
    const HiddenRecording a = drawHidden(kind, 3), b = drawHidden(kind, 3), c = drawHidden(kind, 4);
    EXPECT_EQ(a.recording.wrench, b.recording.wrench);
    EXPECT_EQ(toJson(a.truth), toJson(b.truth));
    EXPECT_NE(toJson(a.truth), toJson(c.truth));
    const auto read = hiddenTruthFromJson(nlohmann::json::parse(toJson(a.truth).dump()), "truth.json");
    ASSERT_TRUE(read.ok()) << read.error().message;
    EXPECT_EQ(read->kind, kind);
    EXPECT_EQ(read->ids, a.truth.ids);
    EXPECT_EQ(read->multiple, a.truth.multiple);
    EXPECT_EQ(read->relatives, a.truth.relatives);
    EXPECT_EQ(read->simulation.payload.mass, a.truth.simulation.payload.mass);
    const std::size_t count = kind == HiddenCase::clean || kind == HiddenCase::walking ? 0
                              : kind == HiddenCase::pair                               ? 2
                              : kind == HiddenCase::triple                             ? 3
                                                                                       : 1;
    EXPECT_EQ(a.truth.ids.size(), count);
    EXPECT_TRUE(checkPhysical(a.truth.simulation.payload).physical);
    EXPECT_TRUE(a.recording.meta.note.empty());
    EXPECT_TRUE(a.recording.meta.marks.empty());
    EXPECT_TRUE(a.recording.meta.knownPayload.empty());
    EXPECT_GE(a.recording.duration(), 9.5);
    EXPECT_LE(a.recording.duration(), 25.5);
  }
}

TEST(HiddenEffects, VisibleMeansAsVisibleAsStated) {
  for (const std::string id : {"cable_pull", "time_offset", "gain_error"}) {
    SCOPED_TRACE(id);
    const HiddenRecording hidden = drawHidden(HiddenCase::single, 7, 1.0, id);
    ASSERT_EQ(hidden.truth.ids.at(0), id);
    SimulateOptions options = hidden.truth.simulation.options;
    const EffectRequest request = options.effects.at(0);
    options.effects.clear();
    const double sigma = misfit(hidden.truth.simulation.payload, options, {id, request.form, std::abs(request.size)});
    EXPECT_NEAR(sigma / kVisibleSigma, 1.0, 0.1);
    // A third of it, from the same draw.
    const HiddenRecording small = drawHidden(HiddenCase::single, 7, 1.0 / 3.0, id);
    EXPECT_NEAR(small.truth.simulation.effects[0].size / hidden.truth.simulation.effects[0].size, 1.0 / 3.0, 1e-12);
  }
  // What a refit swallows is not visible at any size.
  EXPECT_LT(misfit(sampleTool(), optionsFor(MotionKind::free, 5), {"sensor_bias", "", 5.0}), 0.1);
  EXPECT_LT(misfit(sampleTool(), optionsFor(MotionKind::free, 5), {"gain_error", "forces", 0.0}), 1e-9);
}

TEST(HiddenEffects, PairsAreOfUnlikeKinds) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    const auto ids = drawHidden(HiddenCase::pair, seed).truth.ids;
    ASSERT_EQ(ids.size(), 2u);
    EXPECT_NE(ids[0], ids[1]);
    EXPECT_FALSE(std::set<std::string>(ids.begin(), ids.end()) ==
                 std::set<std::string>({"low_pass_lag", "time_offset"}));
  }
}

TEST(HiddenEffects, UnlistedOnesAreInNoProgram) {
  for (const UnlistedKind& kind : unlistedKinds()) {
    EXPECT_EQ(findEffectKind(kind.id), nullptr);
    for (const std::string& relative : kind.relatives) EXPECT_NE(findEffectKind(relative), nullptr) << relative;
    const HiddenRecording hidden = drawHidden(HiddenCase::unlisted, 11, 1.0, kind.id);
    EXPECT_EQ(hidden.truth.ids, std::vector<std::string>{kind.id});
    EXPECT_TRUE(hidden.recording.wrench.allFinite());
  }
}

TEST(Injection, DoesToARecordingWhatTheSimulatorDoes) {
  const SimulateOptions options = quietOptions(MotionKind::free, 5, 8.0);
  const Simulated plain = simulatedOrDie(options);
  // Forces go through the smoothed motion; the ends of the recording have none.
  for (const auto& [text, tolerance] : std::vector<std::pair<std::string, double>>{{"cable_pull=5", 0.01},
                                                                                   {"constant_pull=1", 0.01},
                                                                                   {"gain_error=5", 1e-9},
                                                                                   {"time_offset=12", 1e-9},
                                                                                   {"low_pass_lag=15", 0.02},
                                                                                   {"sensor_rotation=3", 1e-9},
                                                                                   {"payload_change/slow=80", 0.05}}) {
    SCOPED_TRACE(text);
    const EffectRequest request = *parseEffect(text);
    const Simulated whole = withEffect(text, options);
    const auto injected = inject(plain.recording, &RobotModel::panda(), sampleTool(), Vector6d::Zero(), {request}, 5);
    ASSERT_TRUE(injected.ok()) << injected.error().message;
    ASSERT_EQ(injected->effects.size(), 1u);
    // The scene's path is sampled otherwise, so anchors may lie a little elsewhere.
    const Eigen::Index n = plain.recording.rows();
    const SampledWrench a = injected->recording.wrench - plain.recording.wrench,
                        b = whole.recording.wrench - plain.recording.wrench;
    double worst = 0.0;
    for (Eigen::Index k = 100; k < n - 100; ++k) worst = std::max(worst, (a.row(k) - b.row(k)).norm());
    EXPECT_LT(worst, tolerance + 0.02 * b.cwiseAbs().maxCoeff());
  }
}

TEST(Injection, GeometryIsMisstatedInstead) {
  const Simulated plain = simulatedOrDie(quietOptions());
  for (const std::string text : {"gravity_tilt=4", "lever_arm=20"}) {
    const auto injected =
        inject(plain.recording, &RobotModel::panda(), sampleTool(), Vector6d::Zero(), {*parseEffect(text)}, 5);
    ASSERT_TRUE(injected.ok()) << injected.error().message;
    EXPECT_EQ(injected->recording.wrench, plain.recording.wrench);
    const double turned =
        std::acos(injected->recording.meta.gravity.normalized().dot(plain.recording.meta.gravity.normalized()));
    const double moved = (injected->recording.meta.mount.xyz - plain.recording.meta.mount.xyz).norm();
    EXPECT_NEAR(turned, text == "gravity_tilt=4" ? 4.0 * 3.14159265 / 180.0 : 0.0, 1e-6);
    EXPECT_NEAR(moved, text == "lever_arm=20" ? 0.02 : 0.0, 1e-9);
  }
}

TEST(Injection, IntoMeasuredRecordings) {
  const char* given = std::getenv("HEFT_SHARED");
  const std::filesystem::path folder =
      (given ? std::filesystem::path(given) : std::filesystem::path(HEFT_SOURCE_DIR) / ".." / "shared") / "realdata";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "no measured recordings at " << folder;
  for (const char* name : {"panda_optoforce_14-23-21.csv", "kuka_gamma_baseline.csv"}) {
    SCOPED_TRACE(name);
    const auto read = readRecording(folder / name);
    ASSERT_TRUE(read.ok()) << read.error().message;
    Findings findings;
    const auto robot = robotFor(read->recording.meta, findings);
    Vector6d bias = read->recording.wrench.colwise().mean().transpose();
    const auto injected =
        inject(read->recording, robot ? &*robot : nullptr, sampleTool(), bias,
               {*parseEffect("constant_pull=2"), *parseEffect("spikes=1"), *parseEffect("bias_drift=1")}, 3);
    ASSERT_TRUE(injected.ok()) << injected.error().message;
    EXPECT_EQ(injected->effects.size(), 3u);
    EXPECT_TRUE(injected->recording.wrench.allFinite());
    EXPECT_GT((injected->recording.wrench - read->recording.wrench).cwiseAbs().maxCoeff(), 1.0);
    for (std::uint64_t seed = 0; seed < 3; ++seed) {
      const auto draw = [&] {
        return drawInjected(read->recording, robot ? &*robot : nullptr, sampleTool(), bias, 7 * seed + 2, 1.0);
      };
      const auto a = draw(), b = draw();
      ASSERT_TRUE(a.ok()) << a.error().message;
      EXPECT_EQ(a->recording.wrench, b->recording.wrench);
      ASSERT_EQ(a->effects.size(), 1u);
      EXPECT_TRUE(a->recording.wrench.allFinite());
    }
  }
}

TEST(DiagnosisScore, JudgesAnswersByWhatWasHidden) {
  using nlohmann::json;
  HiddenTruth truth;
  truth.kind = HiddenCase::single;
  truth.ids = {"cable_pull"};
  const auto answer = [](const char* verdict, const std::vector<std::pair<std::string, json>>& causes) {
    json list = json::array();
    for (const auto& [id, alternatives] : causes) list.push_back({{"cause", id}, {"alternatives", alternatives}});
    return json{{"verdict", verdict}, {"causes", list}};
  };
  const json none = json::array();
  EXPECT_EQ(judge(truth, answer("explained", {{"cable_pull", none}})), Judgement::right);
  EXPECT_EQ(judge(truth, answer("ambiguous", {{"constant_pull", json::array({"cable_pull"})}})), Judgement::tied);
  EXPECT_EQ(judge(truth, answer("explained", {{"bias_drift", none}, {"cable_pull", none}})), Judgement::later);
  EXPECT_EQ(judge(truth, answer("explained", {{"bias_drift", none}})), Judgement::wrong);
  EXPECT_EQ(judge(truth, answer("unexplained", {})), Judgement::unexplained);
  EXPECT_EQ(judge(truth, answer("clean", {})), Judgement::missed);
  EXPECT_EQ(judge(truth, json::object()), Judgement::wrong);
  truth.kind = HiddenCase::pair;
  truth.ids = {"cable_pull", "time_offset"};
  EXPECT_EQ(judge(truth, answer("explained", {{"time_offset", none}, {"cable_pull", none}})), Judgement::right);
  EXPECT_EQ(judge(truth, answer("explained", {{"time_offset", none}})), Judgement::later);
  truth.kind = HiddenCase::clean;
  truth.ids.clear();
  EXPECT_EQ(judge(truth, answer("clean", {})), Judgement::right);
  EXPECT_EQ(judge(truth, answer("unexplained", {})), Judgement::wrong);
  truth.kind = HiddenCase::unlisted;
  truth.ids = {"magnet"};
  truth.relatives = {"cable_pull"};
  EXPECT_EQ(judge(truth, answer("unexplained", {})), Judgement::right);
  EXPECT_EQ(judge(truth, answer("explained", {{"cable_pull", none}})), Judgement::tied);
  EXPECT_EQ(judge(truth, answer("explained", {{"viscous_drag", none}})), Judgement::wrong);

  DiagnosisScore score;
  truth.multiple = 2.0;
  score.add(truth, answer("unexplained", {}), 1.0);
  score.add(truth, answer("explained", {{"viscous_drag", none}}), 1.0);
  EXPECT_EQ(score.share(HiddenCase::unlisted, Judgement::right), 0.5);
  EXPECT_EQ(score.share(HiddenCase::unlisted, Judgement::wrong, 2.0), 0.5);
  EXPECT_EQ(score.share(HiddenCase::unlisted, Judgement::wrong, 4.0), 0.0);
  EXPECT_NE(score.text().find("viscous_drag 1"), std::string::npos);
}

}  // namespace
}  // namespace heft::test
