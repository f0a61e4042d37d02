// Asking for effects: every kind and form works, zero is nothing, the seed decides, and the recording keeps the secret.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tests/core/simulation/effect_sample.h"

namespace heft {
namespace {

using testing::HasSubstr;

template <class Series>
bool same(const Series& a, const Series& b) {
  return a.rows() == b.rows() && a.cols() == b.cols() && a == b;
}

bool sameRecording(const Recording& a, const Recording& b) {
  return same(a.time, b.time) && same(a.q, b.q) && same(a.dq, b.dq) && same(a.position, b.position) &&
         same(a.quaternion, b.quaternion) && same(a.wrench, b.wrench) && a.meta.gravity == b.meta.gravity;
}

TEST(EffectRequests, EveryKindAndFormChangesTheRecordingTheSameWayForASeed) {
  const SimulateOptions options = optionsFor(MotionKind::free, 3, 1.5);
  const Simulated plain = simulatedOrDie(options);
  for (const EffectKind& kind : effectKinds()) {
    for (const std::string& form : kind.forms) {
      const std::string text = fmt::format("{}/{}={}", kind.id, form, kind.typical);
      SCOPED_TRACE(text);
      const Simulated a = withEffect(text, options), b = withEffect(text, options);
      EXPECT_TRUE(sameRecording(a.recording, b.recording));
      EXPECT_EQ(toJson(a.truth), toJson(b.truth));
      EXPECT_FALSE(sameRecording(a.recording, plain.recording));
      EXPECT_TRUE(a.recording.wrench.allFinite());
      ASSERT_EQ(a.truth.effects.size(), 1u);
      EXPECT_EQ(a.truth.effects[0].id, kind.id);
      EXPECT_EQ(a.truth.effects[0].form, form);
      EXPECT_EQ(a.truth.effects[0].size, kind.typical);
      EXPECT_EQ(a.truth.effects[0].unit, kind.unit);
      EXPECT_EQ(a.q, plain.q);
    }
    SCOPED_TRACE(kind.id + " of size 0");
    const Simulated zero = withEffect(kind.id + "=0", options);
    EXPECT_TRUE(sameRecording(zero.recording, plain.recording));
    EXPECT_TRUE(zero.truth.effects.empty());
  }
}

TEST(EffectRequests, SmallSizesDoLittle) {
  // Without the converter's steps the wrench goes to the plain one as the size goes to zero.
  const SimulateOptions options = quietOptions(MotionKind::free, 3, 1.5);
  const Simulated plain = simulatedOrDie(options);
  for (const EffectKind& kind : effectKinds()) {
    if (kind.id == "frame_error" || kind.id == "spikes" || kind.id == "dropouts" || kind.id == "repeats" ||
        kind.id == "saturation" || kind.id == "quantisation")
      continue;
    for (const std::string& form : kind.forms) {
      const Simulated tiny = withEffect(fmt::format("{}/{}={}", kind.id, form, 1e-9 * kind.typical), options);
      EXPECT_LT((tiny.recording.wrench - plain.recording.wrench).cwiseAbs().maxCoeff(), 1e-6) << kind.id << form;
    }
  }
}

TEST(EffectRequests, PlaceAndTimeComeFromTheSeedAndNotFromTheSize) {
  SimulateOptions options = quietOptions(MotionKind::free, 3, 1.5);
  const Simulated small = withEffect("cable_pull=1", options), large = withEffect("cable_pull=2", options);
  EXPECT_EQ(hidden(small, "anchor_b_m"), hidden(large, "anchor_b_m"));
  EXPECT_LT((2.0 * added(small) - added(large)).cwiseAbs().maxCoeff(), 1e-10);
  options.effects.push_back({"time_offset", "", 5.0});
  const Simulated both = withEffect("cable_pull=2", options);
  ASSERT_EQ(both.truth.effects.size(), 2u);
  EXPECT_EQ(both.truth.effects[0].id, "cable_pull");  // in the order of the chain
  EXPECT_EQ(both.truth.effects[0].parameters[0].values, hidden(large, "anchor_b_m"));
  options = quietOptions(MotionKind::free, 4, 4.0);
  EXPECT_NE(hidden(withEffect("cable_pull=1", options), "anchor_b_m"), hidden(small, "anchor_b_m"));
}

TEST(EffectRequests, TheRecordingKeepsTheSecret) {
  const Simulated simulated = withEffect("cable_pull=3", optionsFor(MotionKind::free, 2, 4.0));
  const RecordingMeta& meta = simulated.recording.meta;
  const RecordingMeta plain = simulatedOrDie(optionsFor(MotionKind::free, 2, 4.0)).recording.meta;
  EXPECT_EQ(meta.note, plain.note);
  EXPECT_EQ(meta.mount.xyz, plain.mount.xyz);
  EXPECT_EQ(meta.mount.rpy, plain.mount.rpy);
  EXPECT_EQ(meta.gravity, plain.gravity);
  EXPECT_EQ(meta.sensorModel, plain.sensorModel);
  EXPECT_TRUE(meta.marks.empty());
  EXPECT_TRUE(simulated.recording.extra.empty());
  EXPECT_TRUE(simulated.recording.labels.empty());
}

TEST(EffectRequests, TruthIsWrittenOut) {
  const nlohmann::json json = toJson(withEffect("payload_change/ramp=80", optionsFor(MotionKind::free, 2, 4.0)).truth);
  const auto& effect = json.at("effects").at(0);
  EXPECT_EQ(effect.at("effect"), "payload_change");
  EXPECT_EQ(effect.at("form"), "ramp");
  EXPECT_EQ(effect.at("size"), 80.0);
  EXPECT_EQ(effect.at("unit"), "g");
  EXPECT_DOUBLE_EQ(effect.at("parameters").at("mass_kg"), 0.08);
  EXPECT_EQ(effect.at("parameters").at("com_s_m").size(), 3u);
  EXPECT_EQ(effect.at("when").at(0).size(), 2u);
}

TEST(EffectRequests, NonsenseGetsOneSentence) {
  const auto message = [](const char* text) {
    const auto effect = parseEffect(text);
    return effect ? std::string("(fine)") : effect.error().message;
  };
  EXPECT_THAT(message("cable_pull"), HasSubstr("ID=SIZE"));
  EXPECT_THAT(message("cable_pull="), HasSubstr("not a number"));
  EXPECT_THAT(message("cable_pull=3x"), HasSubstr("not a number"));
  EXPECT_THAT(message("cable_pull=nan"), HasSubstr("it can be 0 to"));
  EXPECT_THAT(message("cable_pull=-3"), HasSubstr("it can be 0 to"));
  EXPECT_THAT(message("cable_pull=1e9"), HasSubstr("it can be 0 to"));
  EXPECT_THAT(message("cable_pul=3"), HasSubstr("There is no effect 'cable_pul'"));
  EXPECT_THAT(message("cable_pull/rusty=3"), HasSubstr("slack"));
  EXPECT_EQ(message("time_offset=-3.5"), "(fine)");
  EXPECT_EQ(parseEffect("cable_pull/slack=3.5")->form, "slack");
}

}  // namespace
}  // namespace heft
