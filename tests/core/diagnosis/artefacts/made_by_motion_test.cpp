// Faint causes that are made of the motion's own noise, told by smoothing it more.
#include "core/diagnosis/artefacts/made_by_motion.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/diagnosis/causes/catalogue.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
using namespace diagnosis;

namespace {

std::vector<SmoothingCandidate> waysOf(const Recording& recording) {
  std::vector<SmoothingCandidate> out;
  for (const double cutoff : {25.0, 12.0, 8.5, 6.0}) {
    out.push_back(
        smoothingCandidateOf(recording, recording, &RobotModel::panda(), {.cutoffHz = cutoff}, {}, {}).value());
    lookForContact(out.back(), recording, {});
  }
  return out;
}

/// A work on the least smoothed way with that cause alone, in the form `name`, begun with `v`.
Hypothesis workWith(const std::vector<SmoothingCandidate>& ways, const char* cause, std::string_view name,
                    const VectorXd& v) {
  Hypothesis out;
  out.signals = ways.front().signals;
  out.stretches = stretchesOf(out.signals.usable);
  const auto forms = findCause(cause)->forms(out.signals);
  Model model;
  model.terms.push_back({std::make_shared<const Form>(*std::ranges::find(forms, name, &Form::name)), v, {}});
  out.search.final = fitModel(out.signals, out.stretches, model);
  Found found;
  found.cause = cause;
  found.gain = out.search.final.evidence - fitModel(out.signals, out.stretches, Model{}).evidence;
  out.search.found.push_back(found);
  return out;
}

constexpr double kHeight = 0.003;

TEST(MadeByMotion, AMemoryThatStaysWhereTheMotionIsSmootherIsNot) {
  const auto ways = waysOf(withLoop(aRecording(MotionKind::excitation, 261), kHeight));
  const Hypothesis hypothesis = workWith(ways, "hysteresis", "loop", Eigen::Vector2d(kHeight, 0.005));
  ASSERT_GT(hypothesis.search.found.front().gain, kNamed);
  ASSERT_LT(hypothesis.search.found.front().gain, 300.0) << "Else nobody asks";
  EXPECT_TRUE(motionArtefacts(hypothesis, ways, 0).empty());
}

/// As if what smoothing takes away had made it.
TEST(MadeByMotion, OneThatTheLeastSmoothedMotionAloneHasIs) {
  const Recording still = aRecording(MotionKind::excitation, 261);
  auto ways = waysOf(still);
  ways.front() = waysOf(withLoop(still, kHeight)).front();
  const Hypothesis hypothesis = workWith(ways, "hysteresis", "loop", Eigen::Vector2d(kHeight, 0.005));
  EXPECT_EQ(motionArtefacts(hypothesis, ways, 0), std::vector<std::string>{"hysteresis"});
  EXPECT_TRUE(motionArtefacts(hypothesis, ways, ways.size() - 1).empty()) << "Nothing is smoother to ask";
}

}  // namespace
}  // namespace heft::test
