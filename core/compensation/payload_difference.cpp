#include "core/compensation/payload_difference.h"

#include "core/math/linear_algebra.h"

namespace heft {
namespace {

/// Chi-squared with 4 and with 6 degrees of freedom that the same payload exceeds once in 200: together it passes in 99
/// of 100.
constexpr double kMassCentreLimit = 14.860, kInertiaLimit = 18.548;
/// One sensor, still mounted as it was, on another day: gain, and where its axes seem to cross (one deviation).
constexpr double kMassRepeats = 0.005;     // relative
constexpr double kCentreRepeats = 0.0005;  // [m]
constexpr double kInertiaRepeats = 0.02;   // of the mean moment

Vector10d repeatability(const Payload& payload) {
  Vector10d out;
  out << kMassRepeats * payload.mass, Vector3d::Constant(kCentreRepeats),
      VectorXd::Constant(6, kInertiaRepeats * payload.inertiaCom.trace() / 3.0);
  return out;
}

double chiSquared(const Vector10d& off, const Matrix10d& covariance, int first, int count) {
  const VectorXd d = off.segment(first, count);
  const MatrixXd S = covariance.block(first, first, count, count);
  return d.dot(solveSymmetric(S, d));
}

}  // namespace

bool PayloadDifference::massCentreDiffers() const { return massCentreChi2 > kMassCentreLimit; }
bool PayloadDifference::inertiaDiffers() const { return inertiaChi2 > kInertiaLimit; }

PayloadDifference payloadDifference(const Vector10d& off, const Matrix10d& covariance, const Payload& about) {
  Matrix10d whole = covariance;
  whole.diagonal() += repeatability(about).cwiseAbs2();
  PayloadDifference out;
  out.off = off;
  out.std = whole.diagonal().cwiseSqrt();
  out.massCentreChi2 = chiSquared(off, whole, 0, 4);
  out.inertiaChi2 = chiSquared(off, whole, 4, 6);
  return out;
}

}  // namespace heft
