#pragma once
// What rings on after the tool was stopped or started hard: a mount that gives, at the same pitch each time.
#include <optional>
#include <utility>
#include <vector>

#include "core/diagnosis/change_detection/segments.h"

namespace heft::diagnosis {

/// Damped swings of one frequency, each from one moment on.
struct Ringing {
  double frequencyHz = 0.0, frequencyStd = 0.0;
  double damping = 0.0, dampingStd = 0.0;       ///< Share of the critical one
  double evidence = 0.0;                        ///< Of the contacts that it takes the place of
  bool struck = false;                          ///< From outside: nothing in the motion set it off
  std::vector<std::pair<double, double>> when;  ///< [s], each from where a contact begins
};

/// Root of the usual power of what is left of each channel (6 x K) from reading to reading, where it is judged and
/// outside `contacts`. What still rings there is not the usual.
Vector6d usualSpread(const Signals& signals, const Wrenches& left, const std::vector<Contact>& contacts);

/// Whether what `model` leaves of the readings after some of `contacts`, stretches in which it does not hold, is the
/// free ringing of a mass on a spring: after those that the motion may have set off, where it rings no harder than that
/// force accounts for; or else after all, which something outside then struck. `signals`: of the motion smoothed as
/// little as can be, since at a stop smoothing leaves more than rings.
std::optional<Ringing> ringingIn(const Signals& signals, const Model& model, const std::vector<Contact>& contacts);

}  // namespace heft::diagnosis
