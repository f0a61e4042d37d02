#pragma once
// What the step "Mark" says, computed without widgets: each segment in words, and whether enough is left.
#include <QString>
#include <array>
#include <vector>

#include "core/segmentation/segmentation.h"

namespace heft {

/// "13.0 – 15.3 s".
QString stretchText(double from, double to);

/// "very sure" for 0.98.
QString confidenceWord(double confidence);

struct MarkSummary {
  std::array<double, 3> seconds{};  ///< Free, contact, ignored.
  double total = 0.0;               ///< [s]
  int suggestions = 0;              ///< Still to be decided.
  bool enough = false;              ///< Free time for mass and centre.
};

MarkSummary summarise(const std::vector<Segment>& segments, const std::vector<bool>& suggested, double duration);

/// "When was the tool free (not touching anything)?" needs one sentence of answer.
QString markAnswer(const MarkSummary& summary);

}  // namespace heft
