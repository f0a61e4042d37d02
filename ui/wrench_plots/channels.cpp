#include "ui/wrench_plots/channels.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/math/rigid.h"
#include "ui/models/units.h"

namespace heft {
namespace {

struct ChannelWords {
  Q_DECLARE_TR_FUNCTIONS(Channels)
};

double perRadian() { return angleUnit().scale; }
double perMetre() { return lengthUnit().scale; }
constexpr double kHalfWindow = 0.01;  ///< [s] Of the differences that stand for a speed
const double kNothing = std::numeric_limits<double>::quiet_NaN();

std::vector<double> scaled(const Eigen::Ref<const VectorXd>& values, double factor) {
  std::vector<double> out(static_cast<std::size_t>(values.size()));
  for (Eigen::Index n = 0; n < values.size(); ++n) out[static_cast<std::size_t>(n)] = factor * values(n);
  return out;
}

/// Change of `values` a second.
std::vector<double> rateOf(const VectorXd& time, const std::vector<double>& values) {
  const auto rows = static_cast<Eigen::Index>(values.size());
  std::vector<double> out(values.size(), kNothing);
  const double step = rows > 1 ? (time(rows - 1) - time(0)) / static_cast<double>(rows - 1) : 1.0;
  const Eigen::Index reach = std::max<Eigen::Index>(1, std::lround(kHalfWindow / step));
  for (Eigen::Index n = 0; n < rows; ++n) {
    const Eigen::Index from = std::max<Eigen::Index>(0, n - reach), to = std::min(rows - 1, n + reach);
    if (to > from)
      out[static_cast<std::size_t>(n)] =
          (values[static_cast<std::size_t>(to)] - values[static_cast<std::size_t>(from)]) / (time(to) - time(from));
  }
  return out;
}

/// Roll, pitch or yaw [shown unit] about the base's fixed axes, without leaps of a whole turn.
std::vector<double> angleOf(const Recording& recording, int axis) {
  std::vector<double> out;
  double before = 0.0, turns = 0.0;
  for (Eigen::Index n = 0; n < recording.quaternion.rows(); ++n) {
    const double x = recording.quaternion(n, 0), y = recording.quaternion(n, 1), z = recording.quaternion(n, 2),
                 w = recording.quaternion(n, 3);
    const double angle = axis == 0   ? std::atan2(2 * (w * x + y * z), 1 - 2 * (x * x + y * y))
                         : axis == 1 ? std::asin(std::clamp(2 * (w * y - z * x), -1.0, 1.0))
                                     : std::atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z));
    if (n > 0 && angle - before > M_PI) turns -= 2 * M_PI;
    if (n > 0 && angle - before < -M_PI) turns += 2 * M_PI;
    before = angle;
    out.push_back(perRadian() * (angle + turns));
  }
  return out;
}

/// How fast the sensor turns [shown unit a second]: twice the angle between neighbouring orientations.
std::vector<double> turning(const Recording& recording) {
  if (recording.twist.rows() > 0) return scaled(recording.twist.rightCols<3>().rowwise().norm(), perRadian());
  const VectorXd& time = recording.time;
  const Eigen::Index rows = std::min(recording.quaternion.rows(), time.size());
  std::vector<double> out(static_cast<std::size_t>(rows), kNothing);
  const double step = rows > 1 ? (time(rows - 1) - time(0)) / static_cast<double>(rows - 1) : 1.0;
  const Eigen::Index reach = std::max<Eigen::Index>(1, std::lround(kHalfWindow / step));
  for (Eigen::Index n = 0; n < rows; ++n) {
    const Eigen::Index from = std::max<Eigen::Index>(0, n - reach), to = std::min(rows - 1, n + reach);
    if (to == from) continue;
    const double cosine = std::abs(recording.quaternion.row(from).dot(recording.quaternion.row(to)));
    out[static_cast<std::size_t>(n)] = perRadian() * 2.0 * std::acos(std::min(1.0, cosine)) / (time(to) - time(from));
  }
  return out;
}

/// How fast the sensor moves [shown unit a second].
std::vector<double> moving(const Recording& recording) {
  if (recording.twist.rows() > 0) return scaled(recording.twist.leftCols<3>().rowwise().norm(), perMetre());
  std::vector<double> out(static_cast<std::size_t>(recording.position.rows()), 0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const std::vector<double> rate = rateOf(recording.time, scaled(recording.position.col(axis), perMetre()));
    for (std::size_t n = 0; n < out.size(); ++n) out[n] += rate[n] * rate[n];
  }
  for (double& v : out) v = std::sqrt(v);
  return out;
}

double numberIn(const std::string& cell) {
  bool ok = false;
  const double value = QString::fromStdString(cell).trimmed().toDouble(&ok);
  return ok ? value : kNothing;
}

const QString kExtra = QStringLiteral("column:");
constexpr const char* kAxisNames[] = {"x", "y", "z"};
constexpr const char* kAngleNames[] = {"roll", "pitch", "yaw"};

/// "q7" to 6, "px" is none of these.
int indexIn(const QString& id, const QString& prefix, Eigen::Index count) {
  if (!id.startsWith(prefix)) return -1;
  bool ok = false;
  const int number = id.mid(prefix.size()).toInt(&ok);
  return ok && number >= 1 && number <= count ? number - 1 : -1;
}

}  // namespace

Recording forwardPoses(const Recording& recording, const RobotModel& robot) {
  const SensorMount& mount = recording.meta.mount;
  const Isometry3d X_LS = poseFromXyzRpy(mount.xyz, mount.rpy);
  const auto link =
      static_cast<std::size_t>(robot.findLink(mount.parent).value_or(static_cast<int>(robot.links().size()) - 1));
  const Eigen::Index rows = recording.q.rows();
  Recording out;
  out.meta = recording.meta;
  out.time = recording.time;
  out.position.resize(rows, 3);
  out.quaternion.resize(rows, 4);
  std::vector<Isometry3d> X_BL;
  for (Eigen::Index n = 0; n < rows; ++n) {
    robot.linkPoses(recording.q.row(n).transpose(), X_BL);
    const Isometry3d X_BS = X_BL[link] * X_LS;
    const Quaterniond turned(X_BS.linear());
    out.position.row(n) = X_BS.translation().transpose();
    out.quaternion.row(n) << turned.x(), turned.y(), turned.z(), turned.w();
  }
  return out;
}

std::vector<Channel> channelsOf(const Recording& recording, bool poseFromJoints) {
  std::vector<Channel> out;
  const auto add = [&](const QString& id, const QString& label, const QString& group, const QString& unit) {
    out.push_back({id, label, group, unit});
  };
  const QString angle = angleUnit().name, rate = angle + QStringLiteral("/s"), length = lengthUnit().name;
  if (recording.hasJoints()) {
    for (Eigen::Index k = 1; k <= recording.q.cols(); ++k)
      add(QStringLiteral("q%1").arg(k), QStringLiteral("q%1").arg(k), ChannelWords::tr("Joint angles"), angle);
    for (Eigen::Index k = 1; k <= recording.q.cols(); ++k)
      add(QStringLiteral("dq%1").arg(k), QStringLiteral("dq%1").arg(k),
          recording.dq.rows() > 0 ? ChannelWords::tr("Joint speeds")
                                  : ChannelWords::tr("Joint speeds, from the angles"),
          rate);
  }
  const bool position = recording.hasPosition() || poseFromJoints,
             turned = recording.hasOrientation() || poseFromJoints;
  if (position)
    for (const char* axis : kAxisNames)
      add(QStringLiteral("p%1").arg(axis), axis, ChannelWords::tr("Sensor position"), length);
  if (turned)
    for (const char* turn : kAngleNames) add(turn, turn, ChannelWords::tr("Sensor orientation"), angle);
  const QString sizes = ChannelWords::tr("Speeds and magnitudes");
  if (position || recording.twist.rows() > 0) add("speed", QStringLiteral("|v|"), sizes, length + QStringLiteral("/s"));
  if (turned || recording.twist.rows() > 0) add("turning", QStringLiteral("|ω|"), sizes, rate);
  if (recording.wrench.rows() > 0) {
    add("force", QStringLiteral("|F|"), sizes, QStringLiteral("N"));
    add("torque", QStringLiteral("|T|"), sizes, torqueUnit().name);
  }
  for (const ExtraColumn& column : recording.extra) {
    const auto number = [](const std::string& cell) { return std::isfinite(numberIn(cell)); };
    if (std::any_of(column.cells.begin(), column.cells.end(), number))
      add(kExtra + QString::fromStdString(column.name), QString::fromStdString(column.name),
          ChannelWords::tr("Other columns of the file"), {});
  }
  return out;
}

std::vector<double> channelValues(const Recording& recording, const QString& id) {
  const Eigen::Index joints = recording.q.cols();
  if (const int k = indexIn(id, "q", joints); k >= 0) return scaled(recording.q.col(k), perRadian());
  if (const int k = indexIn(id, "dq", joints); k >= 0)
    return recording.dq.rows() > 0 ? scaled(recording.dq.col(k), perRadian())
                                   : rateOf(recording.time, scaled(recording.q.col(k), perRadian()));
  for (int axis = 0; axis < 3; ++axis) {
    if (recording.hasPosition() && id == QStringLiteral("p%1").arg(kAxisNames[axis]))
      return scaled(recording.position.col(axis), perMetre());
    if (recording.hasOrientation() && id == QLatin1String(kAngleNames[axis])) return angleOf(recording, axis);
  }
  if (id == "speed" && (recording.hasPosition() || recording.twist.rows() > 0)) return moving(recording);
  if (id == "turning" && (recording.hasOrientation() || recording.twist.rows() > 0)) return turning(recording);
  if (recording.wrench.rows() == 0 && (id == "force" || id == "torque")) return {};
  if (id == "force") return scaled(recording.wrench.leftCols<3>().rowwise().norm(), 1.0);
  if (id == "torque") return scaled(recording.wrench.rightCols<3>().rowwise().norm(), torqueUnit().scale);
  for (const ExtraColumn& column : recording.extra) {
    if (id != kExtra + QString::fromStdString(column.name)) continue;
    std::vector<double> out;
    for (const std::string& cell : column.cells) out.push_back(numberIn(cell));
    return out;
  }
  return {};
}

}  // namespace heft
