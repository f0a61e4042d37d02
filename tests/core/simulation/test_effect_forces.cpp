// Each force of the world obeys its law, checked against forward kinematics of the exact joints.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/wrench/regressor.h"
#include "tests/core/simulation/effect_sample.h"

namespace heft {
namespace {

constexpr Eigen::Index kStride = 53;  // rows looked at

/// Force of the world on the tool in base axes and its moment about S, from what the sensor shows.
struct Pull {
  Vector3d force_B, moment_B;
};
Pull pullAt(const Simulated& simulated, const SampledWrench& extra, Eigen::Index k) {
  const Matrix3d R = motionAt(simulated, k).X_BS.linear();
  return {-R * extra.row(k).head<3>().transpose(), -R * extra.row(k).tail<3>().transpose()};
}

/// The force goes through this point of the tool.
void expectThrough(const Simulated& simulated, const Pull& pull, const Vector3d& point, Eigen::Index k) {
  const Matrix3d R = motionAt(simulated, k).X_BS.linear();
  EXPECT_LT((pull.moment_B - (R * point).cross(pull.force_B)).norm(), 1e-12) << "row " << k;
}

TEST(EffectForces, SpringPullsWithItsStiffnessTowardsItsAnchor) {
  for (const char* form : {"cable_pull=4", "cable_pull/slack=4"}) {
    const Simulated simulated = withEffect(form);
    const SampledWrench extra = added(simulated);
    const Vector3d anchor = hiddenVector(simulated, "anchor_b_m"), point = hiddenVector(simulated, "point_s_m");
    const bool slack = simulated.truth.effects[0].form == "slack";
    const double free = slack ? hidden(simulated, "free_length_m")[0] : 0.0;
    int taut = 0, loose = 0;
    for (Eigen::Index k = 0; k < extra.rows(); k += kStride) {
      const Vector3d way = anchor - motionAt(simulated, k).X_BS * point;
      const Vector3d expected = 4.0 * std::max(0.0, way.norm() - free) * way.normalized();
      const Pull pull = pullAt(simulated, extra, k);
      EXPECT_LT((pull.force_B - expected).norm(), 1e-10) << form << " row " << k;
      expectThrough(simulated, pull, point, k);
      ++(expected.norm() > 0.0 ? taut : loose);
    }
    EXPECT_GT(taut, 10);
    EXPECT_EQ(loose > 5, slack);
  }
}

TEST(EffectForces, AnisotropicSpringHasOneStiffDirection) {
  const Simulated simulated = withEffect("cable_pull/anisotropic=4");
  const auto values = hidden(simulated, "stiffness_b_n_m");
  const Matrix3d K = Eigen::Map<const Matrix3d>(values.data());
  EXPECT_LT((K - K.transpose()).norm(), 1e-12);
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(K);
  EXPECT_NEAR(solver.eigenvalues()(2), 4.0, 1e-12);
  EXPECT_GT(solver.eigenvalues()(0), 0.0);
  EXPECT_LT(solver.eigenvalues()(1), 0.6 * 4.0 + 1e-9);
  const SampledWrench extra = added(simulated);
  for (Eigen::Index k = 0; k < extra.rows(); k += kStride) {
    const Vector3d way =
        hiddenVector(simulated, "anchor_b_m") - motionAt(simulated, k).X_BS * hiddenVector(simulated, "point_s_m");
    EXPECT_LT((pullAt(simulated, extra, k).force_B - K * way).norm(), 1e-10);
  }
}

TEST(EffectForces, TwistedCableTurnsBackOnly) {
  const Simulated simulated = withEffect("cable_pull/torsion=10");
  const SampledWrench extra = added(simulated);
  EXPECT_EQ(extra.leftCols(3).cwiseAbs().maxCoeff(), 0.0);
  // The difference of two moments belongs to the turn between the two poses; small turns from the rest pose.
  const Matrix3d rest = motionAt(simulated, extra.rows() / 2).X_BS.linear();
  int checked = 0;
  for (Eigen::Index k = 0; k < extra.rows(); k += 7) {
    const Vector3d turn = vectorFromRotation(motionAt(simulated, k).X_BS.linear() * rest.transpose());
    if (turn.norm() > 0.5 || turn.norm() < 0.05) continue;
    EXPECT_LT((pullAt(simulated, extra, k).moment_B + hidden(simulated, "torsion_nm_rad")[0] * turn).norm(), 0.03);
    ++checked;
  }
  EXPECT_GT(checked, 3);
}

TEST(EffectForces, ConstantPullIsConstantInTheWorld) {
  const Simulated simulated = withEffect("constant_pull=0.7");
  const SampledWrench extra = added(simulated);
  for (Eigen::Index k = 0; k < extra.rows(); k += kStride) {
    const Pull pull = pullAt(simulated, extra, k);
    EXPECT_LT((pull.force_B - hiddenVector(simulated, "force_b_n")).norm(), 1e-12);
    EXPECT_NEAR(pull.force_B.norm(), 0.7, 1e-12);
    expectThrough(simulated, pull, hiddenVector(simulated, "point_s_m"), k);
  }
}

TEST(EffectForces, DragTakesEnergyAndFollowsItsLaw) {
  for (const char* form : {"viscous_drag=2", "viscous_drag/quadratic=2", "coulomb_friction=0.4",
                           "coulomb_friction/stribeck=0.4", "coulomb_friction/dahl=0.4"}) {
    const Simulated simulated = withEffect(form);
    const SampledWrench extra = added(simulated);
    const Vector3d point = hiddenVector(simulated, "point_s_m");
    double energy = 0.0;
    for (Eigen::Index k = 0; k < extra.rows(); ++k) {
      const FrameMotion m = motionAt(simulated, k);
      const Vector3d v = m.v_BSo_B + m.w_BS_B.cross(m.X_BS.linear() * point);
      const Pull pull = pullAt(simulated, extra, k);
      energy += pull.force_B.dot(v) * 1e-3;
      if (k % kStride != 0) continue;
      expectThrough(simulated, pull, point, k);
      const double force = pull.force_B.norm();
      const std::string name = form;
      if (name == "viscous_drag=2") {
        EXPECT_LT((pull.force_B + 2.0 * v).norm(), 1e-12);
      } else if (name == "viscous_drag/quadratic=2") {
        EXPECT_NEAR(force, hidden(simulated, "drag_n_s2_m2")[0] * v.squaredNorm(), 1e-12);
      } else if (name == "coulomb_friction=0.4") {
        if (v.norm() > 0.02) {
          EXPECT_LT((pull.force_B + 0.4 * v.normalized()).norm(), 0.003);
        }
      } else {
        EXPECT_LT(force, 0.4 * 1.6 + 1e-9);
      }
    }
    EXPECT_LT(energy, -0.02) << form;
  }
}

TEST(EffectForces, DahlFrictionBendsBeforeItSlips) {
  // After a long way in one direction the full level is there; just after a reversal it is not.
  const Simulated simulated = withEffect("coulomb_friction/dahl=0.4", quietOptions(MotionKind::excitation));
  const SampledWrench extra = added(simulated);
  const VectorXd level = extra.leftCols(3).rowwise().norm();
  EXPECT_LE(level.maxCoeff(), 0.4 + 1e-9);
  EXPECT_GT(level.maxCoeff(), 0.38);
  EXPECT_EQ(level(0), 0.0);  // It starts with straight bristles.
}

TEST(EffectForces, LooseMassBalancesItsMomentum) {
  for (const char* form : {"loose_mass=80", "loose_mass/rail=80"}) {
    const Simulated simulated = withEffect(form);
    const SampledWrench extra = added(simulated);
    // Integrated in base axes, the extra force is the extra momentum mu R x' of the swinging mass: bounded, and at rest
    // before and well after the motion its mean is zero.
    Vector3d momentum = Vector3d::Zero(), largest = Vector3d::Zero();
    for (Eigen::Index k = 0; k < extra.rows(); ++k) {
      momentum += 1e-3 * (motionAt(simulated, k).X_BS.linear() * extra.row(k).head<3>().transpose());
      largest = largest.cwiseMax(momentum.cwiseAbs());
    }
    EXPECT_GT(largest.norm(), 1e-3) << form;
    EXPECT_LT(largest.norm(), 0.08 * 2.0) << form;  // 2 m/s would be a flying part
    EXPECT_LT(extra.row(0).head<3>().norm(), 1e-6) << form;
  }
}

TEST(EffectForces, LooseMassRingsAtItsFrequency) {
  // The arm stands still in the last quarter second.
  const Simulated simulated = withEffect("loose_mass=80", quietOptions(MotionKind::excitation, 5, 8.0));
  const double hz = hidden(simulated, "frequency_hz")[0], zeta = hidden(simulated, "damping_ratio")[0];
  EXPECT_GE(hz, 1.0);
  EXPECT_LE(hz, 4.0);
  // Row by row the law x'' + 2 z w x' + w^2 x = -(s at the mass) leaves no freedom: with f = mu (s_mass + x'') and the
  // rigid mass's mu s_seat known, the second derivative of the force obeys the same oscillator. At rest it is free.
  const SampledWrench extra = added(simulated);
  const Eigen::Index n = extra.rows(), from = n - 230, step = 20;
  const double w = 2.0 * std::numbers::pi * hz, h = 1e-3 * static_cast<double>(step);
  for (int c = 0; c < 3; ++c) {
    const double f0 = extra(from, c), f1 = extra(from + step, c), f2 = extra(from + 2 * step, c);
    const double damped = w * std::sqrt(1.0 - zeta * zeta);
    // Exact recursion of a free damped oscillation.
    EXPECT_NEAR(f2, 2.0 * std::exp(-zeta * w * h) * std::cos(damped * h) * f1 - std::exp(-2.0 * zeta * w * h) * f0,
                2e-3 * (std::abs(f0) + std::abs(f1)) + 1e-6);
  }
}

TEST(EffectForces, SoftMountIsRigidInTheLimit) {
  const double soft = added(withEffect("flexible_mount=0.5")).cwiseAbs().maxCoeff();
  const double stiff = added(withEffect("flexible_mount=0.05")).cwiseAbs().maxCoeff();
  EXPECT_GT(soft, 0.01);
  EXPECT_LT(stiff, 0.5 * soft);
  EXPECT_NEAR(hidden(withEffect("flexible_mount=0.5"), "frequency_hz")[0],
              std::sqrt(9.81 / 0.5e-3) / (2.0 * std::numbers::pi), 1e-9);
}

TEST(EffectForces, PickedUpPartWeighsWhatItWeighs) {
  for (const char* form : {"payload_change=90", "payload_change/ramp=90", "payload_change=-90"}) {
    const Simulated simulated = withEffect(form);
    const SampledWrench extra = added(simulated);
    const auto [from, to] = simulated.truth.effects[0].when.at(0);
    EXPECT_NEAR(to - from, std::string(form).find("ramp") == std::string::npos ? 0.0 : 0.1, 1e-12);
    Payload part;
    part.mass = hidden(simulated, "mass_kg")[0];
    part.com = hiddenVector(simulated, "com_s_m");
    part.inertiaCom = 0.4 * part.mass * 4e-4 * Matrix3d::Identity();
    EXPECT_NEAR(std::abs(part.mass), 0.09, 1e-12);
    for (Eigen::Index k = 0; k < extra.rows(); k += kStride) {
      const double t = simulated.recording.time(k);
      const FrameMotion m = motionAt(simulated, k);
      const Matrix3d R = m.X_BS.linear().transpose();
      const Vector6d whole =
          predictWrench(part, {R * (m.a_BSo_B - simulated.truth.options.gravity), R * m.w_BS_B, R * m.alpha_BS_B});
      if (t < from) {
        EXPECT_EQ(extra.row(k).cwiseAbs().maxCoeff(), 0.0);
      } else if (t > to) {
        EXPECT_LT((extra.row(k).transpose() - whole).norm(), 1e-10);
      }
    }
  }
}

TEST(EffectForces, TouchIsLocalAndReachesItsPeak) {
  for (const char* form : {"contact=6", "contact/push=6", "contact/hands=6", "contact/wall=6"}) {
    const Simulated simulated = withEffect(form, quietOptions(MotionKind::free, 5, 15.0));
    const SampledWrench extra = added(simulated);
    const bool wall = simulated.truth.effects[0].form == "wall";
    const auto [from, to] = simulated.truth.effects[0].when.at(0);
    EXPECT_LT(to - from, 1.6);
    double peak = 0.0;
    for (Eigen::Index k = 0; k < extra.rows(); ++k) {
      const double t = simulated.recording.time(k), force = extra.row(k).head<3>().norm();
      if (t < from || t > to) {
        EXPECT_EQ(force, 0.0) << form << " at " << t;
      }
      peak = std::max(peak, force);
      if (simulated.truth.effects[0].form != "hands") {
        EXPECT_NEAR(extra.row(k).head<3>().dot(extra.row(k).tail<3>()), 0.0, 1e-9) << form;
      }
    }
    // The wall's friction adds 2 %; the path was looked at twenty times a second.
    EXPECT_NEAR(peak, 6.0, wall ? 0.4 : 0.01) << form;
  }
}

}  // namespace
}  // namespace heft
