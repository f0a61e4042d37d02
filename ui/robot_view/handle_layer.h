#pragma once
// What can be grabbed in the 3D picture, and lengths that can be typed there, painted over it.
#include <QObject>
#include <QPointF>
#include <QPointer>
#include <optional>
#include <vector>

#include "ui/robot_view/dimension_lines.h"
#include "ui/robot_view/handles.h"

namespace heft {

class DimensionEditor;
class Viewport;

class HandleLayer : public QObject {
  Q_OBJECT
 public:
  /// `overlay`: painted anew with each change.
  HandleLayer(Viewport* viewport, QWidget* overlay, QObject* parent);

  /// What the shown step lets one grab; null for nothing. Taken out again by the step that put it in.
  void setHandles(HandleSet* handles);
  void setDimensions(std::vector<DimensionLine> lines);
  /// Where a handle's knob is, pixels of the viewport; for tests.
  std::optional<QPointF> knob(int id) const;
  /// Where the label of a handle's dimension is, pixels of the viewport; for tests.
  std::optional<QPointF> dimensionLabel(int id) const;

  // For the view.
  void setPose(const Isometry3d& X_BS);
  void paint(QPainter& painter, const HandleSet::View& view) const;
  /// The labels of the lengths [px].
  std::vector<QRectF> labelPlaces(const HandleSet::View& view) const;

 signals:
  /// A length was typed where it stands in the picture: its handle's id, and what was typed.
  void dimensionTyped(int id, const QString& text);

 private:
  std::vector<PlacedDimension> placed(const HandleSet::View& view) const;

  Viewport* viewport_;
  QWidget* overlay_;
  QPointer<HandleSet> handles_;
  std::vector<DimensionLine> dimensions_;
  DimensionEditor* editor_;
};

}  // namespace heft
