// Speed of the kinematics that an estimate calls for every sample. It says nothing about whether they are right.
#include <benchmark/benchmark.h>

#include "core/robot/robot_model.h"

namespace {

using heft::RobotModel;
using heft::VectorXd;

void frameMotion(benchmark::State& state) {
  const RobotModel& panda = RobotModel::panda();
  const int link = *panda.findLink("panda_link8");
  const auto X_LS = heft::poseFromXyzRpy({0, 0, 0.04}, {0, 0, -0.785});
  VectorXd q = panda.homePosture();
  const VectorXd dq = VectorXd::Constant(7, 0.3), ddq = VectorXd::Constant(7, 1.5);
  for (auto _ : state) {
    q[0] += 1e-6;
    benchmark::DoNotOptimize(panda.frameMotion(link, X_LS, q, dq, ddq));
  }
}
BENCHMARK(frameMotion);

void linkPoses(benchmark::State& state) {
  const RobotModel& panda = RobotModel::panda();
  VectorXd q = panda.homePosture();
  std::vector<heft::Isometry3d> poses;
  for (auto _ : state) {
    q[0] += 1e-6;
    panda.linkPoses(q, poses);
    benchmark::DoNotOptimize(poses.data());
  }
}
BENCHMARK(linkPoses);

void jacobian(benchmark::State& state) {
  const RobotModel& panda = RobotModel::panda();
  const int link = *panda.findLink("panda_link8");
  VectorXd q = panda.homePosture();
  for (auto _ : state) {
    q[0] += 1e-6;
    benchmark::DoNotOptimize(panda.jacobian(link, heft::Isometry3d::Identity(), q));
  }
}
BENCHMARK(jacobian);

}  // namespace
