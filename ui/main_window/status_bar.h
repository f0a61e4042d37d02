#pragma once
// The bottom line: what is open, and how far the work under way is.
#include <QWidget>
#include <vector>

class QLabel;
class QProgressBar;

namespace heft {

class IconButton;
class JobRunner;

class StatusBar : public QWidget {
  Q_OBJECT
 public:
  explicit StatusBar(QWidget* parent = nullptr);
  /// Shows this runner's work, too; of several under way the one that began last.
  void follow(JobRunner* jobs);
  void setFacts(const QString& text);
  /// What may be done here; beside the facts.
  void setHint(const QString& text);
  /// "Saved automatically, 14:31", at the right.
  void setSaved(const QString& text);

 private:
  void showJob(JobRunner* jobs);

  JobRunner* shown_ = nullptr;  ///< Whose work is shown.
  std::vector<JobRunner*> followed_;
  QLabel* facts_;
  QLabel* hint_;
  QLabel* saved_;
  QLabel* job_;
  QProgressBar* bar_;
  IconButton* cancel_;
};

}  // namespace heft
