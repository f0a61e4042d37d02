#pragma once
// How much of a number comes from the data and how much from the shape, as a bar.
#include <QWidget>

namespace heft {

class DataShareBar : public QWidget {
 public:
  /// 1: all from the data.
  explicit DataShareBar(double share, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {200, 8}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double share_;
};

}  // namespace heft
