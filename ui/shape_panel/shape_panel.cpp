#include "ui/shape_panel/shape_panel.h"

#include <QAction>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QUndoStack>
#include <algorithm>

#include "ui/controller/workspace.h"
#include "ui/robot_view/robot_view.h"
#include "ui/shape_panel/body_form.h"
#include "ui/shape_panel/mesh_form.h"
#include "ui/shape_panel/substance_form.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/stepper.h"

namespace heft {

using Answer = ShapeChoice::Answer;

ShapePanel::ShapePanel(const StudioParts& parts) : StepPanel(parts), handles_(HandleSet::Frame::sensor) {
  setAcceptDrops(true);
  parts.followJobs(&meshJobs_);
  connect(&workspace(), &Workspace::shapeChanged, this, &ShapePanel::refresh);
  connect(&workspace(), &Workspace::openedChanged, this, &ShapePanel::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &ShapePanel::showVerdict);
  connect(&handles_, &HandleSet::grabbed, this, [this](int id) {
    if (choosesBody(id)) return select(bodyOfHandle(id));
    dragStart_ = choice().shape;
    dragApplied_ = false;
    editKey_ = workspace().newMergeKey();
  });
  connect(&handles_, &HandleSet::dragged, this, &ShapePanel::dragHandle);
  connect(&handles_, &HandleSet::cancelled, this, [this] {
    if (dragApplied_) workspace().undoStack()->undo();
    dragApplied_ = false;
  });
  connect(&handles_, &HandleSet::changed, this, &ShapePanel::showHandles);
  if (parts.view) {
    modes_ = new Segments({tr("Size"), tr("Move"), tr("Tilt")}, {"modeSize", "modeMove", "modeTurn"}, parts.view);
    modes_->hide();
    modes_->setChosen(0);
    connect(modes_, &Segments::picked, this, [this](int index) { setMode(static_cast<ToolMode>(index)); });
    parts.view->installEventFilter(this);
    connect(&parts.view->handles(), &HandleLayer::dimensionTyped, this, &ShapePanel::typeLength);
  }
  refresh();
}

ShapePanel::~ShapePanel() = default;

const ShapeChoice& ShapePanel::choice() const { return workspace().session().shape; }

ToolPicture ShapePanel::picture() const { return pendingMesh_ ? ToolPicture::mesh : pictureOf(choice()); }

StepState ShapePanel::state() const {
  using P = StepState::Progress;
  const ShapeChoice& now = choice();
  const auto opened = workspace().opened();
  const auto report = workspace().report();
  const auto said = [&](const char* code) {
    return report && std::any_of(report->findings.begin(), report->findings.end(),
                                 [&](const Finding& finding) { return finding.code == code; });
  };
  if (pendingMesh_) return {P::ready, Light::look, tr("choose a CAD file")};
  switch (now.answer) {
    case Answer::notGiven:
      return {opened ? P::ready : P::later, Light::measured, shapeLine(now)};
    case Answer::unknown:
      return {P::done, Light::unknown, shapeLine(now)};
    case Answer::given:
      break;
  }
  if (said("shape_left_out")) return {P::done, Light::look, tr("contradicts the data, left out")};
  const bool fits = shapeProblem(now.shape).isEmpty() && !said("shape_contradicts_data");
  return {P::done, fits ? Light::measured : Light::look, shapeLine(now)};
}

QString ShapePanel::hint() const { return tr("Lengths in mm from the sensor’s tool side · Ctrl+Z to undo"); }

void ShapePanel::entered() {
  here_ = true;
  if (parts().view) {
    parts().view->setAcceptDrops(true);
    parts().view->setToolEditing(true);
  }
  showView();
}

void ShapePanel::left() {
  here_ = false;
  if (!parts().view) return;
  handles_.cancel();
  parts().view->handles().setHandles(nullptr);
  parts().view->handles().setDimensions({});
  parts().view->note().setTools(nullptr);
  parts().view->note().setText({});
  parts().view->setAcceptDrops(false);
  showView();
  parts().view->setToolEditing(false);
}

bool ShapePanel::keyPressed(QKeyEvent* event) {
  if (choice().answer != Answer::given || event->modifiers() != Qt::NoModifier) return false;
  switch (event->key()) {
    case Qt::Key_S:
      return setMode(ToolMode::size), true;
    case Qt::Key_M:
      return setMode(ToolMode::move), true;
    case Qt::Key_R:
      return setMode(ToolMode::turn), true;
    default:
      return false;
  }
}

void ShapePanel::addActions(const StudioMenus& menus) {
  menus.tools->addAction(tr("Tool from a CA&D mesh …"), this, [this] {
    parts().goTo(Step::shape);
    chooseMesh();
  });
}

bool ShapePanel::eventFilter(QObject* watched, QEvent* event) {
  if (here_ && watched == parts().view) {
    if (event->type() == QEvent::DragEnter || event->type() == QEvent::DragMove) {
      auto* drag = static_cast<QDragMoveEvent*>(event);
      if (!droppedMesh(drag->mimeData()).isEmpty()) {
        drag->acceptProposedAction();
        return true;
      }
    } else if (event->type() == QEvent::Drop) {
      auto* drop = static_cast<QDropEvent*>(event);
      if (const QString file = droppedMesh(drop->mimeData()); !file.isEmpty()) {
        drop->acceptProposedAction();
        useFile(file);
        return true;
      }
    }
  }
  return StepPanel::eventFilter(watched, event);
}

void ShapePanel::dragEnterEvent(QDragEnterEvent* event) {
  if (!droppedMesh(event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void ShapePanel::dropEvent(QDropEvent* event) {
  const QString file = droppedMesh(event->mimeData());
  if (file.isEmpty()) return;
  event->acceptProposedAction();
  useFile(file);
}

// ---- edits

void ShapePanel::setChoice(const ShapeChoice& next, const QString& text, int key) {
  workspace().setShape(next, text, key);
}

void ShapePanel::pick(ToolPicture wanted) {
  const bool given = choice().answer == Answer::given && !pendingMesh_;
  if (given && wanted == picture()) return refresh();
  pendingMesh_ = false;
  ShapeChoice next = choice();
  // Said before, and taken back with "I don't know": taken up again as it was.
  const bool kept = !choice().shape.bodies.empty() && pictureOf(choice()) == wanted && !given;
  if (wanted == ToolPicture::mesh && !kept) {
    pendingMesh_ = true;
    return refresh();
  }
  next.answer = Answer::given;
  next.picture = toString(wanted);
  if (given) sketched_[picture()] = next.shape.bodies;
  if (!kept) {
    // Several bodies begin with those that are there. Else each picture has its own sizes: those of another one are of
    // another form.
    const bool begins = wanted == ToolPicture::several && given && picture() != ToolPicture::mesh;
    const auto before = sketched_.find(wanted);
    if (!begins && before != sketched_.end()) {
      next.shape.bodies = before->second;
    } else if (!begins) {
      Isometry3d place = Isometry3d::Identity();
      if (given && !next.shape.bodies.empty() && picture() != ToolPicture::mesh) {
        place.linear() = next.shape.bodies.front().X_SB.linear();
        place.translation() = nearEnd(next.shape.bodies.front());
      }
      next.shape.bodies = sketch(wanted);
      for (ShapeBody& body : next.shape.bodies) body.X_SB = place * body.X_SB;
    }
    selected_ = 0;
    mode_ = ToolMode::size;
    // Weight and material were of another size.
    if (!shapeProblem(next.shape).isEmpty())
      for (ShapeBody& body : next.shape.bodies) body.density.reset();
  }
  setChoice(next, tr("shape: %1").arg(pictureName(wanted)));
}

void ShapePanel::pickUnknown() {
  pendingMesh_ = false;
  if (choice().answer == Answer::unknown) return refresh();
  ShapeChoice next = choice();
  next.answer = Answer::unknown;
  setChoice(next, tr("shape not known"));
}

QString ShapePanel::change(Shape next, const QString& text, int key) {
  if (QString why = shapeProblem(next); !why.isEmpty()) return why;
  ShapeChoice edited = choice();
  edited.shape = std::move(next);
  setChoice(edited, text, key);
  return {};
}

QString ShapePanel::addPart(Shape shape, const ShapeBody& part) {
  shape.bodies.push_back(part);
  selected_ = static_cast<int>(shape.bodies.size()) - 1;
  return change(std::move(shape), tr("add a part"), 0);
}

void ShapePanel::setLength(int body, int measure, double metres) {
  const Shape next =
      resized(choice().shape, picture(), static_cast<std::size_t>(body), static_cast<std::size_t>(measure), metres);
  const QString why = change(next, tr("change a length"), editKey_);
  if (!why.isEmpty() && bodies_.count(body)) bodies_[body]->setProblem(measure, why);
}

void ShapePanel::typeLength(int handle, const QString& text) {
  const int measure = measureOfHandle(handle), body = bodyOfHandle(handle);
  if (!here_ || measure < 0 || body >= static_cast<int>(choice().shape.bodies.size())) return;
  const auto millimetres = parseMeasure(text, QStringLiteral("mm"));
  if (!millimetres || *millimetres < kLeastLength || *millimetres > kMostLength) {
    return parts().say(Severity::warning, tr("“%1” is not a valid length. Enter a number from %2 to %3 mm.")
                                              .arg(text)
                                              .arg(kLeastLength)
                                              .arg(kMostLength));
  }
  editKey_ = workspace().newMergeKey();
  setLength(body, measure, 1e-3 * *millimetres);
}

void ShapePanel::setWall(std::optional<double> wall, const QString& text, int key) {
  Shape next = choice().shape;
  for (std::size_t b = 0; b < next.bodies.size(); ++b) {
    ShapeBody& body = next.bodies[b];
    if (picture() == ToolPicture::several && static_cast<int>(b) != selected_) continue;
    if (body.kind != BodyKind::tube) body.wall = wall;
  }
  if (picture() == ToolPicture::mesh && wall.has_value() != choice().shape.bodies[0].wall.has_value())
    return takeMesh(next.bodies[0], text);
  const QString why = change(next, text, key);
  if (!why.isEmpty() && substance_) substance_->setWallProblem(why);
}

void ShapePanel::setMaterial(std::optional<double> density) {
  Shape next = choice().shape;
  for (std::size_t b = 0; b < next.bodies.size(); ++b) {
    if (picture() == ToolPicture::several && static_cast<int>(b) != selected_) continue;
    next.bodies[b].density = density;
    if (density) next.bodies[b].mass.reset();
  }
  const QString why = change(next, tr("material"), 0);
  if (why.isEmpty() || !substance_) return;
  showValues();
  substance_->setWeightProblem(why);
}

void ShapePanel::setMode(ToolMode mode) {
  mode_ = mode;
  handles_.cancel();
  showView();
}

void ShapePanel::select(int body) {
  if (body == selected_) return;
  selected_ = body;
  // Not while a handle of the page being replaced is handling a press.
  QTimer::singleShot(0, this, &ShapePanel::refresh);
}

void ShapePanel::dragHandle(const HandleDrag& drag) {
  if (choosesBody(drag.handle.id)) return;
  const Shape next = dragTool(dragStart_, picture(), selected_, drag);
  // What cannot be (a hole wider than its tube) stops the drag where it still can.
  if (!shapeProblem(next).isEmpty()) return;
  ShapeChoice edited = choice();
  edited.shape = next;
  dragApplied_ = true;
  setChoice(edited,
            mode_ == ToolMode::size   ? tr("change a length")
            : mode_ == ToolMode::move ? tr("move the tool")
                                      : tr("tilt the tool"),
            editKey_);
}

// ---- scripts

ScriptForms ShapePanel::scriptForms() {
  return {{"shape PICTURE [SIZES] [at X,Y,Z] ... [wall MM] [weighs KG] [of MATERIAL] [CERTAINTY]",
           "shape box 60x40x120 at 0,0,60; steel, aluminium, plastic, wood; rough, good, exact"},
          {"shape mesh FILE [mm] | shape unknown", ""},
          {"handles size|move|tilt", "what dragging the tool in the 3D view does"}};
}

std::optional<Result<bool>> ShapePanel::obey(const QStringList& words) {
  if (words[0] == "handles") {
    const QStringList names{"size", "move", "tilt"};
    if (words.size() != 2 || !names.contains(words[1])) return std::nullopt;
    setMode(static_cast<ToolMode>(names.indexOf(words[1])));
    return Result<bool>(true);
  }
  if (words[0] != "shape") return std::nullopt;
  if (words.size() == 2 && words[1] == "unknown") {
    pickUnknown();
    return Result<bool>(true);
  }
  auto next = shapeFromWords(words.mid(1), choice());
  if (!next) return Result<bool>(next.error());
  pendingMesh_ = false;
  selected_ = 0;
  if (next->picture == "mesh") {
    auto loaded = loadToolMesh(next->shape.bodies[0]);
    if (!loaded) return Result<bool>(loaded.error());
    if (loaded->unusable) return Result<bool>(*loaded->unusable);
    const ShapeBody wanted = next->shape.bodies[0];
    meshes_[wanted.file.string()] = loaded->body.mesh;
    next->shape.bodies[0] = loaded->body;
    mesh_ = std::move(loaded).value();
    mode_ = ToolMode::move;
  }
  setChoice(*next, tr("shape: %1").arg(pictureName(pictureOf(*next))));
  return Result<bool>(true);
}

}  // namespace heft
