// What every cause of the catalogue must have.
#include "core/diagnosis/causes/catalogue.h"

#include <gtest/gtest.h>

#include <set>

#include "core/diagnosis/model/found_values.h"
#include "core/simulation/effects/effect.h"
#include "tests/core/diagnosis/fixture.h"
#include "tests/support/hidden_effects.h"

namespace heft::test {
namespace {

using namespace diagnosis;

std::vector<const Cause*> allCauses() {
  std::vector<const Cause*> out;
  for (const auto* list : {&catalogue(), &seenDirectly()})
    for (const auto& cause : *list)
      if (cause->id() != kRandomWalk) out.push_back(cause.get());
  return out;
}

TEST(Catalogue, EachCauseHasItsTexts) {
  std::set<std::string_view> ids, titles;
  for (const Cause* cause : allCauses()) {
    const CauseInfo& info = cause->info();
    EXPECT_TRUE(ids.insert(info.id).second) << info.id;
    EXPECT_TRUE(titles.insert(info.title).second) << info.title;
    for (const char* text : {info.title, info.check, info.decides, info.looks}) EXPECT_STRNE(text, "") << info.id;
    EXPECT_EQ(findCause(info.id), cause);
    for (const std::string& other : cause->lookAlikes()) EXPECT_NE(findCause(other), nullptr) << info.id << other;
  }
  EXPECT_EQ(infoOf("no_such_cause").id, "");
}

TEST(Catalogue, EachFormHasASentence) {
  const Recording recording = aRecording(MotionKind::excitation, 811);
  const auto motion = motionOf(recording, &RobotModel::panda(), {}).value();
  const Signals signals = signalsOf(recording, motion, &RobotModel::panda());
  for (const auto& cause : catalogue()) {
    if (cause->id() == kRandomWalk) continue;
    for (const Form& form : cause->forms(signals)) {
      if (form.guide) continue;
      std::vector<CauseParameter> parameters;
      for (const Parameter& p : form.parameters) parameters.push_back({p.name, p.unit, p.size * p.scale, 0.01});
      const std::vector<std::pair<double, double>> when{{1.0, 2.0}};
      EXPECT_NE(cause->sentence({parameters, when}), "") << cause->id() << ": " << form.name;
    }
  }
}

/// Whether a recording with that effect, twice as large as is visible, is told to have the cause, or a tie with it.
bool isFound(const std::string& id, std::uint64_t seed) {
  DiagnoseOptions options;
  options.surrogates = 0;
  const auto hidden = drawHidden(HiddenCase::single, seed, 2.0, id);
  const auto report = diagnose(hidden.recording, &RobotModel::panda(), options);
  return report.ok() && std::ranges::any_of(report.value().causes, [&](const DiagnosedCause& cause) {
           return cause.id == id || std::ranges::find(cause.alternatives, id) != cause.alternatives.end();
         });
}

/// One motion may hide what another shows: how often each is found is diagnosis_study's matter.
TEST(Catalogue, EachCauseHasAnEffectInTheSimulatorThatIsFound) {
  constexpr std::uint64_t kFirst = 20261128, kTries = 3;
  for (const Cause* cause : allCauses()) {
    const std::string effect(cause->info().effect);
    ASSERT_NE(findEffectKind(effect), nullptr) << cause->id();
    if (cause->id() == ids::sensorBias) continue;  // Over all the recording it is no misfit; a jump is a form of drift
    bool found = false;
    for (std::uint64_t i = 0; i < kTries && !found; ++i) found = isFound(effect, kFirst + i);
    EXPECT_TRUE(found) << cause->id();
  }
}

}  // namespace
}  // namespace heft::test
