#pragma once
// A picture of a kind of tool with its name, chosen by a click; and the same drawing small, for lists.
#include <QAbstractButton>
#include <optional>

#include "core/payload/tool_sketch.h"

namespace heft {

/// Draws the picture in the colours of the current theme, filling `place`.
void paintToolPicture(QPainter& painter, ToolPicture picture, const QRectF& place);

class PictureCard : public QAbstractButton {
  Q_OBJECT
 public:
  PictureCard(ToolPicture picture, const QString& name, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {90, 70}; }
  QSize minimumSizeHint() const override { return {70, 70}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  ToolPicture picture_;
};

/// The wide card without a picture: "I don't know".
class NoPictureCard : public QAbstractButton {
  Q_OBJECT
 public:
  NoPictureCard(const QString& name, const QString& detail, QWidget* parent = nullptr);
  QSize sizeHint() const override { return {190, 70}; }
  QSize minimumSizeHint() const override { return {140, 70}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QString detail_;
};

}  // namespace heft
