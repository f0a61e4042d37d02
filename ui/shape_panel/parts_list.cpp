#include "ui/shape_panel/parts_list.h"

#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "ui/shape_panel/picture_card.h"
#include "ui/shape_panel/shape_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

QIcon pictureIcon(ToolPicture picture) {
  QPixmap pixmap(48, 48);
  pixmap.setDevicePixelRatio(2.0);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  paintToolPicture(painter, picture, QRectF(0, 0, 24, 24));
  return QIcon(pixmap);
}

}  // namespace

PartsList::PartsList(QWidget* parent) : QWidget(parent) {
  rows_ = new QVBoxLayout(this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(4);
}

void PartsList::showParts(const Shape& shape, int selected) {
  while (QLayoutItem* item = rows_->takeAt(0)) {
    if (item->widget()) {
      item->widget()->hide();
      item->widget()->deleteLater();
    }
    delete item;
  }
  for (std::size_t b = 0; b < shape.bodies.size(); ++b) {
    const ShapeBody& body = shape.bodies[b];
    const int index = static_cast<int>(b);
    auto* line = new QWidget(this);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    QString title = bodyTitle(body);
    if (body.mass) title += QString::fromUtf8(" · ") + kilograms(*body.mass);
    auto* button = new QPushButton(pictureIcon(*toolPictureFromString(toString(body.kind))), title, line);
    button->setObjectName(QStringLiteral("part_%1").arg(index));
    button->setProperty("role", index == selected ? "chosen" : "plain");
    button->setIconSize(QSize(24, 24));
    button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    connect(button, &QPushButton::clicked, this, [this, index] { emit picked(index); });
    row->addWidget(button, 1);
    auto* remove = new IconButton("close", tr("Remove part %1").arg(index + 1), line);
    remove->setObjectName(QStringLiteral("removePart_%1").arg(index));
    remove->setEnabled(shape.bodies.size() > 1);
    connect(remove, &QToolButton::clicked, this, [this, index] { emit removeWanted(index); });
    row->addWidget(remove);
    rows_->addWidget(line);
  }
  auto* add = new QPushButton(tr("Add a part"), this);
  add->setObjectName("addPart");
  auto* menu = new QMenu(add);
  for (const ToolPicture picture : kToolPictures) {
    const auto kind = bodyKindOf(picture);
    if (!kind) continue;
    QAction* action =
        menu->addAction(pictureIcon(picture), pictureName(picture), this, [this, k = *kind] { emit addWanted(k); });
    action->setObjectName(QStringLiteral("add_") + QString::fromUtf8(toString(picture).data()));
  }
  menu->addAction(pictureIcon(ToolPicture::mesh), tr("%1 …").arg(pictureName(ToolPicture::mesh)), this,
                  &PartsList::addMeshWanted)
      ->setObjectName("add_mesh");
  add->setMenu(menu);
  rows_->addWidget(add, 0, Qt::AlignLeft);
}

}  // namespace heft
