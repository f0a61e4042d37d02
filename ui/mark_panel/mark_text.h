#pragma once
// What the step "Mark" says, computed without widgets: each segment in words, and whether enough is left.
#include <QString>
#include <array>
#include <vector>

#include "core/estimation/estimate.h"
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

/// "Residual 9.02 N, 0.512 N m RMS": of measured − simulated in the segment. Empty where nothing was simulated.
QString residualText(const Segment& segment, const WrenchSeries& series);
/// "Sensor noise: 0.09 N, 0.004 N m", to compare with.
QString noiseText(const Vector6d& noiseStd);

/// "When was the tool free (not touching anything)?" needs one sentence of answer.
QString markAnswer(const MarkSummary& summary);

}  // namespace heft
