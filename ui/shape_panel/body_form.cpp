#include "ui/shape_panel/body_form.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/shape_panel/shape_text.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/stepper.h"

#include "core/math/degrees.h"

namespace heft {
namespace {

QString capitalised(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

/// Name with its axis' dot above a stepper.
void addColumn(QGridLayout* grid, int column, int axis, const QString& name, Stepper* stepper, QWidget* parent) {
  auto* head = new QHBoxLayout;
  head->setSpacing(6);
  if (axis >= 0) head->addWidget(new AxisDot(axis, parent));
  head->addWidget(styledLabel(name, "caption", parent));
  head->addStretch(1);
  grid->addLayout(head, 0, column);
  grid->addWidget(stepper, 1, column);
  grid->setColumnStretch(column, 1);
}

QGridLayout* makeGrid(QVBoxLayout* column) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(8);
  grid->setVerticalSpacing(5);
  // Three columns even where one has fewer lengths.
  for (int c = 0; c < 3; ++c) grid->setColumnStretch(c, 1);
  column->addLayout(grid);
  return grid;
}

}  // namespace

QLabel* makeFieldError(QWidget* parent) {
  QLabel* label = wrappedLabel({}, "fieldError", parent);
  label->hide();
  return label;
}

void showFieldError(QLabel* label, const QString& sentence) {
  label->setText(sentence);
  label->setVisible(!sentence.isEmpty());
}

BodyForm::BodyForm(const QString& title, const ShapeBody& body, int index, QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(styledLabel(title, "sectionTitle", this));
  QGridLayout* grid = makeGrid(column);
  error_ = makeFieldError(this);
  column->addWidget(error_);
  const auto measures = measuresOf(body);
  for (std::size_t m = 0; m < measures.size(); ++m) {
    const QString name = lengthName(measures[m].length);
    const double least = measures[m].length == Length::innerDiameter ? 0.0 : kLeastLength;
    auto* stepper = new Stepper(capitalised(name), QStringLiteral("mm"), {least, kMostLength, 1.0, 1}, this);
    stepper->setObjectName(QStringLiteral("size_%1_%2").arg(index).arg(m));
    addColumn(grid, static_cast<int>(m), measures[m].axis, name, stepper, this);
    connect(stepper, &Stepper::begun, this, &BodyForm::begun);
    connect(stepper, &Stepper::changed, this, [this, m](double mm) { emit changed(static_cast<int>(m), 1e-3 * mm); });
    connect(stepper, &Stepper::refused, this, [this](const QString& why) { showFieldError(error_, why); });
    steppers_.push_back(stepper);
  }
  // Where there are fewer lengths than columns the empty ones keep their width.
  for (int c = static_cast<int>(measures.size()); c < 3; ++c) grid->addWidget(new QWidget(this), 1, c);
  showBody(body);
}

void BodyForm::showBody(const ShapeBody& body) {
  const auto measures = measuresOf(body);
  for (std::size_t m = 0; m < std::min(measures.size(), steppers_.size()); ++m)
    steppers_[m]->setValue(1e3 * measures[m].value);
}

void BodyForm::setProblem(int measure, const QString& sentence) {
  if (measure >= 0 && measure < static_cast<int>(steppers_.size()))
    steppers_[static_cast<std::size_t>(measure)]->setProblem(sentence);
}

void BodyForm::setStrong(int measure) {
  for (std::size_t m = 0; m < steppers_.size(); ++m) steppers_[m]->setStrong(static_cast<int>(m) == measure);
}

PlaceForm::PlaceForm(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(wrappedLabel(tr("Centre of the near face, relative to the sensor face"), "caption", this));
  QGridLayout* place = makeGrid(column);
  column->addWidget(wrappedLabel(tr("Tilted about the sensor’s axes"), "caption", this));
  QGridLayout* tilt = makeGrid(column);
  error_ = makeFieldError(this);
  column->addWidget(error_);
  for (int a = 0; a < 3; ++a) {
    const QString axis(QChar("xyz"[a]));
    auto* shift =
        new Stepper(tr("Place along %1").arg(axis), QStringLiteral("mm"), {-kMostLength, kMostLength, 1.0, 1}, this);
    shift->setObjectName(QStringLiteral("place_") + axis);
    addColumn(place, a, a, axis, shift, this);
    auto* turn = new Stepper(tr("Tilt about %1").arg(axis), QString(QChar(0xb0)), {-180.0, 180.0, 1.0, 1}, this);
    turn->setObjectName(QStringLiteral("tilt_") + axis);
    addColumn(tilt, a, a, tr("about %1").arg(axis), turn, this);
    place_[static_cast<std::size_t>(a)] = shift;
    tilt_[static_cast<std::size_t>(a)] = turn;
    for (Stepper* stepper : {shift, turn}) {
      connect(stepper, &Stepper::begun, this, &PlaceForm::begun);
      connect(stepper, &Stepper::refused, this, [this](const QString& why) { showFieldError(error_, why); });
    }
    connect(shift, &Stepper::changed, this,
            [this] { emit moved(1e-3 * Vector3d(place_[0]->value(), place_[1]->value(), place_[2]->value())); });
    connect(turn, &Stepper::changed, this,
            [this] { emit tilted(kRadPerDegree * Vector3d(tilt_[0]->value(), tilt_[1]->value(), tilt_[2]->value())); });
  }
}

void PlaceForm::showPlace(const Vector3d& nearEnd, const Vector3d& rpy) {
  for (int a = 0; a < 3; ++a) {
    place_[static_cast<std::size_t>(a)]->setValue(1e3 * nearEnd(a));
    tilt_[static_cast<std::size_t>(a)]->setValue(rpy(a) / kRadPerDegree);
  }
}

}  // namespace heft
