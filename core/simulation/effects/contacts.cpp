// What touches the tool: a hand, an edge, a wall.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/simulation/effects/kinds.h"
#include "core/simulation/trajectory.h"

namespace heft {
namespace {

class Touch final : public Effect {
 public:
  explicit Touch(const EffectSetup& setup)
      : size_(setup.size),
        form_(setup.form),
        point_(drawToolPoint(setup.random, setup.scene.payload, 0.10)),
        direction_(drawDirection(setup.random)) {
    RandomStream& random = setup.random;
    const double length = setup.scene.to - setup.scene.from;
    const double lasts = std::min(0.2 * length, random.uniform(0.3, 1.5));
    from_ = setup.scene.from + random.uniform(0.15, 0.8) * length;
    to_ = from_ + lasts;
    edge_ = random.uniform(0.1, 0.4) * lasts;
    if (form_ == "hands") couple_ = 0.05 * size_ * drawDirection(random);
    if (form_ == "wall") placeWall(setup);
    note("point_s_m", point_);
    if (form_ != "wall") {
      note("direction_b", direction_);
      truth().when = {{from_, to_}};
    }
    if (form_ == "hands") note("couple_nm", couple_);
  }

  Vector6d force(const Instant& now, double) override {
    if (form_ == "wall") return leanOnWall(now);
    if (now.time <= from_ || now.time >= to_) return Vector6d::Zero();
    const double level =
        form_ == "bump" ? std::sin(std::numbers::pi * (now.time - from_) / (to_ - from_))
                        : minimumJerk((now.time - from_) / edge_).value * minimumJerk((to_ - now.time) / edge_).value;
    Vector6d wrench = against(now, level * size_ * direction_, point_);
    wrench.tail<3>() -= level * couple_;
    return wrench;
  }

 private:
  /// Where the path of the point goes furthest in a direction, for a short while only.
  void placeWall(const EffectSetup& setup) {
    const auto& path = setup.scene.path;
    constexpr double kLongest = 1.5;  // [s]
    double best = 1e-3;               // [m] a flatter top is no place for a wall
    for (int draw = 0; draw < 40 && !path.empty(); ++draw) {
      const Vector3d n = drawDirection(setup.random);
      std::vector<double> height;
      for (const auto& pose : path) height.push_back(n.dot(pose.X_BS * point_));
      const auto top = std::max_element(height.begin(), height.end());
      double beyond = -1e9;  // highest elsewhere
      const double t = path[static_cast<std::size_t>(top - height.begin())].time;
      for (std::size_t i = 0; i < path.size(); ++i)
        if (std::abs(path[i].time - t) > 0.5 * kLongest) beyond = std::max(beyond, height[i]);
      const double depth = *top - beyond;
      const double share = (t - setup.scene.from) / (setup.scene.to - setup.scene.from);
      if (share < 0.12 || share > 0.88 || depth <= best) continue;
      best = depth;
      normal_ = n;
      surface_ = beyond + 0.3 * depth;
      stiffness_ = size_ / (0.7 * depth);
      truth().when.assign(1, {t - 0.5 * kLongest, t + 0.5 * kLongest});
    }
    note("normal_b", normal_);
    note("surface_m", surface_);
    note("stiffness_n_m", stiffness_);
  }
  Vector6d leanOnWall(const Instant& now) const {
    const double depth = normal_.dot(pointPosition(now.motion, point_)) - surface_;
    if (depth <= 0.0) return Vector6d::Zero();
    const double push = stiffness_ * depth;
    Vector3d slide = pointVelocity(now.motion, point_);
    slide -= slide.dot(normal_) * normal_;
    constexpr double kFriction = 0.2, kCreep = 0.002;  // [-], [m/s]
    return against(now, -push * (normal_ + kFriction / std::hypot(slide.norm(), kCreep) * slide), point_);
  }

  double size_;
  std::string form_;
  Vector3d point_, direction_, couple_ = Vector3d::Zero(), normal_ = Vector3d::UnitZ();
  double from_ = 0.0, to_ = 0.0, edge_ = 0.0, surface_ = 1e9, stiffness_ = 0.0;
};

}  // namespace

void addContactKinds(std::vector<EffectKind>& kinds) {
  kinds.push_back({"contact",
                   "N",
                   "peak force of a touch that lasts 0.3 to 1.5 s",
                   5.0,
                   500.0,
                   false,
                   {"bump", "push", "hands", "wall"},
                   making<Touch>()});
}

}  // namespace heft
