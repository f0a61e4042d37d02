#include "core/diagnosis/signals/joint_turns.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace heft::diagnosis {

/// J: the link that the joint turns, its origin on the joint's axis. A column an instant, J axes.
struct JointTurns::Cut {
  bool carries = false;  ///< Whether S is beyond the joint
  Vector3d axis = Vector3d::UnitZ();
  std::vector<Matrix3d> R_BJ, R_JS;
  Eigen::Matrix3Xd omega, alpha, a;  ///< Of J in B
  Eigen::Matrix3Xd place, speed, gain, turning,
      turnsFaster;  ///< Of S in J: position, velocity, acceleration, angular ones
};

namespace {

/// How many answers are kept: more than a first look at all joints asks for, fewer of a long recording.
std::size_t answersKept(Eigen::Index instants) {
  constexpr std::size_t kMost = 40, kFewest = 8, kMostBytes = std::size_t{64} << 20;
  constexpr std::size_t kBytesAnInstant = 3 * sizeof(Vector3d) + sizeof(Matrix3d);
  return std::clamp(kMostBytes / (kBytesAnInstant * static_cast<std::size_t>(std::max<Eigen::Index>(1, instants))),
                    kFewest, kMost);
}

}  // namespace

JointTurns::JointTurns(const RobotModel& robot, int link, const Isometry3d& X_LS, MatrixXd q, MatrixXd dq, MatrixXd ddq)
    : robot_(robot),
      link_(link),
      X_LS_(X_LS),
      q_(std::move(q)),
      dq_(std::move(dq)),
      ddq_(std::move(ddq)),
      cuts_(static_cast<std::size_t>(q_.rows())),
      answers_(answersKept(q_.cols())) {}

JointTurns::~JointTurns() = default;

const Joint& JointTurns::jointAt(int joint) const {
  return robot_.joints()[static_cast<std::size_t>(robot_.movingJoints()[static_cast<std::size_t>(joint)])];
}

bool JointTurns::turnsAlone(int joint) const {
  const auto moved = std::ranges::count_if(robot_.joints(), [&](const Joint& j) { return j.index == joint; });
  return moved == 1 && jointAt(joint).type == JointType::revolute;
}

std::shared_ptr<const Kinematics> JointTurns::with(const JointTurn& turn, const Vector3d& gravity) const {
  return answers_.answer({turn, gravity}, [&](const Asked& asked) { return worked(asked.turn, asked.gravity); });
}

const JointTurns::Cut& JointTurns::cutAt(int joint) const {
  const std::lock_guard lock(mutex_);
  auto& cut = cuts_.at(static_cast<std::size_t>(joint));
  if (!cut) cut = made(joint);
  return *cut;
}

std::unique_ptr<JointTurns::Cut> JointTurns::made(int joint) const {
  auto out = std::make_unique<Cut>();
  const Joint& turned = jointAt(joint);
  out->axis = turned.axis;
  for (int link = link_; link >= 0 && !out->carries;) {
    out->carries = link == turned.childLink;
    const int parent = robot_.links()[static_cast<std::size_t>(link)].parentJoint;
    link = parent >= 0 ? robot_.joints()[static_cast<std::size_t>(parent)].parentLink : -1;
  }
  const Eigen::Index n = q_.cols();
  out->R_BJ.resize(static_cast<std::size_t>(n));
  out->R_JS.resize(static_cast<std::size_t>(n));
  for (Eigen::Matrix3Xd* each :
       {&out->omega, &out->alpha, &out->a, &out->place, &out->speed, &out->gain, &out->turning, &out->turnsFaster})
    each->resize(3, n);
  const auto moves = [&](int link, const Isometry3d& X, Eigen::Index k) {
    return robot_.frameMotion(link, X, q_.col(k), dq_.col(k), ddq_.col(k));
  };
  if (sensor_.empty())
    for (Eigen::Index k = 0; k < n; ++k) sensor_.push_back(moves(link_, X_LS_, k));
  for (Eigen::Index k = 0; k < n; ++k) {
    const FrameMotion J = moves(turned.childLink, Isometry3d::Identity(), k);
    const FrameMotion& S = sensor_[static_cast<std::size_t>(k)];
    const Matrix3d R = J.X_BS.linear(), back = R.transpose();
    const Vector3d arm = S.X_BS.translation() - J.X_BS.translation(), turning = S.w_BS_B - J.w_BS_B;
    const Vector3d speed = S.v_BSo_B - J.v_BSo_B - J.w_BS_B.cross(arm);
    out->R_BJ[static_cast<std::size_t>(k)] = R;
    out->R_JS[static_cast<std::size_t>(k)] = back * S.X_BS.linear();
    out->omega.col(k) = back * J.w_BS_B;
    out->alpha.col(k) = back * J.alpha_BS_B;
    out->a.col(k) = back * J.a_BSo_B;
    out->place.col(k) = back * arm;
    out->speed.col(k) = back * speed;
    out->gain.col(k) = back * (S.a_BSo_B - J.a_BSo_B - J.alpha_BS_B.cross(arm) - J.w_BS_B.cross(J.w_BS_B.cross(arm)) -
                               2.0 * J.w_BS_B.cross(speed));
    out->turning.col(k) = back * turning;
    out->turnsFaster.col(k) = back * (S.alpha_BS_B - J.alpha_BS_B - J.w_BS_B.cross(turning));
  }
  return out;
}

Kinematics JointTurns::worked(const JointTurn& by, const Vector3d& gravity) const {
  const Cut& cut = cutAt(by.joint);
  const Eigen::Index n = cut.omega.cols();
  const Eigen::ArrayXd q = q_.row(by.joint), dq = dq_.row(by.joint), ddq = ddq_.row(by.joint);
  Eigen::ArrayXd angle = Eigen::ArrayXd::Constant(n, by.constant), rate = Eigen::ArrayXd::Zero(n), acceleration = rate;
  if (by.sine != 0.0 || by.cosine != 0.0) {
    const Eigen::ArrayXd sine = q.sin(), cosine = q.cos();
    const Eigen::ArrayXd off = by.sine * sine + by.cosine * cosine, slope = by.sine * cosine - by.cosine * sine;
    angle += off;
    rate = slope * dq;
    acceleration = slope * ddq - off * dq.square();
  }
  Kinematics out;
  out.specificForce.resize(3, n);
  out.omega.resize(3, n);
  out.alpha.resize(3, n);
  auto axes = std::make_shared<std::vector<Matrix3d>>(static_cast<std::size_t>(n));
  Matrix3d turn = Matrix3d::Identity();
  double turnedBy = 0.0;
  for (Eigen::Index k = 0; k < n; ++k) {
    const auto at = static_cast<std::size_t>(k);
    const double turned = cut.carries ? angle(k) : 0.0, faster = cut.carries ? rate(k) : 0.0,
                 gains = cut.carries ? acceleration(k) : 0.0;
    if (turned != turnedBy) {
      turn = Eigen::AngleAxisd(turned, cut.axis).toRotationMatrix();
      turnedBy = turned;
    }
    const Matrix3d &R_BJ = cut.R_BJ[at], &R_JS = cut.R_JS[at];
    // All in the axes of J as it is turned further.
    const Vector3d carried = turn.transpose() * cut.omega.col(k);
    const Vector3d omega = carried + faster * cut.axis;
    const Vector3d alpha = turn.transpose() * cut.alpha.col(k) + gains * cut.axis + faster * carried.cross(cut.axis);
    const Vector3d s = turn.transpose() * (cut.a.col(k) - R_BJ.transpose() * gravity) + alpha.cross(cut.place.col(k)) +
                       omega.cross(omega.cross(cut.place.col(k)) + 2.0 * cut.speed.col(k)) + cut.gain.col(k);
    out.specificForce.col(k) = R_JS.transpose() * s;
    out.omega.col(k) = R_JS.transpose() * (omega + cut.turning.col(k));
    out.alpha.col(k) = R_JS.transpose() * (alpha + cut.turnsFaster.col(k) + omega.cross(cut.turning.col(k)));
    (*axes)[at].noalias() = R_BJ * (turn * R_JS);
  }
  out.turned = std::move(axes);
  return out;
}

}  // namespace heft::diagnosis
