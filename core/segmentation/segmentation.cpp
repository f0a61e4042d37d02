#include "core/segmentation/segmentation.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/say.h"
#include "core/segmentation/blocks.h"
#include "core/segmentation/user_marks.h"

namespace heft {

namespace {

bool userMarkedFree(const Recording& recording) {
  const auto isFree = [](const auto& label) { return label == MarkLabel::free; };
  return std::any_of(recording.meta.marks.begin(), recording.meta.marks.end(),
                     [&](const Mark& mark) { return isFree(mark.label); }) ||
         std::any_of(recording.labels.begin(), recording.labels.end(), isFree);
}

SegmentKind kindOf(MarkLabel label) {
  switch (label) {
    case MarkLabel::free:
      return SegmentKind::freeMotion;
    case MarkLabel::contact:
      return SegmentKind::contact;
    case MarkLabel::ignore:
      break;
  }
  return SegmentKind::ignored;
}

void applyMarks(const Recording& recording, const WrenchRows& rows, SegmentMode mode, SegmentBlocks& blocks) {
  const int byUser = blocks.addReason(heft::say("Marked by you."));
  const int notMarked = blocks.addReason(heft::say("Not marked as free."));
  // Where the user marked free parts, what they left unmarked is not free; where they only marked contact, it is.
  const bool onlyMarked = mode == SegmentMode::marks && userMarkedFree(recording);
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    if (const auto label = markedAt(recording, rows.time(k)))
      blocks.set(k, *label, kindOf(*label), byUser);
    else if (onlyMarked)
      blocks.set(k, MarkLabel::ignore, SegmentKind::ignored, notMarked);
  }
}

/// What the user left out is not looked at: neither its load nor its contact says anything of the rest.
void leaveOutMarked(const Recording& recording, const WrenchRows& rows, SegmentBlocks& blocks) {
  for (Eigen::Index k = 0; k < rows.size(); ++k)
    if (const auto label = markedAt(recording, rows.time(k)); label && *label != MarkLabel::free)
      blocks.set(k, MarkLabel::ignore, SegmentKind::ignored);
}

/// Why the blocks of a segment have their label, where no note says it.
std::string reasonFor(SegmentKind kind, SegmentMode mode) {
  if (mode == SegmentMode::all) return heft::say("All rows were requested.");
  if (mode == SegmentMode::marks) return heft::say("Not marked as contact.");
  if (kind == SegmentKind::contact) return heft::say("Force not explained by the motion.");
  if (kind == SegmentKind::standing) return heft::say("At rest, and a rigid tool explains the forces.");
  return heft::say("Forces match a rigid tool.");
}

/// How sure the label of blocks [from, to) is. A contact is the surer the further its peak lies above the limit that
/// opens one; free motion, the further its largest residuals stay below it.
double confidenceOf(const SegmentBlocks& blocks, Range range) {
  const auto part = blocks.scores.segment(range.from, range.to - range.from);
  const MarkLabel label = blocks.labels[at(range.from)];
  std::vector<double> ordered(part.data(), part.data() + part.size());
  if (label == MarkLabel::contact) {
    const double peak = *std::max_element(ordered.begin(), ordered.end());
    return std::clamp(peak * peak / (peak * peak + 4.0), 0.5, 0.99);
  }
  const auto high = ordered.begin() + static_cast<std::ptrdiff_t>(0.9 * static_cast<double>(ordered.size() - 1));
  std::nth_element(ordered.begin(), high, ordered.end());
  return std::clamp(1.0 - 0.25 * *high * *high, 0.5, 0.99);
}

std::vector<Segment> segmentsFrom(const WrenchRows& rows, const SegmentBlocks& blocks, SegmentMode mode, int byUser) {
  std::vector<Segment> segments;
  const double half = 0.5 / rows.rateHz;
  for (Eigen::Index from = 0; from < rows.size();) {
    Eigen::Index to = from + 1;
    while (to < rows.size() && blocks.labels[at(to)] == blocks.labels[at(from)] &&
           blocks.kinds[at(to)] == blocks.kinds[at(from)] && blocks.notes[at(to)] == blocks.notes[at(from)])
      ++to;
    const int note = blocks.notes[at(from)];
    Segment segment{
        rows.time(from) - half,  rows.time(to - 1) + half,
        blocks.labels[at(from)], note > 0 ? blocks.reasons[at(note - 1)] : reasonFor(blocks.kinds[at(from)], mode),
        blocks.kinds[at(from)],  1.0};
    const bool judged = mode == SegmentMode::automatic && note != byUser;
    if (judged) segment.confidence = note > 0 ? 0.9 : confidenceOf(blocks, {from, to});
    segments.push_back(std::move(segment));
    from = to;
  }
  return segments;
}

}  // namespace

std::string_view toString(SegmentKind kind) {
  switch (kind) {
    case SegmentKind::freeMotion:
      return "free_motion";
    case SegmentKind::standing:
      return "standing_still";
    case SegmentKind::contact:
      return "contact";
    case SegmentKind::pickUp:
      return "pick_up";
    case SegmentKind::putDown:
      return "put_down";
    case SegmentKind::otherPayload:
      return "other_payload";
    case SegmentKind::sensorTrouble:
      return "sensor_trouble";
    case SegmentKind::ignored:
      break;
  }
  return "ignored";
}

SegmentMode defaultSegmentMode(const Recording& recording) {
  const bool marked = !recording.meta.marks.empty() || std::any_of(recording.labels.begin(), recording.labels.end(),
                                                                   [](const auto& l) { return l.has_value(); });
  return marked ? SegmentMode::marks : SegmentMode::automatic;
}

Segmentation segmentRows(const Recording& recording, const WrenchRows& rows, SegmentMode mode,
                         const std::optional<PayloadGuess>& guess, const std::vector<Trouble>* trouble) {
  Segmentation out;
  SegmentBlocks blocks(rows.size());
  if (mode != SegmentMode::all)
    markTrouble(trouble ? *trouble : sensorTrouble(recording), recording, rows, blocks, out.findings);
  if (mode == SegmentMode::automatic) {
    leaveOutMarked(recording, rows, blocks);
    blocks = automaticBlocks(rows, guess, std::move(blocks), out.findings);
  }
  const int byUser = static_cast<int>(blocks.reasons.size()) + 1;
  if (mode != SegmentMode::all) applyMarks(recording, rows, mode, blocks);
  out.segments = segmentsFrom(rows, blocks, mode, byUser);
  out.labels = std::move(blocks.labels);
  return out;
}

nlohmann::json toJson(const std::vector<Segment>& segments) {
  auto list = nlohmann::json::array();
  for (const auto& s : segments)
    list.push_back({{"from_s", s.from},
                    {"to_s", s.to},
                    {"label", toString(s.label)},
                    {"kind", toString(s.kind)},
                    {"reason", s.reason},
                    {"confidence", s.confidence}});
  return list;
}

}  // namespace heft
