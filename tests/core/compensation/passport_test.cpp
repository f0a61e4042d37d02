// A tool's passport, and whether the next one says something new.
#include "core/compensation/passport.h"

#include <gtest/gtest.h>

#include "core/compensation/passport_page.h"
#include "tests/support/estimation_fixtures.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

const Payload kMarked = test::boxPayload(0.9, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06});

EstimateReport shortReport(const Payload& tool, unsigned seed) {
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.duration = 10.0;
  options.rateHz = 250.0;
  options.seed = seed;
  auto simulated = simulate(RobotModel::panda(), tool, options);
  if (!simulated) throw std::runtime_error(simulated.error().message);
  return test::reportOf(simulated->recording);
}

PassportContent contentOf(const char* date) {
  return {"Gripper 3",           date, "Heft test", true, {{"cable_pull", "A cable pulls with 2 N/m.", true}},
          {"delays under 1 ms"}, {}};
}

nlohmann::json passport(const EstimateReport& report, const char* date) {
  auto made = passportOf(contentOf(date), toJson(report), "result.json");
  if (!made) throw std::runtime_error(made.error().message);
  return *made;
}

TEST(Passport, HoldsTheNumbersAndWhatSpeaksForThem) {
  const EstimateReport report = shortReport(kMarked, 1);
  const nlohmann::json made = passport(report, "2026-11-28");
  EXPECT_EQ(made["schema"], "heft.passport/1");
  EXPECT_EQ(made["tool"], "Gripper 3");
  EXPECT_EQ(made["payload"], toJson(report.payload));
  EXPECT_EQ(made["causes"][0]["applied"], true);
  EXPECT_EQ(made["not_seen"][0], "delays under 1 ms");
  EXPECT_TRUE(made["since"].is_null());
  EXPECT_TRUE(made.contains("interval95"));
  EXPECT_FALSE(made.contains("segments"));
}

TEST(Passport, TheSameToolChangesByChanceAlone) {
  int differing = 0;
  for (unsigned seed = 10; seed < 18; ++seed) {
    const auto change = changeSince(passport(shortReport(kMarked, seed), "2026-11-01"), "old.json",
                                    passport(shortReport(kMarked, seed + 100), "2026-11-28"));
    ASSERT_TRUE(change) << change.error().message;
    ASSERT_EQ(change->rows.size(), 10u);
    EXPECT_EQ(change->date, "2026-11-01");
    differing += change->moreThanChance();
  }
  EXPECT_LE(differing, 1);
}

TEST(Passport, AnotherMassOrCentreOrInertiaIsMoreThanChance) {
  const nlohmann::json before = passport(shortReport(kMarked, 3), "2026-11-01");
  Payload heavier = kMarked;
  heavier.mass *= 1.05;
  heavier.inertiaCom *= 1.05;
  const auto mass = changeSince(before, "old.json", passport(shortReport(heavier, 4), "2026-11-28"));
  ASSERT_TRUE(mass);
  EXPECT_TRUE(mass->massCentre);
  EXPECT_TRUE(mass->rows[0].moreThanChance);
  EXPECT_NEAR(mass->rows[0].difference, 0.045, 0.01);
  Payload moved = kMarked;
  moved.com.x() += 0.006;
  const auto centre = changeSince(before, "old.json", passport(shortReport(moved, 5), "2026-11-28"));
  EXPECT_TRUE(centre->massCentre);
  EXPECT_TRUE(centre->rows[1].moreThanChance);
  EXPECT_FALSE(centre->rows[2].moreThanChance);
  EXPECT_EQ(toJson(*centre)["numbers"].size(), 10u);
}

TEST(Passport, ASensorThatSitsElsewhereLeavesTheMassToCompare) {
  const EstimateReport report = shortReport(kMarked, 6);
  EstimateReport turned = report;
  turned.mount.rpy.z() += 0.5;
  turned.payload.com.x() += 0.05;
  const auto change = changeSince(passport(report, "2026-11-01"), "old.json", passport(turned, "2026-11-28"));
  ASSERT_TRUE(change);
  EXPECT_TRUE(change->otherMount);
  EXPECT_EQ(change->rows.size(), 1u);
  EXPECT_FALSE(change->moreThanChance());
}

TEST(Passport, RefusesWhatIsNoneInOneSentence) {
  EstimateReport report = shortReport(kMarked, 7);
  const nlohmann::json good = passport(report, "2026-11-28");
  nlohmann::json other = good, broken = good;
  other["tool"] = "Camera";
  broken["payload"]["mass_kg"] = "heavy";
  for (const nlohmann::json& before :
       {nlohmann::json(), nlohmann::json(3), nlohmann::json({{"schema", "heft.estimate/1"}}), other, broken}) {
    const auto change = changeSince(before, "old.json", good);
    ASSERT_FALSE(change) << before.dump().substr(0, 80);
    EXPECT_NE(change.error().message.find("old.json"), std::string::npos) << change.error().message;
  }
  PassportContent nameless = contentOf("2026-11-28");
  nameless.tool.clear();
  EXPECT_FALSE(passportOf(nameless, toJson(report), "result.json"));
  report.trust = Trust::none;
  EXPECT_FALSE(passportOf(contentOf("2026-11-28"), toJson(report), "result.json"));
}

TEST(Passport, DamagedResultsAreRefusedByName) {
  const nlohmann::json good = toJson(shortReport(kMarked, 8));
  ASSERT_TRUE(passportOf(contentOf("2026-11-28"), good, "result.json"));
  for (const char* key : {"schema", "payload", "std", "interval95", "identifiability"})
    for (const nlohmann::json& instead : {nlohmann::json(), nlohmann::json("x"), nlohmann::json::array()}) {
      nlohmann::json broken = good;
      broken[key] = instead;
      const auto made = passportOf(contentOf("2026-11-28"), broken, "result.json");
      ASSERT_FALSE(made) << key << instead.dump();
      EXPECT_NE(made.error().message.find("result.json"), std::string::npos) << made.error().message;
    }
}

TEST(Passport, ThePageShowsNumbersInTheWantedUnits) {
  nlohmann::json made = passport(shortReport(kMarked, 9), "2026-11-28");
  const std::string page = passportPage(made);
  for (const char* text :
       {"Payload passport: Gripper 3", "2026-11-28, Heft test.", "<td>Mass</td><td>0.", " kg</td>", "Centre z",
        "kg cm²", "measured", "A cable pulls with 2 N/m. The numbers are corrected for it.", "delays under 1 ms",
        "These numbers were not proved on another recording."})
    EXPECT_NE(page.find(text), std::string::npos) << text;
  PageUnits grams;
  grams.mass = {"g", 1e3, -3};
  EXPECT_NE(passportPage(made, grams).find(" g</td>"), std::string::npos);
  Payload heavier = kMarked;
  heavier.mass *= 1.05;
  heavier.inertiaCom *= 1.05;
  nlohmann::json next = passport(shortReport(heavier, 10), "2026-11-29");
  next["since"] = toJson(*changeSince(made, "old.json", next));
  EXPECT_NE(passportPage(next).find("The tool has changed: the difference exceeds the measurement uncertainty."),
            std::string::npos);
  EXPECT_NE(passportText(next).find("Since the passport of 2026-11-28: The tool has changed"), std::string::npos);
}

}  // namespace
}  // namespace heft
