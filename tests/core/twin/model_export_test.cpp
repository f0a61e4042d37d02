// The rig as found, in the simulators that read it: MuJoCo moves it along a recording, libsdformat loads it.
#include "core/twin/model_export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/motion/motion.h"
#include "core/payload/inertial_parameters.h"
#include "core/simulation/simulate.h"
#include "core/wrench/regressor.h"

#ifdef HEFT_WITH_MUJOCO
#include <mujoco/mujoco.h>
#endif
#ifdef HEFT_WITH_SDFORMAT
#include <sdf/sdf.hh>
#endif

namespace heft {
namespace {

using nlohmann::json;

const Payload kCarried{0.9, {0.01, -0.005, 0.07}, Vector3d(0.002, 0.0024, 0.0011).asDiagonal().toDenseMatrix()};

/// A diagnosis of a sensor that sits 25 mm beside its place and is turned by 0.05 rad, in a tilted world, late and with
/// a wrong gain. Its sizes are those of a heft.diagnose/1; nothing else of it is read.
json diagnosisOfARig() {
  const auto parameter = [](double value, const char* unit) {
    return json{{"value", value}, {"std", 0.1}, {"unit", unit}};
  };
  return {{"schema", "heft.diagnose/1"},
          {"verdict", "explained"},
          {"payload_after", toJson(kCarried)},
          {"sensor_mount", {{"parent", "panda_link8"}, {"xyz_m", {0.0, 0.01, 0.04}}, {"rpy_rad", {0.1, 0.2, -0.7}}}},
          {"gravity_m_s2", {0.0, 0.0, -9.81}},
          {"sensor_noise", {{"force_n", {0.05, 0.06, 0.04}}, {"torque_nm", {0.001, 0.002, 0.003}}}},
          {"model",
           {{"bias_and_parameters", {1.0, -2.0, 3.0, 0.1, -0.2, 0.3}},
            {"terms", {{{"cause", "time_offset"}, {"form", ""}, {"choice", json::array()}, {"values_si", {0.012}}}}}}},
          {"meta_changes",
           {{"gravity_m_s2", {0.3, -0.2, -9.8}},
            {"sensor", {{"mount", {{"xyz_m", {0.02, 0.01, 0.055}}, {"rpy_rad", {0.12, 0.24, -0.69}}}}}}}},
          {"causes",
           {{{"cause", "lever_arm"},
             {"title", "Sensor beside its place"},
             {"text", "The origin is 25 mm away."},
             {"parameters", {{"dx", parameter(20.0, "mm")}}}},
            {{"cause", "sensor_rotation"},
             {"title", "Sensor turned"},
             {"text", "It is turned."},
             {"parameters", {{"rx", parameter(1.0, "deg")}}}},
            {{"cause", "gravity_tilt"},
             {"title", "Base tilted"},
             {"text", "It is tilted."},
             {"parameters", {{"tilt_x", parameter(1.2, "deg")}}}},
            {{"cause", "time_offset"},
             {"title", "Late"},
             {"text", "The force readings arrive 12 ms late."},
             {"parameters", {{"delay", parameter(12.0, "ms")}}}},
            {{"cause", "gain_error"},
             {"title", "Gain"},
             {"text", "One channel reads 8 % too much."},
             {"parameters", {{"gain_fy", parameter(8.0, "%")}}}}}}};
}

ExportedModel exported(ModelTarget target, const std::vector<std::string>& without = {}) {
  ModelExportOptions options;
  options.without = without;
  auto model = exportModel(diagnosisOfARig(), "found.json", target, options);
  if (!model) throw std::runtime_error(model.error().message);
  return std::move(*model);
}

TEST(ModelExport, SaysWhatTheSimulatorKnowsAndWhatStandsAsNumbers) {
  const ExportedModel model = exported(ModelTarget::mujoco);
  std::vector<std::string> simulated, numbers;
  for (const auto& cause : model.causes) (cause.simulated ? simulated : numbers).push_back(cause.id);
  EXPECT_THAT(simulated, testing::ElementsAre("lever_arm", "sensor_rotation", "gravity_tilt"));
  EXPECT_THAT(numbers, testing::ElementsAre("time_offset", "gain_error"));
  EXPECT_THAT(model.text, testing::HasSubstr("heft_gain_error"));
  EXPECT_THAT(exported(ModelTarget::mujoco, {"gain_error"}).text, testing::Not(testing::HasSubstr("gain_error")));
}

TEST(ModelExport, JsonHoldsEverything) {
  const json model = json::parse(exported(ModelTarget::data).text);
  EXPECT_EQ(model["schema"], "heft.model/1");
  EXPECT_EQ(payloadFromJson(model, "rig.json")->mass, kCarried.mass);
  EXPECT_DOUBLE_EQ(model["delay_s"].get<double>(), 0.012);
  EXPECT_EQ(model["causes"].size(), 5u);
  EXPECT_EQ(model["causes"][4]["parameters"]["gain_fy"]["value"], 8.0);
  EXPECT_EQ(model["gravity_m_s2"], json({0.3, -0.2, -9.8}));
  EXPECT_EQ(model["terms"].size(), 1u);
  const json straight = json::parse(exported(ModelTarget::data, {"gravity_tilt", "time_offset"}).text);
  EXPECT_EQ(straight["gravity_m_s2"], json({0.0, 0.0, -9.81}));
  EXPECT_EQ(straight["delay_s"], 0.0);
  EXPECT_TRUE(straight["terms"].empty());
}

TEST(ModelExport, RefusesWhatIsNoDiagnosisAndWhatItDoesNotName) {
  const auto errorOf = [](const json& found, const std::vector<std::string>& without) {
    ModelExportOptions options;
    options.without = without;
    const auto model = exportModel(found, "found.json", ModelTarget::data, options);
    return model ? std::string() : model.error().message;
  };
  EXPECT_THAT(errorOf(toJson(kCarried), {}), testing::HasSubstr("heft diagnose"));
  EXPECT_THAT(errorOf(diagnosisOfARig(), {"cable_pull"}), testing::HasSubstr("cable_pull"));
  json old = diagnosisOfARig();
  old.erase("sensor_mount");
  EXPECT_THAT(errorOf(old, {}), testing::HasSubstr("where the sensor is mounted"));
  json impossible = diagnosisOfARig();
  impossible["payload_after"]["inertia_com_kgm2"][0][0] = 0.02;
  EXPECT_THAT(errorOf(impossible, {}), testing::HasSubstr("cannot exist"));
}

#if defined(HEFT_WITH_MUJOCO) || defined(HEFT_WITH_SDFORMAT)
/// A file of the test's own, gone when it ends.
class ModelFile {
 public:
  ModelFile(const std::string& name, const std::string& text)
      : path_(std::filesystem::path(testing::TempDir()) / ("heft_rig_" + name)) {
    std::ofstream(path_) << text;
  }
  ~ModelFile() { std::filesystem::remove(path_); }
  std::string name() const { return path_.string(); }

 private:
  std::filesystem::path path_;
};
#endif

#ifdef HEFT_WITH_MUJOCO
struct MujocoRig {
  std::unique_ptr<mjModel, void (*)(mjModel*)> model{nullptr, mj_deleteModel};
  std::unique_ptr<mjData, void (*)(mjData*)> data{nullptr, mj_deleteData};
};

MujocoRig loadInMujoco(const std::string& text) {
  const ModelFile file("rig.xml", text);
  std::array<char, 1000> error{};
  MujocoRig rig;
  rig.model.reset(mj_loadXML(file.name().c_str(), nullptr, error.data(), static_cast<int>(error.size())));
  if (!rig.model) throw std::runtime_error(error.data());
  rig.data.reset(mj_makeData(rig.model.get()));
  return rig;
}

Vector6d wristSensor(const MujocoRig& rig) {
  Vector6d out;
  Eigen::Index row = 0;
  for (const char* name : {"wrist_force", "wrist_torque"}) {
    const int id = mj_name2id(rig.model.get(), mjOBJ_SENSOR, name);
    for (int i = 0; i < 3; ++i) out(row++) = rig.data->sensordata[rig.model->sensor_adr[id] + i];
  }
  return out;
}

/// Moves the link that carries the sensor as a recording of joint angles says, and reads the wrist.
TEST(ModelExport, MujocoReadsAtTheWristWhatHeftPredicts) {
  SimulateOptions options;
  options.motion = MotionKind::free;
  options.seed = 12;
  options.duration = 4.0;
  options.rateHz = 250.0;
  const json found = diagnosisOfARig();
  options.mount.xyz = {0.0, 0.01, 0.04};
  options.mount.rpy = {0.1, 0.2, -0.7};
  const auto recorded = simulate(RobotModel::panda(), kCarried, options);
  ASSERT_TRUE(recorded);
  const auto motion = motionOf(recorded->recording, &RobotModel::panda(), MotionOptions{});
  ASSERT_TRUE(motion);
  const Isometry3d X_LS = poseFromXyzRpy(options.mount.xyz, options.mount.rpy);
  for (const bool asFound : {false, true}) {
    const std::vector<std::string> straight{"lever_arm", "sensor_rotation", "gravity_tilt"};
    const MujocoRig rig =
        loadInMujoco(exported(ModelTarget::mujoco, asFound ? std::vector<std::string>{} : straight).text);
    const Vector3d g = asFound ? Vector3d(0.3, -0.2, -9.8) : Vector3d(0.0, 0.0, -9.81);
    const Isometry3d X_ST =
        asFound ? X_LS.inverse() * poseFromXyzRpy({0.02, 0.01, 0.055}, {0.12, 0.24, -0.69}) : Isometry3d::Identity();
    double worst = 0.0, largest = 0.0;
    for (Eigen::Index k = 100; k < motion->size() - 100; k += 10) {
      const Matrix3d& R_BS = motion->R_BS[static_cast<std::size_t>(k)];
      const Vector3d omega = motion->omega.col(k), alpha = motion->alpha.col(k);
      // Acceleration of S's origin, base axes; then of the link's, which is -X_LS away.
      const Vector3d aS = R_BS * motion->specificForce.col(k) + Vector3d(0.0, 0.0, -9.81);
      const Vector3d r_S = X_LS.linear().transpose() * -X_LS.translation();  // S's origin to L's, S axes
      const Vector3d aL = aS + R_BS * (alpha.cross(r_S) + omega.cross(omega.cross(r_S)));
      const Matrix3d R_BL = R_BS * X_LS.linear().transpose();
      const Quaterniond q(R_BL);
      mjData* d = rig.data.get();
      const std::array<double, 7> pose{0, 0, 0, q.w(), q.x(), q.y(), q.z()};
      std::copy(pose.begin(), pose.end(), d->qpos);
      for (int i = 0; i < 3; ++i) {
        d->qvel[i] = 0.0;  // how fast it travels changes nothing
        d->qvel[3 + i] = (X_LS.linear() * omega)(i);
        d->qacc[i] = aL(i);
        d->qacc[3 + i] = (X_LS.linear() * alpha)(i);
      }
      mj_inverse(rig.model.get(), d);
      // Heft: in S's axes about S's origin, in this gravity; read by the sensor as found.
      const Vector3d s = R_BS.transpose() * (aS - g);
      const Vector6d F_S = regressor({s, omega, alpha}) * toParameters(kCarried);
      Vector6d F_T;
      F_T.head<3>() = X_ST.linear().transpose() * F_S.head<3>();
      F_T.tail<3>() = X_ST.linear().transpose() * (F_S.tail<3>() - X_ST.translation().cross(F_S.head<3>()));
      const Vector6d read = wristSensor(rig);
      worst = std::max({worst, (read - F_T).head<3>().norm(), 10.0 * (read - F_T).tail<3>().norm()});
      largest = std::max(largest, F_T.head<3>().norm());
    }
    EXPECT_GT(largest, 5.0);
    EXPECT_LT(worst, 1e-3 * largest) << (asFound ? "as found" : "as stated");
    const int gain = mj_name2id(rig.model.get(), mjOBJ_NUMERIC, "heft_gain_error");
    ASSERT_GE(gain, 0);
    EXPECT_EQ(rig.model->numeric_data[rig.model->numeric_adr[gain]], 8.0);
    EXPECT_EQ(rig.model->sensor_user[0], 0.012);
  }
}
#else
TEST(ModelExport, MujocoReadsAtTheWristWhatHeftPredicts) { GTEST_SKIP() << "libmujoco-dev is not installed"; }
#endif

#ifdef HEFT_WITH_SDFORMAT
TEST(ModelExport, LibsdformatLoadsSensorPayloadAndGravity) {
  const ModelFile file("rig.sdf", exported(ModelTarget::gazebo).text);
  sdf::Root root;
  const sdf::Errors errors = root.Load(file.name());
  ASSERT_TRUE(errors.empty()) << errors.front().Message();
  const sdf::World* world = root.WorldByIndex(0);
  ASSERT_NE(world, nullptr);
  EXPECT_EQ(world->Gravity(), ignition::math::Vector3d(0.3, -0.2, -9.8));
  const sdf::Model* model = world->ModelByIndex(0);
  EXPECT_DOUBLE_EQ(model->LinkByName("tool")->Inertial().MassMatrix().Mass(), kCarried.mass);
  const sdf::Joint* wrist = model->JointByName("wrist");
  ASSERT_EQ(wrist->SensorCount(), 1u);
  const sdf::ForceTorque* sensor = wrist->SensorByIndex(0)->ForceTorqueSensor();
  ASSERT_NE(sensor, nullptr);
  EXPECT_EQ(sensor->Frame(), sdf::ForceTorqueFrame::SENSOR);
  EXPECT_EQ(sensor->MeasureDirection(), sdf::ForceTorqueMeasureDirection::PARENT_TO_CHILD);
  EXPECT_DOUBLE_EQ(sensor->ForceYNoise().Mean(), -2.0);
  EXPECT_DOUBLE_EQ(sensor->TorqueZNoise().StdDev(), 0.003);
  // Where the sensor was found, against the payload.
  ignition::math::Pose3d found;
  ASSERT_TRUE(wrist->SemanticPose().Resolve(found, "tool").empty());
  const Isometry3d X_ST = poseFromXyzRpy({0.0, 0.01, 0.04}, {0.1, 0.2, -0.7}).inverse() *
                          poseFromXyzRpy({0.02, 0.01, 0.055}, {0.12, 0.24, -0.69});
  EXPECT_LT((Vector3d(found.Pos().X(), found.Pos().Y(), found.Pos().Z()) - X_ST.translation()).norm(), 1e-9);
  const auto& q = found.Rot();
  EXPECT_LT((Quaterniond(q.W(), q.X(), q.Y(), q.Z()).toRotationMatrix() - X_ST.linear()).norm(), 1e-9);
}
#else
TEST(ModelExport, LibsdformatLoadsSensorPayloadAndGravity) { GTEST_SKIP() << "libsdformat-dev is not installed"; }
#endif

}  // namespace
}  // namespace heft
