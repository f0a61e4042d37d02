#include "ui/main_window/status_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>

#include "ui/jobs/job_runner.h"
#include "ui/widgets/basics.h"

namespace heft {

StatusBar::StatusBar(JobRunner* jobs, QWidget* parent) : QWidget(parent), jobs_(jobs) {
  setObjectName("statusBar");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(28);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 0, 10, 0);
  row->setSpacing(10);
  facts_ = styledLabel({}, "facts", this);
  row->addWidget(facts_, 1);
  job_ = styledLabel({}, "jobTitle", this);
  row->addWidget(job_);
  bar_ = new QProgressBar(this);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(140);
  bar_->setAccessibleName(tr("Progress"));
  row->addWidget(bar_);
  cancel_ = new IconButton("close", tr("Stop this"), this);
  cancel_->setObjectName("cancelButton");
  cancel_->setIconSize(QSize(14, 14));
  row->addWidget(cancel_);
  connect(cancel_, &QToolButton::clicked, jobs_, &JobRunner::cancel);
  connect(jobs_, &JobRunner::started, this, [this](const QString& title) {
    job_->setText(title);
    bar_->setValue(0);
    showJob(true);
  });
  connect(jobs_, &JobRunner::progressed, this, [this](double fraction, const QString& what) {
    bar_->setValue(static_cast<int>(fraction * 1000));
    if (!what.isEmpty()) job_->setToolTip(what);
  });
  connect(jobs_, &JobRunner::finished, this, [this] { showJob(false); });
  showJob(false);
}

void StatusBar::setFacts(const QString& text) { facts_->setText(text); }

void StatusBar::showJob(bool running) {
  job_->setVisible(running);
  bar_->setVisible(running);
  cancel_->setVisible(running);
}

}  // namespace heft
