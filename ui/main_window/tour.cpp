#include "ui/main_window/tour.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/widgets/basics.h"

namespace heft {
namespace {

QString textFor(Step step) {
  switch (step) {
    case Step::record:
      return Tour::tr(
          "Everything begins with a recording: the arm moved with its tool while the sensor measured. In this sample a "
          "hose pulls at the tool, and Heft does not know that. Press the space bar to see the arm move.");
    case Step::mark:
      return Tour::tr(
          "Only segments without contact are used. Heft has marked them; everything is free here. In your own "
          "recordings you can paint over marks that are wrong.");
    case Step::shape:
      return Tour::tr(
          "If you know roughly what the tool looks like, describe it here: it helps where the motion shows too little. "
          "“I don’t know” is a fine answer, and right for now.");
    case Step::result:
      return Tour::tr(
          "The weight, and how certain it is. The triangles are warnings: something other than a rigid tool affects "
          "the readings. The tool of this sample really weighs 0.800 kg.");
    case Step::realityCheck:
      return Tour::tr(
          "Here Heft names the cause and draws it on the arm. Press “Apply this correction”, look at the curves below "
          "the arm, then "
          "at step 4: the number has come close to the truth.");
    case Step::exportFile:
      return Tour::tr(
          "Choose your controller, look at the file, save it. That is all. Continue with a recording of your own, with "
          "the virtual arm, or with an exercise from the menu Practice.");
  }
  return {};
}

}  // namespace

Tour::Tour(QWidget* parent) : QFrame(parent) {
  setObjectName("tour");
  setAttribute(Qt::WA_StyledBackground);
  setAccessibleName(tr("Tour"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(16, 8, 12, 8);
  row->setSpacing(12);
  row->addWidget(new IconLabel("bulb", 20, this), 0, Qt::AlignTop);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  title_ = styledLabel({}, "captionBold", this);
  text_ = wrappedLabel({}, "messageText", this);
  words->addWidget(title_);
  words->addWidget(text_);
  row->addLayout(words, 1);
  const auto button = [&](const QString& text, const char* name) {
    auto* made = new QPushButton(text, this);
    made->setObjectName(name);
    row->addWidget(made);
    return made;
  };
  back_ = button(tr("Back"), "tourBack");
  next_ = button({}, "tourNext");
  auto* end = new IconButton("close", tr("End the tour"), this);
  end->setObjectName("tourEnd");
  row->addWidget(end);
  connect(back_, &QPushButton::clicked, this,
          [this] { emit stepWanted(static_cast<Step>(static_cast<int>(step_) - 1)); });
  connect(next_, &QPushButton::clicked, this, [this] {
    if (step_ == Step::exportFile) return this->end();
    emit stepWanted(static_cast<Step>(static_cast<int>(step_) + 1));
  });
  connect(end, &QToolButton::clicked, this, &Tour::end);
  hide();
}

void Tour::begin() {
  running_ = true;
  refresh();
  show();
}

void Tour::end() {
  if (!running_) return;
  running_ = false;
  hide();
  emit ended();
}

void Tour::setStep(Step step) {
  step_ = step;
  refresh();
}

void Tour::refresh() {
  title_->setText(tr("Tour, %1 of 6: %2").arg(static_cast<int>(step_) + 1).arg(stepName(step_)));
  text_->setText(textFor(step_));
  back_->setVisible(step_ != Step::record);
  next_->setText(step_ == Step::exportFile ? tr("End") : tr("Next"));
}

}  // namespace heft
