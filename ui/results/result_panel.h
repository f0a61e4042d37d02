#pragma once
// The panel at the right: what the estimate says in words, numbers and lights, and the one thing to do next.
#include <functional>

#include "ui/models/result_text.h"
#include "ui/widgets/panel_page.h"

class QVBoxLayout;

namespace heft {

class ResultPanel : public PanelPage {
  Q_OBJECT
 public:
  explicit ResultPanel(QWidget* parent = nullptr);

  /// No recording is open.
  void showNothing();
  /// A recording is open and its estimate under way.
  void showWorking(const QString& fileName);
  /// The recording is open, but there is no estimate.
  void showNoResult(const QString& reason);
  void showResult(const ResultText& result);

  /// The engineer's rows: method, residuals, sensor zero.
  void setDetailsShown(bool shown);
  bool detailsShown() const { return details_; }
  /// Adds more to the end of a result's page: the column, and the parent of what stands in it.
  void setFurther(std::function<void(QVBoxLayout*, QWidget*)> further) { further_ = std::move(further); }

 signals:
  void estimateWanted();
  void exportWanted();
  void recordWanted();
  void causeWanted();
  void shapeWanted();
  void methodsWanted();
  void knownWanted();
  /// Weigh what was picked up or put down.
  void objectWanted();

 private:
  void addMass(QVBoxLayout* column, const ResultText& result);
  void addCentre(QVBoxLayout* column, const ResultText& result);
  void addInertia(QVBoxLayout* column, const ResultText& result);
  void addFindings(QVBoxLayout* column, const std::vector<FindingText>& findings);
  void addAdvice(QVBoxLayout* column, const QString& advice);
  void addShares(QVBoxLayout* column, const std::vector<ShareText>& shares);
  void addKnown(QVBoxLayout* column, const std::vector<DetailText>& known);

  std::function<void(QVBoxLayout*, QWidget*)> further_;
  bool details_ = false;
  int frame_ = 0;                ///< In which the details are stated, as in ResultText::frames
  std::function<void()> again_;  ///< Rebuilds the page after "Details" was switched.
};

}  // namespace heft
