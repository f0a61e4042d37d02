#include "ui/robot_view/dimension_editor.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMouseEvent>

#include "ui/theme/theme.h"

namespace heft {

DimensionEditor::DimensionEditor(QWidget* view, Placed placed, Current current)
    : QObject(view),
      view_(view),
      placed_(std::move(placed)),
      current_(std::move(current)),
      field_(new QLineEdit(view)) {
  field_->setObjectName("dimensionField");
  field_->setAccessibleName(tr("Length"));
  field_->setToolTip(tr("A length in mm, or with its unit: 64, 6.4 cm. Enter applies, Esc cancels."));
  field_->setAlignment(Qt::AlignCenter);
  field_->hide();
  view_->installEventFilter(this);
  field_->installEventFilter(this);
}

std::optional<int> DimensionEditor::labelAt(const QPoint& point) const {
  for (const PlacedDimension& each : placed_())
    if (each.line->id >= 0 && each.label.adjusted(-3, -3, 3, 3).contains(point)) return each.line->id;
  return std::nullopt;
}

void DimensionEditor::open(int id) {
  for (const PlacedDimension& each : placed_()) {
    if (each.line->id != id) continue;
    id_ = id;
    QRect place(QPoint(), QSize(std::max(84, static_cast<int>(each.label.width()) + 30), 30));
    place.moveCenter(each.label.center().toPoint());
    place.moveLeft(std::clamp(place.left(), 4, std::max(4, view_->width() - place.width() - 4)));
    place.moveTop(std::clamp(place.top(), 4, std::max(4, view_->height() - place.height() - 4)));
    field_->setGeometry(place);
    field_->setText(each.line->text);
    field_->show();
    field_->raise();
    field_->setFocus(Qt::MouseFocusReason);
    field_->selectAll();
    return;
  }
}

void DimensionEditor::close() {
  if (id_ < 0) return;
  id_ = -1;
  const bool had = field_->hasFocus();
  field_->hide();
  if (had) view_->setFocus();
}

bool DimensionEditor::eventFilter(QObject* watched, QEvent* event) {
  if (watched == view_) return viewEvent(event);
  if (watched != field_ || id_ < 0) return false;
  if (event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if (key == Qt::Key_Escape) return close(), true;
    if (key != Qt::Key_Return && key != Qt::Key_Enter && key != Qt::Key_Tab) return false;
    const int id = id_;
    const QString text = field_->text();
    close();
    emit typed(id, text);
    return true;
  }
  // Whoever looks elsewhere has not said that the number counts.
  if (event->type() == QEvent::FocusOut && static_cast<QFocusEvent*>(event)->reason() != Qt::PopupFocusReason) close();
  return false;
}

bool DimensionEditor::viewEvent(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseMove: {
      auto* mouse = static_cast<QMouseEvent*>(event);
      if (mouse->buttons() != Qt::NoButton) {
        if (pressed_ && (mouse->pos() - *pressed_).manhattanLength() >= QApplication::startDragDistance())
          pressed_.reset();
        return false;
      }
      const bool over = labelAt(mouse->pos()).has_value();
      if (over != pointing_) {
        pointing_ = over;
        over ? view_->setCursor(Qt::IBeamCursor) : view_->unsetCursor();
      }
      return over;  // Else the view would look for a handle behind the label.
    }
    case QEvent::MouseButtonPress: {
      auto* mouse = static_cast<QMouseEvent*>(event);
      close();
      pressed_.reset();
      if (mouse->button() != Qt::LeftButton) return false;
      if (const auto id = labelAt(mouse->pos())) return open(*id), true;
      pressed_ = mouse->pos();
      return false;
    }
    case QEvent::MouseButtonRelease: {
      if (!pressed_) return false;
      pressed_.reset();
      // After the view has let the handle go.
      if (const auto id = current_())
        QMetaObject::invokeMethod(
            this, [this, id] { open(*id); }, Qt::QueuedConnection);
      return false;
    }
    case QEvent::Wheel:
    case QEvent::Resize:
      close();
      return false;
    default:
      return false;
  }
}

}  // namespace heft
