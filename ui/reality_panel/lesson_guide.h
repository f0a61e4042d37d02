#pragma once
// Leads through a lesson: its recording, its steps with their sliders, its question.
#include <QObject>
#include <QStringList>
#include <optional>

#include "core/simulation/lesson.h"
#include "ui/jobs/job_runner.h"
#include "ui/steps/step_panel.h"

class QMenu;
class QVBoxLayout;

namespace heft {

class WhatIfKnobs;

/// The lessons that come with the program, in their order; tests make sure that they can be read.
std::vector<Lesson> builtInLessons();

class LessonGuide : public QObject {
  Q_OBJECT
 public:
  /// `knobs` must outlive it.
  LessonGuide(const StudioParts& parts, WhatIfKnobs* knobs, QObject* owner);

  bool on() const { return lesson_.has_value(); }
  void begin(const Lesson& lesson);
  Result<bool> beginFile(const QString& file);
  void end();
  void next();
  void back();
  void answer(int index);

  /// Question and answer over the page, and the two buttons at its foot.
  QString title() const;
  QString words() const;
  void addTo(QVBoxLayout* column, QWidget* content);
  /// After the last step, while the question is asked.
  bool asking() const;
  bool solved() const;
  bool first() const { return step_ == 0; }

  void addActions(QMenu* practice, QWidget* owner);
  /// Lines of a script that this obeys.
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words);

 signals:
  void changed();

 private:
  void setStep(std::size_t step);
  void applyFaults();

  StudioParts parts_;
  WhatIfKnobs* knobs_;
  JobRunner jobs_;
  std::optional<Lesson> lesson_;
  QString file_;  ///< Of its recording
  std::size_t step_ = 0;
  bool due_ = false;  ///< The step's faults are still to be set.
  std::optional<int> answered_;
};

}  // namespace heft
