#include "ui/shape_panel/substance_form.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>

#include "ui/models/numbers.h"
#include "ui/shape_panel/body_form.h"
#include "ui/shape_panel/shape_text.h"
#include "ui/theme/theme.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/choice_box.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/stepper.h"

namespace heft {

WeightField::WeightField(const QString& name, const QString& id, const QString& placeholder, QWidget* parent)
    : QWidget(parent) {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(6);
  field_ = new QLineEdit(this);
  field_->setObjectName(id);
  field_->setPlaceholderText(placeholder);
  dimPlaceholder(field_);
  field_->setAccessibleName(name);
  field_->setToolTip(tr("What the scale shows for everything behind the sensor; optional."));
  field_->setMinimumSize(60, 40);
  field_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  unit_ = new ChoiceBox(this);
  unit_->setObjectName(id + "Unit");
  unit_->addItems({QStringLiteral("kg"), QStringLiteral("g")});
  unit_->setAccessibleName(tr("Unit of the weight"));
  unit_->setToolTip(tr("Unit of the weight"));
  unit_->setFixedSize(58, 40);
  row->addWidget(field_, 1);
  row->addWidget(unit_);
  setFocusProxy(field_);
  connect(field_, &QLineEdit::editingFinished, this, &WeightField::take);
  connect(unit_, QOverload<int>::of(&QComboBox::activated), this, [this] {
    // A number just typed takes the unit; one that was taken before is only written in it.
    if (field_->isModified()) return take();
    showWeight(shown_);
  });
}

void WeightField::take() {
  if (!field_->isModified()) return;
  const QString typed = field_->text().trimmed();
  if (typed.isEmpty()) {
    field_->setModified(false);
    setWrong(false);
    emit refused({});
    if (shown_) emit changed(std::nullopt);
    return;
  }
  const auto mass = parseWeight(typed, unit_->currentIndex() == 1);
  if (!mass) {
    setWrong(true);
    emit refused(tr("“%1” is not a weight. Enter e.g. 0.8 kg or 800 g, or leave it blank.").arg(typed));
    return;
  }
  if (typed.endsWith(QLatin1String("kg"), Qt::CaseInsensitive)) {
    unit_->setCurrentIndex(0);
  } else if (typed.endsWith('g', Qt::CaseInsensitive)) {
    unit_->setCurrentIndex(1);
  }
  field_->setModified(false);
  setWrong(false);
  emit refused({});
  emit changed(mass);
}

void WeightField::showWeight(std::optional<double> kilograms) {
  // Not while the user is typing, unless the weight has changed in the meantime (undo).
  if (field_->isModified() && kilograms == shown_) return;
  shown_ = kilograms;
  const bool grams = unit_->currentIndex() == 1;
  QString text;
  if (kilograms) {
    text = numberText(grams ? 1e3 * *kilograms : *kilograms, grams ? 1 : 4);
    const QChar point = QLocale().decimalPoint();
    while (text.contains(point) && text.endsWith('0')) text.chop(1);
    if (text.endsWith(point)) text.chop(1);
  }
  field_->setText(text);
  field_->setModified(false);
  setWrong(false);
}

void WeightField::setWrong(bool wrong) {
  if (field_->property("wrong").toBool() == wrong) return;
  field_->setProperty("wrong", wrong);
  field_->style()->unpolish(field_);
  field_->style()->polish(field_);
}

SubstanceForm::SubstanceForm(const ShapeBody& body, bool part, QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(5);
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  column->addLayout(grid);

  const QString weightName = part ? tr("Weight of this part") : tr("Weight from a scale, if known");
  grid->addWidget(styledLabel(weightName, "caption", this), 0, 0);
  weight_ =
      new WeightField(weightName, part ? "partWeight" : "weight", part ? tr("estimated") : tr("not weighed"), this);
  grid->addWidget(weight_, 1, 0);
  connect(weight_, &WeightField::changed, this, &SubstanceForm::weightChanged);

  const bool mayBeHollow = body.kind != BodyKind::tube;  // A tube is hollow anyway.
  if (mayBeHollow) {
    grid->addWidget(styledLabel(tr("Interior"), "caption", this), 0, 1);
    inside_ = new Segments({tr("Solid"), body.kind == BodyKind::mesh ? tr("Thin shell") : tr("Hollow")},
                           {"insideSolid", "insideHollow"}, this);
    grid->addWidget(inside_, 1, 1);
    connect(inside_, &Segments::picked, this, [this](int index) { emit hollowChanged(index == 1); });
    wallRow_ = new QWidget(this);
    auto* wallColumn = new QVBoxLayout(wallRow_);
    wallColumn->setContentsMargins(0, 0, 0, 0);
    wallColumn->setSpacing(5);
    wallColumn->addWidget(styledLabel(tr("Wall thickness"), "caption", wallRow_));
    wall_ = new Stepper(tr("Wall thickness"), QStringLiteral("mm"), {0.1, 500.0, 0.5, 1}, wallRow_);
    wall_->setObjectName("wall");
    wallColumn->addWidget(wall_);
    grid->addWidget(wallRow_, 2, 1, 2, 1);
    connect(wall_, &Stepper::begun, this, &SubstanceForm::begun);
    connect(wall_, &Stepper::changed, this, [this](double mm) { emit wallChanged(1e-3 * mm); });
  }

  grid->addWidget(styledLabel(tr("Material, if known"), "caption", this), mayBeHollow ? 2 : 0, mayBeHollow ? 0 : 1);
  material_ = new ChoiceBox(this);
  material_->setObjectName("material");
  material_->setAccessibleName(tr("Material"));
  material_->setToolTip(tr("Only if the whole tool is made of it; optional."));
  material_->setMinimumHeight(36);
  material_->addItem(tr("not known"));
  for (const Material& material : materials()) material_->addItem(material.name, material.density);
  grid->addWidget(material_, mayBeHollow ? 3 : 1, mayBeHollow ? 0 : 1);
  connect(material_, QOverload<int>::of(&QComboBox::activated), this, [this](int index) {
    const QVariant density = material_->itemData(index);
    emit materialChanged(density.isValid() ? std::optional(density.toDouble()) : std::nullopt);
  });
  error_ = makeFieldError(this);
  column->addWidget(error_);
  note_ = wrappedLabel({}, "caption", this);
  note_->hide();
  column->addWidget(note_);
  connect(weight_, &WeightField::refused, this, [this](const QString& why) { showFieldError(error_, why); });
  if (wall_) connect(wall_, &Stepper::refused, this, [this](const QString& why) { showFieldError(error_, why); });
}

void SubstanceForm::showSubstance(const ShapeBody& body, std::optional<double> weight) {
  weight_->showWeight(weight);
  if (inside_) {
    inside_->setChosen(body.wall ? 1 : 0);
    wallRow_->setVisible(body.wall.has_value());
    if (body.wall) wall_->setValue(1e3 * *body.wall);
  }
  const int known = body.density ? materialOf(*body.density) : -1;
  // A density from elsewhere (a shape file) has its own line.
  while (material_->count() > static_cast<int>(materials().size()) + 1) material_->removeItem(material_->count() - 1);
  if (body.density && known < 0) material_->addItem(tr("%1 kg/m³").arg(numberText(*body.density, 0)), *body.density);
  material_->setCurrentIndex(!body.density ? 0 : known >= 0 ? known + 1 : material_->count() - 1);
  const auto volume = body.density ? materialVolume(body) : std::nullopt;
  note_->setVisible(volume.has_value());
  if (volume)
    note_->setText(tr("In %1, this would weigh %2.").arg(material_->currentText(), kilograms(*volume * *body.density)));
}

void SubstanceForm::setWeightProblem(const QString& sentence) {
  weight_->setWrong(!sentence.isEmpty());
  showFieldError(error_, sentence);
}

void SubstanceForm::setWallProblem(const QString& sentence) {
  if (wall_) wall_->setProblem(sentence);
}

}  // namespace heft
