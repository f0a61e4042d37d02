#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/payload/stated_payload.h"

namespace heft {
namespace {

using nlohmann::json;
using testing::HasSubstr;

TEST(StatedPayload, ScaleMassIsReadInEveryForm) {
  EXPECT_DOUBLE_EQ(*parseScaleMass("0.812")->mass, 0.812);
  EXPECT_DOUBLE_EQ(parseScaleMass("0.812")->massStd, 0.005);
  EXPECT_DOUBLE_EQ(parseScaleMass("0.8+-0.004")->massStd, 0.005);
  EXPECT_DOUBLE_EQ(parseScaleMass("0.8\u00b10.004")->massStd, 0.005);
  EXPECT_DOUBLE_EQ(parseScaleMass("0.8+-1%")->massStd, 0.01);
  for (const char* text : {"", "kg", "-1", "0", "1e999", "nan", "0.8+", "0.8+-", "0.8+-x", "0.8+-0", "0.8+-200%",
                           "0.8+-1%%", "0.8 kg", "0.8+--0.1"})
    EXPECT_FALSE(parseScaleMass(text)) << text;
  EXPECT_THAT(parseScaleMass("0.8 kg").error().message, HasSubstr("0.812+-0.004"));
}

json box() {
  return {{"mass_kg", 2.0},
          {"com_m", {0.0, 0.01, 0.05}},
          {"inertia_com_kgm2", {{0.013, 0.0, 0.0}, {0.0, 0.010, 0.0}, {0.0, 0.0, 0.005}}}};
}

TEST(StatedPayload, ShapeIsTheSpreadOfTheMass) {
  const auto stated = statedPayloadFromJson({{"payload", box()}, {"certainty", "good"}}, "cad.json");
  ASSERT_TRUE(stated.ok());
  // Of a box of 2 kg with these moments: (Iyy + Izz - Ixx) / 2 / m along x and so on.
  EXPECT_NEAR((*stated->spread)(0, 0), 0.001 / 2.0, 2e-6);
  EXPECT_NEAR((*stated->spread)(2, 2), 0.009 / 2.0, 2e-6);
  EXPECT_EQ(stated->massStd, 0.03);
  EXPECT_EQ(stated->source, "cad.json");
}

TEST(StatedPayload, WeightsCountPartsMoreOrLessOrNotAtAll) {
  json cad = box();
  cad["weights"] = {{"mass", 0}, {"shape", 4}};
  const auto stated = statedPayloadFromJson(cad, "cad.json");
  ASSERT_TRUE(stated.ok());
  EXPECT_FALSE(stated->mass);
  EXPECT_DOUBLE_EQ(stated->centreStd, 0.30);
  EXPECT_DOUBLE_EQ(stated->shapeStd, 0.10);
}

TEST(StatedPayload, NonsenseIsAnsweredWithASentence) {
  const auto message = [](json cad) {
    const auto stated = statedPayloadFromJson(cad, "cad.json");
    return stated ? std::string("accepted") : stated.error().message;
  };
  json cad = box();
  cad.erase("mass_kg");
  EXPECT_THAT(message(cad), HasSubstr("needs mass_kg"));
  cad = box();
  cad["inertia_com_kgm2"][0][0] = 0.03;
  EXPECT_THAT(message(cad), HasSubstr("physically impossible"));
  cad = box();
  cad["weights"] = {{"mass", -1}};
  EXPECT_THAT(message(cad), HasSubstr("weights"));
  cad["weights"] = {{"colour", 1}};
  EXPECT_THAT(message(cad), HasSubstr("weights"));
  cad["weights"] = {{"mass", 0}, {"centre", 0}, {"shape", 0}};
  EXPECT_THAT(message(cad), HasSubstr("nothing is left"));
  cad = box();
  cad["certainty"] = "sure";
  EXPECT_THAT(message(cad), HasSubstr("rough"));
  EXPECT_THAT(message(json::object()), HasSubstr("at least one"));
  EXPECT_THAT(message(json::array()), HasSubstr("object"));
}

}  // namespace
}  // namespace heft
