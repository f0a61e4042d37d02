#pragma once
// Under the 3D view: the difference by frequency over the noise floor, or against what the robot did, or over time,
// before and after the causes found.
#include <QWidget>
#include <memory>
#include <optional>
#include <vector>

#include "ui/charts/chart.h"
#include "ui/controller/diagnosis.h"

class QComboBox;
class QLabel;
class QPushButton;

namespace heft {

class DifferencePane : public QWidget {
  Q_OBJECT
 public:
  explicit DifferencePane(QWidget* parent = nullptr);

  /// `witnesses` may be empty where the motion could not be worked out.
  void showReport(std::shared_ptr<const DiagnosisReport> report, std::vector<diagnosis::Witness> witnesses);

  enum class View { time, frequency, motion };
  void setView(View view);
  View view() const { return view_; }
  /// 0 to 5: force x ... torque z.
  void setChannel(int channel);
  /// By its ID; false if there is none of that name.
  bool setWitness(const QString& id);

  /// For pictures and reports.
  std::vector<Chart> charts() const;

 signals:
  void closeWanted();

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  Chart timeChart() const;
  Chart frequencyChart(bool torque) const;
  Chart motionChart(bool after) const;

  std::shared_ptr<const DiagnosisReport> report_;
  std::vector<diagnosis::Witness> witnesses_;
  View view_ = View::frequency;
  QPushButton* views_[3];
  QComboBox* channel_;
  QComboBox* witness_;
  QLabel* says_;
  ChartWidget* left_;
  ChartWidget* right_;
};

}  // namespace heft
