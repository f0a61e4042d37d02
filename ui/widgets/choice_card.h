#pragma once
// A card that is chosen by a click: a name and a line below it; chosen = accent edge and tint.
#include <QAbstractButton>

namespace heft {

class ChoiceCard : public QAbstractButton {
  Q_OBJECT
 public:
  ChoiceCard(const QString& name, const QString& detail, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {112, 52}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString detail_;
};

}  // namespace heft
