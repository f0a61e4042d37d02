#include "ui/robot_view/view_tools.h"

#include <QAction>
#include <QMenu>
#include <QToolButton>
#include <QVBoxLayout>
#include <utility>

#include "ui/widgets/basics.h"

namespace heft {

ViewTools::ViewTools(SceneParts* parts, bool* labels, QWidget* parent) : QWidget(parent) {
  setObjectName("viewTools");
  setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(3, 3, 3, 3);
  column->setSpacing(2);
  auto* fit = new IconButton("home", tr("Show the whole arm (F)"), this);
  fit->setObjectName("fitButton");
  connect(fit, &QToolButton::clicked, this, [this] { emit presetWanted(ViewPreset::overview); });
  auto* tool = new IconButton("tool", tr("Zoom to the tool (T)"), this);
  tool->setObjectName("toolButton");
  connect(tool, &QToolButton::clicked, this, [this] { emit presetWanted(ViewPreset::tool); });

  auto* views = new IconButton("view", tr("View direction"), this);
  views->setPopupMode(QToolButton::InstantPopup);
  views->setMenu(presetMenu(views));
  auto* eye = new IconButton("eye", tr("Choose what is shown"), this);
  eye->setPopupMode(QToolButton::InstantPopup);
  eye->setMenu(partsMenu(parts, labels, eye));

  auto* alone = new IconButton("fit", tr("Maximise the 3D view, or restore it (Shift+F11)"), this);
  alone->setObjectName("aloneButton");  // The window listens to it.
  auto* picture = new IconButton("camera", tr("Save a picture of this view"), this);
  connect(picture, &QToolButton::clicked, this, &ViewTools::pictureWanted);
  for (auto* button : {fit, tool, views, eye, alone, picture}) column->addWidget(button);
}

QMenu* ViewTools::presetMenu(QWidget* parent) {
  auto* menu = new QMenu(parent);
  const std::pair<QString, ViewPreset> presets[] = {
      {tr("Front"), ViewPreset::front}, {tr("Side"), ViewPreset::side}, {tr("Top"), ViewPreset::top}};
  for (const auto& [text, preset] : presets) menu->addAction(text, this, [this, p = preset] { emit presetWanted(p); });
  return menu;
}

QMenu* ViewTools::partsMenu(SceneParts* parts, bool* labels, QWidget* parent) {
  auto* menu = new QMenu(parent);
  const auto addToggle = [&](const QString& text, bool* flag) {
    QAction* action = menu->addAction(text);
    action->setCheckable(true);
    action->setChecked(*flag);
    connect(action, &QAction::toggled, this, [this, flag](bool on) {
      *flag = on;
      emit partsChanged();
    });
  };
  addToggle(tr("Tool"), &parts->tool);
  addToggle(tr("Path"), &parts->path);
  addToggle(tr("Force, torque and gravity"), &parts->arrows);
  addToggle(tr("Sensor axes"), &parts->axes);
  addToggle(tr("Centre of mass"), &parts->payload);
  addToggle(tr("Floor grid"), &parts->grid);
  addToggle(tr("Labels"), labels);
  return menu;
}

void ViewTools::arrange(QSize picture) {
  // A low pane has no room for the last ones, which the menus have, too.
  const auto buttons = findChildren<QToolButton*>(QString(), Qt::FindDirectChildrenOnly);
  const int room = (picture.height() - 24) / (buttons.front()->sizeHint().height() + 2);
  for (int k = 0; k < buttons.size(); ++k) buttons[k]->setVisible(k < room);
  adjustSize();
  move(picture.width() - width() - 12, 12);
}

}  // namespace heft
