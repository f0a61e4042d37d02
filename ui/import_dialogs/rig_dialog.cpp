#include "ui/import_dialogs/rig_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QFileInfo>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <algorithm>
#include <cmath>

#include "core/math/degrees.h"
#include "core/motion/motion.h"
#include "core/robot/robot_model.h"
#include "ui/controller/robot_choice.h"
#include "ui/import_dialogs/choice.h"
#include "ui/import_dialogs/conventions_form.h"
#include "ui/models/setup_words.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

constexpr double kEarth = 9.81;
enum Stand { upright, hanging, otherwise };

QDoubleSpinBox* makeNumber(const QString& name, const QString& accessible, const QString& unit, double most,
                           int decimals, QWidget* parent) {
  auto* box = new QDoubleSpinBox(parent);
  box->setObjectName(name);
  box->setAccessibleName(accessible);
  box->setToolTip(accessible);
  box->setRange(-most, most);
  box->setDecimals(decimals);
  box->setSuffix(unit);
  return box;
}

/// Numbers beside each other, as one row of a form.
template <class Numbers>
QWidget* inOneRow(const Numbers& numbers, QWidget* parent) {
  auto* widget = new QWidget(parent);
  auto* row = new QHBoxLayout(widget);
  row->setContentsMargins(0, 0, 0, 0);
  for (auto* each : numbers) row->addWidget(each, 1);
  return widget;
}

}  // namespace

RigDialog::RigDialog(const QString& recording, const RecordingMeta& meta,
                     std::function<QString(const RecordingMeta&)> save, QWidget* parent)
    : QDialog(parent), before_(meta), save_(std::move(save)) {
  setObjectName("rigDialog");
  setWindowTitle(tr("Robot and sensor"));
  setMinimumWidth(580);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 18, 20, 16);
  form->setSpacing(10);
  form->addRow(styledLabel(tr("What was recorded?"), "question", this));
  form->addRow(wrappedLabel(tr("Errors here affect all results. If you are unsure about the mounting, leave it: the "
                               "reality check can detect it."),
                            "answer", this));
  addRobot(form);
  addMount(form, meta);
  addSetup(form, meta);
  conventions_ = new ConventionsForm(meta.conventions, this);
  connect(conventions_, &ConventionsForm::folded, this, &RigDialog::fit);
  form->addRow(conventions_);
  form->addRow(wrappedLabel(tr("Saved to %1 beside the recording; other entries are kept.")
                                .arg(QFileInfo(metaFileBeside(recording)).fileName()),
                            "caption", this));
  problem_ = wrappedLabel({}, "body", this);
  problem_->setObjectName("rigProblem");
  problem_->hide();
  form->addRow(problem_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Apply"));
  buttons->button(QDialogButtonBox::Ok)->setObjectName("useRig");
  connect(buttons, &QDialogButtonBox::accepted, this, &RigDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  form->addRow(buttons);
  if (meta.robot && *meta.robot != "panda") urdf_->setText(QString::fromStdString(*meta.robot));
  robot_->setCurrentIndex(!meta.robot ? noRobot : *meta.robot == "panda" ? panda : ownArm);
  connect(robot_, QOverload<int>::of(&QComboBox::activated), this, [this](int now) {
    robotChanged();
    if (now == ownArm && urdf_->text().isEmpty()) chooseUrdf();
  });
  connect(urdf_, &QLineEdit::editingFinished, this, &RigDialog::robotChanged);
  const Vector3d down(0, 0, -kEarth);
  const auto near = [&](const Vector3d& g) { return (meta.gravity - g).norm() < 0.03; };
  stand_->setCurrentIndex(near(down) ? upright : near(-down) ? hanging : otherwise);
  connect(stand_, QOverload<int>::of(&QComboBox::activated), this, &RigDialog::gravityChanged);
  robotChanged();
  gravityChanged();
}

void RigDialog::addRobot(QFormLayout* form) {
  robot_ = makeChoice("rigRobot", tr("Robot"), tr("The arm whose joints were recorded"), 20, this);
  robot_->addItems({tr("Franka Panda"), tr("Another arm (URDF)"), tr("None: poses only")});
  form->addRow(tr("Robot"), robot_);
  urdf_ = new QLineEdit(this);
  urdf_->setObjectName("rigUrdf");
  urdf_->setAccessibleName(tr("Description of the robot (URDF)"));
  urdf_->setToolTip(tr("The file with the robot’s joints and links"));
  auto* choose = new IconButton("folder", tr("Choose the description of the robot"), this);
  connect(choose, &QToolButton::clicked, this, &RigDialog::chooseUrdf);
  urdfRow_ = new QWidget(this);
  auto* urdfLine = new QHBoxLayout(urdfRow_);
  urdfLine->setContentsMargins(0, 0, 0, 0);
  urdfLine->addWidget(urdf_, 1);
  urdfLine->addWidget(choose);
  form->addRow(tr("Its URDF"), urdfRow_);
  link_ = makeChoice("rigLink", tr("Sensor mounted on"), tr("The link of the arm that carries the sensor"), 20, this);
  link_->setEditable(true);
  form->addRow(tr("Sensor mounted on"), link_);
}

void RigDialog::addMount(QFormLayout* form, const RecordingMeta& meta) {
  const QString axes[] = {"x", "y", "z"};
  const QString turns[] = {tr("roll"), tr("pitch"), tr("yaw")};
  for (int a = 0; a < 3; ++a) {
    xyz_[a] = makeNumber("rigXyz", tr("Sensor’s origin from the link, %1").arg(axes[a]), tr(" mm"), 2000, 2, this);
    rpy_[a] = makeNumber(
        "rigRpy", tr("Sensor’s rotation from the link, %1 (roll, then pitch, then yaw about fixed axes)").arg(turns[a]),
        tr(" °"), 360, 2, this);
    gravity_[a] = makeNumber("rigGravity", tr("Gravity along the base’s %1").arg(axes[a]), tr(" m/s²"), 20, 3, this);
    xyz_[a]->setValue(1e3 * meta.mount.xyz(a));
    rpy_[a]->setValue(meta.mount.rpy(a) / kRadPerDegree);
    gravity_[a]->setValue(meta.gravity(a));
  }
  form->addRow(setupWords("xyz_m").title, inOneRow(xyz_, this));
  form->addRow(setupWords("rpy_rad").title, inOneRow(rpy_, this));
}

void RigDialog::addSetup(QFormLayout* form, const RecordingMeta& meta) {
  const auto ask = [&](const char* name, const char* key) {
    const SetupWords words = setupWords(key);
    QComboBox* box = makeChoice(name, words.title, words.tip, 20, this);
    box->addItems(words.choices());
    form->addRow(words.title, box);
    return box;
  };
  sign_ = ask("rigSign", "wrench_sign");
  sign_->setCurrentIndex(meta.wrenchSign == WrenchSign::payloadOnSensor ? 1 : 0);
  stand_ = makeChoice("rigStand", tr("Robot mounting"), tr("Which way gravity pulls at its base"), 20, this);
  stand_->addItems({tr("upright"), tr("hanging from the ceiling"), tr("other")});
  form->addRow(tr("Robot mounting"), stand_);
  gravityRow_ = inOneRow(gravity_, this);
  form->addRow(setupWords("gravity_m_s2").title, gravityRow_);
  kind_ = ask("rigKind", "kind");
  kind_->setCurrentIndex(meta.kind == RecordingKind::poses ? 1 : 0);
  model_ = new QLineEdit(QString::fromStdString(meta.sensorModel), this);
  model_->setObjectName("rigModel");
  model_->setAccessibleName(tr("Sensor model"));
  model_->setToolTip(tr("For your own reference only"));
  form->addRow(tr("Sensor model"), model_);
}

/// As high as its texts need. adjustSize() stops at two thirds of the screen, which cuts the buttons of a small one.
void RigDialog::fit() {
  layout()->activate();
  resize(width(), std::max(layout()->totalHeightForWidth(width()), minimumSizeHint().height()));
}

void RigDialog::showEvent(QShowEvent* event) {
  QDialog::showEvent(event);
  fit();
}

void RigDialog::robotChanged() {
  const int now = robot_->currentIndex();
  urdfRow_->setEnabled(now == ownArm);
  const QString chosen = link_->count() > 0 ? link_->currentText() : QString::fromStdString(before_.mount.parent);
  RecordingMeta wanted;
  if (now == panda) wanted.robot = "panda";
  if (now == ownArm && !urdf_->text().trimmed().isEmpty()) wanted.robot = urdf_->text().trimmed().toStdString();
  link_->clear();
  if (wanted.robot) {
    Findings findings;
    if (const auto robot = robotFor(wanted, findings)) {
      for (const auto& link : robot->links()) link_->addItem(QString::fromStdString(link.name));
    } else {
      problem_->setText(QString::fromStdString(robot.error().message));
      problem_->show();
    }
  }
  if (link_->findText(chosen) < 0) link_->addItem(chosen);
  link_->setCurrentText(chosen);
}

void RigDialog::chooseUrdf() {
  const QString file = QFileDialog::getOpenFileName(this, tr("Choose the description of the robot that was recorded"),
                                                    QFileInfo(urdf_->text()).absolutePath(),
                                                    tr("Robot descriptions (*.urdf);;All files (*)"));
  if (file.isEmpty()) return;
  urdf_->setText(file);
  problem_->hide();
  robotChanged();
}

void RigDialog::gravityChanged() {
  const int now = stand_->currentIndex();
  gravityRow_->setEnabled(now == otherwise);
  if (now == otherwise) return;
  const Vector3d wanted(0, 0, now == upright ? -kEarth : kEarth);
  // A gravity that was measured on the spot stays.
  if ((before_.gravity - wanted).norm() < 0.03) {
    for (int a = 0; a < 3; ++a) gravity_[a]->setValue(before_.gravity(a));
  } else {
    for (int a = 0; a < 3; ++a) gravity_[a]->setValue(wanted(a));
  }
}

RecordingMeta RigDialog::meta() const {
  RecordingMeta out = before_;
  switch (robot_->currentIndex()) {
    case panda:
      out.robot = "panda";
      break;
    case ownArm:
      out.robot = QFileInfo(urdf_->text().trimmed()).absoluteFilePath().toStdString();
      break;
    default:
      out.robot.reset();
  }
  out.mount.parent = link_->currentText().trimmed().toStdString();
  // What was not touched keeps all its digits.
  const auto take = [](double& value, const QDoubleSpinBox* box, double unit) {
    if (std::abs(box->value() * unit - value) > 0.6 * unit * std::pow(10.0, -box->decimals()))
      value = box->value() * unit;
  };
  for (int a = 0; a < 3; ++a) {
    take(out.mount.xyz(a), xyz_[a], 1e-3);
    take(out.mount.rpy(a), rpy_[a], kRadPerDegree);
    take(out.gravity(a), gravity_[a], 1.0);
  }
  out.wrenchSign = sign_->currentIndex() == 1 ? WrenchSign::payloadOnSensor : WrenchSign::sensorOnPayload;
  out.kind = kind_->currentIndex() == 1 ? RecordingKind::poses : RecordingKind::motion;
  out.conventions = conventions_->conventions();
  out.sensorModel = model_->text().trimmed().toStdString();
  return out;
}

void RigDialog::accept() {
  QString problem;
  if (robot_->currentIndex() == ownArm && urdf_->text().trimmed().isEmpty())
    problem = tr("Choose the URDF of the arm, or another robot.");
  else
    problem = save_(meta());
  problem_->setText(problem);
  problem_->setVisible(!problem.isEmpty());
  if (problem.isEmpty()) QDialog::accept();
}

}  // namespace heft
