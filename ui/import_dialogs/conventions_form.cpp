#include "ui/import_dialogs/conventions_form.h"

#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QPushButton>
#include <QScrollArea>
#include <cmath>
#include <numbers>

#include "ui/import_dialogs/choice.h"
#include "ui/models/setup_words.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

constexpr double kAngleDegree = std::numbers::pi / 180.0;
constexpr double kLengthMillimetre = 1e-3;
constexpr int kUnfoldedHeight = 160;  ///< [px] So that the dialog stays on a small screen.

}  // namespace

ConventionsForm::ConventionsForm(const Conventions& conventions, QWidget* parent)
    : QWidget(parent), before_(conventions) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  auto* toggle = new QPushButton(tr("Conventions of the numbers"), this);
  toggle->setObjectName("rigConventions");
  toggle->setToolTip(tr("Axes, signs, units and orders that differ from the usual ones"));
  toggle->setCheckable(true);
  column->addWidget(toggle, 0, Qt::AlignLeft);
  auto* scroll = new QScrollArea(this);
  scroll->setWidgetResizable(true);
  scroll->setFixedHeight(kUnfoldedHeight);
  column->addWidget(scroll);
  auto* content = new QWidget(scroll);
  auto* form = new QFormLayout(content);
  form->setContentsMargins(0, 4, 8, 4);
  form->setSpacing(8);
  scroll->setWidget(content);

  form->addRow(styledLabel(tr("Force and torque"), "rowName", content));
  axes_ =
      addChoice(form, "rigWrenchAxes", "wrench_axes", conventions.wrenchAxes == Conventions::WrenchAxes::base ? 1 : 0);
  point_ = addChoice(form, "rigWrenchPoint", "wrench_point", static_cast<int>(conventions.wrenchPoint.kind));
  auto* offset = new QWidget(content);
  auto* row = new QHBoxLayout(offset);
  row->setContentsMargins(0, 0, 0, 0);
  for (int a = 0; a < 3; ++a) {
    offset_[a] = new QDoubleSpinBox(offset);
    offset_[a]->setObjectName("rigOffset");
    offset_[a]->setAccessibleName(tr("That point from the sensor’s origin along its %1").arg("xyz"[a]));
    offset_[a]->setToolTip(offset_[a]->accessibleName());
    offset_[a]->setRange(-2000, 2000);
    offset_[a]->setDecimals(2);
    offset_[a]->setSuffix(tr(" mm"));
    offset_[a]->setValue(conventions.wrenchPoint.offset(a) / kLengthMillimetre);
    row->addWidget(offset_[a], 1);
  }
  form->addRow(tr("Point x, y, z"), offset);
  torqueSign_ = addChoice(form, "rigTorqueSign", "torque_sign",
                          conventions.torqueSign == Conventions::TorqueSign::opposite ? 1 : 0);
  order_ = addChoice(form, "rigWrenchOrder", "wrench_order",
                     conventions.wrenchOrder == Conventions::WrenchOrder::torqueFirst ? 1 : 0);
  mirror_ = addChoice(form, "rigMirror", "mirrored_axis", conventions.mirroredAxis ? 1 + *conventions.mirroredAxis : 0);
  force_ = addUnit(form, "rigForceUnit", "force_unit", forceUnits(), conventions.force);
  torque_ = addUnit(form, "rigTorqueUnit", "torque_unit", torqueUnits(), conventions.torque);

  form->addRow(styledLabel(tr("Joints and poses"), "rowName", content));
  angles_ = addChoice(form, "rigAngles", "angle_unit", conventions.radPerAngle == 1.0 ? 0 : 1);
  lengths_ = addChoice(form, "rigLengths", "length_unit", conventions.mPerLength == 1.0 ? 0 : 1);
  pose_ = addChoice(form, "rigPose", "pose", conventions.pose == Conventions::PoseDirection::baseInSensor ? 1 : 0);
  quaternions_ = addChoice(form, "rigQuaternions", "quaternion_order",
                           conventions.quaternionOrder == Conventions::QuaternionOrder::wxyz ? 1 : 0);
  for (QComboBox* box : {point_, force_.name, torque_.name})
    connect(box, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &ConventionsForm::enableNumbers);
  enableNumbers();
  connect(toggle, &QPushButton::toggled, this, [this, scroll](bool on) {
    scroll->setVisible(on);
    layout()->activate();
    updateGeometry();
    emit folded();
  });
  toggle->setChecked(!conventions.plain());
  scroll->setVisible(toggle->isChecked());
}

QComboBox* ConventionsForm::addChoice(QFormLayout* form, const char* name, const char* key, int now) {
  const SetupWords words = setupWords(key);
  auto* box = makeChoice(name, words.title, words.tip, 16, this);
  box->addItems(words.choices());
  box->setCurrentIndex(now);
  form->addRow(words.title, box);
  return box;
}

ConventionsForm::UnitChoice ConventionsForm::addUnit(QFormLayout* form, const char* name, const char* key,
                                                     std::span<const Conventions::Unit> units,
                                                     const Conventions::Unit& now) {
  const SetupWords words = setupWords(key);
  UnitChoice out{makeChoice(name, words.title, words.tip, 8, this), new QDoubleSpinBox(this)};
  int at = static_cast<int>(units.size());
  for (const auto& unit : units) {
    if (unit.si == now.si) at = out.name->count();
    out.name->addItem(QString::fromStdString(unit.name));
  }
  out.name->addItem(tr("another"));
  out.name->setCurrentIndex(at);
  const QString si = QString::fromStdString(units[0].name);
  out.si->setObjectName(QString(name) + "Number");
  out.si->setAccessibleName(tr("%1: how many %2 one unit is").arg(words.title, si));
  out.si->setToolTip(out.si->accessibleName());
  out.si->setDecimals(9);
  out.si->setRange(1e-9, 1e6);
  out.si->setSuffix(" " + si);
  out.si->setValue(now.si);
  auto* line = new QWidget(this);
  auto* row = new QHBoxLayout(line);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(out.name, 1);
  row->addWidget(out.si, 1);
  form->addRow(words.title, line);
  return out;
}

void ConventionsForm::enableNumbers() {
  for (auto* box : offset_)
    box->setEnabled(point_->currentIndex() == static_cast<int>(Conventions::WrenchPoint::Kind::offset));
  for (const UnitChoice& unit : {force_, torque_})
    unit.si->setEnabled(unit.name->currentIndex() + 1 == unit.name->count());
}

Conventions::Unit ConventionsForm::chosen(const UnitChoice& choice, std::span<const Conventions::Unit> units,
                                          const Conventions::Unit& before) {
  const auto at = static_cast<std::size_t>(choice.name->currentIndex());
  if (at < units.size()) return units[at].si == 1.0 ? Conventions::Unit{} : units[at];
  // What was not touched keeps all its digits.
  const double number = choice.si->value();
  return {"", std::abs(number - before.si) < 1e-9 ? before.si : number};
}

Conventions ConventionsForm::conventions() const {
  Conventions out = before_;
  out.wrenchAxes = axes_->currentIndex() == 1 ? Conventions::WrenchAxes::base : Conventions::WrenchAxes::sensor;
  out.wrenchPoint.kind = static_cast<Conventions::WrenchPoint::Kind>(point_->currentIndex());
  if (out.wrenchPoint.kind != Conventions::WrenchPoint::Kind::offset) out.wrenchPoint.offset.setZero();
  for (int a = 0; a < 3 && out.wrenchPoint.kind == Conventions::WrenchPoint::Kind::offset; ++a) {
    const double number = offset_[a]->value() * kLengthMillimetre;
    if (std::abs(number - before_.wrenchPoint.offset(a)) > 0.006 * kLengthMillimetre)
      out.wrenchPoint.offset(a) = number;
  }
  if (out.wrenchPoint.offset.isZero(0.0) && out.wrenchPoint.kind == Conventions::WrenchPoint::Kind::offset)
    out.wrenchPoint.kind = Conventions::WrenchPoint::Kind::sensor;
  out.torqueSign =
      torqueSign_->currentIndex() == 1 ? Conventions::TorqueSign::opposite : Conventions::TorqueSign::asForce;
  out.wrenchOrder =
      order_->currentIndex() == 1 ? Conventions::WrenchOrder::torqueFirst : Conventions::WrenchOrder::forceFirst;
  out.mirroredAxis.reset();
  if (mirror_->currentIndex() > 0) out.mirroredAxis = mirror_->currentIndex() - 1;
  out.force = chosen(force_, forceUnits(), before_.force);
  out.torque = chosen(torque_, torqueUnits(), before_.torque);
  out.radPerAngle = angles_->currentIndex() == 1 ? kAngleDegree : 1.0;
  out.mPerLength = lengths_->currentIndex() == 1 ? kLengthMillimetre : 1.0;
  out.pose =
      pose_->currentIndex() == 1 ? Conventions::PoseDirection::baseInSensor : Conventions::PoseDirection::sensorInBase;
  out.quaternionOrder =
      quaternions_->currentIndex() == 1 ? Conventions::QuaternionOrder::wxyz : Conventions::QuaternionOrder::xyzw;
  return out;
}

}  // namespace heft
