#pragma once
// What happened between t1 and t2? A generalised likelihood ratio test (Willsky and Jones, 1976): each answer that is
// no contact stands in a file of its own, and the one with the best evidence is told.
#include <optional>
#include <vector>

#include "core/diagnosis/change_detection/carried_load.h"
#include "core/diagnosis/change_detection/segments.h"

namespace heft::diagnosis {

/// Segments that seem to be contact, with what a fit leaves there.
class SegmentData {
 public:
  SegmentData(const Signals& signals, const Fit& fit, const std::vector<Contact>& contacts);

  /// Power of a reading that is `off` on a channel beyond the usual, in units of it.
  double excess(double off, Eigen::Index channel) const { return std::max(0.0, off * off / usual(channel) - 1.0); }
  /// In units in which the usual power is 1 on each channel.
  Wrenches scaled(const Wrenches& wrench) const { return usual.cwiseSqrt().cwiseInverse().asDiagonal() * wrench; }

  const Signals& signals;
  const Fit& fit;
  const std::vector<Contact>& contacts;
  const Wrenches should;             ///< What the channels should read, by the model
  const Vector6d usual;              ///< Power of what is left outside of the segments [N^2, (N m)^2]
  const std::optional<LoadIn> load;  ///< The segments as one load would make all of them
  double tenths = 0.0;               ///< Tenths of a second in the segments: as often a push may change
  double noise = 0.0;                ///< Share of the power in the segments that is usual: no answer leaves less
};

/// How an answer accounts for all of the segments.
struct SegmentAnswer {
  Correlate correlate;      ///< What they go with; empty where that is a cause, which is looked for by itself
  double left = 1.0;        ///< Share of the power there that it leaves, as a mean over the channels' logarithms
  double parameters = 0.0;  ///< How many were fitted to the segments
  /// Whether it leaves clearly less than where somebody pushes. A push is the reference, but a wrench that is free all
  /// the time leaves nothing, whatever happened: how much of true pushes the answer explains by chance says more.
  bool unlikeAPush = false;
};

/// Nothing where the answer makes no sense there.
using SegmentHypothesis = std::optional<SegmentAnswer> (*)(const SegmentData& data);

std::optional<SegmentAnswer> lateReadings(const SegmentData& data);
std::optional<SegmentAnswer> otherMoment(const SegmentData& data);
std::optional<SegmentAnswer> mixedChannels(const SegmentData& data);
std::optional<SegmentAnswer> commonGain(const SegmentData& data);
std::optional<SegmentAnswer> loadBeyondLimit(const SegmentData& data);
std::optional<SegmentAnswer> carriedLoad(const SegmentData& data);
std::optional<SegmentAnswer> weightElsewhere(const SegmentData& data);
std::optional<SegmentAnswer> clockwork(const SegmentData& data);
std::optional<SegmentAnswer> torquesAlone(const SegmentData& data);
std::optional<SegmentAnswer> whereNobodyTouches(const SegmentData& data);
std::optional<SegmentAnswer> motors(const SegmentData& data);
std::optional<SegmentAnswer> toolSpeed(const SegmentData& data);

}  // namespace heft::diagnosis
