#pragma once
// Two minutes through the six steps with a sample recording: what each step is for, and what to try in it. The steps
// stay what they are; the tour only says and leads on.
#include <QFrame>

#include "ui/steps/step.h"

class QLabel;
class QPushButton;

namespace heft {

class Tour : public QFrame {
  Q_OBJECT
 public:
  explicit Tour(QWidget* parent = nullptr);

  void begin();
  void end();
  bool running() const { return running_; }
  /// What is shown now, by whatever way the user got there.
  void setStep(Step step);

 signals:
  void stepWanted(heft::Step step);
  void ended();

 private:
  void refresh();

  bool running_ = false;
  Step step_ = Step::record;
  QLabel *title_, *text_;
  QPushButton *back_, *next_;
};

}  // namespace heft
