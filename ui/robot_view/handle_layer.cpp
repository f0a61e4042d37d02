#include "ui/robot_view/handle_layer.h"

#include <QPainter>

#include "ui/robot_view/dimension_editor.h"
#include "ui/robot_view/viewport.h"

namespace heft {

HandleLayer::HandleLayer(Viewport* viewport, QWidget* overlay, QObject* parent)
    : QObject(parent),
      viewport_(viewport),
      overlay_(overlay),
      editor_(new DimensionEditor(
          viewport, [this] { return placed(viewport_->handleView()); },
          [this] { return handles_ ? handles_->current() : std::nullopt; })) {
  connect(editor_, &DimensionEditor::typed, this, &HandleLayer::dimensionTyped);
}

void HandleLayer::setHandles(HandleSet* handles) {
  if (handles_) disconnect(handles_, nullptr, overlay_, nullptr);
  handles_ = handles;
  viewport_->setHandles(handles);
  if (handles_) {
    handles_->setPose(viewport_->scene().X_BS);
    connect(handles_, &HandleSet::changed, overlay_, QOverload<>::of(&QWidget::update));
  }
  overlay_->update();
}

void HandleLayer::setDimensions(std::vector<DimensionLine> lines) {
  dimensions_ = std::move(lines);
  if (dimensions_.empty()) editor_->close();
  overlay_->update();
}

std::optional<QPointF> HandleLayer::knob(int id) const {
  return handles_ ? handles_->knob(id, viewport_->handleView()) : std::nullopt;
}

std::optional<QPointF> HandleLayer::dimensionLabel(int id) const {
  for (const PlacedDimension& each : placed(viewport_->handleView()))
    if (each.line->id == id) return each.label.center();
  return std::nullopt;
}

void HandleLayer::setPose(const Isometry3d& X_BS) {
  if (handles_) handles_->setPose(X_BS);
}

void HandleLayer::paint(QPainter& painter, const HandleSet::View& view) const {
  if (!dimensions_.empty()) paintDimensions(painter, placed(view));
  if (handles_) handles_->paint(painter, view);
}

std::vector<QRectF> HandleLayer::labelPlaces(const HandleSet::View& view) const {
  std::vector<QRectF> places;
  for (const PlacedDimension& each : placed(view)) places.push_back(each.label);
  return places;
}

std::vector<PlacedDimension> HandleLayer::placed(const HandleSet::View& view) const {
  return placeDimensions(dimensions_, viewport_->scene().X_BS, view);
}

}  // namespace heft
