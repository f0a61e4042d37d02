// Messages that every system has: their fields, for files and bridges that do not state them.
#include <fmt/format.h>

#include <map>

#include "core/import/message_definition.h"

namespace heft {

std::string builtInDefinition(std::string_view type) {
  // Facts of the formats: field types and their order.
  static const std::map<std::string, std::string, std::less<>> kFields = {
      {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
      {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
      {"std_msgs/Float64MultiArray", "MultiArrayLayout layout\nfloat64[] data\n"},
      {"std_msgs/MultiArrayLayout", "MultiArrayDimension[] dim\nuint32 data_offset\n"},
      {"std_msgs/MultiArrayDimension", "string label\nuint32 size\nuint32 stride\n"},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
      {"geometry_msgs/Pose", "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
      {"geometry_msgs/Transform", "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
      {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
      {"sensor_msgs/Imu",
       "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\nfloat64[9] orientation_covariance\n"
       "geometry_msgs/Vector3 angular_velocity\nfloat64[9] angular_velocity_covariance\n"
       "geometry_msgs/Vector3 linear_acceleration\nfloat64[9] linear_acceleration_covariance\n"},
      {"geometry_msgs/Wrench", "geometry_msgs/Vector3 force\ngeometry_msgs/Vector3 torque\n"},
      {"geometry_msgs/WrenchStamped", "std_msgs/Header header\ngeometry_msgs/Wrench wrench\n"},
      {"geometry_msgs/Twist", "geometry_msgs/Vector3 linear\ngeometry_msgs/Vector3 angular\n"},
      {"geometry_msgs/TwistStamped", "std_msgs/Header header\ngeometry_msgs/Twist twist\n"},
      {"sensor_msgs/JointState",
       "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\nfloat64[] effort\n"},
      {"franka_msgs/CollisionIndicators",
       "geometry_msgs/Vector3 is_cartesian_linear_collision\ngeometry_msgs/Vector3 is_cartesian_angular_collision\n"
       "geometry_msgs/Vector3 is_cartesian_linear_contact\ngeometry_msgs/Vector3 is_cartesian_angular_contact\n"
       "float64[7] is_joint_collision\nfloat64[7] is_joint_contact\n"},
      // Only its beginning: what follows differs between versions of franka_ros2 and is not needed.
      {"franka_msgs/FrankaRobotState",
       "std_msgs/Header header\nCollisionIndicators collision_indicators\n"
       "sensor_msgs/JointState measured_joint_state\n"},
  };
  const std::string name = plainTypeName(type);
  const auto own = kFields.find(name);
  if (own == kFields.end()) return {};
  std::string out = own->second;
  for (const auto& [other, fields] : kFields)
    if (other != name) out += fmt::format("{:=<80}\nMSG: {}\n{}", "", other, fields);
  return out;
}

}  // namespace heft
