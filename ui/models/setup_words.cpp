#include "ui/models/setup_words.h"

#include <QCoreApplication>
#include <QHash>

namespace heft {
namespace {

struct RigWords {
  Q_DECLARE_TR_FUNCTIONS(SetupWords)
};

QHash<QString, SetupWords> wordsOfWrench() {
  return {
      {"wrench_axes",
       {RigWords::tr("Along the axes of"),
        RigWords::tr("UR’s TCP force, for instance, is along the axes of the robot’s base"),
        {{"sensor", RigWords::tr("the sensor")}, {"base", RigWords::tr("the robot’s base")}}}},
      {"wrench_point",
       {RigWords::tr("Torque about"),
        RigWords::tr("The reference point of the torque"),
        {{"sensor", RigWords::tr("the sensor’s origin")},
         {"base", RigWords::tr("the base’s origin")},
         {{}, RigWords::tr("another point of the sensor")}}}},
      {"wrench_sign",
       {RigWords::tr("Force direction"),
        RigWords::tr("Hold the tool still: which way does the force point?"),
        {{"sensor_on_payload", RigWords::tr("up when the tool hangs at rest")},
         {"payload_on_sensor", RigWords::tr("down when the tool hangs at rest")}}}},
      {"torque_sign",
       {RigWords::tr("Torque sign"),
        RigWords::tr("Some drivers invert the torque but not the force"),
        {{"as_force", RigWords::tr("as for the force")}, {"opposite", RigWords::tr("opposite to the force")}}}},
      {"wrench_order",
       {RigWords::tr("Order"),
        RigWords::tr("What the first three of the six columns are"),
        {{"force_first", RigWords::tr("force, then torque")}, {"torque_first", RigWords::tr("torque, then force")}}}},
      {"mirrored_axis",
       {RigWords::tr("Mirrored axis"),
        RigWords::tr("The axis along which force and torque have the opposite sign: a left-handed sensor"),
        {{"null", RigWords::tr("none")}, {"x", "x"}, {"y", "y"}, {"z", "z"}}}},
      {"force_unit", {RigWords::tr("Unit of force"), RigWords::tr("Unit used in the file"), {}}},
      {"torque_unit", {RigWords::tr("Unit of torque"), RigWords::tr("Unit used in the file"), {}}},
  };
}

QHash<QString, SetupWords> wordsOfMotion() {
  return {
      {"angle_unit",
       {RigWords::tr("Angles"),
        RigWords::tr("Joint angles and their speeds"),
        {{"rad", RigWords::tr("radians")}, {"deg", RigWords::tr("degrees")}}}},
      {"length_unit",
       {RigWords::tr("Positions"),
        RigWords::tr("Positions and their speeds"),
        {{"m", RigWords::tr("metres")}, {"mm", RigWords::tr("millimetres")}}}},
      {"pose",
       {RigWords::tr("A pose describes"),
        RigWords::tr("Some programs write the inverse pose"),
        {{"sensor_in_base", RigWords::tr("the sensor in the base")},
         {"base_in_sensor", RigWords::tr("the base in the sensor")}}}},
      {"quaternion_order",
       {RigWords::tr("Quaternions"),
        RigWords::tr("Position of the real part w"),
        {{"xyzw", "x, y, z, w"}, {"wxyz", "w, x, y, z"}}}},
      {"kind",
       {RigWords::tr("Recording type"),
        RigWords::tr("Standing poses: one row per pose; times are ignored"),
        {{"motion", RigWords::tr("motion")}, {"poses", RigWords::tr("standing poses")}}}},
      {"xyz_m", {RigWords::tr("Sensor’s origin x, y, z"), {}, {}}},
      {"rpy_rad", {RigWords::tr("Sensor’s rotation x, y, z"), {}, {}}},
      {"gravity_m_s2", {RigWords::tr("Gravity x, y, z"), {}, {}}},
  };
}

}  // namespace

QStringList SetupWords::choices() const {
  QStringList out;
  for (const SetupAnswer& answer : answers) out << answer.words;
  return out;
}

SetupWords setupWords(const QString& key) {
  QHash<QString, SetupWords> all = wordsOfWrench();
  if (!all.contains(key)) all = wordsOfMotion();
  return all.value(key, {key, {}, {}});
}

QString setupAnswer(const QString& key, const QString& inFile) {
  for (const SetupAnswer& answer : setupWords(key).answers)
    if (answer.inFile == inFile) return answer.words;
  return inFile;
}

}  // namespace heft
