#pragma once
#include <QComboBox>

namespace heft {

/// A list to choose from whose shown entry ends in dots where it has no room, and is in the tip in full.
class ChoiceBox : public QComboBox {
 public:
  using QComboBox::QComboBox;

 protected:
  bool event(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;

 private:
  QRect textRoom() const;
};

}  // namespace heft
