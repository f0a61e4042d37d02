#pragma once
// A mass on a spring: what something loose in the tool (slow) and a mount that gives (fast) have in common.
#include <initializer_list>
#include <span>
#include <vector>

#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/causes.h"
#include "core/diagnosis/causes/common.h"

namespace heft::diagnosis {

class Oscillator : public Cause {
 public:
  void force(const Form& form, const VectorXd& v, const Signals& signals, const Kinematics& kin,
             Wrenches& w) const override;
  /// Masses that go the same way are swung once, and several at a time.
  void forces(const Form& form, std::span<const VectorXd> each, const Signals& signals, const Kinematics& kin,
              std::span<Wrenches> wrenches) const override;

  /// Smoothing takes a little of what is just below its corner, and noise in what it leaves makes the rest look
  /// smaller: either looks like something that rings above. What rolls to its place comes late, as do readings: those
  /// are more common.
  double doubt(const Form& form, const VectorXd& v, const Signals& signals) const override;

 protected:
  static double doubtAt(double frequency, const Signals& signals);

  static constexpr double kMostDamped = kThird;
  /// form.choice: 0 to 2 mostly along that axis, kRolls: no swinging, kElse: what a cause has besides
  static constexpr int kAllWays = 3, kRolls = 4, kElse = 5;

  static std::vector<Parameter> parameters(double lowest, double highest);
  /// A form a frequency [Hz] and axis, and one that moves all ways.
  std::vector<Form> at(std::initializer_list<double> frequencies, double lowest, double highest) const;
};

}  // namespace heft::diagnosis
