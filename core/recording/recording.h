#pragma once
// A recorded demonstration: time series and what is known about how they were measured.
#include <Eigen/Dense>
#include <optional>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/math/rigid.h"
#include "core/payload/inertial_parameters.h"
#include "core/recording/configured_payload.h"
#include "core/recording/conventions.h"

namespace heft {

enum class WrenchSign { sensorOnPayload, payloadOnSensor };
enum class RecordingKind { motion, poses };
enum class MarkLabel { free, contact, ignore };

std::string_view toString(MarkLabel label);
std::optional<MarkLabel> markLabelFromString(std::string_view text);

struct Mark {
  double from = 0.0;  ///< [s], inclusive
  double to = 0.0;    ///< [s], inclusive
  MarkLabel label = MarkLabel::free;
};

/// Where S sits: its pose in the parent link, fixed-axis rpy.
struct SensorMount {
  std::string parent = "panda_link8";
  Vector3d xyz = Vector3d::Zero();  ///< [m]
  Vector3d rpy = Vector3d::Zero();  ///< [rad]
};

struct RecordingMeta {
  std::optional<std::string> robot;  ///< "panda", a URDF path (made absolute against the setup file), or none.
  RecordingKind kind = RecordingKind::motion;
  SensorMount mount;
  std::string sensorModel;
  WrenchSign wrenchSign = WrenchSign::sensorOnPayload;  ///< Sign in the FILE; in memory it is always sensorOnPayload.
  Conventions conventions;            ///< Of the FILE's numbers; in memory they are in the plain form.
  Vector3d gravity{0.0, 0.0, -9.81};  ///< g_B [m/s2], pointing down.
  PartialPayload knownPayload;
  /// [s] Standard deviation of what was added to the wrench's times where its clock and the motion's were brought
  /// together by the data alone; nothing where they are on one clock. A delay then says nothing of the rig.
  std::optional<double> clockAlignmentStd;
  std::vector<Mark> marks;
  std::string note;

  /// From now on this goes with numbers in the plain form: those of a recording in memory, for instance.
  void numbersArePlain() {
    wrenchSign = WrenchSign::sensorOnPayload;
    conventions = {};
  }
};

struct ExtraColumn {
  std::string name;
  std::vector<std::string> cells;  ///< As they stood in the file.
};

/// N rows. A series that the file lacks has zero rows. Columns are contiguous in memory.
struct Recording {
  std::string file;
  RecordingMeta meta;
  VectorXd time;                                        ///< [s], strictly rising
  MatrixXd q;                                           ///< N x dof [rad]
  MatrixXd dq;                                          ///< N x dof [rad/s], optional
  Eigen::Matrix<double, Eigen::Dynamic, 3> position;    ///< p_BSo_B [m]; absent for orientation only
  Eigen::Matrix<double, Eigen::Dynamic, 4> quaternion;  ///< R_BS as x, y, z, w; unit length
  Eigen::Matrix<double, Eigen::Dynamic, 6> twist;       ///< v_BSo_B [m/s], w_BS_B [rad/s], optional
  /// What an inertial sensor I on the tool side reads, in its own axes: R_SI^T (a_BIo - g) [m/s2] and w_BI_I [rad/s],
  /// with biases. How it is mounted is told by nobody, see core/motion/accelerometer.h. Each optional.
  Eigen::Matrix<double, Eigen::Dynamic, 3> accelerometer;
  Eigen::Matrix<double, Eigen::Dynamic, 3> gyroscope;
  Eigen::Matrix<double, Eigen::Dynamic, 6> wrench;  ///< F_PSo_S: sensor on payload, force [N], torque [N m]
  /// The wrench is still in the axes and about the point that meta.conventions states: toSensorAxes() is to come.
  bool wrenchNeedsPose = false;
  std::vector<std::optional<MarkLabel>> labels;  ///< From the column `label`; empty if there is none.
  std::vector<ExtraColumn> extra;                ///< Columns that Heft does not know, kept for writing back.
  std::optional<ConfiguredPayload> configured;   ///< What the controller was told, where the file tells it.

  Eigen::Index rows() const { return time.size(); }
  bool hasJoints() const { return q.rows() > 0; }
  bool hasOrientation() const { return quaternion.rows() > 0; }
  bool hasPosition() const { return position.rows() > 0; }
  bool hasAccelerometer() const { return accelerometer.rows() > 0; }
  double duration() const { return time.size() > 1 ? time(time.size() - 1) - time(0) : 0.0; }
  /// 1 / median time step [Hz]; 0 with fewer than two rows.
  double rateHz() const;
};

/// Rows [from, to) as if nothing else had been recorded; without extra columns.
Recording excerpt(const Recording& recording, Eigen::Index from, Eigen::Index to);

}  // namespace heft
