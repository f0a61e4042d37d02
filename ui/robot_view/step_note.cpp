#include "ui/robot_view/step_note.h"

#include <QLabel>
#include <algorithm>

#include "ui/widgets/basics.h"

namespace heft {

StepNote::StepNote(QWidget* picture, std::function<void()> changed)
    : picture_(picture), changed_(std::move(changed)), note_(styledLabel({}, "viewNote", picture)) {
  note_->hide();
}

void StepNote::setText(const QString& text) {
  text_ = text;
  show();
}

void StepNote::setOtherwise(const QString& text) {
  otherwise_ = text;
  show();
}

void StepNote::setTools(QWidget* tools) {
  if (tools_) tools_->hide();
  tools_ = tools;
  if (tools) {
    tools->setParent(picture_);
    tools->adjustSize();
    tools->move(16, 12);
    tools->show();
    tools->raise();
  }
  show();
}

void StepNote::show() {
  const QString& text = text_.isEmpty() ? otherwise_ : text_;
  note_->setText(text);
  note_->adjustSize();
  note_->setVisible(!text.isEmpty());
  changed_();
}

void StepNote::place(const std::vector<QRectF>& subjects) {
  const double least = tools_ ? tools_->geometry().bottom() + 10 : 14;
  note_->setWordWrap(false);
  const QSize line = note_->sizeHint();
  note_->setWordWrap(true);
  const int narrow = std::min(line.width(), 240);
  const QSize lines(narrow, note_->heightForWidth(narrow));
  const auto placeOf = [&](int way) {
    const QSize size = way % 2 == 0 ? line : lines;
    const double y = way < 2 ? least : picture_->height() - size.height() - 14;
    return QRectF(QPointF(16, y), QSizeF(size));
  };
  const auto covers = [&](int way, double margin) {
    const QRectF place = placeOf(way).adjusted(-margin, -margin, margin, margin);
    return std::any_of(subjects.begin(), subjects.end(), [&](const QRectF& each) { return each.intersects(place); });
  };
  // In one line, in several; at the top, at the bottom. It goes back only where there is clearly room.
  int way = 0;
  while (way < 4 && covers(way, way < way_ ? 24 : 0)) ++way;
  way_ = way < 4 ? way : 1;
  note_->setWordWrap(way_ % 2 == 1);
  note_->setGeometry(placeOf(way_).toRect());
}

QRectF StepNote::notePlace() const { return note_->isHidden() ? QRectF() : QRectF(note_->geometry()); }

std::vector<QRectF> StepNote::places() const {
  std::vector<QRectF> places;
  if (note_->isVisibleTo(picture_)) places.push_back(notePlace());
  if (tools_ && tools_->isVisibleTo(picture_)) places.push_back(QRectF(tools_->geometry()));
  return places;
}

}  // namespace heft
