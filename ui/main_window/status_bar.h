#pragma once
// The bottom line: what is open, and how far the work under way is.
#include <QWidget>

class QLabel;
class QProgressBar;

namespace heft {

class IconButton;
class JobRunner;

class StatusBar : public QWidget {
  Q_OBJECT
 public:
  explicit StatusBar(JobRunner* jobs, QWidget* parent = nullptr);
  void setFacts(const QString& text);

 private:
  void showJob(bool running);

  JobRunner* jobs_;
  QLabel* facts_;
  QLabel* job_;
  QProgressBar* bar_;
  IconButton* cancel_;
};

}  // namespace heft
