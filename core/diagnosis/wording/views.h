#pragma once
// The difference between measured and simulated, looked at from several sides: where it shows best, at which
// frequencies, and against what the robot did.
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// The stretch of held-out blocks in which a cause shows best, and the channel.
struct TellingStretch {
  double from = 0.0, to = 0.0;  ///< [s]
  Eigen::Index channel = 0;
};
/// `before`, `after`: 6 x N, left over without and with the cause; `seconds`: length wanted. The channel is one of
/// [firstChannel, endChannel).
TellingStretch tellingStretch(const DiagnosisSeries& series, const Wrenches& before, const Wrenches& after,
                              double seconds = 4.0, int firstChannel = 0, int endChannel = 6);

/// The same for a cause that was found: the channel that its sentence speaks of or, where it speaks of newtons, one of
/// the forces; half a second for what only fast changes show.
TellingStretch tellingStretch(const DiagnosisSeries& series, const DiagnosedCause& cause);

/// Amplitude by frequency of what is left over, root mean square over the three channels of force or torque.
struct Spectrum {
  VectorXd frequency;      ///< [Hz]
  VectorXd before, after;  ///< [N/sqrt(Hz)] or [N m/sqrt(Hz)]
  double floor = 0.0;      ///< Level of the sensor's own noise: the median of `after` in the upper half of the band
};
/// Averaged over windows of 2.5 s that lie within judged stretches; empty if there is none.
Spectrum spectrumOf(const DiagnosisSeries& series, bool torque);

/// The noise that a verdict judges by, at these frequencies [Hz], in the unit of Spectrum::after: the autoregressive
/// model of each channel, fitted to what is left over, root mean square over three channels. It is noise only where the
/// verdict found nothing else in there.
VectorXd noiseLevel(const DiagnosisSeries& series, bool torque, const VectorXd& frequency);

/// Something about the motion that a difference may go with, at series.time.
struct Witness {
  std::string id;  ///< "gravity_x", "speed_z", "load", ...; the part before the last _ is its kind.
  std::string unit;
  VectorXd value;  ///< N
};
/// Gravity's direction and its rate (S axes), position and velocity (B axes), its sign, acceleration and turning (S
/// axes), load, time. Fails like motionOf().
Result<std::vector<Witness>> witnesses(const Recording& recording, const RobotModel* robot);

/// What a witness is called: "gravity's direction, x", "load".
std::string witnessWords(const std::string& id);

/// Correlation of a witness with a channel over the judged blocks, -1..1.
double correlation(const DiagnosisSeries& series, const VectorXd& witness, const VectorXd& difference);

}  // namespace heft::diagnosis
