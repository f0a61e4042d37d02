#include "ui/export_panel/mounted_list.h"

#include <QCheckBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/export_panel/export_text.h"
#include "ui/models/units.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

/// What does not fit ends in dots.
class FittedCheckBox : public QCheckBox {
 public:
  FittedCheckBox(const QString& text, QWidget* parent) : QCheckBox(text, parent), whole_(text) {
    setAccessibleName(text);
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QCheckBox::resizeEvent(event);
    constexpr int kIndicator = 30;  // [px] with its gap
    setText(fontMetrics().elidedText(whole_, Qt::ElideRight, width() - kIndicator));
  }

 private:
  QString whole_;
};

}  // namespace

MountedList::MountedList(QWidget* parent) : QWidget(parent) {
  rows_ = new QVBoxLayout(this);
  rows_->setContentsMargins(0, 0, 0, 0);
  rows_->setSpacing(0);
}

void MountedList::showParts(const std::vector<MountedPart>& parts, bool nothingElse, double together) {
  parts_ = parts;
  while (QLayoutItem* item = rows_->takeAt(0)) {
    if (item->widget()) item->widget()->deleteLater();
    delete item;
  }
  const auto line = [&](QWidget* left, const QString& right, const char* style) {
    auto* row = new QWidget(this);
    row->setFixedHeight(40);  // A finger's worth, as the boxes and the button in it are high
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    // A long name must not make the panel wider than it is.
    left->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    layout->addWidget(left, 1);
    layout->addWidget(styledLabel(right, style, row));
    rows_->addWidget(makeDivider(this));
    rows_->addWidget(row);
  };
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    auto* box = new FittedCheckBox(QString::fromStdString(parts_[i].name), this);
    box->setObjectName(QStringLiteral("mounted%1").arg(i));
    box->setChecked(parts_[i].present);
    box->setToolTip(QStringLiteral("%1\n%2").arg(
        QString::fromStdString(parts_[i].name),
        tr("Is it between flange and tool, and not entered into the controller elsewhere?")));
    connect(box, &QCheckBox::toggled, this, [this, i](bool on) {
      auto next = parts_;
      next[i].present = on;
      emit changed(next, on ? tr("add %1").arg(QString::fromStdString(next[i].name))
                            : tr("leave out %1").arg(QString::fromStdString(next[i].name)));
    });
    line(box, massText(parts_[i].payload.mass, 3), parts_[i].present ? "smallNumber" : "rowName");
  }
  auto* nothing = new QCheckBox(tr("Nothing else"), this);
  nothing->setObjectName("mountedNothing");
  nothing->setChecked(nothingElse);
  connect(nothing, &QCheckBox::clicked, this, [this] {
    auto next = parts_;
    for (MountedPart& part : next) part.present = false;
    emit changed(next, tr("nothing else is mounted"));
  });
  line(nothing, {}, "rowName");
  auto* more = new QPushButton(tr("Something else …"), this);
  more->setObjectName("linkButton");
  connect(more, &QPushButton::clicked, this, &MountedList::addPart);
  line(more, {}, "rowName");
  if (together >= 0) {
    line(styledLabel(tr("Total on the flange"), "sectionTitle", this), massText(together, 3), "midNumber");
  }
}

void MountedList::addPart() {
  QDialog dialog(this);
  dialog.setWindowTitle(tr("Something else on the flange"));
  auto* form = new QFormLayout(&dialog);
  auto* name = new QLineEdit(tr("Adapter"), &dialog);
  name->setObjectName("partName");
  form->addRow(tr("What it is"), name);
  auto* mass = new QDoubleSpinBox(&dialog);
  mass->setObjectName("partMass");
  mass->setRange(0.001, 50.0);
  mass->setDecimals(3);
  mass->setValue(0.1);
  mass->setSuffix(tr(" kg"));
  form->addRow(tr("Weight"), mass);
  QDoubleSpinBox* place[3];
  const QString axes[] = {tr("Centre from the flange, x"), tr("y"), tr("z")};
  for (int i = 0; i < 3; ++i) {
    place[i] = new QDoubleSpinBox(&dialog);
    place[i]->setRange(-1000, 1000);
    place[i]->setDecimals(1);
    place[i]->setSuffix(tr(" mm"));
    form->addRow(axes[i], place[i]);
  }
  place[2]->setValue(20);
  form->addRow(wrappedLabel(tr("Inertia is approximated by a compact aluminium body."), "caption", &dialog));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, &dialog);
  buttons->button(QDialogButtonBox::Ok)->setText(tr("Add it"));
  connect(buttons, &QDialogButtonBox::accepted, &dialog, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  form->addRow(buttons);
  if (dialog.exec() != QDialog::Accepted || name->text().trimmed().isEmpty()) return;
  auto next = parts_;
  const Vector3d centre = 1e-3 * Vector3d(place[0]->value(), place[1]->value(), place[2]->value());
  next.push_back({name->text().trimmed().toStdString(), compactPart(mass->value(), centre), true});
  emit changed(next, tr("add %1").arg(name->text().trimmed()));
}

}  // namespace heft
