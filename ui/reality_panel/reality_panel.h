#pragma once
// The step "Reality check": what the simulation gets wrong, one card a cause, applied and taken back one by one.
#include <QMap>
#include <memory>
#include <optional>

#include "ui/controller/diagnosis.h"
#include "ui/jobs/job_runner.h"
#include "ui/reality_panel/reading_card.h"
#include "ui/steps/step_panel.h"

class QProgressBar;

namespace heft {

class DecidingMotion;
class DifferencePane;
struct OpenRecording;

/// What was found, by path. The workspace's only child of its kind.
class RealityFindings : public QObject {
 public:
  using QObject::QObject;
  struct Found {
    std::weak_ptr<const OpenRecording> of;
    std::shared_ptr<const DiagnosisReport> report;
    std::vector<diagnosis::Witness> witnesses;
    std::optional<ReadingCurves> curves;  ///< Where the numbers do not mean what the meta file says
    std::string json;                     ///< heft.diagnose/1
    std::vector<Mark> marks;              ///< That it was made with.
    std::string guess;                    ///< Of a practice recording
  };
  QMap<QString, Found> found;
};

class RealityPanel : public StepPanel {
  Q_OBJECT
 public:
  explicit RealityPanel(const StudioParts& parts);

  Step step() const override { return Step::realityCheck; }
  StepState state() const override;
  void entered() override;
  void left() override;
  void setDetailsShown(bool shown) override;
  Below below() const override { return looking_ ? Below::own : Below::plots; }
  QWidget* ownPane() override;
  QString hint() const override;
  void addActions(const StudioMenus& menus) override;
  std::optional<Result<bool>> obey(const QStringList& words) override;

  /// Looks for causes in the shown recording, in a job.
  void diagnose();
  /// Makes a recording that hides one fault and opens it.
  void practise(std::uint64_t seed);
  void guess(const std::string& cause);
  void apply(const std::string& cause);
  void takeBack(const std::string& cause);
  std::shared_ptr<const DiagnosisReport> report() const;
  /// Beside the report: what the difference can be drawn against.
  const std::vector<diagnosis::Witness>& witnesses() const;

 private:
  using Found = RealityFindings::Found;
  void refresh();
  void showWaiting();
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
  void saveMeta();
  Result<bool> writeMeta(const QString& file, bool replace);
  void saveReport();
  Result<bool> writeReport(const QString& file, bool replace);
  void look(bool on);

  JobRunner jobs_;
  DifferencePane* pane_;
  DecidingMotion* motion_ = nullptr;  ///< Null without a 3D view.
  QProgressBar* bar_ = nullptr;       ///< While looking; of the page.
  QMap<QString, Found>& found_;
  QString failure_;
  bool details_ = false, looking_ = false, wanted_ = false, shown_ = false;
};

}  // namespace heft
