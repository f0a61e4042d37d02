#include "core/coach/deciding_pose.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "core/base/say.h"
#include "core/coach/pose_guide.h"
#include "core/conventions/fit.h"
#include "core/motion/motion.h"
#include "core/simulation/trajectory.h"
#include "core/wrench/regressor.h"

namespace heft {

namespace {

constexpr int kGridOfJoint = 9;
/// Less does not decide, by chance and by what else bends a wrench.
constexpr double kDecides = 4.0;  // Standard deviations

/// What a reading expects in each of `targets`, as the numbers look under the stated conventions.
struct Expected {
  MatrixXd wrench;             ///< 6 x K [N, N m]
  VectorXd forceSd, torqueSd;  ///< What is known of a component
};

Expected expectedBy(const conventions::Reading& reading, const conventions::Reading& stated, const Motion& poses,
                    Motion targets, bool posesInFile) {
  const Motion so = conventions::readSo(poses, stated, reading, posesInFile);
  const conventions::Blocks blocks = conventions::blocksOf(so, so.wrench, {}, true);
  conventions::Way way;
  way.axes = conventions::kStated;
  conventions::Place place;
  place.gravity = reading.gravity;
  constexpr int kRounds = 8;
  const conventions::Fit fit =
      conventions::robustFit(blocks, way, conventions::Free::nothing, place, reading.gravity, kRounds);
  const PoseGuideOptions usual;
  const Eigen::Index K = targets.size();
  Expected out;
  out.forceSd.resize(K);
  out.torqueSd.resize(K);
  targets.wrench.resize(6, K);
  for (Eigen::Index k = 0; k < K; ++k) {
    Eigen::Matrix<double, 6, 16> A;
    const Vector3d s = -(targets.R_BS[static_cast<std::size_t>(k)].transpose() * reading.gravity);
    A << regressor({s, Vector3d::Zero(), Vector3d::Zero()}), Matrix6d::Identity();
    targets.wrench.col(k) = A * fit.x;
    const Vector6d variance = (A * fit.covariance * A.transpose()).diagonal().cwiseMax(0.0);
    out.forceSd(k) = std::sqrt(usual.forceSd * usual.forceSd + variance.head<3>().mean());
    out.torqueSd(k) = std::sqrt(usual.torqueSd * usual.torqueSd + variance.tail<3>().mean());
  }
  out.wrench = conventions::readSo(std::move(targets), reading, stated, false).wrench;
  return out;
}

}  // namespace

std::optional<TiedReadings> tiedReadings(const conventions::Report& report) {
  if (report.ties.empty()) return std::nullopt;
  const auto& other = report.ties.front();
  if (report.suggested) return TiedReadings{*report.suggested, other.reading, report.sentence, other.sentence};
  return TiedReadings{report.stated, other.reading, heft::say("The readings follow the stated conventions."),
                      other.sentence};
}

std::optional<DecidingPose> decidingPose(const Recording& poses, const GuidedTool& tool, const TiedReadings& tied,
                                         const VectorXd& from, const Clearance* clearance) {
  const RobotModel& robot = *tool.robot;
  if (!poses.hasJoints() || from.size() != robot.dof()) return std::nullopt;
  const auto motion = standingPoses(poses, &robot);
  if (!motion) return std::nullopt;
  const auto rooms = jointRooms(robot, robot.homePosture());
  const int dof = robot.dof(), moved = std::min(3, dof);
  Eigen::Index count = 1;
  for (int i = 0; i < moved; ++i) count *= kGridOfJoint;
  Recording grid;
  grid.meta = poses.meta;
  grid.meta.numbersArePlain();
  grid.time = VectorXd::LinSpaced(count, 0.0, static_cast<double>(count - 1));
  grid.wrench.setZero(count, 6);
  grid.q.resize(count, dof);
  for (Eigen::Index k = 0; k < count; ++k) {
    grid.q.row(k) = from.transpose();
    Eigen::Index rest = k;
    for (int i = 0; i < moved; ++i, rest /= kGridOfJoint) {
      const JointRoom& room = rooms[static_cast<std::size_t>(dof - 1 - i)];
      grid.q(k, dof - 1 - i) =
          room.lower + (room.upper - room.lower) * (static_cast<double>(rest % kGridOfJoint) + 0.5) / kGridOfJoint;
    }
  }
  const auto targets = standingPoses(grid, &robot);
  if (!targets) return std::nullopt;
  const conventions::Reading stated = conventions::statedIn(poses.meta);
  const Expected a = expectedBy(tied.first, stated, *motion, *targets, poses.hasOrientation()),
                 b = expectedBy(tied.second, stated, *motion, *targets, poses.hasOrientation());
  const MatrixXd d = a.wrench - b.wrench;
  const VectorXd apart =
      (d.topRows<3>().colwise().squaredNorm().transpose().cwiseQuotient(a.forceSd.cwiseAbs2() + b.forceSd.cwiseAbs2()) +
       d.bottomRows<3>().colwise().squaredNorm().transpose().cwiseQuotient(a.torqueSd.cwiseAbs2() +
                                                                           b.torqueSd.cwiseAbs2()))
          .cwiseSqrt();
  // Of poses that decide as well the nearer one.
  const VectorXd far = (grid.q.rowwise() - from.transpose()).cwiseAbs().rowwise().maxCoeff();
  const VectorXd score = apart.array().log() - 0.05 * far.array();
  std::vector<Eigen::Index> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::ranges::sort(order, [&](Eigen::Index i, Eigen::Index k) { return score(i) > score(k); });
  MotionLimits limits;
  limits.clearance = clearance;
  limits.gravity = poses.meta.gravity;
  for (const Eigen::Index k : order)
    if (apart(k) > kDecides && isReached(tool, from, grid.q.row(k).transpose(), limits))
      return DecidingPose{grid.q.row(k).transpose(), apart(k)};
  return std::nullopt;
}

}  // namespace heft
