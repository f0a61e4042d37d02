#include "tests/support/injection.h"

#include <algorithm>
#include <cmath>

namespace heft::test {
namespace {

/// What the motion of a recording says about one of its rows.
Instant instantAt(const Motion& motion, const Vector3d& gravity, double time) {
  const auto k =
      std::clamp<Eigen::Index>(std::llround((time - motion.startTime) * motion.rateHz), 0, motion.size() - 1);
  Instant now;
  now.time = time;
  now.gravity = gravity;
  now.state = {motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)};
  const Matrix3d R = motion.R_BS[static_cast<std::size_t>(k)];
  now.motion.X_BS.linear() = R;
  now.motion.X_BS.translation() = motion.position.col(k);
  now.motion.v_BSo_B = motion.velocity.col(k);
  now.motion.w_BS_B = R * now.state.omega;
  now.motion.alpha_BS_B = R * now.state.alpha;
  now.motion.a_BSo_B = R * now.state.specificForce + gravity;
  return now;
}

/// The effect turns stated geometry into true geometry; the recording's is true, so what is stated must be wrong.
void misstate(const Effects& effects, RecordingMeta& meta) {
  const Isometry3d X = poseFromXyzRpy(meta.mount.xyz, meta.mount.rpy);
  Geometry altered{X, Vector3d::Zero()};
  Matrix3d turned;
  for (const auto& effect : effects) effect->alterGeometry(altered);
  for (int i = 0; i < 3; ++i) {
    Geometry axis{X, Vector3d::Unit(i)};
    for (const auto& effect : effects) effect->alterGeometry(axis);
    turned.col(i) = axis.gravity;
  }
  if (!turned.isIdentity(0.0)) meta.gravity = turned.transpose() * meta.gravity;
  if (!altered.X_LS.isApprox(X, 0.0)) {
    const Isometry3d stated = X * (X.inverse() * altered.X_LS).inverse();
    meta.mount.xyz = stated.translation();
    meta.mount.rpy = rpyFromRotation(stated.linear());
  }
}

}  // namespace

Result<Injected> inject(const Recording& recording, const RobotModel* robot, const Payload& payload,
                        const Vector6d& bias, const std::vector<EffectRequest>& requests, std::uint64_t seed) {
  MotionOptions options;
  options.outputRateHz = 0.0;
  const auto motion = motionOf(recording, robot, options);
  if (!motion) return motion.error();
  const Eigen::Index rows = recording.rows();
  const Vector3d gravity = recording.meta.gravity;
  EffectScene scene;
  scene.robot = robot;
  scene.payload = payload;
  scene.sensor.forceResolution.setZero();
  scene.sensor.torqueResolution.setZero();
  scene.gravity = gravity;
  scene.from = recording.time(0);
  scene.to = recording.time(rows - 1);
  scene.rateHz = recording.rateHz();
  for (double t = scene.from; t <= scene.to; t += 0.05)
    scene.path.push_back({t, instantAt(*motion, gravity, t).motion.X_BS});
  auto made = makeEffects(requests, seed, scene);
  if (!made) return made.error();
  const Effects effects = std::move(*made);

  Injected out{recording, {}};
  Recording& changed = out.recording;
  for (Eigen::Index k = 0; k < rows; ++k) {
    Instant now = instantAt(*motion, gravity, recording.time(k));
    if (recording.hasJoints()) now.q = recording.q.row(k).transpose();
    const double step = k > 0 ? recording.time(k) - recording.time(k - 1) : 1.0 / scene.rateHz;
    Vector6d load = recording.wrench.row(k).transpose() - bias;
    for (const auto& effect : effects) load += effect->force(now, step);
    for (const auto& effect : effects) load = effect->gauge(load);
    changed.wrench.row(k) = load + bias;
  }
  for (const auto& effect : effects) effect->filter(changed.wrench, scene.rateHz);
  const SampledWrench fresh = changed.wrench;
  for (Eigen::Index k = 0; k < rows; ++k) {
    double age = 0.0;
    for (const auto& effect : effects) age += effect->age(recording.time(k));
    if (age != 0.0)
      changed.wrench.row(k) = fresh.row(std::clamp<Eigen::Index>(k - std::llround(age * scene.rateHz), 0, rows - 1));
  }
  for (const auto& effect : effects) effect->shiftZero(recording.time, changed.wrench);
  for (const auto& effect : effects) effect->convert(changed.wrench);
  misstate(effects, changed.meta);
  for (const auto& effect : effects) {
    effect->log(changed);
    out.effects.push_back(effect->truth());
  }
  return out;
}

Result<Injected> drawInjected(const Recording& recording, const RobotModel* robot, const Payload& payload,
                              const Vector6d& bias, std::uint64_t seed, double multiple) {
  const auto fits = [&](const std::string& id) {
    const auto among = [&](std::initializer_list<const char*> ids) {
      return std::any_of(ids.begin(), ids.end(), [&](const char* each) { return id == each; });
    };
    if (among({"sensor_bias", "frame_error"})) return false;  // swallowed, or already there for all one knows
    const bool joints = recording.hasJoints(), velocities = recording.dq.rows() > 0 || recording.twist.rows() > 0;
    if (among({"joint_offset", "lever_arm"})) return joints;
    if (among({"motion_lag", "derivative_noise"})) return velocities;
    if (among({"cable_pull", "viscous_drag", "coulomb_friction"})) return joints || recording.hasPosition();
    return true;
  };
  std::vector<const EffectKind*> kinds;
  for (const EffectKind& kind : effectKinds())
    if (fits(kind.id)) kinds.push_back(&kind);
  const EffectKind& kind = *kinds[seed % kinds.size()];
  RandomStream random(seed, RandomPurpose::effect, 1u << 22);
  const auto form = static_cast<std::size_t>(random.uniform() * static_cast<double>(kind.forms.size()));
  return inject(recording, robot, payload, bias, {{kind.id, kind.forms[form], multiple * kind.typical}}, seed);
}

}  // namespace heft::test
