#include "core/compensation/phases.h"

#include <algorithm>
#include <cmath>

namespace heft {

namespace {

constexpr double kLongest = 1.5;      // [s] of an approach
constexpr double kBlind = 0.5;        // [s] of an approach when only the orientation is known
constexpr double kShortest = 0.05;    // [s]
constexpr double kAtRest = 0.01;      // [m/s]
constexpr double kTouchWindow = 0.6;  // [s] before the contact that give its direction; a hand slows down and waits

Phase phaseOf(const Segment& segment) {
  if (segment.kind == SegmentKind::pickUp || segment.kind == SegmentKind::putDown) return Phase::contact;
  if (segment.label == MarkLabel::free) return Phase::free;
  return segment.label == MarkLabel::contact ? Phase::contact : Phase::ignore;
}

Eigen::Index sampleAt(const Motion& motion, double t) {
  return std::clamp<Eigen::Index>(std::lround((t - motion.startTime) * motion.rateHz), 0, motion.size() - 1);
}

/// The approach to a contact at `touch`, not before `earliest`; from == to if there is none.
PhaseSegment approachTo(const Motion& motion, double earliest, double touch) {
  PhaseSegment out{touch, touch, Phase::approach, "Moves towards the contact that follows.", 1.0};
  const Eigen::Index end = sampleAt(motion, touch);
  const Eigen::Index first = sampleAt(motion, std::max(earliest, touch - kLongest));
  if (!motion.originAccelerationKnown) {
    // Without a position only the turning shows that the tool moves.
    const Eigen::Index blind = sampleAt(motion, std::max(earliest, touch - kBlind));
    if (motion.omega.middleCols(blind, std::max<Eigen::Index>(1, end - blind)).colwise().norm().mean() > 0.05)
      out.from = motion.time(blind);
    return out;
  }
  const Eigen::Index window = std::max<Eigen::Index>(1, std::lround(kTouchWindow * motion.rateHz));
  const Eigen::Index from = std::max(first, end - window);
  const Vector3d arriving = motion.velocity.middleCols(from, end - from + 1).rowwise().mean();
  if (arriving.norm() < kAtRest) return out;
  const Vector3d direction = arriving.normalized();
  // The window itself may hold the stop at the surface; before it the tool must keep coming.
  Eigen::Index k = from;
  while (k > first &&
         motion.velocity.col(k - 1).dot(direction) > std::max(kAtRest, 0.5 * motion.velocity.col(k - 1).norm()))
    --k;
  out.from = std::max(earliest, motion.time(k));
  if (motion.position.cols() == motion.size()) {
    const Vector3d path = motion.position.col(end) - motion.position.col(k);
    out.distance = path.norm();
    if (out.distance > 1e-4) out.direction_B = path / out.distance;
    out.speed = out.distance / std::max(1e-3, touch - out.from);
  }
  return out;
}

}  // namespace

std::vector<PhaseSegment> phasesOf(const std::vector<Segment>& segments, const Motion& motion) {
  std::vector<PhaseSegment> phases;
  for (const auto& segment : segments) {
    const Phase phase = phaseOf(segment);
    if (!phases.empty() && phases.back().phase == phase) {
      phases.back().to = segment.to;
      phases.back().confidence = std::min(phases.back().confidence, segment.confidence);
    } else {
      phases.push_back({segment.from, segment.to, phase, segment.reason, segment.confidence});
    }
  }
  for (std::size_t i = 1; i < phases.size(); ++i) {
    if (phases[i].phase != Phase::contact || phases[i - 1].phase != Phase::free) continue;
    PhaseSegment approach = approachTo(motion, phases[i - 1].from, phases[i].from);
    if (approach.to - approach.from < kShortest) continue;
    approach.confidence = std::min(phases[i - 1].confidence, phases[i].confidence);
    if (approach.from - phases[i - 1].from < kShortest) {
      approach.from = phases[i - 1].from;
      phases[i - 1] = approach;
      continue;
    }
    phases[i - 1].to = approach.from;
    phases.insert(phases.begin() + static_cast<std::ptrdiff_t>(i), approach);
    ++i;
  }
  return phases;
}

}  // namespace heft
