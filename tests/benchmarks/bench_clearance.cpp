// How long a motion takes to be checked against arm, tool and room, and the coach's proposal there. It says nothing
// about whether that is right.
#include <benchmark/benchmark.h>

#include "core/coach/coach.h"
#include "core/collision/clearance.h"
#include "core/online/online_information.h"
#include "core/simulation/simulate.h"
#include "tests/core/collision/random_motion.h"

namespace {

using namespace heft;

Clearance tenObstacles() {
  const RobotModel& panda = RobotModel::panda();
  HeldTool tool{*panda.findLink("panda_link8"), Isometry3d(Eigen::Translation3d(0.0, 0.0, 0.04)), std::nullopt};
  tool.shape = parseShape("box:0.06,0.06,0.16@0,0,0.08").value();
  Room room;
  room.obstacles.push_back({"table", RoomPlane{{0.0, 0.0, -0.4}, Vector3d::UnitZ()}});
  for (int i = 0; i < 9; ++i) {
    Isometry3d X_BO = Isometry3d::Identity();
    X_BO.translation() = 1.3 * Vector3d(std::cos(0.7 * i), std::sin(0.7 * i), 0.3);
    room.obstacles.push_back({"rack " + std::to_string(i), RoomBox{{0.2, 0.2, 0.8}, X_BO}});
  }
  Findings findings;
  return std::move(Clearance::of(panda, tool, room, findings).value());
}

/// A free motion of 20 s in many small moves about the home posture, as guiding and excitation make them.
void twentySeconds(benchmark::State& state) {
  const Clearance clearance = tenObstacles();
  JointMotion motion = test::randomMotion(RobotModel::panda(), 5, 21, 1.0);
  motion.q = (0.12 * motion.q).rowwise() + (0.88 * RobotModel::panda().homePosture()).transpose();
  for (auto _ : state) {
    const auto found = clearance.firstConflict(motion);
    if (found) state.SkipWithError(found->sentence().c_str());
    benchmark::DoNotOptimize(found);
  }
}
BENCHMARK(twentySeconds)->Unit(benchmark::kMillisecond);

/// After a slow demonstration of five seconds, which leaves all candidates in question.
void proposal(benchmark::State& state) {
  const Clearance clearance = tenObstacles();
  SimulateOptions simulation;
  simulation.motion = MotionKind::free;
  simulation.duration = 5.0;
  simulation.speed = 0.2;
  const Payload payload{0.8, {0.0, 0.0, 0.08}, Vector3d(0.003, 0.003, 0.001).asDiagonal()};
  const Recording recording = simulate(RobotModel::panda(), payload, simulation)->recording;
  const OnlineInformation information = informationOf(recording, &RobotModel::panda(), {}).value();
  const GuidedTool tool = guidedTool(RobotModel::panda(), recording.meta.mount).value();
  CoachOptions options;
  options.want = CoachGoal::inertia;
  options.limits.clearance = &clearance;
  for (auto _ : state) {
    const auto advice = advise(information, tool, recording.meta.gravity, RobotModel::panda().homePosture(), options);
    if (!advice || !advice->needed) state.SkipWithError("no advice");
    benchmark::DoNotOptimize(advice);
  }
}
BENCHMARK(proposal)->Unit(benchmark::kMillisecond);

void buildPanda(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(tenObstacles());
}
BENCHMARK(buildPanda)->Unit(benchmark::kMillisecond);

}  // namespace
