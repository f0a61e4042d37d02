// The page of the step Shape: built anew when its parts change, else only its values. Declared in shape_panel.h.
#include <QApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/controller/workspace.h"
#include "ui/models/numbers.h"
#include "ui/robot_view/robot_view.h"
#include "ui/shape_panel/body_form.h"
#include "ui/shape_panel/mesh_form.h"
#include "ui/shape_panel/parts_list.h"
#include "ui/shape_panel/picture_card.h"
#include "ui/shape_panel/shape_panel.h"
#include "ui/shape_panel/substance_form.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/segments.h"

#include "core/math/degrees.h"

namespace heft {

using Answer = ShapeChoice::Answer;

namespace {

constexpr double kUsualWall = 0.003;  ///< [m]

}  // namespace

QString ShapePanel::structure() const {
  const ShapeChoice& now = choice();
  QStringList parts{QString::number(static_cast<int>(now.answer)), QString::number(pendingMesh_),
                    QString::number(static_cast<int>(picture())), QString::number(selected_),
                    QString::number(placeShown_)};
  if (now.answer == Answer::given && !pendingMesh_)
    for (const ShapeBody& body : now.shape.bodies) parts << QString::number(static_cast<int>(body.kind));
  return parts.join(',');
}

void ShapePanel::refresh() {
  const int count = static_cast<int>(choice().shape.bodies.size());
  selected_ = std::clamp(selected_, 0, std::max(0, count - 1));
  if (choice().answer != Answer::given && !pendingMesh_) mesh_.reset();
  if (choice().answer == Answer::given && pictureOf(choice()) != ToolPicture::mesh) meshProblem_.clear();
  if (structure() != built_) rebuild();
  showValues();
  loadMissingMesh();
  showView();
  emit stateChanged();
}

void ShapePanel::rebuild() {
  built_ = structure();
  const int position = page()->scrollPosition();
  const QWidget* focused = QApplication::focusWidget();
  const QString focusName = focused && isAncestorOf(focused) ? focused->objectName() : QString();
  bodies_.clear();
  partsList_ = nullptr;
  meshForm_ = nullptr;
  certainty_ = nullptr;
  certaintyNote_ = nullptr;
  substance_ = nullptr;
  wholeWeight_ = nullptr;
  place_ = nullptr;
  placeButton_ = nullptr;
  verdict_ = nullptr;
  QVBoxLayout* column = page()->restart(tr("What does your tool look like?"),
                                        tr("Choose the closest shape. It doesn’t have to be exact."));
  addPictures(column);
  const bool given = choice().answer == Answer::given || pendingMesh_;
  if (given) addBodies(column);
  const bool described = choice().answer == Answer::given && !pendingMesh_ && !choice().shape.bodies.empty();
  if (described) {
    verdict_ = wrappedLabel({}, "body", page()->content());
    verdict_->setObjectName("shapeVerdict");
    column->addWidget(verdict_);
    showVerdict();
    addCertainty(column);
    addSubstance(column);
    addPlace(column);
  } else if (!given) {
    column->addSpacing(6);
    column->addWidget(wrappedLabel(tr("The shape fills in the mass distribution where the motion doesn’t determine it. "
                                      "The result shows how much each value depends on it."),
                                   "answer", page()->content()));
  }
  column->addStretch(1);
  page()->setSecondButton(tr("Back"), [this] { parts().goTo(Step::mark); });
  if (pendingMesh_) {
    page()->setMainButton(
        tr("Choose a CAD file …"), [this] { chooseMesh(); }, "open");
  } else if (described) {
    page()->setMainButton(
        tr("Use this shape"), [this] { parts().goTo(Step::result); }, "check");
  } else {
    page()->setMainButton(
        choice().answer == Answer::unknown ? tr("Continue without a shape") : tr("I don’t know, continue"), [this] {
          pickUnknown();
          parts().goTo(Step::result);
        });
  }
  page()->setScrollPosition(position);
  if (!focusName.isEmpty())
    if (auto* again = findChild<QWidget*>(focusName)) again->setFocus();
}

/// What the motion says against the shape, beside the shape.
void ShapePanel::showVerdict() {
  emit stateChanged();
  if (!verdict_) return;
  QString text;
  if (const auto report = workspace().report())
    for (const Finding& finding : report->findings)
      if (finding.code == "shape_left_out" || finding.code == "shape_contradicts_data")
        text = QString::fromStdString(errorAt({}, finding.text, finding.remedy).message);
  verdict_->setText(text);
  verdict_->setVisible(!text.isEmpty());
}

void ShapePanel::addPictures(QVBoxLayout* column) {
  QWidget* content = page()->content();
  cards_.clear();
  auto* grid = new QGridLayout;
  grid->setSpacing(8);
  int place = 0;
  for (const ToolPicture each : kToolPictures) {
    auto* card = new PictureCard(each, pictureName(each), content);
    card->setObjectName(QStringLiteral("picture_") + QString::fromUtf8(toString(each).data()));
    connect(card, &QAbstractButton::clicked, this, [this, each] { pick(each); });
    grid->addWidget(card, place / 4, place % 4);
    cards_[each] = card;
    ++place;
  }
  noPicture_ = new NoPictureCard(tr("I don’t know"), tr("Use the motion only"), content);
  noPicture_->setObjectName("picture_unknown");
  connect(noPicture_, &QAbstractButton::clicked, this, &ShapePanel::pickUnknown);
  grid->addWidget(noPicture_, place / 4, place % 4, 1, 4 - place % 4);
  for (int c = 0; c < 4; ++c) grid->setColumnStretch(c, 1);
  column->addLayout(grid);
}

void ShapePanel::addBodies(QVBoxLayout* column) {
  QWidget* content = page()->content();
  const ToolPicture now = picture();
  column->addSpacing(4);
  if (now == ToolPicture::mesh) {
    meshForm_ = new MeshForm(content);
    if (pendingMesh_ && choice().answer == Answer::given)
      column->addWidget(wrappedLabel(tr("Until a file is chosen, the result uses: %1.").arg(shapeLine(choice())),
                                     "caption", content));
    connect(meshForm_, &MeshForm::chooseWanted, this, &ShapePanel::chooseMesh);
    connect(meshForm_, &MeshForm::unitPicked, this, [this](double unit) {
      if (!mesh_) return;
      ShapeBody wanted = pendingMesh_ || choice().shape.bodies.empty() ? mesh_->body : choice().shape.bodies[0];
      wanted.unit = unit;
      takeMesh(wanted, tr("unit of the mesh"));
    });
    connect(meshForm_, &MeshForm::shellWanted, this, [this] {
      if (!mesh_) return;
      ShapeBody wanted = mesh_->body;
      wanted.wall = 0.002;
      takeMesh(wanted, tr("thin shell"));
    });
    connect(meshForm_, &MeshForm::placeWanted, this, [this] {
      const Shape& shape = choice().shape;
      const auto box = extentOf(shape);
      if (box.isEmpty()) return;
      const Vector3d to(-box.center().x(), -box.center().y(), -box.min().z());
      change(shifted(shape, kWholeTool, to), tr("move the tool"), 0);
    });
    column->addWidget(meshForm_);
    return;
  }
  const auto& bodies = choice().shape.bodies;
  const auto addForm = [&](const QString& title, int index) {
    auto* form = new BodyForm(title, bodies[static_cast<std::size_t>(index)], index, content);
    connect(form, &BodyForm::begun, this, [this] { editKey_ = workspace().newMergeKey(); });
    connect(form, &BodyForm::changed, this,
            [this, index](int measure, double metres) { setLength(index, measure, metres); });
    column->addWidget(form);
    bodies_[index] = form;
  };
  if (now == ToolPicture::gripper) {
    addForm(tr("Body"), 0);
    addForm(tr("Fingers"), 1);
  } else if (now == ToolPicture::several) {
    column->addWidget(styledLabel(tr("Parts joined to each other"), "sectionTitle", content));
    partsList_ = new PartsList(content);
    connect(partsList_, &PartsList::picked, this, &ShapePanel::select);
    connect(partsList_, &PartsList::removeWanted, this, [this](int index) {
      Shape next = choice().shape;
      if (next.bodies.size() < 2) return;
      next.bodies.erase(next.bodies.begin() + index);
      if (selected_ > 0 && selected_ >= index) --selected_;
      change(next, tr("remove a part"), 0);
    });
    connect(partsList_, &PartsList::addWanted, this,
            [this](BodyKind kind) { addPart(choice().shape, nextBody(kind, choice().shape)); });
    connect(partsList_, &PartsList::addMeshWanted, this, &ShapePanel::chooseMesh);
    column->addWidget(partsList_);
    if (bodies[static_cast<std::size_t>(selected_)].kind != BodyKind::mesh)
      addForm(tr("Size of part %1").arg(selected_ + 1), selected_);
  } else {
    addForm(tr("Size"), 0);
  }
}

void ShapePanel::addCertainty(QVBoxLayout* column) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  column->addWidget(styledLabel(tr("How sure are you of these sizes?"), "sectionTitle", content));
  certainty_ = new Segments({tr("Rough"), tr("Good"), tr("Exact")}, {"sureRough", "sureGood", "sureExact"}, content);
  connect(certainty_, &Segments::picked, this, [this](int index) {
    Shape next = choice().shape;
    next.certainty = static_cast<Certainty>(index);
    if (next.certainty != choice().shape.certainty) change(next, tr("how sure the sizes are"), 0);
  });
  column->addWidget(certainty_);
  certaintyNote_ = wrappedLabel({}, "caption", content);
  column->addWidget(certaintyNote_);
}

void ShapePanel::addSubstance(QVBoxLayout* column) {
  QWidget* content = page()->content();
  const bool several = picture() == ToolPicture::several;
  column->addSpacing(2);
  if (several) column->addWidget(styledLabel(tr("Part %1, if known").arg(selected_ + 1), "sectionTitle", content));
  const ShapeBody& body = choice().shape.bodies[several ? static_cast<std::size_t>(selected_) : 0];
  substance_ = new SubstanceForm(body, several, content);
  connect(substance_, &SubstanceForm::begun, this, [this] { editKey_ = workspace().newMergeKey(); });
  connect(substance_, &SubstanceForm::weightChanged, this, [this, several](std::optional<double> mass) {
    Shape next = choice().shape;
    if (several) {
      ShapeBody& part = next.bodies[static_cast<std::size_t>(selected_)];
      part.mass = mass;
      if (mass) part.density.reset();
    } else {
      next.totalMass = mass;
    }
    substance_->setWeightProblem(change(next, tr("weight"), 0));
  });
  connect(substance_, &SubstanceForm::hollowChanged, this, [this, several](bool hollow) {
    if (!hollow) return setWall(std::nullopt, tr("solid"), 0);
    const ShapeBody& now = choice().shape.bodies[several ? static_cast<std::size_t>(selected_) : 0];
    if (now.wall) return;
    double wall = kUsualWall;
    for (const ShapeBody& each : choice().shape.bodies)
      if (const auto limit = wallLimit(each)) wall = std::min(wall, 0.4 * *limit);
    setWall(std::max(1e-4, std::round(wall * 1e4) / 1e4), tr("hollow"), 0);
  });
  connect(substance_, &SubstanceForm::wallChanged, this,
          [this](double wall) { setWall(wall, tr("wall thickness"), editKey_); });
  connect(substance_, &SubstanceForm::materialChanged, this, &ShapePanel::setMaterial);
  column->addWidget(substance_);
  if (!several) return;
  column->addWidget(styledLabel(tr("Total weight, from a scale"), "caption", content));
  wholeWeight_ = new WeightField(tr("Total weight"), "weight", tr("not weighed"), content);
  QLabel* error = makeFieldError(content);
  connect(wholeWeight_, &WeightField::refused, error, [error](const QString& why) { showFieldError(error, why); });
  connect(wholeWeight_, &WeightField::changed, this, [this, error](std::optional<double> mass) {
    Shape next = choice().shape;
    next.totalMass = mass;
    const QString why = change(next, tr("weight"), 0);
    wholeWeight_->setWrong(!why.isEmpty());
    showFieldError(error, why);
  });
  column->addWidget(wholeWeight_);
  column->addWidget(error);
}

void ShapePanel::addPlace(QVBoxLayout* column) {
  QWidget* content = page()->content();
  placeButton_ = new QPushButton(content);
  placeButton_->setObjectName("placeButton");
  placeButton_->setProperty("role", "link");
  connect(placeButton_, &QPushButton::clicked, this, [this] {
    placeShown_ = !placeShown_;
    refresh();
  });
  column->addWidget(placeButton_);
  if (!placeShown_) return;
  place_ = new PlaceForm(content);
  connect(place_, &PlaceForm::begun, this, [this] { editKey_ = workspace().newMergeKey(); });
  connect(place_, &PlaceForm::moved, this, [this](const Vector3d& to) {
    const Shape& shape = choice().shape;
    const ShapeBody& first = shape.bodies[static_cast<std::size_t>(std::max(0, movedNow()))];
    change(shifted(shape, movedNow(), to - nearEnd(first)), tr("move the tool"), editKey_);
  });
  connect(place_, &PlaceForm::tilted, this, [this](const Vector3d& rpy) {
    const Shape& shape = choice().shape;
    const ShapeBody& first = shape.bodies[static_cast<std::size_t>(std::max(0, movedNow()))];
    change(turned(shape, movedNow(), rotationFromRpy(rpy) * first.X_SB.linear().transpose()), tr("tilt the tool"),
           editKey_);
  });
  column->addWidget(place_);
}

void ShapePanel::showValues() {
  const ShapeChoice& now = choice();
  const bool given = now.answer == Answer::given || pendingMesh_;
  for (const auto& [each, card] : cards_) card->setChecked(given && each == picture());
  noPicture_->setChecked(now.answer == Answer::unknown && !pendingMesh_);
  if (meshForm_) {
    const QString reading = meshJobs_.running() ? meshJobs_.title() : QString();
    if (mesh_ && (pendingMesh_ || mesh_->body.file == now.shape.bodies.front().file)) {
      LoadedMesh shown = *mesh_;
      if (!pendingMesh_) shown.body = now.shape.bodies.front();
      shown.unitGuessed = shown.unitGuessed && shown.body.unit == mesh_->body.unit;
      meshForm_->showMesh(shown);
    } else if (!reading.isEmpty()) {
      meshForm_->showWorking(reading);
    } else {
      meshForm_->showNothing(meshProblem_);
    }
  }
  if (now.answer != Answer::given || pendingMesh_ || now.shape.bodies.empty()) return;
  const Shape& shape = now.shape;
  for (const auto& [index, form] : bodies_)
    if (index < static_cast<int>(shape.bodies.size())) form->showBody(shape.bodies[static_cast<std::size_t>(index)]);
  if (partsList_) partsList_->showParts(shape, selected_);
  const bool several = picture() == ToolPicture::several;
  const ShapeBody& body = shape.bodies[several ? static_cast<std::size_t>(selected_) : 0];
  if (certainty_) {
    certainty_->setChosen(static_cast<int>(shape.certainty));
    certaintyNote_->setText(certaintyNote(shape.certainty, body.kind == BodyKind::mesh));
  }
  if (substance_) {
    ShapeBody shown = body;
    // Of a gripper both boxes are of one stuff; the note counts them together.
    substance_->showSubstance(shown, several ? body.mass : shape.totalMass);
  }
  if (wholeWeight_) wholeWeight_->showWeight(shape.totalMass);
  const ShapeBody& moved = shape.bodies[static_cast<std::size_t>(std::max(0, movedNow()))];
  const Vector3d at = nearEnd(moved), rpy = rpyFromRotation(moved.X_SB.linear());
  if (place_) place_->showPlace(at, rpy);
  if (placeButton_) {
    const bool usual = at.norm() < 5e-5 && rpy.norm() < 1e-3;
    const auto number = [](double value) {
      return numberText(value, std::abs(value - std::round(value)) < 0.05 ? 0 : 1);
    };
    QString where =
        usual ? tr("Position: centred on the sensor, not tilted")
              : tr("Position: %1, %2, %3 mm").arg(number(1e3 * at.x()), number(1e3 * at.y()), number(1e3 * at.z()));
    if (rpy.norm() >= 1e-3)
      where += tr(", tilted by %1°").arg(number(vectorFromRotation(moved.X_SB.linear()).norm() / kRadPerDegree));
    placeButton_->setText((placeShown_ ? QString::fromUtf8("▾  ") : QString::fromUtf8("▸  ")) + where);
    placeButton_->setAccessibleName(where);
  }
}

std::vector<ShapeBody> ShapePanel::bodiesWithMeshes() const {
  std::vector<ShapeBody> bodies = choice().shape.bodies;
  for (ShapeBody& body : bodies) {
    if (body.kind != BodyKind::mesh || body.mesh) continue;
    const auto found = meshes_.find(body.file.string());
    if (found != meshes_.end()) body.mesh = found->second;
  }
  return bodies;
}

void ShapePanel::showView() {
  if (!parts().view) return;
  const bool given = choice().answer == Answer::given && !pendingMesh_;
  const bool editing = here_ && given;
  parts().view->showTool(given ? bodiesWithMeshes() : std::vector<ShapeBody>{},
                         editing && picture() == ToolPicture::several ? selected_ : -1);
  if (!here_) return;
  if (mode_ == ToolMode::size && given && picture() == ToolPicture::mesh) mode_ = ToolMode::move;
  modes_->button(0)->setEnabled(picture() != ToolPicture::mesh);
  modes_->setChosen(static_cast<int>(mode_));
  parts().view->note().setTools(given ? modes_ : nullptr);
  parts().view->note().setText(!given                    ? tr("Choose a shape to place it here")
                               : mode_ == ToolMode::size ? tr("Drag a white handle to change the size")
                               : mode_ == ToolMode::move
                                   ? tr("Drag an arrow to move along an axis, the centre to move freely")
                                   : tr("Drag a ring to tilt the tool"));
  if (given) {
    Shape shown = choice().shape;
    shown.bodies = bodiesWithMeshes();
    handles_.setHandles(toolHandles(shown, picture(), selected_, mode_));
  } else {
    handles_.setHandles({});
  }
  parts().view->handles().setHandles(&handles_);
  showHandles();
}

void ShapePanel::showHandles() {
  if (!here_ || !parts().view) return;
  const bool given = choice().answer == Answer::given && !pendingMesh_;
  const auto current = handles_.current();
  parts().view->handles().setDimensions(given && mode_ == ToolMode::size
                                            ? toolDimensions(choice().shape, picture(), selected_, current)
                                            : std::vector<DimensionLine>{});
  for (const auto& [index, form] : bodies_) {
    const bool ofThis = current && mode_ == ToolMode::size && bodyOfHandle(*current) == index && !choosesBody(*current);
    form->setStrong(ofThis ? *current % 32 : -1);
  }
}

}  // namespace heft
