#include "ui/main_window/header_bar.h"

#include <QButtonGroup>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenuBar>
#include <QPushButton>
#include <QUndoStack>
#include <algorithm>

#include "ui/widgets/basics.h"

namespace heft {

HeaderBar::HeaderBar(QUndoStack* undo, QWidget* parent) : QWidget(parent) {
  setObjectName("header");
  setAttribute(Qt::WA_StyledBackground);
  setFixedHeight(38);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 0, 12, 0);
  row->setSpacing(8);
  row->addWidget(new IconLabel("heft", 20, this));
  row->addWidget(styledLabel(tr("Heft Studio"), "productName", this));
  row->addSpacing(4);
  menus_ = new QMenuBar(this);
  menus_->setNativeMenuBar(false);
  menus_->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  row->addWidget(menus_, 0, Qt::AlignVCenter);
  row->addStretch(1);
  auto* back = new IconButton("undo", tr("Undo (Ctrl+Z)"), this);
  undo_ = back;
  back->setObjectName("undoButton");
  auto* forth = new IconButton("redo", tr("Redo (Ctrl+Y)"), this);
  forth->setObjectName("redoButton");
  connect(back, &QToolButton::clicked, undo, &QUndoStack::undo);
  connect(forth, &QToolButton::clicked, undo, &QUndoStack::redo);
  const auto refresh = [undo, back, forth] {
    back->setEnabled(undo->canUndo());
    forth->setEnabled(undo->canRedo());
    back->setToolTip(undo->canUndo() ? tr("Undo: %1 (Ctrl+Z)").arg(undo->undoText()) : tr("Nothing to undo"));
    forth->setToolTip(undo->canRedo() ? tr("Redo: %1 (Ctrl+Y)").arg(undo->redoText()) : tr("Nothing to redo"));
  };
  connect(undo, &QUndoStack::indexChanged, this, refresh);
  refresh();
  row->addWidget(back);
  row->addWidget(forth);
  row->addSpacing(8);
  auto* segmented = new QFrame(this);
  segmented->setObjectName("segmented");
  segmented->setFixedHeight(26);
  auto* segments = new QHBoxLayout(segmented);
  segments->setContentsMargins(1, 1, 1, 1);
  segments->setSpacing(0);
  simple_ = new QPushButton(tr("Simple"), segmented);
  details_ = new QPushButton(tr("Details"), segmented);
  simple_->setToolTip(tr("The result in plain words"));
  details_->setToolTip(tr("Also method, residuals and the sensor’s zero"));
  auto* group = new QButtonGroup(this);
  for (QPushButton* button : {simple_, details_}) {
    button->setCheckable(true);
    segments->addWidget(button);
    group->addButton(button);
  }
  simple_->setObjectName("simpleButton");
  details_->setObjectName("detailsButton");
  simple_->setChecked(true);
  row->addWidget(segmented, 0, Qt::AlignVCenter);
  connect(details_, &QPushButton::toggled, this, &HeaderBar::detailsWanted);
  // Outside the layout, so that it stands in the middle of the window and not of what is left.
  file_ = styledLabel({}, "fileName", this);
  file_->setAlignment(Qt::AlignCenter);
}

void HeaderBar::setDetails(bool shown) { (shown ? details_ : simple_)->setChecked(true); }

void HeaderBar::setFileName(const QString& name, const QString& path) {
  name_ = name;
  file_->setToolTip(path);
  placeFileName();
}

void HeaderBar::placeFileName() {
  const int left = menus_->geometry().right() + 16, room = undo_->x() - 16 - left;
  // The end of a name is more informative than its middle: elide there rather than cut it off.
  file_->setText(file_->fontMetrics().elidedText(name_, Qt::ElideMiddle, std::max(0, room - 8)));
  const int wanted = std::min(file_->sizeHint().width() + 8, std::max(0, room));
  // In the middle of the window where the menus leave room for that.
  file_->setGeometry(std::clamp((width() - wanted) / 2, left, std::max(left, left + room - wanted)), 0, wanted,
                     height() - 1);
}

void HeaderBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeFileName();
}

}  // namespace heft
