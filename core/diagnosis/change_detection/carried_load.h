#pragma once
// What seems to be contact and is a part that the tool carries for a while.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnosis/change_detection/segments.h"

namespace heft::diagnosis {

struct CarriedLoad {
  double mass = 0.0, massStd = 0.0;             ///< [kg]
  double evidence = 0.0;                        ///< Of the contacts that it takes the place of
  std::vector<std::pair<double, double>> when;  ///< [s]
};

/// The load, at one place of the tool, whose weight and inertial forces account for next to all that the fit leaves in
/// all of `contacts`, and clearly more than somebody does who holds on to the tool; nothing where it is another thing.
std::optional<CarriedLoad> carriedLoadIn(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts);

/// Whether in all of `contacts` the tool weighs what it weighs elsewhere, but its weight sits at another place, the
/// same each time, as where it has play in its holder: that leaves next to nothing there, and clearly less than
/// somebody does who holds on to the tool.
bool isWeightElsewhere(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts);

/// Contacts in which the zero was another one, where it jumps elsewhere, too, or the load, where that changes
/// elsewhere: no touches but that again.
std::vector<Contact> recurrencesIn(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts,
                                   bool zeroJumps, bool loadChanges);

}  // namespace heft::diagnosis
