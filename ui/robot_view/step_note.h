#pragma once
// What to do here, and the step's own tools beside it: at the top left of the picture, the words at the bottom where
// they would cover what is shown.
#include <QPointer>
#include <QRectF>
#include <QString>
#include <QWidget>
#include <functional>
#include <vector>

class QLabel;

namespace heft {

class StepNote {
 public:
  /// `changed` is called after each change, so that the picture places it anew.
  StepNote(QWidget* picture, std::function<void()> changed);

  void setText(const QString& text);
  /// Empty takes the earlier ones out; they are not owned.
  void setTools(QWidget* tools);
  /// Where the step says nothing.
  void setOtherwise(const QString& text);

  /// Clear of these [px].
  void place(const std::vector<QRectF>& subjects);
  /// Of the words; empty while there are none.
  QRectF notePlace() const;
  /// Of words and tools that are shown.
  std::vector<QRectF> places() const;

 private:
  void show();

  QWidget* picture_;
  std::function<void()> changed_;
  QLabel* note_;
  QPointer<QWidget> tools_;
  QString text_, otherwise_;
  int way_ = 0;  ///< Even: in one line; from 2: at the bottom.
};

}  // namespace heft
