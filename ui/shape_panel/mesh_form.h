#pragma once
// The CAD file of a tool: choosing or dropping it, its unit, and what is odd about it.
#include <QWidget>
#include <optional>

#include "ui/shape_panel/mesh_loading.h"

class QMimeData;
class QVBoxLayout;

namespace heft {

/// A mesh file among what is dragged; empty if there is none.
QString droppedMesh(const QMimeData* data);

class MeshForm : public QWidget {
  Q_OBJECT
 public:
  explicit MeshForm(QWidget* parent = nullptr);

  /// Nothing chosen yet; `problem` says why an earlier choice was not taken.
  void showNothing(const QString& problem);
  void showWorking(const QString& fileName);
  void showMesh(const LoadedMesh& mesh);

 signals:
  void chooseWanted();
  void unitPicked(double metres);
  /// Take it as a sheet with a wall, because it encloses no volume.
  void shellWanted();
  /// Begin at the sensor's face, in its middle.
  void placeWanted();

 private:
  void clear();
  void addProblem(const QString& text, const QString& remedy, bool grave);
  QVBoxLayout* column_;
};

}  // namespace heft
