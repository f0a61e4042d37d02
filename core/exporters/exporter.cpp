#include "core/exporters/exporter.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/exporters/writing.h"

namespace heft {

namespace {

constexpr double kPandaPayload = 3.0;      // [kg], the Panda's rated payload
constexpr double kUrInertiaLimit = 133.0;  // [kg m2], of each entry of set_target_payload

/// Possible without any tolerance, so that a reader that allows none (MuJoCo) takes it too.
bool strictlyPhysical(const Matrix3d& I) {
  Vector3d moments = I.diagonal();
  const bool diagonal = I(0, 1) == 0.0 && I(0, 2) == 0.0 && I(1, 2) == 0.0;
  // Readers of a diagonal tensor add two of these very numbers; others turn it first, which costs some bits.
  const double slack = diagonal ? 0.0 : 1e-11;
  if (!diagonal) moments = Eigen::SelfAdjointEigenSolver<Matrix3d>(I, Eigen::EigenvaluesOnly).eigenvalues();
  std::sort(moments.begin(), moments.end());
  return moments(0) > 0.0 && moments(0) + moments(1) >= moments(2) * (1.0 + slack);
}

Matrix3d roundedInertia(const Matrix3d& inertia) {
  const Matrix3d I = 0.5 * (inertia + inertia.transpose());
  const int coarse = decimalsFor(I.cwiseAbs().maxCoeff());
  constexpr int kFiner = 4;
  for (int decimals = coarse; decimals <= coarse + kFiner; decimals += 2) {
    Matrix3d rounded = I.unaryExpr([&](double v) { return roundedTo(v, decimals); });
    if (strictlyPhysical(rounded)) return rounded;
  }
  // A plate or a rod on the border of the possible: a few last places more about every axis. Rounding moves the
  // triangle inequality by 4.5 steps at most, adding k steps mends k of them.
  const double step = std::pow(10.0, -(coarse + kFiner));
  Matrix3d rounded = I;
  for (int k = 1; k <= 8; ++k) {
    rounded = (I + k * step * Matrix3d::Identity()).unaryExpr([&](double v) { return roundedTo(v, coarse + kFiner); });
    if (strictlyPhysical(rounded)) break;
  }
  return rounded;
}

void addWarning(Findings& findings, std::string code, std::string text, std::string remedy) {
  findings.push_back({Severity::warning, std::move(code), std::move(text), std::move(remedy), {}});
}

/// What files for a sensor's driver leave out, or cannot know.
void addSensorFindings(const ExportFormat& format, const ExportInput& input, Findings& findings) {
  const bool named = format.write == writeRos2Control || format.write == writeForceTorqueTools;
  const bool biased = format.write == writeForceTorqueTools || format.write == writeMcRtc;
  if (named || biased || format.write == writeXarm)
    findings.push_back(
        {Severity::info, "inertia_left_out", heft::say("This format has no inertia: it is left out."), {}, {}});
  if (named && (!input.sensor || input.sensor->frame.empty()))
    findings.push_back({Severity::info,
                        "sensor_frame_unset",
                        heft::say("The sensor's frame is called ft_sensor."),
                        heft::say("Use the name that it has on your robot."),
                        {}});
  if (biased && (!input.sensor || !input.sensor->bias))
    addWarning(findings, "bias_unknown", heft::say("A payload without an estimate has no bias; zeros are written."),
               heft::say("Zero the sensor with the tool off."));
}

/// What this format does to this payload that the user would not expect.
void addFormatFindings(const ExportFormat& format, const ExportInput& input, Findings& findings) {
  const Payload& payload = input.payload;
  if (format.heaviest > 0.0 && payload.mass > format.heaviest)
    addWarning(findings, "payload_limit",
               heft::say("The payload weighs {:.3f} kg; the robot is rated for {} kg.", payload.mass, format.heaviest),
               heft::say("Check the recording's frame and sign, or use a lighter tool."));
  if (format.write == writeUr && payload.inertiaCom.cwiseAbs().maxCoeff() > kUrInertiaLimit)
    addWarning(findings, "inertia_limit",
               heft::say("An inertia entry is {:.4g} kg m2; set_target_payload accepts at most {} kg m2.",
                         payload.inertiaCom.cwiseAbs().maxCoeff(), kUrInertiaLimit),
               heft::say("Check the units of the inertia."));
  if (format.write == writeFanuc) {
    const Matrix3d& I = payload.inertiaCom;
    const double lost = std::max({std::abs(I(0, 1)), std::abs(I(0, 2)), std::abs(I(1, 2))});
    if (lost > 0.02 * I.diagonal().maxCoeff())
      addWarning(findings, "products_of_inertia_lost",
                 heft::say("This format has no products of inertia; up to {:.3g} kg m2 are left out.", lost), {});
  }
  addSensorFindings(format, input, findings);
  if (carriesTool(format) && input.X_FE.matrix().isIdentity(1e-12))
    findings.push_back({Severity::info,
                        "tool_centre_unset",
                        heft::say("The tool centre point is written at the flange."),
                        heft::say("Set it in Desk, or specify it before exporting."),
                        {}});
  if (format.write == writeFrankaProfile && !input.X_FE.linear().isIdentity(1e-9))
    addWarning(findings, "tool_rotation_lost",
               heft::say("The tool's rotation is left out: this format's angle unit is not known."),
               heft::say("Set the rotation in Desk."));
  if (!format.unverified.empty())
    addWarning(findings, "format_unverified",
               heft::say("Not checked against a primary source: {}.", heft::say(fmt::runtime(format.unverified))),
               heft::say("Compare the file with one that your controller wrote."));
}

}  // namespace

const std::vector<ExportFormat>& exportFormats() {
  static const std::vector<ExportFormat> formats = {
      {"franka-desk", "Franka Desk end effector (JSON)", ".json", writeFrankaDesk, {}, kPandaPayload},
      {"franka-profile", "Franka end-effector profile (JSON)", ".endeffector-profile.json", writeFrankaProfile,
       heft::toSay("the format of the profile and the unit of its angles (zeros are written)"), kPandaPayload},
      {"libfranka", "libfranka setLoad (C++)", ".h", writeLibfranka, {}, kPandaPayload},
      {"franka-ros", "franka_ros set_load request (YAML)", ".yaml", writeFrankaRos, {}, kPandaPayload},
      {"franka-ros2", "franka_ros2 set_load request (YAML)", ".yaml", writeFrankaRos2,
       heft::toSay("the name of the service, /service_server/set_load"), kPandaPayload},
      {"urdf", "URDF link", ".urdf", writeUrdf},
      {"sdf", "SDFormat model", ".sdf", writeSdf},
      {"mjcf", "MuJoCo body", ".xml", writeMjcf},
      {"ur", "Universal Robots set_target_payload (URScript)", ".script", writeUr},
      {"kuka", "KUKA LOAD_DATA (KRL)", ".dat", writeKuka,
       heft::toSay("the syntax of the line (its units and angles are)")},
      {"abb", "ABB loaddata (RAPID)", ".mod", writeAbb},
      {"fanuc", "FANUC payload schedule, to type in", ".txt", writeFanuc,
       heft::toSay("the unit of the inertia, kgf cm s2")},
      {"xarm", "UFACTORY xArm set_tcp_load (Python)", ".py", writeXarm,
       heft::toSay("that the centre of mass counts from the flange")},
      {"ros2-control", "ros2_control gravity compensation filter (YAML)", ".yaml", writeRos2Control},
      {"force-torque-tools", "force_torque_tools calibration (YAML)", ".yaml", writeForceTorqueTools},
      {"mc-rtc", "mc_rtc force sensor calibration", ".calib", writeMcRtc},
      {"json", "Heft payload (JSON)", ".json", writeJson},
  };
  return formats;
}

bool carriesTool(const ExportFormat& format) {
  return format.write == writeFrankaDesk || format.write == writeFrankaProfile;
}

const ExportFormat* findExportFormat(std::string_view id) {
  for (const ExportFormat& format : exportFormats())
    if (format.id == id) return &format;
  return nullptr;
}

Payload roundedForExport(const Payload& payload) {
  Payload rounded;
  rounded.mass = roundedTo(payload.mass, std::max(5, decimalsFor(payload.mass)));
  rounded.com = payload.com.unaryExpr([](double v) { return roundedTo(v, 6); });
  rounded.inertiaCom = roundedInertia(payload.inertiaCom);
  return rounded;
}

Result<std::string> exportPayload(const ExportFormat& format, const ExportInput& input, Findings& findings) {
  const Consistency consistency = checkPhysical(input.payload);
  if (!consistency.physical)
    return Error{heft::say("This payload cannot exist, so no {} file is written: {}", format.id, consistency.reason)};
  const Matrix3d R = input.X_FE.linear();
  if (!input.X_FE.matrix().allFinite() || (R * R.transpose() - Matrix3d::Identity()).norm() > 1e-6 ||
      R.determinant() < 0.0)
    return Error{heft::say("The tool centre point is not a pose: its rotation must be orthonormal and right-handed.")};
  ExportInput rounded = input;
  rounded.payload = roundedForExport(input.payload);
  if (rounded.sensor) rounded.sensor->payload = roundedForExport(rounded.sensor->payload);
  if (const Consistency after = checkPhysical(rounded.payload); !after.physical)
    return Error{heft::say("This payload is too small to be written: {}", after.reason)};
  addFormatFindings(format, rounded, findings);
  return format.write(rounded);
}

}  // namespace heft
