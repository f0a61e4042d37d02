// What takes the tool's weight off a force/torque sensor's readings, and xArm. None of these files holds an inertia.
// Sources: control_toolbox, gravity_compensation_filter_parameters.yaml and gravity_compensation.cpp (it subtracts the
// weight m g from the wrench); force_torque_tools, gravity_compensation_params.cpp and ft_calib.cpp (the wrench is
// m (a - g) + bias); mc_rtc, ForceSensor.cpp (13 numbers; the offset is an sva::ForceVecd, whose couple stands first);
// xArm-Python-SDK, set_tcp_load (kg, mm).
#include <fmt/format.h>

#include "core/exporters/writing.h"

namespace heft {

namespace {

SensorSide sensorOf(const ExportInput& input) {
  return input.sensor ? *input.sensor : SensorSide{input.payload, Isometry3d::Identity(), std::nullopt, {}};
}

std::string frameOf(const SensorSide& sensor) { return sensor.frame.empty() ? "ft_sensor" : frameName(sensor.frame); }

Vector6d rounded(const Vector6d& bias) {
  return bias.unaryExpr([](double v) { return roundedTo(v, 6); });
}

/// YAML reads "1" as an integer, which ROS 2 refuses for a double.
std::string real(double value) {
  const std::string text = number(value);
  return text.find('.') == std::string::npos ? text + ".0" : text;
}
std::string reals(const Vector3d& v) { return fmt::format("[{}, {}, {}]", real(v.x()), real(v.y()), real(v.z())); }

}  // namespace

std::string writeRos2Control(const ExportInput& input) {
  const SensorSide sensor = sensorOf(input);
  return comment(
             remarksOf(input, {"Parameters of control_filters/GravityCompensationWrench: mass [kg], centre of mass "
                               "in the sensor's frame [m], gravity in the world's [m/s2].",
                               "The filter takes the weight m g off the wrench: it is for a driver whose wrench is "
                               "that of the payload on the sensor.",
                               "It knows no bias: zero the sensor with the tool off, or take the bias away first."}),
             "#") +
         fmt::format(
             "world_frame: world\n"
             "sensor_frame: {}\n"
             "tool:\n"
             "  mass: {}\n"
             "  pos: {}\n"
             "  gravity_field: [0.0, 0.0, -9.81]\n",
             frameOf(sensor), real(sensor.payload.mass), reals(sensor.payload.com));
}

std::string writeForceTorqueTools(const ExportInput& input) {
  const SensorSide sensor = sensorOf(input);
  const Vector6d bias = rounded(sensor.bias.value_or(Vector6d::Zero()));
  return comment(remarksOf(input, {"Calibration of force_torque_tools: bias [N, N m], mass [kg], centre of mass in the "
                                   "sensor's frame [m].",
                                   "Its wrench is that of the sensor on the payload: at rest it points up."}),
                 "#") +
         fmt::format(
             "bias: [{}, {}, {}, {}, {}, {}]\n"
             "gripper_com_frame_id: {}\n"
             "gripper_com_pose: [{}, {}, {}, 0.0, 0.0, 0.0]\n"
             "gripper_mass: {}\n",
             real(bias(0)), real(bias(1)), real(bias(2)), real(bias(3)), real(bias(4)), real(bias(5)), frameOf(sensor),
             real(sensor.payload.com.x()), real(sensor.payload.com.y()), real(sensor.payload.com.z()),
             real(sensor.payload.mass));
}

std::string writeMcRtc(const ExportInput& input) {
  const SensorSide sensor = sensorOf(input);
  const Vector3d com = (sensor.X_FS * sensor.payload.com).unaryExpr([](double v) { return roundedTo(v, 6); });
  // Its wrench is that of the payload on the sensor; the couple stands first.
  const Vector6d bias = rounded(-sensor.bias.value_or(Vector6d::Zero()));
  return fmt::format("{}\n0 0 0\n{}\n{}\n{}\n\n", number(sensor.payload.mass), list(com, " "),
                     list(Vector3d(bias.tail<3>()), " "), list(Vector3d(bias.head<3>()), " ")) +
         comment(
             remarksOf(input, {"mc_rtc reads the thirteen numbers above and nothing behind them: mass [kg], turn of "
                               "the sensor against its model [rad], centre of mass from the flange [m], offset of "
                               "the couple [N m] and of the force [N].",
                               "For a sensor whose parent body is the flange, and a wrench of the payload on the "
                               "sensor."}),
             "#");
}

std::string writeXarm(const ExportInput& input) {
  const Vector3d com = (1e3 * input.payload.com).unaryExpr([](double v) { return roundedTo(v, 3); });
  return comment(remarksOf(input, {"Load for xArm-Python-SDK: mass [kg], centre of mass from the flange [mm]; it has "
                                   "no inertia.",
                                   "arm is your XArmAPI; arm.save_conf() keeps the load over a restart."}),
                 "#") +
         fmt::format("arm.set_tcp_load({}, [{}])\n", number(input.payload.mass), list(com));
}

}  // namespace heft
