#pragma once
// Which conventions do these numbers follow? The readings are fitted under every convention that people have; physics
// decides, and says where it cannot.
//
// Source of the recipe and of the sizes of evidence: the project's notes of a prototype (domain/conventions.md).
// Exact ties, whatever the data: a unit of force alone scales the mass; all signs turned is gravity pointing up in
// standing poses; there, too, the torque's sign and the centre of mass mirrored through the sensor are the same, and so
// are another reference point and another centre.
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/base/findings.h"
#include "core/conventions/agreement.h"
#include "core/conventions/reading.h"

namespace heft::conventions {

struct Question {
  const Motion* motion = nullptr;  ///< Of the recording as stated; poses: of standingPoses()
  RecordingKind kind = RecordingKind::motion;
  Reading stated;
  bool posesInFile = false;  ///< The motion comes from poses in the file, not from joints.
  std::vector<bool> use;     ///< Empty, or one a sample of the motion: what the user marked as contact is not used.
  /// Channels that hold one value, where the file's are the sensor's. Only the stated conventions are asked then.
  std::array<bool, 6> silent{};
  double heaviest = 50.0;  ///< Payload of the arm [kg]: what weighs more is not read rightly. Arms guided by hand
                           ///< carry 3 to 50 kg (FANUC CR-35iB).
};

/// What to ask of a recording whose motion, as stated, is `motion` (standing poses: of standingPoses()). Of a motion
/// only what the user did not mark as contact, or as to be ignored, is used. `motion` must outlive it.
Question questionOf(const Recording& recording, const Motion& motion);

enum class Verdict {
  asStated,   ///< The stated conventions fit, or what is wrong is no convention.
  suggested,  ///< The stated conventions are out, and one other fits.
  ambiguous,  ///< The stated conventions are out, and two or more others fit: this recording cannot tell.
  none,       ///< Nothing fits: the model does not describe the readings.
};
std::string_view toString(Verdict verdict);  ///< "as_stated", "suggested", "ambiguous", "none"

/// How far from the readings a fit stays, robustly: pushed parts count little.
struct Misfit {
  Vector6d left = Vector6d::Zero();   ///< Residual of blocks of some 80 ms, or of poses [N, N m]
  Vector6d noise = Vector6d::Zero();  ///< Of it, what changes from block to block; 0 for poses [N, N m]
  Vector6d load = Vector6d::Zero();   ///< What the motion makes of the payload, standard deviation [N, N m]
  double force = 0.0, torque = 0.0;   ///< Residual beyond noise over load: 0 none, 1 all of it
  double worst() const { return std::max(force, torque); }
};

struct Alternative {
  Reading reading;
  std::vector<Change> changes;  ///< From what is stated
  double evidence = 0.0;        ///< 2 ln L over the stated conventions, priced
  Payload payload;              ///< By least squares: may be unphysical in what the motion does not show
  Misfit misfit;
  std::string sentence;
};

struct Report {
  Verdict verdict = Verdict::asStated;
  bool enough = true;  ///< False: too little data to say anything; the verdict is asStated then.
  Reading stated;
  std::optional<Reading> suggested;  ///< With Verdict::suggested; with ambiguous, the likeliest.
  double evidence = 0.0;             ///< 2 ln L of the best over the next that is not the same thing
  double overStated = 0.0;           ///< 2 ln L of the best over the stated conventions
  std::optional<Alternative> next;   ///< With a suggestion: the likeliest that is not the same thing
  std::vector<Alternative> ties;     ///< What fits as well as the best, likeliest first; the best itself is not in it.
  Misfit misfit;                     ///< Of what the verdict takes for right: as stated, or as suggested
  Misfit statedMisfit;
  Payload payload, statedPayload;
  /// Where the suggestion turns the sensor or gravity freely: standard deviation of that turn about the axis known
  /// worst [rad]. 0 otherwise.
  double turnStd = 0.0;
  Eigen::Matrix<double, 10, 10> covariance = Eigen::Matrix<double, 10, 10>::Zero();  ///< Of phi of `payload`
  /// What such a turn, or a free point of the torque, has of the covariance of phi [kg, kg m, kg m2]. 0 otherwise.
  Eigen::Matrix<double, 10, 10> fromFree = Eigen::Matrix<double, 10, 10>::Zero();
  std::optional<Agreement> agreement;  ///< As stated, where that is the verdict; absent where it cannot be told
  std::string sentence;                ///< "The force is given in the robot's base axes, not the sensor's."
  std::string check;                   ///< Where to look at the driver; empty for asStated
  std::string decides;                 ///< What would decide a tie; empty without one
  Findings cautions;                   ///< "centre_behind_sensor", "centre_far", "weight_large", "nearly_tied",
                                       ///< "turn_unsure", "point_unsure", "sensor_turned", "force_and_torque"
};

/// Standard deviation of the centre along the axis known worst [m], from a covariance of phi (m, m c, I).
double centreStd(const Payload& payload, const Eigen::Matrix<double, 10, 10>& ofPhi);

/// As stated is not doubted where it leaves less than this share of the load beyond noise: a torque's sign, an axis or
/// a turn of 15 degrees leaves a quarter and more; clean recordings leave a quarter of it.
constexpr double kFits = 0.08;

Report check(const Question& question);

/// What a payload and a zero, fitted robustly, leave of the readings of `question.motion` as stated.
struct LeftOver {
  std::vector<double> time;  ///< [s], of blocks of some 80 ms; poses: their numbers, from 1
  MatrixXd left;             ///< 6 x K, force [N] and torque [N m] in sensor axes
  double mass = 0.0;         ///< Of the payload [kg]; below 0 where the sign is wrong
};
LeftOver leftOver(const Question& question);

/// {"verdict", "stated", "suggested", "evidence", "over_stated", "meta", "ties", "sentence", "misfit": {...}}: the
/// contract's keys of `conventions` and more.
nlohmann::json toJson(const Report& report, const SensorMount& mount, bool fromJoints);

}  // namespace heft::conventions
