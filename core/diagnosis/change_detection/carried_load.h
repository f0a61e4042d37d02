#pragma once
// What seems to be contact and is a part that the tool carries for a while.
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/diagnosis/change_detection/segments.h"

namespace heft::diagnosis {

/// Share of the payload's mass, or of what acts in a segment, that is as good as none.
constexpr double kNoLoad = 0.02;

/// Contacts as one load, at one place of the tool, would make all of them.
struct LoadIn {
  double share = 1.0,
         shareOfHolding = 1.0;       ///< That it leaves: of what is there, of what holding on to the tool leaves
  double mass = 0.0, massStd = 0.0;  ///< [kg]
};

/// Nothing where there are no contacts, or one is too short to tell.
std::optional<LoadIn> loadIn(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts);

/// Whether it leaves next to nothing, and clearly less than somebody does who holds on to the tool.
bool isCarried(const LoadIn& load);

struct CarriedLoad {
  double mass = 0.0, massStd = 0.0;             ///< [kg]
  double evidence = 0.0;                        ///< Of the contacts that it takes the place of
  std::vector<std::pair<double, double>> when;  ///< [s]
};

/// The load, at one place of the tool, whose weight and inertial forces account for next to all that the fit leaves in
/// all of `contacts`, and clearly more than somebody does who holds on to the tool; nothing where it is another thing.
std::optional<CarriedLoad> carriedLoadIn(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts);

/// Contacts in which the zero was another one, where it jumps elsewhere, too, or the load, where that changes
/// elsewhere: no touches but that again.
std::vector<Contact> recurrencesIn(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts,
                                   bool zeroJumps, bool loadChanges);

}  // namespace heft::diagnosis
