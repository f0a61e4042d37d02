#pragma once
// The step "Mark": which segments are free of contact. Heft makes suggestions; the user accepts them or paints over
// them.
#include <QColor>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "core/segmentation/segmentation.h"
#include "ui/mark_panel/mark_text.h"
#include "ui/steps/step_panel.h"

class QGridLayout;
class QVBoxLayout;

namespace heft {

class Segments;

/// In the order of their keys.
inline constexpr std::array kBrushes{MarkLabel::free, MarkLabel::contact, MarkLabel::ignore};

class MarkPanel : public StepPanel {
  Q_OBJECT
 public:
  explicit MarkPanel(const StudioParts& parts);

  Step step() const override { return Step::mark; }
  StepState state() const override;
  double viewShare() const override { return 0.4; }
  QString hint() const override;
  void entered() override;
  void left() override;
  void addActions(const StudioMenus& menus) override;
  void setDetailsShown(bool shown) override;
  bool keyPressed(QKeyEvent* event) override;
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words) override;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void addSuggestion(QVBoxLayout* column, const Segment& segment, bool first);
  void addSegments(QVBoxLayout* column, const std::vector<Segment>& segments, const std::vector<bool>& suggested);
  /// What an engineer asks of one: how long, the residual in it, why, and how sure.
  void addEvidence(QGridLayout* rows, int line, const Segment& segment);
  void addPainting(QVBoxLayout* column);
  void addSummary(QVBoxLayout* column, const MarkSummary& summary);
  void addTrim(QVBoxLayout* column);
  void chooseBrush(MarkLabel label);
  /// Puts the brush into the shared pane, or takes it out.
  void showBrush();
  void decide(const Segment& segment, MarkLabel label);
  void acceptAll();
  void select(double from, double to);
  /// The segment under the time cursor.
  std::optional<Segment> segmentNow() const;
  std::pair<std::vector<Segment>, std::vector<bool>> shown() const;

  MarkLabel brush_ = MarkLabel::contact;
  bool inPlots_ = false;  ///< Dragging in the plots paints, too.
  bool here_ = false;
  QColor drawnIn_;  ///< The theme's text colour when that was last asked.
  Segments* brushes_ = nullptr;
  bool details_ = false;  ///< The evidence for each label
  int trimKey_ = 0;       ///< Steps of one change are one edit.
};

}  // namespace heft
