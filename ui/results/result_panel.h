#pragma once
// The panel at the right: what the estimate says in words, numbers and lights, and the one thing to do next.
#include <QStringList>
#include <QWidget>
#include <functional>

#include "ui/models/result_text.h"

class QPushButton;
class QScrollArea;
class QVBoxLayout;

namespace heft {

class ResultPanel : public QWidget {
  Q_OBJECT
 public:
  explicit ResultPanel(QWidget* parent = nullptr);

  /// Nothing open: how to begin, and the files opened lately.
  void showWelcome(const QStringList& recentFiles);
  /// A recording is open and its estimate under way.
  void showWorking(const QString& fileName);
  /// The recording is open, but there is no estimate.
  void showNoResult(const QString& reason);
  void showResult(const ResultText& result);

  /// The engineer's rows: method, residuals, sensor zero.
  void setDetailsShown(bool shown);
  bool detailsShown() const { return details_; }

 signals:
  void openWanted();
  void fileWanted(const QString& path);
  void estimateWanted();
  void saveWanted();

 private:
  /// Empties the panel and begins again with its question.
  QVBoxLayout* restart(const QString& question, const QString& answer);
  void setMainButton(const QString& text, void (ResultPanel::*signal)());
  void addMass(QVBoxLayout* column, const ResultText& result);
  void addCentre(QVBoxLayout* column, const ResultText& result);
  void addInertia(QVBoxLayout* column, const ResultText& result);
  void addFindings(QVBoxLayout* column, const std::vector<FindingText>& findings);
  void addDetails(QVBoxLayout* column, const std::vector<DetailText>& details);

  QScrollArea* scroll_;
  QWidget* foot_;
  QPushButton* main_;
  QMetaObject::Connection mainConnection_;
  bool details_ = false;
  std::function<void()> again_;  ///< Shows the same once more, after "Details" was switched.
};

}  // namespace heft
