#pragma once
// What the fits of core/conventions know before they see a recording. Private to it.
#include "core/math/rigid.h"

namespace heft::conventions {

/// Below this share of the readings nothing is noise: rounding of the numbers in a file.
inline constexpr double kRounding = 1e-6;

/// A whisper of prior information, as wide as any payload on any arm: phi (10), then bias (6).
inline Eigen::Matrix<double, 16, 1> payloadAndBiasPrecision() {
  constexpr double kMassSd = 30.0, kFirstMomentSd = 3.0, kInertiaSd = 1.0, kBiasSd = 1e4;  // [kg], [kg m], [kg m2], [N]
  Eigen::Matrix<double, 16, 1> sd;
  sd << kMassSd, Vector3d::Constant(kFirstMomentSd), Vector6d::Constant(kInertiaSd), Vector6d::Constant(kBiasSd);
  return sd.cwiseInverse().cwiseAbs2();
}

}  // namespace heft::conventions
