#pragma once
// The step "Reality check": what the simulation gets wrong, one card a cause, applied and taken back one by one.
#include <QColor>
#include <QElapsedTimer>
#include <QMap>
#include <QSet>
#include <memory>
#include <optional>
#include <utility>

#include "ui/controller/reality_findings.h"
#include "ui/jobs/job_runner.h"
#include "ui/reality_cards/reading_card.h"
#include "ui/reality_panel/reality_files.h"
#include "ui/steps/step_panel.h"

class QProgressBar;
class QStackedWidget;
class QVBoxLayout;

namespace heft {

class DecidingMotion;
class DifferencePane;
class LessonGuide;
class WhatIfKnobs;
struct CardActions;
struct OpenRecording;
struct RiddleActions;

class RealityPanel : public StepPanel {
  Q_OBJECT
 public:
  explicit RealityPanel(const StudioParts& parts);

  Step step() const override { return Step::realityCheck; }
  StepState state() const override;
  void entered() override;
  void left() override;
  void setDetailsShown(bool shown) override;
  Below below() const override;
  QWidget* ownPane() override;
  double viewShare() const override { return 0.5; }
  QString hint() const override;
  void addActions(const StudioMenus& menus) override;
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words) override;

  /// Looks for causes in the shown recording, in a job.
  void diagnose();
  /// Makes a recording that hides one fault and opens it.
  void practise(std::uint64_t seed);
  void guess(const std::string& cause);
  /// What the practice recording would be without its fault, in the curves; once more hides it.
  void showTwin(const QString& path);
  void apply(const std::string& cause);
  void takeBack(const std::string& cause);
  std::shared_ptr<const DiagnosisReport> report() const;
  /// Beside the report: what the difference can be drawn against.
  const std::vector<diagnosis::Witness>& witnesses() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  using Found = RealityFindings::Found;
  void refresh();
  void showWaiting();
  void showKnobs();
  void showLesson();
  void showReport(const Found& found);
  Found* found();
  const Found* found() const;
  bool applied(const std::string& cause) const;
  bool outdated() const;
  /// A practice recording whose fault has not been guessed yet.
  bool riddle() const;
  bool isOfPoses() const;
  void checkOnOther(int index);
  std::vector<int> others() const;
  void markPull();
  void showMotion(const std::string& cause);
  void recordFor(const std::string& cause);
  /// A command that is not carried out, and why.
  static Result<bool> refusal(const QString& sentence);
  void look(bool on);
  void arrange();
  void addCards(QVBoxLayout* column, const Found& found, bool& someNext);
  CardActions actions();
  RiddleActions riddleActions(const QString& path);

  JobRunner jobs_;
  DifferencePane* pane_;
  WhatIfKnobs* whatIf_;
  LessonGuide* lesson_;
  QStackedWidget* panes_;             ///< The difference, or what the knobs do
  DecidingMotion* motion_ = nullptr;  ///< Null without a 3D view.
  QProgressBar* bar_ = nullptr;       ///< While looking; of the page.
  QElapsedTimer since_;               ///< Since the search was started
  QString stage_;                     ///< What it does now
  RealityFindings* findings_;
  QMap<QString, Found>& found_;
  RealityFiles files_;
  QString failure_;
  std::pair<double, double> before_{0.0, 0.0};  ///< What the plots showed when the step was entered [s]
  QColor drawnIn_;                              ///< Text colour of the theme that the page was built in
  bool details_ = false, wanted_ = false, shown_ = false;
  bool looking_ = true;        ///< The difference stands below the arm, not force and torque.
  bool below_ = false;         ///< What below() said last
  QSet<QString> open_;         ///< Causes whose details are open
  bool handledShown_ = false;  ///< Findings that Heft allows for are unfolded
};

}  // namespace heft
