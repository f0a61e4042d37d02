// A controller's payload, read back from what Heft writes.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/exporters/controller_file.h"
#include "core/exporters/exporter.h"

namespace heft {
namespace {

Payload example() {
  Payload payload;
  payload.mass = 0.8;
  payload.com = {0.005, -0.01, 0.06};
  payload.inertiaCom << 2.1e-3, 1e-4, -2e-4, 1e-4, 1.9e-3, 3e-4, -2e-4, 3e-4, 1.2e-3;
  return payload;
}

void expectSame(const Result<Payload>& read, const Payload& written) {
  ASSERT_TRUE(read) << read.error().message;
  EXPECT_NEAR(read->mass, written.mass, 1e-5);
  EXPECT_TRUE(read->com.isApprox(written.com, 1e-4));
  EXPECT_TRUE(read->inertiaCom.isApprox(written.inertiaCom, 1e-4));
}

TEST(ControllerFile, ReadsWhatFrankaReads) {
  for (const char* id : {"franka-desk", "franka-profile"}) {
    const ExportFormat* format = findExportFormat(id);
    ASSERT_TRUE(format) << id;
    Findings findings;
    ExportInput input;
    input.payload = example();
    const auto text = exportPayload(*format, input, findings);
    ASSERT_TRUE(text);
    expectSame(controllerPayloadFromJson(nlohmann::json::parse(*text), id), example());
  }
}

TEST(ControllerFile, PlacesAResultOnTheFlangeAndTakesAPayloadAsItStands) {
  expectSame(controllerPayloadFromJson(toJson(example()), "payload.json"), example());
  const nlohmann::json mount{{"parent", "panda_link8"}, {"xyz_m", {0.0, 0.0, 0.05}}, {"rpy_rad", {0.0, 0.0, 0.5}}};
  const nlohmann::json result{{"schema", "heft.estimate/1"}, {"payload", toJson(example())}, {"sensor_mount", mount}};
  expectSame(controllerPayloadFromJson(result, "result.json"),
             transformed(example(), poseFromXyzRpy({0, 0, 0.05}, {0, 0, 0.5})));
}

TEST(ControllerFile, RefusesOtherFilesInOneSentence) {
  for (const char* text : {"[]", "3", "{}", R"({"schema":"heft.diagnose/1"})", R"({"mass":1,"centerOfMass":[0,0]})",
                           R"({"mass":-1,"centerOfMass":[0,0,0],"inertia":[1,0,0,0,1,0,0,0,1]})",
                           R"({"mass":1,"centerOfMass":[0,0,0],"inertia":[1,2,0,0,1,0,0,0,1]})",
                           R"({"inertial":{"mass":1,"centerOfMass":{"x":0,"y":0,"z":"a"}}})"}) {
    const auto read = controllerPayloadFromJson(nlohmann::json::parse(text), "desk.json");
    ASSERT_FALSE(read) << text;
    EXPECT_NE(read.error().message.find("desk.json"), std::string::npos) << read.error().message;
  }
}

}  // namespace
}  // namespace heft
