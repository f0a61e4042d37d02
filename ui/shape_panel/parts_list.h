#pragma once
// The bodies that a tool is joined of: choose one, take one away, add one.
#include <QWidget>

#include "core/payload/tool_sketch.h"

class QVBoxLayout;

namespace heft {

class PartsList : public QWidget {
  Q_OBJECT
 public:
  explicit PartsList(QWidget* parent = nullptr);
  void showParts(const Shape& shape, int selected);

 signals:
  void picked(int index);
  void removeWanted(int index);
  void addWanted(heft::BodyKind kind);
  /// A CAD mesh, whose file is still to be chosen.
  void addMeshWanted();

 private:
  QVBoxLayout* rows_;
};

}  // namespace heft
