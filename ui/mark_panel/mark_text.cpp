#include "ui/mark_panel/mark_text.h"

#include <QCoreApplication>

#include "ui/models/numbers.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(MarkText)
};

/// With less than this, the tool cannot be distinguished from noise and bias [s].
constexpr double kEnough = 3.0;

}  // namespace

QString stretchText(double from, double to) {
  return Words::tr("%1 – %2 s").arg(numberText(from, 1), numberText(to, 1));
}

QString confidenceWord(double confidence) {
  return confidence >= 0.95 ? Words::tr("high") : confidence >= 0.8 ? Words::tr("medium") : Words::tr("low");
}

MarkSummary summarise(const std::vector<Segment>& segments, const std::vector<bool>& suggested, double duration) {
  MarkSummary out;
  out.total = duration;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    out.seconds[static_cast<std::size_t>(segments[i].label)] += segments[i].to - segments[i].from;
    out.suggestions += i < suggested.size() && suggested[i] ? 1 : 0;
  }
  out.enough = out.seconds[0] >= kEnough;
  return out;
}

QString markAnswer(const MarkSummary& summary) {
  if (summary.suggestions > 0)
    return Words::tr("Only free segments are used. Please review %n suggestion(s).", "", summary.suggestions);
  if (summary.seconds[1] + summary.seconds[2] <= 0) return Words::tr("No contact detected.");
  return Words::tr("Only free segments are used.");
}

}  // namespace heft
