#pragma once
// Contact as a cause: stretches in which no model of the whole recording holds.
#include <string>
#include <vector>

#include "core/base/say.h"
#include "core/diagnosis/model/correlate.h"
#include "core/diagnosis/search/search.h"

namespace heft::diagnosis {

/// Contact::instead where all of it is on one channel of the sensor.
inline constexpr const char* kOneChannel = heft::toSay("one channel of the sensor alone");

struct Contact {
  double from = 0, to = 0;  ///< [s]
  double evidence = 0;      ///< Gained by leaving the stretch out
  Stretch blocks;           ///< The same in blocks
  Correlate instead;        ///< What is there that no push makes; empty: nothing
  bool smoothed = false;    ///< Left by the smoothing of the motion where a motor's force jumps
};

/// The contacts' stretches.
std::vector<Stretch> blocksOf(const std::vector<Contact>& contacts);

/// Evidence for all of the contacts, and how long they last together [s].
double evidenceOf(const std::vector<Contact>& contacts);
double durationOf(const std::vector<Contact>& contacts);

/// How many blocks they have.
double blocksIn(const std::vector<Stretch>& stretches);

/// The stretches of both, those that touch or overlap as one, rising in time.
std::vector<Stretch> together(std::vector<Stretch> a, const std::vector<Stretch>& b);

/// Judges neither the `holes` nor two blocks to either side.
void leaveOut(Signals& signals, const std::vector<Stretch>& holes);

/// One a block: whether it is judged and outside of `stretches`.
std::vector<bool> usableOutside(const Signals& signals, const std::vector<Stretch>& stretches);

/// Mean power of what the fit leaves on each channel, where it is judged and outside of `stretches`.
Vector6d usualPower(const Signals& signals, const Fit& fit, const std::vector<Stretch>& stretches);

/// Evidence for leaving blocks [from, to) out of `fit`: what they would cost under its noise, less the price of a force
/// that may change freely every tenth of a second.
double evidenceForLeavingOut(const Signals& signals, const Fit& fit, Eigen::Index from, Eigen::Index to);

/// The candidates' stretches (blocks) that the fit really needs to leave out.
std::vector<Contact> contactsIn(const Signals& signals, const Fit& fit, const std::vector<Stretch>& candidates);

}  // namespace heft::diagnosis
