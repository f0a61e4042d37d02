#pragma once
// Which topic or column of a recording is which quantity: Heft's guess, and what the user says instead.
#include <QDialog>
#include <QStringListModel>
#include <map>
#include <memory>

#include "core/import/import.h"
#include "ui/jobs/job_runner.h"

class QComboBox;
class QDoubleSpinBox;
class QGridLayout;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace heft {

class LightIcon;

/// Begins with what the map file beside the recording says, if there is one. Every choice is tried at once, as a job.
class SourcesDialog : public QDialog {
  Q_OBJECT
 public:
  explicit SourcesDialog(const QString& recording, QWidget* parent = nullptr);
  ~SourcesDialog() override;

  const MappingWishes& wishes() const { return wishes_; }
  /// The recording can be read with these wishes.
  bool complete() const { return complete_; }
  bool looking() const { return jobs_.running(); }
  /// Writes them beside the recording, or takes that file away where nothing differs from Heft's guess.
  Result<bool> keep() const;

  void accept() override;

 private:
  struct Row {
    QString part;
    QComboBox* source = nullptr;
    QComboBox* unit = nullptr;
  };
  void addRow(QGridLayout* grid, const QString& part, const QString& title, const QString& tip,
              const std::vector<std::pair<QString, double>>& units);
  void addColumns(QVBoxLayout* column);
  void addMore(QVBoxLayout* column);
  void addFile();
  void showFiles();
  /// Tries the present wishes.
  void look();
  void show(const Result<RecordingContents>& found);
  void showRow(const Row& row, const RecordingContents& found);
  void showState(bool good, const QString& sentence);
  void setUse(const std::string& name, const QString& source);
  void setUnit(const QString& part, double factor);
  QString streamName(const Stream& stream) const;

  QString path_;
  MappingWishes wishes_;
  bool complete_ = false, first_ = true;
  std::shared_ptr<const RecordingContents> contents_;
  std::vector<Row> rows_;
  std::map<std::string, QComboBox*> columns_;  ///< By contract name
  QStringListModel fields_;                    ///< What a single column may be read from.
  QWidget* single_;
  QVBoxLayout* files_;
  QComboBox* poseOf_;
  QDoubleSpinBox* shift_;
  LightIcon* light_;
  QLabel* state_;
  QPushButton *read_, *guess_;
  JobRunner jobs_;
};

}  // namespace heft
