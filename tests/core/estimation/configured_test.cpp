// What the controller was told stands beside the estimate.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/estimation/estimate.h"
#include "tests/support/estimation_fixtures.h"

namespace heft {
namespace {

TEST(ConfiguredPayloadBesideTheEstimate, SaysByHowMuchItDiffers) {
  Recording recording = test::recordingOf(MotionKind::excitation,
                                          {0.8, {0.01, 0.0, 0.05}, Vector3d(0.001, 0.0012, 0.0008).asDiagonal()}, 5);
  recording.configured = ConfiguredPayload{{1.1, Vector3d(0.0, 0.0, 0.1), std::nullopt}, "m_total", "link8", false};
  const auto report = estimate(recording, &RobotModel::panda(), {}).value();
  const auto json = toJson(report);
  const double mass = report.payload.mass;
  EXPECT_EQ(json["configured"]["payload"]["mass_kg"], 1.1);
  EXPECT_NEAR(json["configured"]["difference"]["mass_kg"].get<double>(), 1.1 - mass, 1e-12);
  const Payload onFlange =
      transformed(report.payload, poseFromXyzRpy(recording.meta.mount.xyz, recording.meta.mount.rpy));
  EXPECT_NEAR(json["configured"]["difference"]["com_m"][2].get<double>(), 0.1 - onFlange.com.z(), 1e-12);
  const auto found = std::find_if(report.findings.begin(), report.findings.end(),
                                  [](const Finding& f) { return f.code == "configured_payload"; });
  ASSERT_NE(found, report.findings.end());
  EXPECT_THAT(found->text, testing::HasSubstr("1.100 kg (m_total)"));

  // In the axes of another flange the centre is not compared.
  recording.configured->flange = "tool0";
  EXPECT_FALSE(
      toJson(estimate(recording, &RobotModel::panda(), {}).value())["configured"]["difference"].contains("com_m"));
  recording.configured.reset();
  EXPECT_FALSE(toJson(estimate(recording, &RobotModel::panda(), {}).value()).contains("configured"));
}

}  // namespace
}  // namespace heft
