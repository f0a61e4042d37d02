#pragma once
// How much of the recording is free, contact and ignored, as one bar.
#include <QWidget>
#include <array>

namespace heft {

class ShareBar : public QWidget {
 public:
  explicit ShareBar(QWidget* parent = nullptr);
  void setSeconds(const std::array<double, 3>& seconds);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::array<double, 3> seconds_{};
};

/// One value from 0 to 1 as a bar in text colour: how sure Heft is.
class ConfidenceBar : public QWidget {
 public:
  explicit ConfidenceBar(double value, QWidget* parent = nullptr);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  double value_;
};

}  // namespace heft
