// Names and units of arriving numbers, as in recordings.
#include <gtest/gtest.h>

#include <numbers>

#include "core/live/field_mapper.h"

namespace heft {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

std::vector<std::string> joints(const std::string& before, const std::string& after) {
  std::vector<std::string> out;
  for (int j = 1; j <= 7; ++j) out.push_back(before + std::to_string(j) + after);
  return out;
}

/// Angles of 1 to 7 and a wrench of 1 to 6 in whatever units `wrench` and `angles` name.
LiveSample mapped(std::vector<std::string> angles, const std::vector<std::string>& wrench,
                  const Conventions& conventions = {}) {
  std::vector<double> values = {1, 2, 3, 4, 5, 6, 7, 1, 2, 3, 4, 5, 6};
  angles.insert(angles.end(), wrench.begin(), wrench.end());
  FieldMapper mapper({}, conventions);
  const auto sample = mapper.map("", "", angles, values);
  EXPECT_TRUE(sample && sample->q && sample->wrench) << wrench[0];
  return sample.value_or(LiveSample{});
}

TEST(FieldMapper, UnitsInNamesHold) {
  struct Case {
    std::vector<std::string> names;
    double force, torque;
  };
  const std::vector<Case> cases = {
      {{"fx_N", "fy_N", "fz_N", "tx_Nm", "ty_Nm", "tz_Nm"}, 1.0, 1.0},
      {{"Fx (N)", "Fy (N)", "Fz (N)", "Tx (N mm)", "Ty (N mm)", "Tz (N mm)"}, 1.0, 1e-3},
      {{"fx_N", "fy_N", "fz_N", "tx_N_mm", "ty_N_mm", "tz_N_mm"}, 1.0, 1e-3},
      {{"force_kgf_x", "force_kgf_y", "force_kgf_z", "torque_nm_x", "torque_nm_y", "torque_nm_z"}, 9.80665, 1.0},
      {{"force_kgf[0]", "force_kgf[1]", "force_kgf[2]", "torque_kgf_cm[0]", "torque_kgf_cm[1]", "torque_kgf_cm[2]"},
       9.80665,
       0.0980665},
      {{"force_n.x", "force_n.y", "force_n.z", "torque_nm.x", "torque_nm.y", "torque_nm.z"}, 1.0, 1.0},
      {{"Fx [kg]", "Fy [kg]", "Fz [kg]", "Mx [Nm]", "My [Nm]", "Mz [Nm]"}, 9.80665, 1.0},
      {{"fx_lbf", "fy_lbf", "fz_lbf", "tx_lbf_in", "ty_lbf_in", "tz_lbf_in"}, 4.4482216, 0.1129848}};
  for (const auto& each : cases) {
    const auto sample = mapped(joints("q", "_deg"), each.names);
    for (int a = 0; a < 3; ++a) {
      EXPECT_NEAR((*sample.wrench)(a), each.force * (a + 1), 1e-6) << each.names[0];
      EXPECT_NEAR((*sample.wrench)(a + 3), each.torque * (a + 4), 1e-6) << each.names[3];
    }
    for (std::size_t j = 0; j < 7; ++j) EXPECT_NEAR((*sample.q)[j], kDegree * static_cast<double>(j + 1), 1e-12);
  }
}

TEST(FieldMapper, ANameStandsBeforeAStatedUnitWhichIsUndoneLater) {
  Conventions stated;
  stated.radPerAngle = kDegree;
  stated.torque.si = 1e-3;
  const std::vector<std::string> named = {"fx", "fy", "fz", "tx_Nm", "ty_Nm", "tz_Nm"};
  const auto radians = mapped(joints("q", "_rad"), named, stated);
  EXPECT_NEAR((*radians.q)[0] * stated.radPerAngle, 1.0, 1e-12);
  EXPECT_NEAR((*radians.wrench)(3) * stated.torque.si, 4.0, 1e-12);
  const auto plain = mapped(joints("q", ""), {"fx", "fy", "fz", "tx", "ty", "tz"}, stated);
  EXPECT_EQ((*plain.q)[0], 1.0) << "what is stated is undone by PlainSamples";
  EXPECT_EQ((*plain.wrench)(3), 4.0);
}

}  // namespace
}  // namespace heft
