#include "ui/shape_panel/mesh_form.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QMimeData>
#include <QPushButton>
#include <QUrl>
#include <QVBoxLayout>

#include "core/payload/tool_sketch.h"
#include "ui/models/numbers.h"
#include "ui/shape_panel/shape_text.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/segments.h"

namespace heft {
namespace {

constexpr double kUnits[] = {0.001, 0.01, 1.0, 0.0254};

int unitIndex(double unit) {
  for (int i = 0; i < 4; ++i)
    if (std::abs(kUnits[i] - unit) < 1e-9) return i;
  return -1;
}

QString unitName(int index) {
  switch (index) {
    case 0:
      return MeshForm::tr("millimetres");
    case 1:
      return MeshForm::tr("centimetres");
    case 2:
      return MeshForm::tr("metres");
    default:
      return MeshForm::tr("inches");
  }
}

}  // namespace

QString droppedMesh(const QMimeData* data) {
  static const QStringList endings{"stl", "obj", "ply", "dae", "glb", "gltf", "3mf", "off", "fbx", "x3d"};
  for (const QUrl& url : data->urls())
    if (url.isLocalFile() && endings.contains(QFileInfo(url.toLocalFile()).suffix().toLower()))
      return url.toLocalFile();
  return {};
}

MeshForm::MeshForm(QWidget* parent) : QWidget(parent) {
  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(8);
}

void MeshForm::clear() {
  const auto forget = [](QLayout* layout, const auto& self) -> void {
    while (QLayoutItem* item = layout->takeAt(0)) {
      if (item->layout()) self(item->layout(), self);
      if (item->widget()) {
        item->widget()->hide();
        item->widget()->deleteLater();
      }
      delete item;
    }
  };
  forget(column_, forget);
}

void MeshForm::addProblem(const QString& text, const QString& remedy, bool grave) {
  const Card card = makeCard(grave ? "cardBad" : "cardLook", this);
  card.layout->addWidget(wrappedLabel(text, "body", this));
  if (!remedy.isEmpty()) card.layout->addWidget(wrappedLabel(remedy, "caption", this));
  column_->addWidget(card.frame);
}

void MeshForm::showNothing(const QString& problem) {
  clear();
  if (!problem.isEmpty()) addProblem(problem, {}, true);
  column_->addWidget(wrappedLabel(
      tr("Drop the file here, or choose it. Closed solids work best (STL, OBJ, PLY, DAE, glTF)."), "answer", this));
  auto* choose = new QPushButton(tr("Choose a file …"), this);
  choose->setObjectName("chooseMesh");
  connect(choose, &QPushButton::clicked, this, &MeshForm::chooseWanted);
  column_->addWidget(choose);
}

void MeshForm::showWorking(const QString& fileName) {
  clear();
  column_->addWidget(wrappedLabel(tr("Reading %1 …").arg(fileName), "answer", this));
}

void MeshForm::showMesh(const LoadedMesh& mesh) {
  clear();
  const QString name = bodyTitle(mesh.body);
  auto* head = new QHBoxLayout;
  QLabel* title = styledLabel(name, "sectionTitle", this);
  title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  title->setToolTip(QString::fromStdString(mesh.body.file.string()));
  head->addWidget(title, 1);
  auto* other = new QPushButton(tr("Another file …"), this);
  other->setObjectName("linkButton");
  connect(other, &QPushButton::clicked, this, &MeshForm::chooseWanted);
  head->addWidget(other);
  column_->addLayout(head);

  column_->addWidget(styledLabel(tr("Unit of the file"), "caption", this));
  auto* units =
      new Segments({tr("mm"), tr("cm"), tr("m"), tr("inch")}, {"unit_mm", "unit_cm", "unit_m", "unit_in"}, this);
  const int index = unitIndex(mesh.body.unit);
  units->setChosen(index);
  connect(units, &Segments::picked, this, [this](int i) { emit unitPicked(kUnits[i]); });
  column_->addWidget(units);
  const double longest = mesh.longest * mesh.body.unit;
  const QString size =
      longest < 1.0 ? tr("%1 cm").arg(numberText(100 * longest, 1)) : tr("%1 m").arg(numberText(longest, 2));
  column_->addWidget(wrappedLabel(mesh.unitGuessed ? tr("The longest side is %1 in the file. Assuming %2, that is %3.")
                                                         .arg(numberText(mesh.longest, mesh.longest < 10     ? 3
                                                                                       : mesh.longest < 1000 ? 1
                                                                                                             : 0),
                                                              unitName(index), size)
                                                   : tr("The longest side is then %1.").arg(size),
                                  "caption", this));
  if (mesh.unusable) {
    addProblem(QString::fromStdString(mesh.unusable->message), {}, true);
    if (!mesh.body.wall) {
      auto* shell = new QPushButton(tr("Treat it as a thin shell of 2 mm"), this);
      shell->setObjectName("meshShell");
      connect(shell, &QPushButton::clicked, this, &MeshForm::shellWanted);
      column_->addWidget(shell);
    }
  }
  for (const Finding& finding : mesh.findings) {
    if (finding.severity == Severity::info) continue;
    addProblem(QString::fromStdString(finding.text), QString::fromStdString(finding.remedy),
               finding.severity == Severity::error);
  }
  if (mesh.unusable) return;
  auto* place = new QPushButton(tr("Snap to sensor face"), this);
  place->setObjectName("meshPlace");
  place->setToolTip(
      tr("Centres its bounding box on the sensor face. Otherwise the file origin is placed at the sensor origin."));
  connect(place, &QPushButton::clicked, this, &MeshForm::placeWanted);
  column_->addWidget(place);
}

}  // namespace heft
