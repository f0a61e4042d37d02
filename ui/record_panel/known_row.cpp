#include "ui/record_panel/known_row.h"

#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "ui/theme/theme.h"

namespace heft {

KnownBand::KnownBand(QWidget* parent) : QWidget(parent) {
  setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  setFixedSize(sizeHint());
}

void KnownBand::show(std::vector<double> times, std::vector<double> halfWidths, Light light) {
  times_ = std::move(times);
  halfWidths_ = std::move(halfWidths);
  light_ = light;
  update();
}

void KnownBand::paintEvent(QPaintEvent*) {
  const Theme& t = theme();
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const QColor line = light_ == Light::measured ? t.good : light_ == Light::partly ? t.look : t.text3;
  const double middle = height() / 2.0;
  if (times_.size() < 2) {
    painter.fillRect(QRectF(0, 0, width(), height()), t.quietTint);
    painter.setPen(QPen(line, 1.4));
    painter.drawLine(QPointF(0, middle), QPointF(width(), middle));
    return;
  }
  // The first guesses are wild; from twice the value after a tenth of the time on the band is drawn true to scale.
  const double widest = 2.0 * halfWidths_[times_.size() / 10];
  const double span = std::max(1e-9, times_.back() - times_.front());
  QPainterPath band;
  std::vector<QPointF> lower;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    const double x = (times_[i] - times_.front()) / span * width();
    const double half = std::clamp(halfWidths_[i] / std::max(1e-12, widest), 0.03, 1.0) * (middle - 1);
    if (i == 0) {
      band.moveTo(x, middle - half);
    } else {
      band.lineTo(x, middle - half);
    }
    lower.emplace_back(x, middle + half);
  }
  for (auto point = lower.rbegin(); point != lower.rend(); ++point) band.lineTo(*point);
  band.closeSubpath();
  QColor fill = line;
  fill.setAlpha(t.dark ? 80 : 60);
  painter.fillPath(band, fill);
  painter.setPen(QPen(line, 1.4));
  painter.drawLine(QPointF(0, middle), QPointF(width(), middle));
}

KnownRow::KnownRow(QWidget* parent) : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 8, 0, 8);
  row->setSpacing(12);
  light_ = new LightIcon(Light::unknown, 22, this);
  row->addWidget(light_, 0, Qt::AlignVCenter);
  auto* texts = new QVBoxLayout;
  texts->setSpacing(1);
  name_ = styledLabel({}, "smallNumber", this);
  words_ = wrappedLabel({}, "caption", this);
  texts->addWidget(name_);
  texts->addWidget(words_);
  row->addLayout(texts, 1);
  band_ = new KnownBand(this);
  row->addWidget(band_, 0, Qt::AlignVCenter);
  size_ = styledLabel({}, "smallNumber", this);
  size_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  size_->setFixedWidth(92);
  row->addWidget(size_);
}

void KnownRow::show(const KnownText& text, std::vector<double> times, std::vector<double> halfWidths) {
  light_->setLight(text.light);
  name_->setText(text.name);
  words_->setText(text.words);
  size_->setText(text.size);
  setAccessibleName(text.name + QStringLiteral(": ") + text.words + QStringLiteral(" ") + text.size);
  band_->show(std::move(times), std::move(halfWidths), text.light);
}

}  // namespace heft
