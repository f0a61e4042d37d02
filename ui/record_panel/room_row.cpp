#include "ui/record_panel/room_row.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "core/collision/room.h"
#include "ui/controller/workspace.h"
#include "ui/models/numbers.h"
#include "ui/widgets/basics.h"

namespace heft {

QString roomText(const QString& file, const Room& room) {
  return RoomRow::tr("%1: %n obstacle(s); everything stays at least %2 mm away.", "",
                     static_cast<int>(room.obstacles.size()))
      .arg(QFileInfo(file).fileName(), numberText(1e3 * room.margin, 0));
}

RoomRow::RoomRow(Workspace* workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 6, 0, 0);
  column->addWidget(styledLabel(tr("Obstacles"), "sectionTitle", this));
  words_ = wrappedLabel({}, "caption", this);
  column->addWidget(words_);
  auto* buttons = new QHBoxLayout;
  choose_ = new QPushButton(tr("Choose a room …"), this);
  choose_->setObjectName("chooseRoom");
  choose_->setToolTip(tr("A file with walls, tables, boxes and meshes (heft.room/1)."));
  touched_ = new QPushButton(tr("From touches"), this);
  touched_->setObjectName("roomFromTouches");
  touched_->setToolTip(
      tr("Walls and tables that the tool was pressed against in this recording, by the tool’s shape and the direction "
         "of what presses back."));
  remove_ = new QPushButton(tr("Remove"), this);
  remove_->setObjectName("removeRoom");
  for (QPushButton* button : {choose_, touched_, remove_}) button->setProperty("role", "plain");
  // Three in a row are wider than the panel in German.
  buttons->addWidget(choose_);
  buttons->addWidget(touched_);
  buttons->addStretch(1);
  column->addLayout(buttons);
  column->addWidget(remove_, 0, Qt::AlignLeft);
  connect(choose_, &QPushButton::clicked, this, &RoomRow::chooseWanted);
  connect(touched_, &QPushButton::clicked, this, &RoomRow::touchedWanted);
  connect(remove_, &QPushButton::clicked, this, [this] { workspace_->setRoom({}, tr("Remove the room")); });
  connect(workspace_, &Workspace::roomChanged, this, &RoomRow::refresh);
  connect(workspace_, &Workspace::openedChanged, this, &RoomRow::refresh);
  refresh();
}

void RoomRow::refresh() {
  const auto& file = workspace_->session().room;
  touched_->setVisible(workspace_->opened() != nullptr);
  remove_->setVisible(!file.empty());
  if (file.empty())
    return words_->setText(
        tr("Walls and tables are not known: suggested motions only keep the arm clear of itself and its tool."));
  const auto room = readRoom(file);
  words_->setText(room ? roomText(QString::fromStdString(file.string()), *room)
                       : QString::fromStdString(room.error().message));
}

}  // namespace heft
