#pragma once
// Labels block by block, before they become segments.
#include <optional>
#include <string>
#include <vector>

#include "core/segmentation/segmentation.h"

namespace heft {

inline std::size_t at(Eigen::Index k) { return static_cast<std::size_t>(k); }

struct Range {
  Eigen::Index from = 0, to = 0;  ///< Blocks [from, to).
};

/// What is known of each block.
struct SegmentBlocks {
  std::vector<MarkLabel> labels;
  std::vector<SegmentKind> kinds;
  std::vector<int> notes;  ///< 0, or 1 + the index of a reason in `reasons`
  VectorXd scores;         ///< Residual, worst channel: 1 where a contact ends, 2 where one opens
  std::vector<std::string> reasons;

  explicit SegmentBlocks(Eigen::Index n)
      : labels(at(n), MarkLabel::free),
        kinds(at(n), SegmentKind::freeMotion),
        notes(at(n), 0),
        scores(VectorXd::Zero(n)) {}
  void set(Eigen::Index k, MarkLabel label, SegmentKind kind, int note = 0) {
    labels[at(k)] = label;
    kinds[at(k)] = kind;
    notes[at(k)] = note;
  }
  int addReason(std::string reason) {
    reasons.push_back(std::move(reason));
    return static_cast<int>(reasons.size());
  }
};

/// Labels these stretches "ignore", and says so: a finding a reason, and another for what the user marked free, which
/// is used in the end.
void markTrouble(const std::vector<Trouble>& troubles, const Recording& recording, const WrenchRows& rows,
                 SegmentBlocks& blocks, Findings& findings);

/// What a rigid payload explains, what pushes, where the payload changes and where the tool rests. `clean`: nothing but
/// where the sensor fails (markTrouble()) and what the user left out.
SegmentBlocks automaticBlocks(const WrenchRows& rows, const std::optional<PayloadGuess>& guess,
                              const SegmentBlocks& clean, Findings& findings);

}  // namespace heft
