#include "core/simulation/virtual_rig.h"

#include <cmath>

#include "core/base/say.h"
#include "core/simulation/random.h"
#include "core/simulation/sensor.h"
#include "core/wrench/regressor.h"

namespace heft {

struct VirtualRig::Impl {
  VirtualRigOptions options;
  GuidedArm arm;
  SensorNoise noise;
  Vector6d bias;
  std::vector<RandomStream> encoders;
  VirtualSample sample;
  std::uint64_t count = 0;

  Impl(const RobotModel& robot, const VirtualRigOptions& o, int link)
      : options(o),
        arm(robot, {link, poseFromXyzRpy(o.mount.xyz, o.mount.rpy)}),
        noise(o.sensor, o.seed, o.rateHz),
        bias(drawBias(o.sensor, o.seed)) {
    for (int j = 0; j < robot.dof(); ++j)
      encoders.emplace_back(o.seed, RandomPurpose::encoder, static_cast<std::uint64_t>(j));
  }
};

VirtualRig::VirtualRig(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
VirtualRig::VirtualRig(VirtualRig&&) noexcept = default;
VirtualRig& VirtualRig::operator=(VirtualRig&&) noexcept = default;
VirtualRig::~VirtualRig() = default;

Result<VirtualRig> VirtualRig::create(const RobotModel& robot, const VirtualRigOptions& options) {
  if (const auto physical = checkPhysical(options.payload); !physical.physical)
    return Error{heft::say("The virtual tool cannot exist: {}", physical.reason)};
  if (!(options.rateHz >= 200.0 && options.rateHz <= 10000.0))
    return Error{heft::say("The virtual arm samples at 200 to 10000 Hz, not at {} Hz.", options.rateHz)};
  const auto link = robot.findLink(options.mount.parent);
  if (!link)
    return Error{heft::say("The robot {} has no link {} to mount the sensor on.", robot.name(), options.mount.parent)};
  return VirtualRig(std::make_unique<Impl>(robot, options, *link));
}

GuidedArm& VirtualRig::arm() { return impl_->arm; }
const GuidedArm& VirtualRig::arm() const { return impl_->arm; }
const VirtualRigOptions& VirtualRig::options() const { return impl_->options; }

const VirtualSample& VirtualRig::next() {
  Impl& s = *impl_;
  const VirtualRigOptions& o = s.options;
  if (s.count > 0) s.arm.step(1.0 / o.rateHz);
  VirtualSample& out = s.sample;
  out.time = static_cast<double>(s.count++) / o.rateHz;
  const FrameMotion motion =
      s.arm.robot().frameMotion(s.arm.tool().link, s.arm.tool().X_LS, s.arm.q(), s.arm.dq(), s.arm.ddq());
  const Matrix3d R_SB = motion.X_BS.linear().transpose();
  const WrenchState state{R_SB * (motion.a_BSo_B - o.gravity), R_SB * motion.w_BS_B, R_SB * motion.alpha_BS_B};
  out.wrench = digitised(o.sensor, predictWrench(o.payload, state) + s.bias + s.noise.next());
  out.q = s.arm.q();
  out.dq = s.arm.dq();
  for (Eigen::Index j = 0; j < out.q.size(); ++j) {
    out.q(j) += o.positionNoise * s.encoders[static_cast<std::size_t>(j)].normal();
    if (o.velocityQuantum > 0.0) out.dq(j) = std::nearbyint(out.dq(j) / o.velocityQuantum) * o.velocityQuantum;
  }
  return out;
}

Result<bool> VirtualRig::changeTool(const Payload& payload) {
  if (const auto physical = checkPhysical(payload); !physical.physical)
    return Error{heft::say("The virtual tool cannot exist: {}", physical.reason)};
  impl_->options.payload = payload;
  return true;
}

RecordingMeta VirtualRig::metaFor(const VirtualRigOptions& options) {
  RecordingMeta meta;
  meta.robot = options.robotReference;
  meta.mount = options.mount;
  meta.sensorModel = options.sensor.name;
  meta.gravity = options.gravity;
  return meta;
}

Payload practiceTool(std::uint64_t seed) {
  RandomStream random(seed, RandomPurpose::effect, 77);
  const auto box = [&](double mass, const Vector3d& edges, const Vector3d& at, const Vector3d& rpy) {
    Payload body;
    body.mass = mass;
    const Vector3d squares = edges.cwiseAbs2();
    body.inertiaCom = (mass / 12.0 * (Vector3d::Constant(squares.sum()) - squares)).asDiagonal();
    return transformed(body, poseFromXyzRpy(at, rpy));
  };
  const double mass = 0.25 * std::exp(random.uniform(0.0, 1.0) * std::log(1.6 / 0.25));
  const double share = random.uniform(0.35, 0.65);
  const double height = random.uniform(0.05, 0.08);
  const double handYaw = random.uniform(-0.4, 0.4);
  const Vector3d handEdges{random.uniform(0.06, 0.10), random.uniform(0.05, 0.12), height};
  const Payload hand = box(share * mass, handEdges, {0.0, 0.0, 0.5 * height}, {0.0, 0.0, handYaw});
  const double length = random.uniform(0.06, 0.14);
  const Vector3d heldTurn{random.uniform(-0.2, 0.2), random.uniform(-0.2, 0.2), 0.0};
  const Vector3d heldAt{random.uniform(-0.03, 0.03), random.uniform(-0.03, 0.03), height + 0.45 * length};
  const Vector3d heldEdges{random.uniform(0.03, 0.06), random.uniform(0.03, 0.06), length};
  const Payload held = box((1.0 - share) * mass, heldEdges, heldAt, heldTurn);
  return composed(hand, held);
}

}  // namespace heft
