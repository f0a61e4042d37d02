#include "core/coach/pose_guide.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math/linear_algebra.h"
#include "core/motion/motion.h"
#include "core/simulation/trajectory.h"

namespace heft {

namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kContactForce = 0.5;    // [N] misfit that no standing tool has,
constexpr double kContactTorque = 0.05;  // [N m]
constexpr double kContactSds = 5.0;      // or so many standard deviations
constexpr std::size_t kJudgeable = 5;    // poses before one of them can be called touched
constexpr double kGoodSpread = 0.12;     // least variance of gravity's directions: three spread axes have 0.33
constexpr double kPoorSpread = 0.02;
constexpr std::size_t kStretchMost = 4000;  // samples that are averaged at most

/// Unknowns of a standing tool: bias force, bias torque, m, m c.
constexpr int kUnknowns = 10;
using Normal = Eigen::Matrix<double, kUnknowns, kUnknowns>;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using PoseRows = Eigen::Matrix<double, 6, kUnknowns>;

PoseRows rowsFor(const Vector3d& gravity_S) {
  PoseRows A = PoseRows::Zero();
  A.leftCols<6>().setIdentity();
  A.block<3, 1>(0, 6) = -gravity_S;
  A.block<3, 3>(3, 7) = skew(gravity_S);  // (m c) x (-g) = g x (m c)
  return A;
}

/// Weak knowledge that keeps untold directions finite: what sensors' biases and hand-held tools can be.
Normal weakly() {
  Unknowns sd;
  sd << Vector3d::Constant(50.0), Vector3d::Constant(5.0), 10.0, Vector3d::Constant(2.0);
  return Normal(sd.cwiseAbs2().cwiseInverse().asDiagonal());
}

struct Fit {
  Unknowns x = Unknowns::Zero();
  Normal covariance = Normal::Identity();
};

/// Covariance of m and c from that of x.
Eigen::Matrix4d massAndCentre(const Fit& fit) {
  const double m = std::max(1e-3, fit.x(6));
  const Vector3d c = fit.x.tail<3>() / m;
  Eigen::Matrix4d J = Eigen::Matrix4d::Identity();
  J.block<3, 1>(1, 0) = -c / m;
  J.bottomRightCorner<3, 3>() /= m;
  return J * fit.covariance.bottomRightCorner<4, 4>() * J.transpose();
}

/// What the mean of a pose may be off by.
Vector6d sdOf(const StandingPose& pose, const PoseGuideOptions& options) {
  Vector6d sd;
  sd << Vector3d::Constant(options.forceSd), Vector3d::Constant(options.torqueSd);
  return (sd.cwiseAbs2() + pose.scatter.cwiseAbs2()).cwiseSqrt();
}

/// To the poses that are used, but that with index `left`. `gravity`: g_B.
Fit fitWithout(std::size_t left, const std::vector<JudgedPose>& poses, const Vector3d& gravity,
               const PoseGuideOptions& options) {
  Normal H = weakly();
  Unknowns g = Unknowns::Zero();
  for (std::size_t i = 0; i < poses.size(); ++i) {
    if (i == left || poses[i].light != PoseLight::used) continue;
    const StandingPose& pose = poses[i].pose;
    const Vector6d w = sdOf(pose, options).cwiseAbs2().cwiseInverse();
    const PoseRows A = rowsFor(pose.R_BS.transpose() * gravity);
    H += A.transpose() * w.asDiagonal() * A;
    g += A.transpose() * w.asDiagonal() * pose.wrench;
  }
  const SymmetricSolver solver(H);
  return Fit{solver.solve(g), solver.solveAll(Normal::Identity())};
}

/// Angle between two vectors in degrees.
double angle(const Vector3d& a, const Vector3d& b) { return std::atan2(a.cross(b).norm(), a.dot(b)) * kDegrees; }

}  // namespace

std::string_view toString(PoseLight light) {
  switch (light) {
    case PoseLight::used:
      return "used";
    case PoseLight::tooClose:
      return "too_close";
    case PoseLight::moving:
      return "moving";
    case PoseLight::contact:
      return "contact";
  }
  return "used";
}

PoseGuide::PoseGuide(std::optional<GuidedTool> tool, const Vector3d& gravity, const PoseGuideOptions& options)
    : tool_(std::move(tool)), gravity_(gravity), options_(options) {
  judge();
}

Matrix3d PoseGuide::orientationAt(const VectorXd& q) const {
  return (tool_->robot->linkPose(q, tool_->link) * tool_->X_LS).linear();
}

int PoseGuide::usedCount() const {
  return static_cast<int>(
      std::count_if(poses_.begin(), poses_.end(), [](const JudgedPose& p) { return p.light == PoseLight::used; }));
}

void PoseGuide::add(const StandingPose& pose) {
  poses_.push_back({pose, PoseLight::used, "", 0.0});
  judge();
}

void PoseGuide::remove(std::size_t index) {
  if (index >= poses_.size()) return;
  poses_.erase(poses_.begin() + static_cast<std::ptrdiff_t>(index));
  judge();
}

bool PoseGuide::add(const OnlineSample& sample) {
  StandingPose now;
  now.time = sample.time;
  now.wrench = sample.wrench;
  if (!std::isfinite(sample.time) || !sample.wrench.allFinite()) return false;
  if (sample.q && tool_) {
    now.q = Eigen::Map<const VectorXd>(sample.q->data(), tool_->robot->dof());
    if (!now.q.allFinite()) return false;
    now.R_BS = orientationAt(now.q);
  }
  if (sample.pose) {
    if (!(sample.pose->orientation.norm() > 0.5)) return false;
    now.R_BS = sample.pose->orientation.normalized().toRotationMatrix();
  } else if (!sample.q || !tool_) {
    return false;
  }
  if (taken_ && angle(taken_->transpose() * gravity_, gravityIn(now)) < 0.5 * options_.closest) return false;
  taken_.reset();
  // A stretch ends where the tool has turned away from where it began.
  const double allowed = options_.standStill * options_.hold;
  if (!stretch_.empty() && (now.time <= stretch_.back().time || now.time - stretch_.back().time > 0.2 ||
                            vectorFromRotation(stretch_.front().R_BS.transpose() * now.R_BS).norm() > allowed))
    stretch_.clear();
  stretch_.push_back(now);
  if (stretch_.size() > kStretchMost) stretch_.erase(stretch_.begin());
  if (stretch_.back().time - stretch_.front().time < options_.hold) return false;

  StandingPose pose = stretch_[stretch_.size() / 2];
  Vector6d mean = Vector6d::Zero(), square = Vector6d::Zero();
  for (const auto& s : stretch_) {
    mean += s.wrench;
    square += s.wrench.cwiseAbs2();
  }
  const auto n = static_cast<double>(stretch_.size());
  mean /= n;
  pose.wrench = mean;
  // Slow noise: a hundred samples a second are taken as independent at most.
  const double independent = std::max(1.0, std::min(n, 100.0 * options_.hold));
  pose.scatter = ((square / n - mean.cwiseAbs2()).cwiseMax(0.0) / independent).cwiseSqrt();
  pose.speed = vectorFromRotation(stretch_.front().R_BS.transpose() * stretch_.back().R_BS).norm() / options_.hold;
  taken_ = pose.R_BS;
  stretch_.clear();
  add(pose);
  return true;
}

void PoseGuide::judge() {
  for (auto& p : poses_) {
    p.light = PoseLight::used;
    p.words = "Used.";
    p.misfit = 0.0;
  }
  lightByStanding();
  lightTouched();
  const Fit fit = fitWithout(poses_.size(), poses_, gravity_, options_);
  for (auto& p : poses_) {
    p.misfit = (p.pose.wrench - rowsFor(gravityIn(p.pose)) * fit.x).head<3>().norm();
    if (p.light == PoseLight::contact)
      p.words =
          fmt::format("The force differs by {:.1f} N from the other poses: something touched the tool.", p.misfit);
  }

  result_ = PoseResult();
  result_.bias = fit.x.head<6>();
  result_.mass = fit.x(6);
  if (fit.x(6) > 1e-3) result_.com = fit.x.tail<3>() / fit.x(6);
  const Eigen::Vector4d sd = massAndCentre(fit).diagonal().cwiseMax(0.0).cwiseSqrt();
  result_.massStd = sd(0);
  result_.comStd = sd.tail<3>();
  judgeSpread();
}

void PoseGuide::lightByStanding() {
  for (auto& p : poses_)
    if (p.pose.speed > options_.standStill) {
      p.light = PoseLight::moving;
      p.words = fmt::format("The tool moved ({:.2f} rad/s): hold it still for {:g} s.", p.pose.speed, options_.hold);
    }
  for (std::size_t i = 0; i < poses_.size(); ++i)
    for (std::size_t j = 0; j < i && poses_[i].light == PoseLight::used; ++j) {
      if (poses_[j].light != PoseLight::used) continue;
      const double apart = angle(gravityIn(poses_[i].pose), gravityIn(poses_[j].pose));
      if (apart >= options_.closest) continue;
      poses_[i].light = PoseLight::tooClose;
      poses_[i].words =
          fmt::format("Too similar to pose {} ({:.0f} degrees apart): tilt the tool further.", j + 1, apart);
    }
}

// One touched pose after the other: the one whose removal lets the rest fit best, if the others contradict it.
void PoseGuide::lightTouched() {
  const std::size_t nobody = poses_.size();
  for (;;) {
    if (static_cast<std::size_t>(usedCount()) < kJudgeable) break;
    std::size_t worst = nobody;
    double most = 1.0;
    for (std::size_t i = 0; i < poses_.size(); ++i) {
      if (poses_[i].light != PoseLight::used) continue;
      const Fit rest = fitWithout(i, poses_, gravity_, options_);
      const PoseRows A = rowsFor(gravityIn(poses_[i].pose));
      const Vector6d r = poses_[i].pose.wrench - A * rest.x;
      const Vector6d sd =
          ((A * rest.covariance * A.transpose()).diagonal() + sdOf(poses_[i].pose, options_).cwiseAbs2()).cwiseSqrt();
      Vector6d least;
      least << Vector3d::Constant(kContactForce), Vector3d::Constant(kContactTorque);
      const double score = r.cwiseAbs().cwiseQuotient((kContactSds * sd).cwiseMax(least)).maxCoeff();
      if (score > most) {
        most = score;
        worst = i;
      }
    }
    if (worst == nobody) break;
    poses_[worst].light = PoseLight::contact;
  }
}

void PoseGuide::judgeSpread() {
  // With the bias unknown only differences between gravity's directions tell something: their spread about the mean.
  Vector3d mean = Vector3d::Zero();
  Matrix3d spread = Matrix3d::Zero();
  const int used = usedCount();
  for (const auto& p : poses_)
    if (p.light == PoseLight::used) mean += gravityIn(p.pose).normalized() / std::max(1, used);
  for (const auto& p : poses_) {
    if (p.light != PoseLight::used) continue;
    const Vector3d d = gravityIn(p.pose).normalized() - mean;
    spread += d * d.transpose() / std::max(1, used);
  }
  const Vector3d values = symmetricEigen(spread).values;
  result_.known = used >= 4 && values(1) > kPoorSpread && result_.mass > 0.0 && result_.massStd < 0.3 * result_.mass;
  if (used < 2 || values(2) < kPoorSpread) {
    result_.spreadWords = "All poses have the same orientation. Tilt the tool by at least 30°.";
  } else if (values(1) < kPoorSpread) {
    result_.spreadWords = "The tool has been tilted about one axis only: tilt it about another one too.";
  } else if (values(0) < kPoorSpread || used < 6) {
    result_.spread = ExcitationLight::coarse;
    result_.spreadWords = used < 6
                              ? fmt::format("{} of at least 6 poses are usable.", used)
                              : "Two axes of tilt are well covered; also hold the tool nearly upside down or level.";
  } else {
    result_.spread = values(0) > kGoodSpread ? ExcitationLight::good : ExcitationLight::coarse;
    result_.spreadWords = values(0) > kGoodSpread
                              ? "The tilts cover all directions."
                              : "All directions are covered, but only slightly. Larger tilts give better results.";
  }
}

std::optional<NextPose> PoseGuide::next(const VectorXd& from, const Clearance* clearance) const {
  if (!tool_ || from.size() != tool_->robot->dof() || !from.allFinite()) return std::nullopt;
  const RobotModel& robot = *tool_->robot;
  const auto rooms = jointRooms(robot, robot.homePosture());
  Normal H = weakly();
  Unknowns g = Unknowns::Zero();
  Vector6d w;
  w << Vector3d::Constant(1.0 / (options_.forceSd * options_.forceSd)),
      Vector3d::Constant(1.0 / (options_.torqueSd * options_.torqueSd));
  for (const auto& p : poses_) {
    if (p.light != PoseLight::used) continue;
    const PoseRows A = rowsFor(gravityIn(p.pose));
    H += A.transpose() * w.asDiagonal() * A;
    g += A.transpose() * w.asDiagonal() * p.pose.wrench;
  }
  const Unknowns x = solveSymmetric(H, g);
  constexpr int kGrid = 9;
  const int dof = robot.dof(), moved = std::min(3, dof);
  int combinations = 1;
  for (int i = 0; i < moved; ++i) combinations *= kGrid;
  const Vector3d now = orientationAt(from).transpose() * gravity_;
  MotionLimits limits;
  limits.clearance = clearance;
  limits.gravity = gravity_;
  if (result_.known) limits.payload = Payload{result_.mass, result_.com, Matrix3d::Zero()};
  std::optional<NextPose> best;
  double bestScore = -INFINITY;
  for (int c = 0; c < combinations; ++c) {
    VectorXd q = from;
    for (int i = 0, rest = c; i < moved; ++i, rest /= kGrid) {
      const JointRoom& room = rooms[static_cast<std::size_t>(dof - 1 - i)];
      q(dof - 1 - i) = room.lower + (room.upper - room.lower) * (rest % kGrid + 0.5) / kGrid;
    }
    const Vector3d direction = orientationAt(q).transpose() * gravity_;
    double closest = 180.0;
    for (const auto& p : poses_)
      if (p.light == PoseLight::used) closest = std::min(closest, angle(direction, gravityIn(p.pose)));
    if (closest < 1.5 * options_.closest) continue;
    const PoseRows A = rowsFor(direction);
    const Normal after = H + A.transpose() * w.asDiagonal() * A;
    const Fit fit{x, SymmetricSolver(after).solveAll(Normal::Identity())};
    // Volume of what stays unknown of m and m c; of equal ones the pose that is nearer.
    const double volume = fit.covariance.bottomRightCorner<4, 4>().determinant();
    const double score = -std::log(std::max(volume, 1e-300)) - 0.05 * (q - from).cwiseAbs().maxCoeff();
    if (score <= bestScore || !isReached(*tool_, from, q, limits)) continue;
    bestScore = score;
    const Eigen::Vector4d sd = massAndCentre(fit).diagonal().cwiseMax(0.0).cwiseSqrt();
    best = NextPose{q,
                    fmt::format("Tilt the tool by about {:.0f} degrees from here, as the ghost shows, and hold it "
                                "still for {:g} s.",
                                angle(now, direction), options_.hold),
                    sd(0), sd.tail<3>().maxCoeff()};
  }
  return best;
}

Result<std::vector<StandingPose>> posesOf(const Recording& recording, const RobotModel* robot) {
  const auto motion = standingPoses(recording, robot);
  if (!motion) return motion.error();
  std::vector<StandingPose> poses;
  for (Eigen::Index k = 0; k < motion->size(); ++k) {
    StandingPose pose;
    pose.time = recording.time(k);
    if (recording.hasJoints()) pose.q = recording.q.row(k).transpose();
    pose.R_BS = motion->R_BS[static_cast<std::size_t>(k)];
    pose.wrench = motion->wrench.col(k);
    if (recording.dq.rows() > 0) pose.speed = recording.dq.row(k).cwiseAbs().maxCoeff();
    poses.push_back(std::move(pose));
  }
  return poses;
}

}  // namespace heft
