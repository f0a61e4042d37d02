#pragma once
// What a sensor or what carries its readings does for a moment, and no touch does.
#include <algorithm>
#include <vector>

#include "core/diagnosis/change_detection/segments.h"

namespace heft::diagnosis {

/// What the channels should read, and what they read beyond that and the usual, in units of it.
class Beyond {
 public:
  Beyond(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts)
      : should(signals.measured - fit.residual), power_(usualPower(signals, fit, blocksOf(contacts))) {}

  /// Of a reading that is `off` on a channel.
  double of(double off, Eigen::Index channel) const { return std::max(0.0, off * off / power_(channel) - 1.0); }
  /// In units in which the usual is 1 on each channel.
  Wrenches scaled(const Wrenches& wrench) const { return power_.cwiseSqrt().cwiseInverse().asDiagonal() * wrench; }

  /// Power that is usual on the channels [N^2, (N m)^2].
  const Vector6d& usual() const { return power_; }

  const Wrenches should;

 private:
  Vector6d power_;
};

/// Whether what seems to be contact are readings that come late at these moments, such as where a logger stalls or an
/// output cannot follow: who pushes makes a sensor read what it should not have read a moment before. In 370 recordings
/// that were touched or seemed so, late readings left 0.06 and less; one touch left 0.15, all others more.
bool comesLate(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond);

/// Whether what seems to be contact are readings of another moment, the same way off for as long as it lasts, such as
/// where a clock is set. In 46 recordings that were touched or seemed so, these left 0.27 and less, all others 0.6 and
/// more, touches 0.8.
bool areShifted(const Signals& signals, const std::vector<Contact>& contacts, const Beyond& beyond);

/// Whether there is hardly any force to the torques of the contacts, as where a rotor is turned: who pushes would have
/// to do so farther away than the tool reaches.
bool areTorquesAlone(const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond);

/// Whether what seems to be contact are channels that are mixed up for a while, as by a cable or a parser out of step:
/// in each of the contacts two of them, or two axes, read what the model says for each other, or one has the other
/// sign.
bool areMixedUp(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond);

/// Whether all channels, the zero with them, read too little or too much by one factor at a time, as where the
/// amplifier's supply dips: of 24 touches, such factors left 0.42 and more. Or all forces by one and all torques by
/// another, the same throughout, as where somebody changes their units.
bool growTogether(const Fit& fit, const std::vector<Contact>& contacts, const Beyond& beyond);

/// Whether the contacts are where one channel's load goes beyond some size, one way, and grow with how far it does, as
/// where chips in a gap begin to carry, or a converter is not straight: that leaves little of them, and clearly less
/// than a push that is the same all through each. What stands on a floor goes with its posture, too, where it is put
/// down: asked are the moments at which most is left.
bool growBeyondALoad(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts,
                     const Beyond& beyond);

}  // namespace heft::diagnosis
