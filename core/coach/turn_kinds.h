#pragma once
// The motions that the coach chooses from: turns of the tool about its centre of mass, or of the wrist's joints.
#include <array>
#include <span>

#include "core/coach/coach.h"
#include "core/online/online_information.h"

namespace heft {

/// A turn about axes of the tool, 0 sideways, 1 forwards, 2 long axis, or of the last three joints, counted from the
/// one next to the tool. Where two of the frequencies are the same, the second wave is a quarter behind: a circle.
struct TurnKind {
  const char* id;
  const char* sentence;
  std::array<double, 3> amplitude;  ///< [rad]
  std::array<double, 3> hz;         ///< [Hz]
  bool wrist = false;  ///< Joints; the point that stays where it is is then the wrist, and not the centre of mass
};

std::span<const TurnKind> turnKinds();

/// From where, with what, about which point a kind turns.
struct TurnPlace {
  const GuidedTool* tool = nullptr;
  Matrix3d axes = Matrix3d::Identity();  ///< Of the tool in S: sideways, forwards, long
  Vector3d pivot = Vector3d::Zero();     ///< p_SP_S [m]
  VectorXd start;                        ///< Posture [rad]
};

/// The tool's axes in S. The long axis is that of the least moment of inertia where the body clearly is long, else the
/// way from the sensor to the centre of mass.
Matrix3d toolAxes(const std::optional<OnlineInformation>& information);

/// Why no motion was found: what was met, or the torque that was missing.
struct TurnRefusal {
  std::optional<Conflict> inTheWay;
  std::optional<TorqueUse> tooHeavy;
};

/// A kind that keeps the limits, its waves' sizes and frequencies as they then are.
struct FittedTurn {
  TurnKind kind;
  Advice advice;  ///< With id, sentence, motion and use
};

/// The kind at up to `largest` times its size, as large as the limits allow and as arm and room leave it, or nothing;
/// then `refusal` gets what was met on the way.
std::optional<FittedTurn> fitted(const TurnKind& kind, const TurnPlace& place, const CoachOptions& options,
                                 double largest, TurnRefusal& refusal);

/// How many times larger a kind is still what its sentence says.
double largestOf(const TurnKind& kind);
/// Whether its frequencies are still what the sentence of the listed kind says.
bool isStill(const TurnKind& listed, const TurnKind& kind);

}  // namespace heft
