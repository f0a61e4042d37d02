#pragma once
// The six steps across the top: done, now, next, later. Always clickable.
#include <QAbstractButton>
#include <QMap>
#include <QWidget>

#include "ui/steps/step.h"

namespace heft {

/// One step of the bar.
class StepButton : public QAbstractButton {
  Q_OBJECT
 public:
  enum class Place { now, next, other };
  StepButton(Step step, int number, QWidget* parent = nullptr);
  void show(const StepState& state, Place place);
  const StepState& state() const { return state_; }
  Place place() const { return place_; }
  QSize sizeHint() const override { return {180, 62}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  Step step_;
  int number_;
  StepState state_;
  Place place_ = Place::other;
};

class StepBar : public QWidget {
  Q_OBJECT
 public:
  explicit StepBar(QWidget* parent = nullptr);

  void addStep(Step step);
  void setState(Step step, const StepState& state);
  void setNow(Step step);
  Step now() const { return now_; }
  StepButton* button(Step step) const { return buttons_.value(step); }

 signals:
  void stepWanted(heft::Step step);

 private:
  void refresh();

  QMap<Step, StepButton*> buttons_;
  QMap<Step, StepState> states_;
  Step now_ = Step::record;
};

}  // namespace heft
