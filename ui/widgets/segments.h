#pragma once
// One of a few answers side by side.
#include <QFrame>
#include <QStringList>
#include <vector>

class QPushButton;

namespace heft {

class Segments : public QFrame {
  Q_OBJECT
 public:
  /// `names`: object names of the buttons, as many as texts.
  Segments(const QStringList& texts, const QStringList& names, QWidget* parent = nullptr);

  /// -1: none. No signal.
  void setChosen(int index);
  int chosen() const { return chosen_; }
  QPushButton* button(int index) const { return buttons_[static_cast<std::size_t>(index)]; }

 signals:
  void picked(int index);

 private:
  std::vector<QPushButton*> buttons_;
  int chosen_ = -1;
};

}  // namespace heft
