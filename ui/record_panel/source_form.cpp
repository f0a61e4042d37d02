#include "ui/record_panel/source_form.h"

#include <QButtonGroup>
#include <QFileDialog>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <filesystem>
#include <tuple>

#include "core/recording/csv_reader.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/choice_card.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/stepper.h"

namespace heft {
namespace {

using Kind = SourceForm::Kind;

struct Place {
  QString label, tip;
};

}  // namespace

SourceForm::SourceForm(QWidget* parent) : QWidget(parent) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  column->addWidget(styledLabel(tr("Where does the force/torque data come from?"), "sectionTitle", this));
  auto* grid = new QGridLayout;
  grid->setSpacing(8);
  auto* group = new QButtonGroup(this);
  const std::tuple<Kind, QString, QString, const char*> cards[] = {
      {Kind::netFt, tr("Net F/T sensor"), tr("ATI, Schunk"), "sourceNetFt"},
      {Kind::ur, tr("Universal Robots"), tr("joints and wrench"), "sourceUr"},
      {Kind::foxglove, tr("ROS, Foxglove bridge"), tr("joints and wrench"), "sourceFoxglove"},
      {Kind::rosbridge, tr("ROS, rosbridge"), tr("joints and wrench"), "sourceRosbridge"},
      {Kind::jsonUdp, tr("Custom program"), tr("JSON over UDP"), "sourceUdp"},
      {Kind::replay, tr("Recording"), tr("replayed in real time"), "sourceReplay"}};
  int place = 0;
  for (const auto& [kind, name, detail, object] : cards) {
    auto* card = new ChoiceCard(name, detail, this);
    card->setObjectName(object);
    card->setChecked(kind == kind_);
    group->addButton(card);
    connect(card, &QAbstractButton::clicked, this, [this, k = kind] { setKind(k); });
    grid->addWidget(card, place / 2, place % 2);
    ++place;
  }
  column->addLayout(grid);
  fields_ = new QWidget(this);
  column->addWidget(fields_);
  rebuild();
}

void SourceForm::setKind(Kind kind) {
  if (kind == kind_) return;
  lastAddress_[static_cast<int>(kind_)] = address_->text();
  if (jointsAddress_) lastJoints_ = jointsAddress_->text();
  lastRig_ = rig_->text();
  kind_ = kind;
  const char* names[] = {"sourceNetFt", "sourceUr", "sourceFoxglove", "sourceRosbridge", "sourceUdp", "sourceReplay"};
  if (auto* card = findChild<QAbstractButton*>(names[static_cast<int>(kind)])) card->setChecked(true);
  rebuild();
}

QLineEdit* SourceForm::addField(QVBoxLayout* column, const QString& label, const QString& name, const QString& tip) {
  auto* title = styledLabel(label, "captionBold", fields_);
  column->addWidget(title);
  auto* field = new QLineEdit(fields_);
  field->setObjectName(name);
  field->setToolTip(tip);
  field->setAccessibleName(label);
  title->setBuddy(field);
  connect(field, &QLineEdit::textEdited, this, &SourceForm::clearComplaint);
  return field;
}

void SourceForm::rebuild() {
  auto* old = fields_;
  fields_ = new QWidget(this);
  layout()->replaceWidget(old, fields_);
  old->hide();
  old->deleteLater();
  jointsAddress_ = nullptr;
  complaint_ = nullptr;
  mounted_ = nullptr;
  distance_ = nullptr;
  auto* column = new QVBoxLayout(fields_);
  column->setContentsMargins(0, 4, 0, 0);
  column->setSpacing(6);
  const Place places[] = {
      {tr("Address of the sensor, for instance 192.168.1.1"),
       tr("As shown on the sensor’s web page. Heft only reads its data.")},
      {tr("Address of the robot, for instance 192.168.0.10"),
       tr("A Universal Robots e-Series with its own force sensor. Heft only reads from it.")},
      {tr("Foxglove bridge address (default: localhost:8765)"), tr("Computer and port of foxglove_bridge")},
      {tr("rosbridge address (default: localhost:9090)"), tr("Computer and port of rosbridge_server")},
      {tr("UDP port (default: 9870)"),
       tr("One JSON object per datagram: time [s], q1 … q7 [rad], fx fy fz [N], tx ty tz [N m]. Only from this "
          "computer.")},
      {tr("Recording to replay"), tr("Any recording that Heft opens")}};
  const Place& place = places[static_cast<int>(kind_)];
  const auto addWithChooser = [&](QLineEdit* field, const QString& title, const QString& filter) {
    auto* row = new QHBoxLayout;
    row->addWidget(field, 1);
    auto* choose = new IconButton("folder", title, fields_);
    connect(choose, &QToolButton::clicked, this, [this, field, title, filter] {
      const QString file = QFileDialog::getOpenFileName(window(), title, field->text(), filter);
      if (!file.isEmpty()) field->setText(file);
    });
    row->addWidget(choose);
    column->addLayout(row);
  };
  address_ = addField(column, place.label, "sourceAddress", place.tip);
  address_->setText(lastAddress_[static_cast<int>(kind_)]);
  if (kind_ == Kind::replay) {
    addWithChooser(address_, tr("Choose a recording"), {});
  } else {
    column->addWidget(address_);
  }
  // Whoever writes that program needs it before his eyes.
  if (kind_ == Kind::jsonUdp) column->addWidget(wrappedLabel(place.tip, "caption", fields_));
  if (kind_ == Kind::netFt) {
    column->addSpacing(4);
    column->addWidget(styledLabel(tr("Where do the joint angles come from?"), "sectionTitle", fields_));
    auto* choices = new Segments({tr("Foxglove"), tr("rosbridge"), tr("JSON, UDP"), tr("UR")}, {}, fields_);
    static constexpr Kind kKinds[] = {Kind::foxglove, Kind::rosbridge, Kind::jsonUdp, Kind::ur};
    choices->setChosen(static_cast<int>(std::find(std::begin(kKinds), std::end(kKinds), joints_) - std::begin(kKinds)));
    connect(choices, &Segments::picked, this, [this](int i) {
      joints_ = kKinds[i];
      lastAddress_[0] = address_->text();
      lastJoints_ = jointsAddress_->text();
      lastRig_ = rig_->text();
      rebuild();
    });
    column->addWidget(choices);
    const Place& other = places[static_cast<int>(joints_)];
    jointsAddress_ = addField(column, other.label, "jointsAddress", other.tip);
    jointsAddress_->setText(lastJoints_);
    column->addWidget(jointsAddress_);
  }
  column->addSpacing(4);
  rig_ = addField(column, tr("Setup file (NAME.meta.json), optional"), "rigFile",
                  tr("States the robot, the sensor’s mounting and the sign of its forces"));
  rig_->setText(lastRig_);
  addWithChooser(rig_, tr("Choose a setup file"), tr("Setup files (*.json)"));
  if (kind_ == Kind::replay) {
    column->addWidget(wrappedLabel(tr("Without one, the recording’s own is used."), "caption", fields_));
    return;
  }
  column->addWidget(wrappedLabel(tr("Without one, Heft assumes a Franka Panda, and asks:"), "caption", fields_));
  addMount(column);
}

/// The sensor's pose on the flange affects the inertia and everything exported: the user is asked; it is not silently
/// assumed.
void SourceForm::addMount(QVBoxLayout* column) {
  column->addSpacing(4);
  column->addWidget(styledLabel(tr("Where is the sensor’s measuring point?"), "sectionTitle", fields_));
  mounted_ = new Segments({tr("At the flange"), tr("Below it"), tr("Not sure")},
                          {"mountAtFlange", "mountBelow", "mountUnsure"}, fields_);
  mounted_->setChosen(mountAnswer_);
  column->addWidget(mounted_);
  auto* below = new QWidget(fields_);
  auto* row = new QHBoxLayout(below);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(styledLabel(tr("Distance along the flange’s axis"), "caption", below), 1);
  distance_ = new Stepper(tr("Distance along the flange’s axis"), QStringLiteral("mm"), {0.0, 500.0, 1.0, 1}, below);
  distance_->setObjectName("mountDistance");
  distance_->setValue(lastDistance_);
  connect(distance_, &Stepper::changed, this, [this](double millimetres) { lastDistance_ = millimetres; });
  row->addWidget(distance_);
  column->addWidget(below);
  auto* note = wrappedLabel({}, "caption", fields_);
  column->addWidget(note);
  const auto show = [this, below, note] {
    below->setVisible(mountAnswer_ == 1);
    note->setText(mountAnswer_ == 2 ? tr("Heft assumes the flange’s axes for now and asks again after the recording.")
                                    : tr("Heft assumes the flange’s axes; a rotated sensor needs a setup file."));
  };
  connect(mounted_, &Segments::picked, this, [this, show](int answer) {
    mountAnswer_ = answer;
    clearComplaint();
    mounted_->setChosen(answer);
    show();
  });
  show();
}

QWidget* SourceForm::culprit() const {
  const bool needsAddress = kind_ == Kind::netFt || kind_ == Kind::ur || kind_ == Kind::replay;
  if (needsAddress && address_->text().trimmed().isEmpty()) return address_;
  if (jointsAddress_ && joints_ == Kind::ur && jointsAddress_->text().trimmed().isEmpty()) return jointsAddress_;
  if (!rigFile().isEmpty()) return rig_;
  return mounted_ && mountAnswer_ < 0 ? static_cast<QWidget*>(mounted_) : address_;
}

void SourceForm::clearComplaint() {
  if (!complaint_) return;
  for (auto* field : fields_->findChildren<QLineEdit*>()) {
    field->setProperty("wrong", false);
    field->style()->polish(field);
  }
  delete complaint_;
  complaint_ = nullptr;
}

void SourceForm::complain(const QString& sentence) {
  clearComplaint();
  QWidget* field = culprit();
  complaint_ = wrappedLabel(sentence, "fieldError", fields_);
  auto* column = static_cast<QVBoxLayout*>(fields_->layout());
  int below = column->count();
  for (int k = 0; k < column->count(); ++k) {
    QLayoutItem* item = column->itemAt(k);
    if (item->widget() == field || (item->layout() && item->layout()->indexOf(field) >= 0)) below = k + 1;
  }
  column->insertWidget(below, complaint_);
  if (qobject_cast<QLineEdit*>(field)) {
    field->setProperty("wrong", true);
    field->style()->polish(field);
  }
  (field == mounted_ ? mounted_->button(0) : field)->setFocus(Qt::OtherFocusReason);
  for (QWidget* up = parentWidget(); up; up = up->parentWidget())
    if (auto* scroll = qobject_cast<QScrollArea*>(up)) {
      fields_->layout()->activate();
      scroll->ensureWidgetVisible(complaint_);
      scroll->ensureWidgetVisible(field);
    }
}

bool SourceForm::mountAssumed() const {
  return kind_ != Kind::replay && rigFile().isEmpty() && mountAnswer_ != 0 && mountAnswer_ != 1;
}

QString SourceForm::rigFile() const { return rig_->text().trimmed(); }

Result<std::vector<std::string>> SourceForm::addresses() const {
  const auto one = [](Kind kind, const QString& text) -> Result<std::string> {
    QString address = text.trimmed();
    switch (kind) {
      case Kind::netFt:
        if (address.isEmpty()) return Error{tr("Enter the sensor’s address.").toStdString()};
        return "rdt:" + address.toStdString();
      case Kind::ur:
        if (address.isEmpty()) return Error{tr("Enter the robot’s address.").toStdString()};
        return "rtde:" + address.toStdString();
      case Kind::foxglove:
        return "foxglove:" + (address.isEmpty() ? std::string("localhost") : address.toStdString());
      case Kind::rosbridge:
        return "rosbridge:" + (address.isEmpty() ? std::string("localhost") : address.toStdString());
      case Kind::jsonUdp:
        return "udp:" + (address.isEmpty() ? std::string("9870") : address.toStdString());
      case Kind::replay:
        if (address.isEmpty()) return Error{tr("Choose a recording to replay.").toStdString()};
        return "replay:" + address.toStdString();
    }
    return Error{""};
  };
  std::vector<std::string> out;
  auto first = one(kind_, address_->text());
  if (!first) return first.error();
  out.push_back(*first);
  if (kind_ == Kind::netFt) {
    auto second = one(joints_, jointsAddress_->text());
    if (!second) return second.error();
    out.push_back(*second);
  }
  return out;
}

Result<RecordingMeta> SourceForm::meta() const {
  Findings findings;
  std::filesystem::path file = rigFile().toStdString();
  const std::filesystem::path replayed = address_->text().trimmed().toStdString();
  if (file.empty() && kind_ == Kind::replay && std::filesystem::exists(metaFileOf(replayed)))
    file = metaFileOf(replayed);
  RecordingMeta meta;
  if (!file.empty()) {
    auto read = readMeta(file, findings);
    if (!read) return read.error();
    meta = std::move(*read);
  } else if (kind_ != Kind::replay) {
    if (mountAnswer_ < 0) return Error{tr("Enter the sensor’s measuring point, or choose a setup file.").toStdString()};
    if (mountAnswer_ == 1) meta.mount.xyz.z() = 1e-3 * lastDistance_;
  }
  if (meta.kind == RecordingKind::poses)
    return Error{tr("Standing poses cannot be replayed as a motion.").toStdString()};
  // A replayed recording is brought to the plain form when it is read.
  if (kind_ == Kind::replay) meta.numbersArePlain();
  meta.marks.clear();
  return meta;
}

}  // namespace heft
