// What a tool carries: the difference of a recording with it and one without.
#include "core/estimation/carried_object.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <random>

#include "core/estimation/picked_up.h"
#include "core/estimation/uncertainty.h"
#include "core/simulation/simulate.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

const Payload kGripper = test::boxPayload(0.8, {0.08, 0.10, 0.12}, {0.01, -0.005, 0.06});
/// A box between the fingers.
const Payload kBox = test::boxPayload(0.35, {0.05, 0.06, 0.09}, {0.005, 0.01, 0.16});

Recording demonstration(const Payload& payload, unsigned seed, double speed = 1.0) {
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.seed = seed;
  options.duration = 8.0;
  options.rateHz = 250.0;
  options.speed = speed;
  auto simulated = simulate(RobotModel::panda(), payload, options);
  simulated->recording.file = "recording " + std::to_string(seed);
  return std::move(simulated->recording);
}

CarriedObject carriedBetween(const Recording& with, const Recording& without) {
  auto carried = estimateCarriedObject({&with, &RobotModel::panda()}, {&without, &RobotModel::panda()}, {});
  if (!carried) throw std::runtime_error(carried.error().message);
  return *carried;
}

/// Picked up, carried and put down again: both sides come from the parts between, and the moments belong to neither.
TEST(PickedUp, PartsWithAndWithoutAreFoundInOneRecording) {
  const RobotModel& panda = RobotModel::panda();
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.seed = 77;
  options.duration = 24.0;
  options.rateHz = 250.0;
  Recording both = simulate(panda, kGripper, options)->recording;
  const Recording heavy = simulate(panda, composed(kGripper, kBox), options)->recording;
  ASSERT_EQ((both.q - heavy.q).norm(), 0.0) << "the same motion and noise";
  for (Eigen::Index i = 0; i < both.rows(); ++i)
    if (both.time(i) > 7.0 && both.time(i) < 16.0) both.wrench.row(i) = heavy.wrench.row(i);
  const auto parts = partsWithAndWithout(both, &panda, {});
  ASSERT_TRUE(parts) << parts.error().message;
  ASSERT_EQ(parts->pickedUpAt.size(), 1u);
  ASSERT_EQ(parts->putDownAt.size(), 1u);
  EXPECT_NEAR(parts->pickedUpAt[0], 7.0, 0.3);
  EXPECT_NEAR(parts->putDownAt[0], 16.0, 0.3);
  EstimateOptions automatic;
  automatic.segments = SegmentMode::automatic;
  const auto carried = estimateCarriedObject({&parts->with, &panda}, {&parts->without, &panda}, automatic);
  ASSERT_TRUE(carried);
  EXPECT_EQ(carried->verdict, ObjectVerdict::found);
  EXPECT_NEAR(carried->object.payload.mass, kBox.mass, 4.0 * carried->object.std.mass);
  EXPECT_LT((carried->object.payload.com - kBox.com).norm(), 0.004);
  EXPECT_FALSE(partsWithAndWithout(heavy, &panda, {})) << "nothing changes in it";
}

/// How often the intervals hold the object's numbers, and how large its errors are beside their standard deviations.
TEST(CarriedObject, IntervalsHoldTheObjectAsOftenAsTheySay) {
  constexpr int kPairs = 16;
  Vector10d inside = Vector10d::Zero(), ratio = Vector10d::Zero();
  for (unsigned pair = 0; pair < kPairs; ++pair) {
    std::mt19937 random(4100 + pair);
    const Payload tool = test::randomTool(random).payload;
    Payload object = test::randomTool(random).payload;
    object.com.z() += 0.08;
    const auto carried =
        carriedBetween(demonstration(composed(tool, object), 2 * pair + 500), demonstration(tool, 2 * pair + 501));
    ASSERT_EQ(carried.verdict, ObjectVerdict::found);
    EXPECT_TRUE(carried.object.physicallyConsistent);
    const Vector10d truth = componentsOf(object);
    const auto& i95 = carried.object.interval95;
    const auto& I = i95.inertiaCom;
    const Interval intervals[10] = {i95.mass, i95.com[0], i95.com[1], i95.com[2], I[0][0],
                                    I[0][1],  I[0][2],    I[1][1],    I[1][2],    I[2][2]};
    for (int k = 0; k < 10; ++k)
      inside(k) += truth(k) >= intervals[k].lower && truth(k) <= intervals[k].upper ? 1.0 : 0.0;
    ratio += (truth - componentsOf(carried.object.payload)).cwiseQuotient(componentsOf(carried.object.std)).cwiseAbs2();
  }
  inside /= kPairs;
  ratio /= kPairs;
  // 95 % of 160 numbers that hang together: about 64 independent ones, two and a half deviations are 7 %.
  EXPECT_GE(inside.mean(), 0.88) << inside.transpose();
  EXPECT_GE(inside.head<4>().mean(), 0.85) << inside.transpose();
  EXPECT_GT(ratio.mean(), 0.5) << ratio.transpose();
  EXPECT_LT(ratio.mean(), 1.5) << ratio.transpose();
}

TEST(CarriedObject, IsTheDifferenceWithTheNoiseOfBoth) {
  const auto carried = carriedBetween(demonstration(composed(kGripper, kBox), 11), demonstration(kGripper, 12));
  EXPECT_NEAR(carried.object.payload.mass, kBox.mass, 0.003);
  EXPECT_LT((carried.object.payload.com - kBox.com).norm(), 0.003);
  EXPECT_NEAR(carried.object.payload.mass, carried.with.payload.mass - carried.without.payload.mass, 2e-4);
  const double both = std::hypot(carried.with.std.mass, carried.without.std.mass);
  EXPECT_NEAR(carried.object.std.mass, both, 0.1 * both);
  EXPECT_EQ(carried.object.identifiability.mass, Source::data);

  const auto json = toJson(carried);
  EXPECT_EQ(json["schema"], "heft.estimate/1");
  EXPECT_EQ(json["object"]["verdict"], "found");
  EXPECT_EQ(json["object"]["mass_kg"].get<double>(), carried.object.payload.mass);
  EXPECT_EQ(json["object"]["interval95"]["com_m"].size(), 3u);
  EXPECT_EQ(json["without"]["payload"]["mass_kg"].get<double>(), carried.without.payload.mass);
  EXPECT_THAT(toText(carried), testing::StartsWith("The object weighs 0.3"));
}

TEST(CarriedObject, NothingCarriedIsNotToldFromNothing) {
  int seen = 0;
  for (unsigned seed = 0; seed < 6; ++seed) {
    const auto carried = carriedBetween(demonstration(kGripper, 900 + seed), demonstration(kGripper, 950 + seed));
    if (carried.verdict != ObjectVerdict::nothing) {
      ++seen;
      continue;
    }
    EXPECT_THAT(toText(carried), testing::StartsWith("No object detected"));
    EXPECT_TRUE(toJson(carried)["object"]["com_m"].is_null());
    EXPECT_TRUE(toJson(carried)["object"]["mass_kg"].is_number());
  }
  EXPECT_LE(seen, 1) << "one in a hundred may be seen where nothing is";
}

TEST(CarriedObject, ExchangedRecordingsAreSaid) {
  const auto carried = carriedBetween(demonstration(kGripper, 12), demonstration(composed(kGripper, kBox), 11));
  EXPECT_EQ(carried.verdict, ObjectVerdict::negative);
  EXPECT_EQ(carried.object.trust, Trust::none);
  EXPECT_THAT(toText(carried), testing::HasSubstr("Swap the two recordings"));
}

TEST(CarriedObject, OtherMountsAreRefusedAndOtherSensorsAreSaid) {
  const Recording with = demonstration(composed(kGripper, kBox), 11);
  Recording without = demonstration(kGripper, 12);
  without.meta.sensorModel = "another";
  EXPECT_EQ(carriedBetween(with, without).object.trust, Trust::low);
  without.meta.mount.xyz.z() += 0.01;
  const auto refused = estimateCarriedObject({&with, &RobotModel::panda()}, {&without, &RobotModel::panda()}, {});
  ASSERT_FALSE(refused);
  EXPECT_THAT(refused.error().message, testing::HasSubstr("differs by 10.00 mm"));
}

TEST(CarriedObject, TrustIsTheWorseOfTheTwo) {
  const Recording with = demonstration(composed(kGripper, kBox), 11);
  Recording without = demonstration(kGripper, 12);
  without.wrench.rightCols<3>() *= -1.0;  // another sign than stated
  const auto carried = carriedBetween(with, without);
  EXPECT_EQ(carried.with.trust, Trust::good);
  EXPECT_EQ(carried.object.trust, Trust::none);
  EXPECT_EQ(carried.object.identifiability.mass, Source::none);
  EXPECT_THAT(toText(carried), testing::StartsWith("The object cannot be weighed. recording 12:"));
}

}  // namespace
}  // namespace heft
