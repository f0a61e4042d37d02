#include "core/robot/robot_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/robot/urdf_reader.h"

namespace heft {
namespace {

/// A rotation that takes z to the unit vector `axis`; exact for axes along x, y and z.
Matrix3d turnZTo(const Vector3d& axis) {
  if (axis == Vector3d::UnitZ()) return Matrix3d::Identity();
  Vector3d::Index least = 0;
  axis.cwiseAbs().minCoeff(&least);
  const Vector3d x = (Vector3d::Unit(least) - axis[least] * axis).normalized();
  Matrix3d R;
  R << x, axis.cross(x), axis;
  return R;
}

Isometry3d displacement(const Joint& joint, double value) {
  Isometry3d X = Isometry3d::Identity();
  if (joint.type == JointType::revolute) X.linear() = Eigen::AngleAxisd(value, joint.axis).toRotationMatrix();
  if (joint.type == JointType::prismatic) X.translation() = value * joint.axis;
  return X;
}

double clampTo(const JointLimits& limits, double value) { return std::clamp(value, limits.lower, limits.upper); }

}  // namespace

Result<RobotModel> RobotModel::fromUrdfFile(const std::filesystem::path& file, Findings& findings,
                                            std::string_view sensorLink) {
  Result<std::string> text = readTextFile(file);
  if (!text) return text.error();
  Result<UrdfTree> tree = readUrdf(*text, displayName(file), file.parent_path(), findings);
  if (!tree) return tree.error();
  return assemble(std::move(*tree), displayName(file), sensorLink, findings);
}

Result<RobotModel> RobotModel::fromUrdfText(const std::string& urdf, const std::filesystem::path& baseFolder,
                                            Findings& findings, std::string_view sensorLink) {
  Result<UrdfTree> tree = readUrdf(urdf, "URDF", baseFolder, findings);
  if (!tree) return tree.error();
  return assemble(std::move(*tree), "URDF", sensorLink, findings);
}

Result<RobotModel> RobotModel::assemble(UrdfTree tree, const std::string& file, std::string_view sensorLink,
                                        Findings& findings) {
  const std::vector<int> columns = chooseColumns(tree, sensorLink);
  if (columns.empty()) {
    return errorAt({file, 0, 0}, heft::say("Robot \"{}\" has no joint that moves.", printable(tree.name)),
                   heft::say("Give an arm's URDF."));
  }
  for (std::size_t k = 0; k < columns.size(); ++k) tree.joints[columns[k]].joint.index = static_cast<int>(k);
  followMimics(tree);
  holdOthers(tree, file, findings);

  RobotModel robot;
  robot.name_ = std::move(tree.name);
  robot.links_ = std::move(tree.links);
  for (UrdfJoint& joint : tree.joints) robot.joints_.push_back(std::move(joint.joint));
  robot.moving_ = columns;
  robot.dof_ = static_cast<int>(columns.size());
  robot.buildChains();
  return robot;
}

void RobotModel::buildChains() {
  chains_.assign(links_.size(), Chain());
  for (std::size_t link = 0; link < links_.size(); ++link) {
    if (links_[link].parentJoint < 0) continue;
    const Joint& joint = joints_[links_[link].parentJoint];
    Chain chain = chains_[joint.parentLink];
    chain.p_end += chain.R_end * joint.X_PJ.translation();
    chain.R_end = chain.R_end * joint.X_PJ.linear();
    if (joint.index >= 0) {
      const Matrix3d align = turnZTo(joint.axis);
      chain.steps.push_back({chain.R_end * align, chain.p_end, joint.index, joint.type == JointType::revolute,
                             joint.ratio, joint.offset});
      chain.R_end = align.transpose();
      chain.p_end.setZero();
    }
    chains_[link] = std::move(chain);
  }
}

const RobotModel::Chain& RobotModel::chainTo(int link, Eigen::Index columns) const {
  if (link < 0 || link >= static_cast<int>(links_.size())) {
    throw std::invalid_argument(fmt::format("robot \"{}\" has links 0 to {}, not {}", name_, links_.size() - 1, link));
  }
  if (columns != dof_) {
    throw std::invalid_argument(fmt::format("robot \"{}\" needs {} joint values, not {}", name_, dof_, columns));
  }
  return chains_[link];
}

std::optional<int> RobotModel::findLink(std::string_view name) const {
  for (std::size_t k = 0; k < links_.size(); ++k) {
    if (links_[k].name == name) return static_cast<int>(k);
  }
  return std::nullopt;
}

VectorXd RobotModel::clampToLimits(const VectorXd& q) const {
  chainTo(0, q.size());
  VectorXd clamped(q.size());
  for (int k = 0; k < dof_; ++k) clamped[k] = clampTo(limits(k), q[k]);
  return clamped;
}

VectorXd RobotModel::homePosture() const {
  // The posture that a Franka arm calls ready; its fourth joint cannot reach zero, which tells the family from other
  // arms of seven joints.
  constexpr double kPi = 3.14159265358979323846;
  if (dof_ == 7 && limits(3).upper < 0.0) {
    VectorXd ready(7);
    ready << 0.0, -kPi / 4, 0.0, -3 * kPi / 4, 0.0, kPi / 2, kPi / 4;
    bool inside = true;
    for (int k = 0; k < dof_; ++k) inside = inside && clampTo(limits(k), ready[k]) == ready[k];
    if (inside) return ready;
  }
  VectorXd home(dof_);
  for (int k = 0; k < dof_; ++k) {
    const JointLimits& range = limits(k);
    const bool bounded = std::isfinite(range.lower) && std::isfinite(range.upper);
    home[k] = bounded ? 0.5 * (range.lower + range.upper) : clampTo(range, 0.0);
  }
  return home;
}

void RobotModel::linkPoses(const VectorXd& q, std::vector<Isometry3d>& X_BL) const {
  chainTo(0, q.size());
  X_BL.resize(links_.size());
  for (std::size_t link = 0; link < links_.size(); ++link) {
    if (links_[link].parentJoint < 0) {
      X_BL[link].setIdentity();
      continue;
    }
    const Joint& joint = joints_[links_[link].parentJoint];
    X_BL[link] = X_BL[joint.parentLink] * joint.X_PJ;
    if (joint.index >= 0) X_BL[link] = X_BL[link] * displacement(joint, joint.ratio * q[joint.index] + joint.offset);
  }
}

Isometry3d RobotModel::linkPose(const VectorXd& q, int link) const {
  const VectorXd zero = VectorXd::Zero(dof_);
  return frameMotion(link, Isometry3d::Identity(), q, zero, zero).X_BS;
}

FrameMotion RobotModel::frameMotion(int link, const Isometry3d& X_LS, const Eigen::Ref<const VectorXd>& q,
                                    const Eigen::Ref<const VectorXd>& dq, const Eigen::Ref<const VectorXd>& ddq) const {
  const Chain& chain = chainTo(link, q.size());
  if (dq.size() != dof_ || ddq.size() != dof_) chainTo(link, dq.size() != dof_ ? dq.size() : ddq.size());
  Matrix3d R = Matrix3d::Identity();
  Vector3d p = Vector3d::Zero(), w = Vector3d::Zero(), v = Vector3d::Zero(), alpha = Vector3d::Zero(),
           a = Vector3d::Zero();
  for (const Step& step : chain.steps) {
    const Vector3d arm = R * step.p;
    const Vector3d armSpeed = w.cross(arm);
    p += arm;
    v += armSpeed;
    a += alpha.cross(arm) + w.cross(armSpeed);
    R = (R * step.R).eval();
    const Vector3d z = R.col(2);
    const double value = step.ratio * q[step.index] + step.offset;
    const Vector3d speed = z * (step.ratio * dq[step.index]);
    const Vector3d gain = z * (step.ratio * ddq[step.index]);
    if (step.turns) {
      const double c = std::cos(value), s = std::sin(value);
      const Vector3d x = R.col(0);
      R.col(0) = c * x + s * R.col(1);
      R.col(1) = c * R.col(1) - s * x;
      alpha += gain + w.cross(speed);
      w += speed;
    } else {
      const Vector3d slide = z * value;
      const Vector3d slideSpeed = w.cross(slide);
      p += slide;
      v += slideSpeed + speed;
      a += alpha.cross(slide) + w.cross(slideSpeed) + 2.0 * w.cross(speed) + gain;
    }
  }
  const Vector3d p_end = chain.p_end + chain.R_end * X_LS.translation();
  const Vector3d arm = R * p_end;
  const Vector3d armSpeed = w.cross(arm);
  FrameMotion motion;
  motion.X_BS.linear() = R * (chain.R_end * X_LS.linear());
  motion.X_BS.translation() = p + arm;
  motion.w_BS_B = w;
  motion.v_BSo_B = v + armSpeed;
  motion.alpha_BS_B = alpha;
  motion.a_BSo_B = a + alpha.cross(arm) + w.cross(armSpeed);
  return motion;
}

MatrixXd RobotModel::jacobian(int link, const Isometry3d& X_LS, const VectorXd& q) const {
  const Chain& chain = chainTo(link, q.size());
  const Vector3d p_BS = (linkPose(q, link) * X_LS).translation();
  MatrixXd J = MatrixXd::Zero(6, dof_);
  Isometry3d X = Isometry3d::Identity();
  for (const Step& step : chain.steps) {
    X.translation() += X.linear() * step.p;
    X.linear() = X.linear() * step.R;
    const Vector3d axis = X.linear().col(2) * step.ratio;
    const double value = step.ratio * q[step.index] + step.offset;
    if (step.turns) {
      J.col(step.index).head<3>() += axis.cross(p_BS - X.translation());
      J.col(step.index).tail<3>() += axis;
      X.linear() = X.linear() * Eigen::AngleAxisd(value, Vector3d::UnitZ());
    } else {
      J.col(step.index).head<3>() += axis;
      X.translation() += X.linear().col(2) * value;
    }
  }
  return J;
}

}  // namespace heft
