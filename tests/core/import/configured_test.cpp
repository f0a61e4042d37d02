// What a controller was told that it carries, by the names of UR's and Franka's fields.
#include <gtest/gtest.h>

#include <cmath>

#include "core/import/configured.h"

namespace heft {
namespace {

/// Each field with its values over the samples.
Stream told(const std::vector<std::pair<std::string, std::vector<double>>>& fields) {
  Stream out;
  out.name = "/state";
  for (const auto& [name, values] : fields) {
    out.fields.push_back(name);
    out.values.push_back(values);
  }
  return out;
}

TEST(ConfiguredPayload, UrsFieldsInEveryWayOfWritingTheirIndex) {
  for (const std::string form : {"payload_cog_{}", "payload_cog[{}]", "/rtde/payload_cog[{}]", "ur.payload_cog_{}"}) {
    const auto cog = [&](const char* index) {
      std::string name = form;
      return name.replace(name.find("{}"), 2, index);
    };
    const Stream stream = told({{"payload", {0.0, 1.1, 1.1}},
                                {cog("0"), {0.0, 0.01, 0.01}},
                                {cog("1"), {0.0, 0.02, 0.02}},
                                {cog("2"), {0.0, 0.06, 0.06}}});
    for (std::size_t f = 0; f < 4; ++f) EXPECT_TRUE(tellsConfiguredPayload(stream, f)) << stream.fields[f];
    const auto found = configuredPayload({stream});
    ASSERT_TRUE(found) << form;
    EXPECT_EQ(*found->payload.mass, 1.1);  // what held longest
    EXPECT_TRUE(found->changed);
    ASSERT_TRUE(found->payload.com);
    EXPECT_EQ(*found->payload.com, Vector3d(0.01, 0.02, 0.06));
    EXPECT_FALSE(found->payload.inertiaCom);
    EXPECT_EQ(found->flange, "tool0");
  }
}

TEST(ConfiguredPayload, AColumnThatHappensToBeCalledPayloadIsNone) {
  EXPECT_FALSE(configuredPayload({told({{"payload", {1.0, 1.0}}, {"fx", {0.0, 0.0}}})}));
  EXPECT_TRUE(configuredPayload({told({{"payload", {1.0, 1.0}}, {"actual_q_0", {0.0, 0.0}}})}));
  EXPECT_FALSE(configuredPayload({told({{"m_total", {-1.0}}})}));
  EXPECT_FALSE(configuredPayload({told({{"m_total", {std::nan("")}}})}));
  EXPECT_FALSE(configuredPayload({told({{"m_load", {1.0}}})}));  // of which hand?
}

TEST(ConfiguredPayload, FrankasHandAndLoadAreOneBody) {
  const auto found = configuredPayload({told({{"m_ee", {0.7}},
                                              {"F_x_Cee[0]", {0.0}},
                                              {"F_x_Cee[1]", {0.0}},
                                              {"F_x_Cee[2]", {0.03}},
                                              {"m_load", {0.3}},
                                              {"F_x_Cload[0]", {0.0}},
                                              {"F_x_Cload[1]", {0.1}},
                                              {"F_x_Cload[2]", {0.13}}})});
  ASSERT_TRUE(found && found->payload.com);
  EXPECT_DOUBLE_EQ(*found->payload.mass, 1.0);
  EXPECT_NEAR(found->payload.com->y(), 0.03, 1e-15);
  EXPECT_NEAR(found->payload.com->z(), 0.06, 1e-15);
  EXPECT_EQ(found->source, "m_ee + m_load");
  EXPECT_EQ(found->flange, "link8");
}

TEST(ConfiguredPayload, FrankasTotalCountsWhereItIsTold) {
  std::vector<std::pair<std::string, std::vector<double>>> fields = {{"inertia_ee.inertia.m", {0.7}},
                                                                     {"inertia_total.inertia.m", {0.9}}};
  for (const char* entry : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"})
    fields.push_back({std::string("inertia_total.inertia.") + entry, {std::string(entry) == "iyz" ? 0.5 : 2.0}});
  const auto found = configuredPayload({told(fields)});
  ASSERT_TRUE(found && found->payload.inertiaCom);
  EXPECT_EQ(*found->payload.mass, 0.9);
  EXPECT_EQ((*found->payload.inertiaCom)(2, 1), 0.5);
  EXPECT_FALSE(found->payload.com);
}

}  // namespace
}  // namespace heft
