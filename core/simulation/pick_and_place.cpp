// A demonstration at a table: approach, touch, lift, carry and turn, put down; point-to-point legs of minimum jerk.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/random.h"
#include "core/simulation/trajectory.h"

namespace heft {

namespace {

struct Leg {
  double from = 0.0, duration = 0.0;
  VectorXd start, change;
};

class LegTrajectory final : public Trajectory {
 public:
  LegTrajectory(VectorXd home, Tremor tremor) : home_(std::move(home)), tremor_(std::move(tremor)) {}

  void at(double t, VectorXd& q, VectorXd& dq, VectorXd& ddq) const override {
    const auto after =
        std::upper_bound(legs_.begin(), legs_.end(), t, [](double time, const Leg& leg) { return time < leg.from; });
    if (after == legs_.begin()) {
      q = home_;
      dq.setZero();
      ddq.setZero();
    } else {
      evaluate(*(after - 1), t, q, dq, ddq);
    }
    tremor_.add(t, q, dq, ddq);
  }

  static void evaluate(const Leg& leg, double t, VectorXd& q, VectorXd& dq, VectorXd& ddq) {
    const Jet s = minimumJerk((t - leg.from) / leg.duration);
    q = leg.start + s.value * leg.change;
    dq = s.rate / leg.duration * leg.change;
    ddq = s.second / (leg.duration * leg.duration) * leg.change;
  }

  std::vector<Contact> contacts() const override { return contacts_; }
  std::vector<Leg> legs_;
  std::vector<Contact> contacts_;

 private:
  VectorXd home_;
  Tremor tremor_;
};

/// The table scene in base axes, sized after the arm.
struct Scene {
  Isometry3d X_BS_home = Isometry3d::Identity();
  Vector3d up, ahead, aside;  ///< unit vectors
  double reach = 0.6;         ///< [m]
};

Scene makeScene(const Isometry3d& X_BS_home, const Vector3d& gravity) {
  Scene scene;
  scene.X_BS_home = X_BS_home;
  scene.up = gravity.norm() > 1e-6 ? Vector3d(-gravity.normalized()) : Vector3d::UnitZ();
  const Vector3d p = X_BS_home.translation();
  const Vector3d flat = p - p.dot(scene.up) * scene.up;
  scene.ahead = flat.norm() > 1e-3 ? Vector3d(flat.normalized()) : scene.up.unitOrthogonal();
  scene.aside = scene.up.cross(scene.ahead);
  scene.reach = std::clamp(p.norm(), 0.2, 1.5);
  return scene;
}

class Planner {
 public:
  Planner(const RobotModel& robot, const ToolFrame& tool, const Payload& payload, const SimulateOptions& options)
      : robot_(robot),
        tool_(tool),
        options_(options),
        home_(robot.homePosture()),
        rooms_(jointRooms(robot, home_)),
        random_(options.seed, RandomPurpose::motion),
        touch_(options.seed, RandomPurpose::contact) {
    rest_ = std::min(0.3, 0.05 * options.duration);
    for (std::size_t j = 0; j < rooms_.size(); ++j) {
      const auto i = static_cast<Eigen::Index>(j);
      home_(i) = std::clamp(home_(i), rooms_[j].lower, rooms_[j].upper);
    }
    tremor_ = Tremor(options.seed, rooms_, rest_, options.duration - rest_, std::min(0.5, 0.2 * options.duration));
    scene_ = makeScene(robot.linkPose(home_, tool.link) * tool.X_LS, options.gravity);
    posture_ = home_;
    now_ = rest_;
    const Vector3d along = payload.com.norm() > 0.01 ? Vector3d(payload.com.normalized()) : Vector3d::UnitZ();
    tip_ = payload.com + along * std::max(0.03, 0.7 * payload.com.norm());
  }

  std::unique_ptr<LegTrajectory> plan() {
    auto trajectory = std::make_unique<LegTrajectory>(home_, tremor_);
    while (cycle()) {
    }
    trajectory->legs_ = std::move(legs_);
    trajectory->contacts_ = std::move(contacts_);
    return trajectory;
  }

 private:
  /// One object from a spot to another. False once the time is used up.
  bool cycle() {
    const double side = random_.chance(0.5) ? 1.0 : -1.0;
    return visit(side) && carry() && visit(-side) && hold(random_.uniform(0.1, 0.5));
  }

  bool visit(double side) {
    const double reach = scene_.reach;
    const double down = random_.uniform(0.25, 0.36), aside = random_.uniform(0.15, 0.45),
                 ahead = random_.uniform(-0.10, 0.25);
    const Vector3d spot = scene_.X_BS_home.translation() + scene_.ahead * reach * ahead +
                          scene_.aside * reach * side * aside - scene_.up * reach * down;
    const Matrix3d R = turned(0.8, 0.25);
    const Vector3d above = spot + scene_.up * reach * random_.uniform(0.12, 0.20);
    return moveTo(above, R, 1.0) && hold(random_.uniform(0.0, 0.25)) && moveTo(spot, R, 0.5) && touch(spot, R) &&
           hold(random_.uniform(0.1, 0.4)) && moveTo(above, R, 0.8);
  }

  /// High over the table, with the tool turned as a person does to look at it or to pour.
  bool carry() {
    const double reach = scene_.reach;
    const double up = random_.uniform(-0.1, 0.1), aside = random_.uniform(-0.2, 0.2),
                 ahead = random_.uniform(-0.1, 0.2);
    const Vector3d via = scene_.X_BS_home.translation() + scene_.ahead * reach * ahead + scene_.aside * reach * aside +
                         scene_.up * reach * up;
    const Matrix3d R = turned(1.2, 0.8);
    return moveTo(via, R, 1.0) && hold(random_.uniform(0.0, 0.3));
  }

  bool touch(const Vector3d& spot, const Matrix3d& R) {
    Contact contact;
    const double size = touch_.uniform(2.0, 9.0);
    const double angle = touch_.uniform(0.0, 2.0 * std::numbers::pi);
    const Vector3d across = std::cos(angle) * scene_.ahead + std::sin(angle) * scene_.aside;
    // The table pushes up, with some friction; now and then it is a fixture that pushes sideways. The sensor balances
    // it.
    const bool fixture = touch_.chance(0.2);
    contact.force = fixture ? Vector3d(-size * (across + 0.3 * scene_.up))
                            : Vector3d(-size * (scene_.up + touch_.uniform(0.0, 0.3) * across));
    const double y = touch_.uniform(-0.02, 0.02), x = touch_.uniform(-0.02, 0.02);
    contact.point = tip_ + Vector3d(x, y, 0.0);
    const double length = touch_.uniform(0.3, 1.9);
    const bool bump = touch_.chance(0.4);
    const double edge = std::min(0.4 * length, touch_.uniform(0.05, 0.4));
    const bool slides = touch_.chance(0.35);
    const double before = touch_.uniform(0.02, 0.15);
    const double after = touch_.uniform(0.02, 0.15);
    if (now_ + before + length + after > lastMoment()) return false;
    contact.from = now_ + before;
    contact.to = contact.from + length;
    contact.edge = bump ? 0.0 : edge;
    const double end = contact.to + after;
    if (slides) {
      // A short stroke over the table while pressing; only if it is over before the release.
      hold(before + 0.25 * length);
      const double start = now_;
      moveTo(spot + 0.05 * scene_.reach * across, R, 0.3, contact.to - start);
    }
    contacts_.push_back(contact);
    now_ = end;
    return true;
  }

  bool hold(double duration) {
    now_ += duration;
    return now_ < lastMoment();
  }

  double lastMoment() const { return options_.duration - rest_; }

  /// The tool as a person might turn it.
  Matrix3d turned(double mostYaw, double mostTilt) {
    const double tiltAside = random_.uniform(-mostTilt, mostTilt), tiltAhead = random_.uniform(-mostTilt, mostTilt),
                 yaw = random_.uniform(-mostYaw, mostYaw);
    return rotationFromVector(yaw * scene_.up) * rotationFromVector(tiltAside * scene_.ahead) *
           rotationFromVector(tiltAhead * scene_.aside) * scene_.X_BS_home.linear();
  }

  /// False, and nothing planned, if the leg does not end in time or would take longer than `longest` [s].
  bool moveTo(const Vector3d& position, const Matrix3d& R, double pace, double longest = 1e9) {
    Isometry3d X_BS = Isometry3d::Identity();
    X_BS.linear() = R;
    X_BS.translation() = position;
    const VectorXd target = reachFor(X_BS);
    Leg leg{now_, 0.3, posture_, target - posture_};
    const double fast = pace * options_.speed * random_.uniform(0.85, 1.1);
    for (std::size_t j = 0; j < rooms_.size(); ++j) {
      const Jet shake = tremor_.bound(j);
      const double change = std::abs(leg.change(static_cast<Eigen::Index>(j)));
      if (change == 0.0) continue;
      const double speed = std::min(fast * rooms_[j].unit, rooms_[j].velocity - shake.rate);
      const double acceleration = rooms_[j].acceleration - shake.second;
      // Peaks of the minimum-jerk profile: 15/8 and 10/sqrt(3).
      leg.duration = std::max({leg.duration, 1.875 * change / speed, std::sqrt(5.7736 * change / acceleration)});
    }
    VectorXd q(robot_.dof()), dq(robot_.dof()), ddq(robot_.dof());
    for (int pass = 0; pass < 3; ++pass) {
      double load = 0.0;
      constexpr int kSteps = 24;
      for (int k = 1; k < kSteps; ++k) {
        LegTrajectory::evaluate(leg, leg.from + leg.duration * k / kSteps, q, dq, ddq);
        load = std::max(load, cartesianLoad(robot_, tool_, q, dq, ddq));
      }
      constexpr double kForTremor = 0.92;
      if (load <= kForTremor) break;
      leg.duration *= 1.01 * load / kForTremor;
    }
    if (leg.duration > longest || now_ + leg.duration > lastMoment()) return false;
    now_ += leg.duration;
    posture_ = target;
    legs_.push_back(std::move(leg));
    return true;
  }

  /// Damped least squares from the present posture, staying in the joints' room. An arm that cannot get there comes as
  /// near as it can: any posture is good enough for a demonstration.
  VectorXd reachFor(const Isometry3d& X_BS) const {
    VectorXd q = posture_;
    const double arm = 0.5 * scene_.reach;  // [m/rad] makes turning and shifting comparable
    for (int iteration = 0; iteration < 60; ++iteration) {
      const Isometry3d X_BS_now = robot_.linkPose(q, tool_.link) * tool_.X_LS;
      Vector6d error;
      error << X_BS.translation() - X_BS_now.translation(),
          arm * vectorFromRotation(X_BS.linear() * X_BS_now.linear().transpose());
      if (error.norm() < 1e-5) break;
      MatrixXd J = robot_.jacobian(tool_.link, tool_.X_LS, q);
      J.bottomRows(3) *= arm;
      const double damping = 0.03 * scene_.reach;
      const Matrix6d A = J * J.transpose() + damping * damping * Matrix6d::Identity();
      VectorXd step = J.transpose() * A.ldlt().solve(error);
      // A mild pull towards the comfortable posture keeps the elbow from wandering off over many cycles.
      step += 0.02 * (home_ - q);
      const double largest = step.cwiseAbs().maxCoeff();
      if (largest > 0.3) step *= 0.3 / largest;
      q += step;
      for (std::size_t j = 0; j < rooms_.size(); ++j) {
        const auto i = static_cast<Eigen::Index>(j);
        const double shake = tremor_.bound(j).value;
        q(i) =
            std::clamp(q(i), std::min(rooms_[j].lower + shake, home_(i)), std::max(rooms_[j].upper - shake, home_(i)));
      }
    }
    for (std::size_t j = 0; j < rooms_.size(); ++j) {
      const Jet shake = tremor_.bound(j);
      const auto i = static_cast<Eigen::Index>(j);
      if (rooms_[j].velocity <= shake.rate || rooms_[j].acceleration <= shake.second) q(i) = posture_(i);
    }
    return q;
  }

  const RobotModel& robot_;
  const ToolFrame& tool_;
  const SimulateOptions& options_;
  VectorXd home_;
  std::vector<JointRoom> rooms_;
  RandomStream random_, touch_;
  Tremor tremor_;
  Scene scene_;
  VectorXd posture_;
  double now_ = 0.0, rest_ = 0.0;
  Vector3d tip_ = Vector3d::Zero();  ///< p_SoC_S of the tool's tip
  std::vector<Leg> legs_;
  std::vector<Contact> contacts_;
};

}  // namespace

std::unique_ptr<Trajectory> planPickAndPlace(const RobotModel& robot, const ToolFrame& tool, const Payload& payload,
                                             const SimulateOptions& options) {
  return Planner(robot, tool, payload, options).plan();
}

}  // namespace heft
