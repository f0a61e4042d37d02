#pragma once
// The view's own buttons at the top right: where to look from, what is shown, a picture.
#include <QWidget>

#include "ui/robot_view/orbit_camera.h"
#include "ui/robot_view/scene_state.h"

class QMenu;

namespace heft {

class ViewTools : public QWidget {
  Q_OBJECT
 public:
  /// `parts` and `labels` say what is shown; the menu changes them.
  ViewTools(SceneParts* parts, bool* labels, QWidget* parent);
  /// In the corner of a picture of this size: as many as have room.
  void arrange(QSize picture);

 signals:
  void presetWanted(heft::ViewPreset preset);
  void partsChanged();
  void pictureWanted();

 private:
  QMenu* presetMenu(QWidget* parent);
  QMenu* partsMenu(SceneParts* parts, bool* labels, QWidget* parent);
};

}  // namespace heft
