// CAD files in the step Shape: choosing, reading in a job, taking. Declared in shape_panel.h.
#include <QFileDialog>
#include <QFileInfo>
#include <optional>

#include "ui/controller/workspace.h"
#include "ui/shape_panel/mesh_form.h"
#include "ui/shape_panel/shape_panel.h"

namespace heft {

using Answer = ShapeChoice::Answer;

namespace {

ShapeBody meshOf(const QString& file) {
  ShapeBody body;
  body.kind = BodyKind::mesh;
  body.file = QFileInfo(file).absoluteFilePath().toStdString();
  body.unit = 0.0;  // To be guessed.
  return body;
}

}  // namespace

void ShapePanel::chooseMesh() {
  const auto opened = workspace().opened();
  const QString folder = opened ? QFileInfo(opened->path).absolutePath() : QString();
  const QString file = QFileDialog::getOpenFileName(
      this, tr("The tool’s CAD mesh"), folder,
      tr("Meshes (*.stl *.obj *.ply *.dae *.glb *.gltf *.3mf *.off *.fbx);;All files (*)"));
  if (!file.isEmpty()) useFile(file);
}

void ShapePanel::useFile(const QString& file) {
  const bool joins = choice().answer == Answer::given && !pendingMesh_ && picture() == ToolPicture::several;
  joins ? addMeshPart(file) : replaceByMesh(file);
}

void ShapePanel::addMeshPart(const QString& file) {
  const ShapeBody wanted = meshOf(file);
  meshJobs_.start(
      tr("Reading %1").arg(bodyTitle(wanted)), [wanted](const Progress&) { return loadToolMesh(wanted); },
      [this, key = wanted.file.string()](const Result<LoadedMesh>& result) {
        const std::optional<Error> problem = !result ? std::optional(result.error()) : result->unusable;
        if (problem) {
          if (!problem->cancelled) parts().say(Severity::error, QString::fromStdString(problem->message));
          return;
        }
        meshes_[key] = result->body.mesh;
        Shape next = choice().shape;
        next.bodies = bodiesWithMeshes();
        ShapeBody part = result->body;
        // Its box begins where the other parts end, in the middle.
        const auto box = extentOf(part), taken = extentOf(next);
        const double end = taken.isEmpty() ? 0.0 : taken.max().z();
        if (!box.isEmpty()) part.X_SB.pretranslate(Vector3d(-box.center().x(), -box.center().y(), end - box.min().z()));
        mode_ = ToolMode::move;
        const QString why = addPart(next, part);
        if (!why.isEmpty()) parts().say(Severity::error, why);
      });
}

void ShapePanel::replaceByMesh(const QString& file) {
  const ShapeBody wanted = meshOf(file);
  meshes_.erase(wanted.file.string());  // It may have been written anew.
  pendingMesh_ = true;
  mesh_.reset();
  meshProblem_.clear();
  takeMesh(wanted, tr("shape: %1").arg(pictureName(ToolPicture::mesh)));
}

void ShapePanel::takeMesh(const ShapeBody& wanted, const QString& text) {
  meshJobs_.start(
      tr("Reading %1").arg(bodyTitle(wanted)), [wanted](const Progress&) { return loadToolMesh(wanted); },
      [this, wanted, text](Result<LoadedMesh> result) { meshTaken(std::move(result), wanted, text); });
  refresh();
}

void ShapePanel::meshTaken(Result<LoadedMesh> result, const ShapeBody& wanted, const QString& text) {
  if (!result) {
    if (!result.error().cancelled) meshProblem_ = QString::fromStdString(result.error().message);
    built_.clear();
    return refresh();
  }
  meshes_[wanted.file.string()] = result->body.mesh;
  mesh_ = std::move(result).value();
  meshProblem_.clear();
  if (mesh_->unusable) {
    // Shown with what can be done about it; what was said before stays.
    pendingMesh_ = true;
    built_.clear();
    return refresh();
  }
  pendingMesh_ = false;
  ShapeChoice next = choice();
  next.answer = Answer::given;
  next.picture = toString(ToolPicture::mesh);
  next.shape.bodies = {mesh_->body};
  selected_ = 0;
  mode_ = ToolMode::move;
  built_.clear();
  setChoice(next, text);
}

void ShapePanel::loadMissingMesh() {
  if (choice().answer != Answer::given || pendingMesh_ || meshJobs_.running()) return;
  for (const ShapeBody& body : choice().shape.bodies) {
    if (body.kind != BodyKind::mesh) continue;
    const std::string file = body.file.string();
    const bool known = body.mesh || meshes_.count(file) > 0;
    const bool described = mesh_ && mesh_->body.file == body.file;
    if (known && (described || picture() != ToolPicture::mesh)) continue;
    if (!meshProblem_.isEmpty()) return;  // Tried already.
    ShapeBody wanted = body;
    if (!wanted.mesh && known) wanted.mesh = meshes_[file];
    // Of a session: nothing is edited, only drawn and looked at.
    meshJobs_.start(
        tr("Reading %1").arg(bodyTitle(body)), [wanted](const Progress&) { return loadToolMesh(wanted); },
        [this, file](Result<LoadedMesh> result) {
          if (result) {
            meshes_[file] = result->body.mesh;
            mesh_ = std::move(result).value();
          } else if (!result.error().cancelled) {
            meshProblem_ = QString::fromStdString(result.error().message);
            parts().say(Severity::warning, meshProblem_);
          }
          refresh();
        });
    return;
  }
}

}  // namespace heft
