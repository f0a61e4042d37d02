#include "core/workspace/marks.h"

#include <algorithm>

namespace heft {

std::vector<Mark> painted(const std::vector<Mark>& marks, double from, double to, std::optional<MarkLabel> label) {
  if (to < from) std::swap(from, to);
  if (!(to > from)) return marks;
  std::vector<Mark> out;
  for (const Mark& mark : marks) {
    if (mark.to <= from || mark.from >= to) {
      out.push_back(mark);
      continue;
    }
    if (mark.from < from) out.push_back({mark.from, from, mark.label});
    if (mark.to > to) out.push_back({to, mark.to, mark.label});
  }
  if (label) out.push_back({from, to, *label});
  std::sort(out.begin(), out.end(), [](const Mark& a, const Mark& b) { return a.from < b.from; });
  std::vector<Mark> joined;
  for (const Mark& mark : out) {
    if (!joined.empty() && joined.back().label == mark.label && mark.from <= joined.back().to) {
      joined.back().to = std::max(joined.back().to, mark.to);
    } else {
      joined.push_back(mark);
    }
  }
  return joined;
}

std::vector<Segment> withMarks(const std::vector<Segment>& segments, const std::vector<Mark>& marks,
                               const std::string& reason, double least) {
  std::vector<Segment> current = segments;
  for (const Mark& mark : marks) {
    std::vector<Segment> next;
    Segment own;
    own.from = mark.from;
    own.to = mark.to;
    own.label = mark.label;
    own.reason = reason;
    own.kind = mark.label == MarkLabel::free      ? SegmentKind::freeMotion
               : mark.label == MarkLabel::contact ? SegmentKind::contact
                                                  : SegmentKind::ignored;
    for (const Segment& segment : current) {
      if (segment.to <= mark.from || segment.from >= mark.to) {
        next.push_back(segment);
        continue;
      }
      Segment before = segment, after = segment;
      before.to = mark.from;
      after.from = mark.to;
      if (before.to - before.from >= least) {
        next.push_back(before);
      } else {
        own.from = std::min(own.from, segment.from);
      }
      if (after.to - after.from >= least) {
        next.push_back(after);
      } else {
        own.to = std::max(own.to, segment.to);
      }
    }
    next.push_back(own);
    std::sort(next.begin(), next.end(), [](const Segment& a, const Segment& b) { return a.from < b.from; });
    current = std::move(next);
  }
  std::vector<Segment> joined;
  double longest = 0.0;
  for (const Segment& segment : current) {
    // Free is free, moving or at rest, decided or not: one stretch, explained by its longest part.
    const bool same = !joined.empty() && segment.from <= joined.back().to + least &&
                      joined.back().label == segment.label &&
                      (segment.label == MarkLabel::free || joined.back().reason == segment.reason);
    if (!same) {
      joined.push_back(segment);
      longest = segment.to - segment.from;
      continue;
    }
    if (segment.to - segment.from > longest) {
      longest = segment.to - segment.from;
      joined.back().reason = segment.reason;
      joined.back().kind = segment.kind;
      joined.back().confidence = segment.confidence;
    }
    joined.back().to = std::max(joined.back().to, segment.to);
  }
  return joined;
}

}  // namespace heft
