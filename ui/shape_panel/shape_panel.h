#pragma once
// The step Shape: "What does your tool look like?" A picture, a few lengths, how sure one is; the tool stands on the
// arm at once, with handles.
#include <map>
#include <string>

#include "core/workspace/session.h"
#include "ui/jobs/job_runner.h"
#include "ui/shape_panel/mesh_loading.h"
#include "ui/shape_panel/shape_text.h"
#include "ui/shape_panel/tool_handles.h"
#include "ui/steps/step_panel.h"

class QLabel;
class QPushButton;

namespace heft {

class BodyForm;
class MeshForm;
class PartsList;
class PictureCard;
class NoPictureCard;
class PlaceForm;
class Segments;
class SubstanceForm;
class WeightField;

class ShapePanel : public StepPanel {
  Q_OBJECT
 public:
  explicit ShapePanel(const StudioParts& parts);
  ~ShapePanel() override;

  Step step() const override { return Step::shape; }
  StepState state() const override;
  void entered() override;
  void left() override;
  Below below() const override { return Below::marksOnly; }
  double viewShare() const override { return 0.82; }
  QString hint() const override;
  bool keyPressed(QKeyEvent* event) override;
  void addActions(const StudioMenus& menus) override;
  static ScriptForms scriptForms();
  std::optional<Result<bool>> obey(const QStringList& words) override;

  /// Several bodies: joins a CAD file to them, at their end.
  void addMeshPart(const QString& file);
  /// For tests: what can be grabbed in the 3D view.
  HandleSet* handles() { return &handles_; }

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  const ShapeChoice& choice() const;
  ToolPicture picture() const;
  int movedNow() const { return movedBody(picture(), selected_); }

  // The page.
  void refresh();
  void rebuild();
  QString structure() const;
  void showVerdict();
  void addPictures(QVBoxLayout* column);
  void addBodies(QVBoxLayout* column);
  void addCertainty(QVBoxLayout* column);
  void addSubstance(QVBoxLayout* column);
  void addPlace(QVBoxLayout* column);
  void showValues();
  void showView();
  void showHandles();

  // Edits.
  void pick(ToolPicture picture);
  void pickUnknown();
  /// Puts the shape in place if it can be; else says why not and changes nothing.
  QString change(Shape next, const QString& text, int key);
  /// Chooses it, too. Why not, where it cannot be.
  QString addPart(Shape shape, const ShapeBody& part);
  void setChoice(const ShapeChoice& next, const QString& text, int key = 0);
  void setLength(int body, int measure, double metres);
  /// A length that was typed in the 3D view.
  void typeLength(int handle, const QString& text);
  void setWall(std::optional<double> wall, const QString& text, int key);
  void setMaterial(std::optional<double> density);
  void setMode(ToolMode mode);
  void select(int body);
  void dragHandle(const HandleDrag& drag);

  // CAD meshes.
  void chooseMesh();
  /// Reads, tries and takes it; a unit of 0 is guessed.
  void takeMesh(const ShapeBody& wanted, const QString& text);
  void meshTaken(Result<LoadedMesh> result, const ShapeBody& wanted, const QString& text);
  void loadMissingMesh();
  void useFile(const QString& file);
  void replaceByMesh(const QString& file);
  std::vector<ShapeBody> bodiesWithMeshes() const;

  HandleSet handles_;
  JobRunner meshJobs_;
  std::map<std::string, std::shared_ptr<const Mesh>> meshes_;  ///< By file.
  std::optional<LoadedMesh> mesh_;                             ///< The last one tried.
  QString meshProblem_;
  std::map<ToolPicture, std::vector<ShapeBody>> sketched_;  ///< As each picture was left, to come back to
  QLabel* verdict_ = nullptr;
  bool pendingMesh_ = false;  ///< The picture of a mesh is picked, but no file taken yet.
  bool here_ = false, placeShown_ = false;
  ToolMode mode_ = ToolMode::size;
  int selected_ = 0;
  int editKey_ = 0;
  Shape dragStart_;
  bool dragApplied_ = false;

  QString built_;  ///< structure() that the page was built for.
  std::map<ToolPicture, PictureCard*> cards_;
  NoPictureCard* noPicture_ = nullptr;
  std::map<int, BodyForm*> bodies_;
  PartsList* partsList_ = nullptr;
  MeshForm* meshForm_ = nullptr;
  Segments* certainty_ = nullptr;
  QLabel* certaintyNote_ = nullptr;
  SubstanceForm* substance_ = nullptr;
  WeightField* wholeWeight_ = nullptr;
  PlaceForm* place_ = nullptr;
  QPushButton* placeButton_ = nullptr;
  Segments* modes_ = nullptr;  ///< Size, move, turn: stands in the 3D view.
};

}  // namespace heft
