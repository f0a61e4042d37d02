#include "ui/main_window/status_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <algorithm>

#include "ui/jobs/job_runner.h"
#include "ui/widgets/basics.h"

namespace heft {

StatusBar::StatusBar(QWidget* parent) : QWidget(parent) {
  setObjectName("statusBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(28);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 0, 10, 0);
  row->setSpacing(10);
  facts_ = styledLabel({}, "facts", this);
  facts_->setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Preferred);
  row->addWidget(facts_);
  row->addSpacing(8);
  hint_ = styledLabel({}, "hint", this);
  hint_->setMinimumWidth(0);
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  row->addWidget(hint_, 1);
  job_ = styledLabel({}, "jobTitle", this);
  row->addWidget(job_);
  bar_ = new QProgressBar(this);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(140);
  bar_->setAccessibleName(tr("Progress"));
  row->addWidget(bar_);
  cancel_ = new IconButton("close", tr("Stop this task"), this);
  cancel_->setObjectName("cancelButton");
  cancel_->setIconSize(QSize(14, 14));
  row->addWidget(cancel_);
  connect(cancel_, &QToolButton::clicked, this, [this] {
    if (!shown_) return;
    job_->setText(tr("Stopping …"));
    cancel_->setEnabled(false);
    shown_->cancel();
  });
  saved_ = styledLabel({}, "saved", this);
  row->addWidget(saved_);
  showJob(nullptr);
}

void StatusBar::follow(JobRunner* jobs) {
  followed_.push_back(jobs);
  connect(jobs, &JobRunner::started, this, [this, jobs] {
    if (!jobs->title().isEmpty()) showJob(jobs);
  });
  connect(jobs, &JobRunner::progressed, this, [this, jobs](double fraction, const QString& what) {
    if (jobs != shown_) return;
    bar_->setValue(static_cast<int>(fraction * 1000));
    if (!what.isEmpty()) job_->setToolTip(what);
  });
  connect(jobs, &JobRunner::finished, this, [this, jobs] {
    if (jobs != shown_) return;
    // Another one may still be at work.
    JobRunner* other = nullptr;
    for (JobRunner* runner : followed_) {
      if (runner->running() && !runner->title().isEmpty()) other = runner;
    }
    showJob(other);
  });
  connect(jobs, &QObject::destroyed, this, [this, jobs] {
    followed_.erase(std::remove(followed_.begin(), followed_.end(), jobs), followed_.end());
    if (jobs == shown_) showJob(nullptr);
  });
}

void StatusBar::setFacts(const QString& text) {
  if (text != facts_->text()) facts_->setText(text);
}

void StatusBar::setHint(const QString& text) {
  if (text != hint_->text()) hint_->setText(text);
}

void StatusBar::setSaved(const QString& text) { saved_->setText(text); }

void StatusBar::showJob(JobRunner* jobs) {
  shown_ = jobs;
  cancel_->setEnabled(true);
  if (jobs) {
    job_->setText(jobs->title());
    bar_->setValue(static_cast<int>(jobs->fraction() * 1000));
  }
  for (QWidget* part : std::initializer_list<QWidget*>{job_, bar_, cancel_}) part->setVisible(jobs != nullptr);
  saved_->setVisible(jobs == nullptr);
}

}  // namespace heft
