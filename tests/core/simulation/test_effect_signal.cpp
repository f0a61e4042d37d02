// What gauges, filters, transport, converter and log do to the signal.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "tests/core/simulation/effect_sample.h"

#include "core/math/degrees.h"

namespace heft {
namespace {

double largest(const SampledWrench& a) { return a.cwiseAbs().maxCoeff(); }

TEST(EffectSignal, LatePacketsAreExactlyLate) {
  const SampledWrench now = simulatedOrDie(quietOptions()).signal;
  for (const int ms : {7, 40, -12}) {
    const SampledWrench late = withEffect("time_offset=" + std::to_string(ms)).signal;
    const Eigen::Index d = ms, n = now.rows();
    for (Eigen::Index k = 50; k < n - 50; ++k) ASSERT_LT((late.row(k) - now.row(k - d)).norm(), 1e-9) << ms << " ms";
  }
  // Between two samples: late by half a step lies in the middle of a smooth signal, to third order.
  const SampledWrench half = withEffect("time_offset=0.5").signal;
  for (Eigen::Index k = 10; k < now.rows() - 10; ++k) {
    const auto middle = (9.0 * (now.row(k) + now.row(k - 1)) - now.row(k + 1) - now.row(k - 2)) / 16.0;
    ASSERT_LT((half.row(k) - middle).norm(), 1e-5);
  }
}

TEST(EffectSignal, CreepingDelayGrowsToTwiceItsMean) {
  const SampledWrench now = simulatedOrDie(quietOptions()).signal;
  const SampledWrench late = withEffect("time_offset/creeping=10").signal;
  EXPECT_LT((late.topRows(50) - now.topRows(50)).cwiseAbs().maxCoeff(), 1e-3);
  const Eigen::Index k = 4000;  // the middle of 8 s: 10 ms
  EXPECT_LT((late.row(k) - now.row(k - 10)).norm(), 1e-9);
}

TEST(EffectSignal, FiltersHaveTheirLagAndSolveTheirEquation) {
  const SampledWrench now = simulatedOrDie(quietOptions()).signal;
  const SampledWrench low = withEffect("low_pass_lag=20").signal;
  // T y' + y = u, with the central difference of y.
  for (Eigen::Index k = 100; k < now.rows() - 2; k += 31)
    EXPECT_LT((0.02 * (low.row(k + 1) - low.row(k - 1)) * 500.0 + low.row(k) - now.row(k)).norm(), 2e-3);
  // All forms lag a slow signal by the stated time: compare with the delayed signal.
  for (const char* form : {"low_pass_lag=20", "low_pass_lag/second-order=20", "low_pass_lag/average=20"}) {
    const SampledWrench slow = withEffect(form, quietOptions(MotionKind::excitation)).signal;
    const SampledWrench same = simulatedOrDie(quietOptions(MotionKind::excitation)).signal;
    double best = 1e9;
    Eigen::Index at = 0;
    for (Eigen::Index d = 5; d <= 35; ++d) {
      const double error = (slow.bottomRows(slow.rows() - 40) - same.middleRows(40 - d, same.rows() - 40)).norm();
      if (error < best) {
        best = error;
        at = d;
      }
    }
    EXPECT_NEAR(static_cast<double>(at), 20.0, 1.0) << form;
  }
}

TEST(EffectSignal, FilterActsOnTheNoiseToo) {
  SimulateOptions options = quietOptions();
  options.sensor.forceNoise = 0.1;
  const auto roughness = [](const Simulated& s) {
    const SampledWrench noise = s.recording.wrench - s.signal;
    return (noise.bottomRows(noise.rows() - 1) - noise.topRows(noise.rows() - 1)).norm();
  };
  EXPECT_LT(roughness(withEffect("low_pass_lag=15", options)), 0.2 * roughness(simulatedOrDie(options)));
}

TEST(EffectSignal, RotatedMountIsARotatedFrame) {
  const Simulated turned = withEffect("sensor_rotation=3");
  const Matrix3d R = rotationFromVector(hidden(turned, "angle_rad")[0] * hiddenVector(turned, "axis_s"));
  EXPECT_NEAR(vectorFromRotation(R).norm(), 3.0 * kRadPerDegree, 1e-12);
  // The same payload described in the turned axes, on a mount that says so.
  SimulateOptions options = quietOptions();
  options.mount.rpy = rpyFromRotation(rotationFromRpy(options.mount.rpy) * R);
  Isometry3d X = Isometry3d::Identity();
  X.linear() = R.transpose();
  const Payload payload = transformed(sampleTool(), X);
  const RobotModel& robot = RobotModel::panda();
  const Isometry3d X_LS = poseFromXyzRpy(options.mount.xyz, options.mount.rpy);
  for (Eigen::Index k = 0; k < turned.q.rows(); k += 101) {
    const FrameMotion m = robot.frameMotion(*robot.findLink("panda_link8"), X_LS, turned.q.row(k).transpose(),
                                            turned.dq.row(k).transpose(), turned.ddq.row(k).transpose());
    const Matrix3d R_SB = m.X_BS.linear().transpose();
    const Vector6d expected =
        predictWrench(payload, {R_SB * (m.a_BSo_B - options.gravity), R_SB * m.w_BS_B, R_SB * m.alpha_BS_B});
    EXPECT_LT((turned.signal.row(k).transpose() - expected).norm(), 1e-10);
  }
  EXPECT_EQ(turned.recording.meta.mount.rpy, quietOptions().mount.rpy);
}

TEST(EffectSignal, TiltAndLeverChangeTheWorldNotTheMeta) {
  const Simulated tilted = withEffect("gravity_tilt=5"), shifted = withEffect("lever_arm=30");
  SimulateOptions options = quietOptions();
  options.gravity = rotationFromVector(5.0 * kRadPerDegree * hiddenVector(tilted, "axis_b")) * options.gravity;
  EXPECT_LT(std::abs(hiddenVector(tilted, "axis_b").z()), 1e-12);
  // The motion is planned without knowing of the tilt, so only compare at the same joints: the planned motion of
  // free guiding does not depend on gravity.
  EXPECT_LT(largest(tilted.signal - simulatedOrDie(options).signal), 1e-10);
  EXPECT_EQ(tilted.recording.meta.gravity, quietOptions().gravity);

  const Vector3d d = hiddenVector(shifted, "offset_s_m");
  EXPECT_NEAR(d.norm(), 0.03, 1e-12);
  for (Eigen::Index k = 0; k < shifted.q.rows(); k += 101) {
    const FrameMotion m = motionAt(shifted, k);  // at the stated place
    const Matrix3d R = m.X_BS.linear();
    const Vector3d r = R * d;
    const Vector3d a = m.a_BSo_B + m.alpha_BS_B.cross(r) + m.w_BS_B.cross(m.w_BS_B.cross(r));
    const Vector6d expected = predictWrench(sampleTool(), {R.transpose() * (a - shifted.truth.options.gravity),
                                                           R.transpose() * m.w_BS_B, R.transpose() * m.alpha_BS_B});
    EXPECT_LT((shifted.signal.row(k).transpose() - expected).norm(), 1e-10);
  }
  EXPECT_EQ(shifted.recording.meta.mount.xyz, quietOptions().mount.xyz);
}

TEST(EffectSignal, GainAndCrosstalkAreMatrices) {
  const SampledWrench plain = simulatedOrDie(quietOptions()).signal;
  const Simulated gain = withEffect("gain_error/each=6");
  const auto g = hidden(gain, "gain");
  for (int c = 0; c < 6; ++c) EXPECT_LT((gain.signal.col(c) - g[c] * plain.col(c)).norm(), 1e-9);
  const Simulated one = withEffect("gain_error=6");
  int changed = 0;
  for (const double x : hidden(one, "gain")) changed += std::abs(x - 1.06) < 1e-12;
  EXPECT_EQ(changed, 1);
  const Simulated mixed = withEffect("crosstalk/full=6");
  const auto m = hidden(mixed, "matrix_rows");
  for (Eigen::Index k = 0; k < plain.rows(); k += 97)
    for (int r = 0; r < 6; ++r) {
      double expected = plain(k, r);
      for (int c = 0; c < 6; ++c) expected += m[6 * r + c] * plain(k, c);
      EXPECT_NEAR(mixed.signal(k, r), expected, 1e-10);
      EXPECT_EQ(m[7 * r], 0.0);
    }
}

TEST(EffectSignal, HysteresisDependsOnTheWayBack) {
  const Simulated simulated = withEffect("hysteresis=5");
  const SampledWrench memory = added(simulated) / hidden(simulated, "share")[0];
  const auto way = hidden(simulated, "turning_way");
  for (int c = 0; c < 6; ++c) EXPECT_LE(memory.col(c).cwiseAbs().maxCoeff(), way[c] + 1e-9);
  EXPECT_GT(largest(memory), 0.1 * way[0]);
}

TEST(EffectSignal, ZeroMovesAsStated) {
  const SimulateOptions options = quietOptions();
  const auto zero = [](const Simulated& s) { return SampledWrench(s.recording.wrench - s.signal); };
  const SampledWrench linear = zero(withEffect("bias_drift=0.8"));
  const Eigen::Index n = linear.rows();
  EXPECT_NEAR((linear.row(n - 1) - linear.row(0)).head<3>().norm(), 0.8, 1e-3);
  EXPECT_LT((linear.row(n / 2) - 0.5 * (linear.row(0) + linear.row(n - 1))).norm(), 1e-3);
  const SampledWrench warm = zero(withEffect("bias_drift/warm-up=0.8"));
  EXPECT_GT(warm.row(n / 4).head<3>().norm(), 0.3 * 0.8);
  const Simulated jumping = withEffect("bias_drift/jump=0.8");
  const SampledWrench jump = zero(jumping);
  for (Eigen::Index k = 0; k < n; k += 13) {
    const bool after = jumping.recording.time(k) >= jumping.truth.effects[0].when[0].first;
    EXPECT_NEAR(jump.row(k).head<3>().norm(), after ? 0.8 : 0.0, 1e-12);
  }
  const SampledWrench bias = zero(withEffect("sensor_bias=2"));
  EXPECT_LT((bias.row(0) - bias.row(n - 1)).norm(), 1e-12);
  EXPECT_NEAR(bias.row(0).head<3>().norm(), 2.0, 1e-12);
}

TEST(EffectSignal, ClipsItsShareAtOneLevel) {
  SimulateOptions options = quietOptions();
  options.sensor.forceNoise = 0.05;
  options.sensor.torqueNoise = 0.002;
  const Simulated simulated = withEffect("saturation=5", options);
  const auto axis = static_cast<Eigen::Index>(hidden(simulated, "axis")[0]);
  const double level = hidden(simulated, "level")[0];
  const VectorXd x = simulated.recording.wrench.col(axis).cwiseAbs();
  EXPECT_EQ(x.maxCoeff(), level);
  EXPECT_NEAR(static_cast<double>((x.array() == level).count()) / static_cast<double>(x.size()), 0.05, 0.002);
  EXPECT_GT(withEffect("saturation/soft=5", options).recording.wrench.col(axis).cwiseAbs().maxCoeff(), level);
}

TEST(EffectSignal, StepsAreWholeMultiples) {
  const Simulated simulated = withEffect("quantisation=0.5", optionsFor(MotionKind::free, 5, 8.0));
  const auto steps = hidden(simulated, "step_n_nm");
  for (int c = 0; c < 6; ++c) {
    const VectorXd counts = simulated.recording.wrench.col(c) / steps[c];
    EXPECT_LT((counts - counts.array().round().matrix()).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST(EffectSignal, RowsRepeatDropAndSpikeAsOftenAsStated) {
  const SimulateOptions options = optionsFor(MotionKind::free, 5, 20.0);
  const Simulated plain = simulatedOrDie(options);
  const auto repeated = [](const Recording& r) {
    Eigen::Index count = 0;
    for (Eigen::Index k = 1; k < r.rows(); ++k) count += r.wrench.row(k) == r.wrench.row(k - 1);
    return static_cast<double>(count) / static_cast<double>(r.rows());
  };
  EXPECT_LT(repeated(plain.recording), 0.001);
  EXPECT_NEAR(repeated(withEffect("repeats=33", options).recording), 0.33, 0.01);
  EXPECT_NEAR(repeated(withEffect("repeats/random=33", options).recording), 0.33, 0.02);
  EXPECT_NEAR(repeated(withEffect("dropouts=5", options).recording), 0.05, 0.015);
  const Recording missing = withEffect("dropouts/missing=5", options).recording;
  EXPECT_NEAR(static_cast<double>(missing.rows()), 19000.0, 350.0);
  EXPECT_EQ(missing.q.rows(), missing.rows());
  EXPECT_EQ(missing.wrench.rows(), missing.rows());
  const SampledWrench spikes = withEffect("spikes=1", options).recording.wrench - plain.recording.wrench;
  const auto hit = (spikes.array() != 0.0).rowwise().any().count();
  EXPECT_NEAR(static_cast<double>(hit), 200.0, 50.0);
  EXPECT_GE(spikes.leftCols(3).cwiseAbs().maxCoeff(), 10.0);
  const Recording late = withEffect("jitter=3", options).recording;
  const VectorXd lateness = late.time - plain.recording.time;
  EXPECT_GE(lateness.minCoeff(), 0.0);
  EXPECT_LE(lateness.maxCoeff(), 0.0032);
  for (Eigen::Index k = 1; k < late.rows(); ++k) ASSERT_GT(late.time(k), late.time(k - 1));
}

TEST(EffectSignal, JointsAndVelocitiesAreReportedWrongly) {
  const Simulated plain = simulatedOrDie(quietOptions());
  const Simulated offset = withEffect("joint_offset/4=2");
  VectorXd expected = VectorXd::Zero(7);
  expected(3) = 2.0 * kRadPerDegree;
  EXPECT_LT((offset.recording.q - plain.recording.q).rowwise().sum().array().cwiseAbs().maxCoeff() - expected(3),
            1e-12);
  EXPECT_LT((offset.recording.q.row(7) - plain.recording.q.row(7) - expected.transpose()).norm(), 1e-12);
  EXPECT_EQ(offset.recording.wrench, plain.recording.wrench);

  EXPECT_LT((withEffect("derivative_noise=20").recording.dq - 0.8 * plain.recording.dq).norm(), 1e-9);
  const MatrixXd late = withEffect("motion_lag/late=30").recording.dq;
  EXPECT_LT((late.row(2000) - plain.recording.dq.row(1970)).norm(), 1e-9);
  const MatrixXd filtered = withEffect("motion_lag=30").recording.dq;
  const MatrixXd& exact = plain.recording.dq;
  for (Eigen::Index k = 500; k < exact.rows() - 1; k += 41)
    EXPECT_LT((0.03 * 500.0 * (filtered.row(k + 1) - filtered.row(k - 1)) + filtered.row(k) - exact.row(k)).norm(),
              0.02 * exact.cwiseAbs().maxCoeff());
}

TEST(EffectSignal, AMotionSmoothedBeforeItWasWrittenLosesWhatIsFast) {
  const Simulated plain = simulatedOrDie(quietOptions());
  const Simulated smoothed = withEffect("derivative_noise/recorded=10");
  EXPECT_EQ(smoothed.recording.wrench, plain.recording.wrench);
  // A narrow filter takes width^2 / 2 of the second derivative, the stated share at 5 Hz, and is not late.
  const auto& noted = smoothed.truth.effects.front().parameters;
  const double width = std::ranges::find_if(noted, [](const auto& p) { return p.name == "width_s"; })->values.front();
  EXPECT_NEAR(0.5 * std::pow(width * 2.0 * std::numbers::pi * 5.0, 2), 0.1, 0.01);
  const MatrixXd& q = plain.recording.q;
  const double step = 1.0 / plain.recording.rateHz();
  const auto far = static_cast<Eigen::Index>(std::llround(width / step));
  const double across = static_cast<double>(far) * step;
  double largest = 0.0, off = 0.0;
  for (Eigen::Index k = 500; k + 500 < q.rows(); k += 7) {
    const VectorXd lost =
        (0.5 * width * width / (across * across)) * (q.row(k + far) - 2.0 * q.row(k) + q.row(k - far));
    const VectorXd change = smoothed.recording.q.row(k) - q.row(k);
    largest = std::max(largest, change.norm());
    off = std::max(off, (change - lost).norm());
  }
  EXPECT_LT(off, 0.1 * largest);
}

TEST(EffectSignal, FrameMistakesOfPeople) {
  const Simulated plain = simulatedOrDie(quietOptions());
  EXPECT_EQ(withEffect("frame_error/wrench-sign=1").recording.wrench, -plain.recording.wrench);
  EXPECT_EQ(withEffect("frame_error/gravity-sign=1").recording.meta.gravity, -plain.recording.meta.gravity);
  const SampledWrench half = withEffect("frame_error=1").recording.wrench;
  EXPECT_LT((half.col(0) + plain.recording.wrench.col(0)).norm(), 1e-9);
  EXPECT_LT((half.col(2) - plain.recording.wrench.col(2)).norm(), 1e-9);
  const Recording transposed = withEffect("frame_error/transposed=1").recording;
  ASSERT_TRUE(transposed.hasOrientation());
  EXPECT_FALSE(transposed.hasJoints());
  const Isometry3d X = motionAt(plain, 1234).X_BS;
  const auto c = transposed.quaternion.row(1234);
  EXPECT_LT((Quaterniond(c(3), c(0), c(1), c(2)).toRotationMatrix() - X.linear().transpose()).norm(), 1e-9);
  EXPECT_LT((transposed.position.row(1234).transpose() - X.translation()).norm(), 1e-9);
  const Recording first = withEffect("frame_error/w-first=1").recording;
  ASSERT_TRUE(first.hasOrientation());
  const auto d = first.quaternion.row(1234);
  EXPECT_LT((Quaterniond(d(0), d(1), d(2), d(3)).toRotationMatrix() - X.linear()).norm(), 1e-9);
}

}  // namespace
}  // namespace heft
