#pragma once
// "What does the controller's current entry cost?" under the result: its card, its arrow in the 3D view, its script
// verb.
#include <QObject>
#include <QStringList>
#include <optional>

#include "ui/controller/entry_costs.h"
#include "ui/robot_view/cause_mark.h"
#include "ui/steps/step_panel.h"

class QVBoxLayout;

namespace heft {

/// The force at `time` as the view draws it; nothing where the entry is right.
std::optional<CauseMark> phantomMark(const EntryCost& cost, const Vector3d& p_SPcm_S, double time);

class EntryCard : public QObject {
  Q_OBJECT
 public:
  EntryCard(const StudioParts& parts, QWidget* owner);

  /// At the end of a page that is being built.
  void addTo(QVBoxLayout* column, QWidget* content);
  /// While the step is shown, the arrow follows the instant shown.
  void setShown(bool shown);
  void ask();
  void askFile();
  /// Lines of a script that this obeys.
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words);

 signals:
  void changed();

 private:
  void addAnswer(QVBoxLayout* card, QWidget* content);
  void showArrow();

  StudioParts parts_;
  QWidget* owner_;
  EntryCosts* costs_;
  bool shown_ = false;
};

}  // namespace heft
