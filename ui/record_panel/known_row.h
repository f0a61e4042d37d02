#pragma once
// One line of "What Heft knows so far": a light, a word, a band that narrows as time goes on, and how far it is known.
#include <QWidget>
#include <vector>

#include "ui/live/live_words.h"

class QLabel;

namespace heft {

/// The uncertainty over time as a band about a line; the widest that was fills the height.
class KnownBand : public QWidget {
 public:
  explicit KnownBand(QWidget* parent = nullptr);
  /// `halfWidths` over `times`, as many.
  void show(std::vector<double> times, std::vector<double> halfWidths, Light light);
  QSize sizeHint() const override { return {92, 34}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<double> times_, halfWidths_;
  Light light_ = Light::unknown;
};

class KnownRow : public QWidget {
 public:
  explicit KnownRow(QWidget* parent = nullptr);
  void show(const KnownText& text, std::vector<double> times, std::vector<double> halfWidths);

 private:
  LightIcon* light_;
  QLabel* name_;
  QLabel* words_;
  QLabel* size_;
  KnownBand* band_;
};

}  // namespace heft
