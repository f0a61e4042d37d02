#pragma once
// "What if …?" in Reality check and Practice: one slider a cause, and what it does.
#include <QObject>
#include <QStringList>
#include <memory>
#include <optional>
#include <vector>

#include "core/diagnosis/what_if.h"
#include "ui/jobs/job_runner.h"
#include "ui/steps/step_panel.h"

class QVBoxLayout;

namespace heft {

class WhatIfPane;
struct OpenRecording;

class WhatIfKnobs : public QObject {
  Q_OBJECT
 public:
  WhatIfKnobs(const StudioParts& parts, QObject* owner);

  bool on() const { return on_; }
  /// Switched on it gets the shown recording ready, in a job.
  void setOn(bool on);
  /// The sliders, on a page that is being built.
  void addTo(QVBoxLayout* column, QWidget* content);
  WhatIfPane* pane() { return pane_; }
  /// Turns a knob as a hand does.
  void turn(std::size_t knob, double position);
  void allOff();
  /// To a size in the cause's unit. Fails for causes without a slider and sizes beyond its end.
  Result<bool> turnTo(const QString& cause, double size);
  /// Sliders of these causes alone are shown; nothing: all.
  void showOnly(const std::optional<QStringList>& causes) { only_ = causes; }
  bool ready() const { return whatIf_ != nullptr; }
  const WhatIf& whatIf() const { return *whatIf_; }
  /// Null before one was turned or made ready.
  const WhatIfState* state() const { return state_ ? &*state_ : nullptr; }
  /// Lines of a script that this obeys.
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words);

 signals:
  /// on() or the set of sliders has changed.
  void changed();

 private:
  void prepare();
  void showState();
  Result<bool> turnBySize(const QString& cause, const QString& size);

  StudioParts parts_;
  WhatIfPane* pane_;
  JobRunner jobs_;
  bool on_ = false;
  QString failure_;
  std::shared_ptr<const OpenRecording> of_;
  std::shared_ptr<const WhatIf> whatIf_;
  std::vector<double> positions_;  ///< One per knob, 0 to 1
  std::optional<WhatIfState> calm_, state_;
  std::optional<QStringList> only_;
  QStringList wanted_;  ///< Of a script: turned once it is ready
};

}  // namespace heft
