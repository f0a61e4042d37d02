#include "ui/results/payload_form.h"

#include <QFormLayout>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "ui/widgets/basics.h"

namespace heft {
namespace {

constexpr int kPairs[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

}  // namespace

QString editableNumber(double value) {
  QLocale locale;
  locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(value, 'g', 7);
}

std::optional<double> typedNumber(const QLineEdit* field) {
  const QString typed = field->text().trimmed();
  bool ok = false;
  double value = QLocale().toDouble(typed, &ok);
  if (!ok) value = QLocale::c().toDouble(typed, &ok);
  return ok && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

PayloadForm::PayloadForm(const PartialPayload& known, const QString& frame, QFormLayout* form, QWidget* parent)
    : QObject(parent) {
  const auto field = [&](const char* name, const QString& accessible) {
    auto* edit = new QLineEdit(parent);
    edit->setObjectName(name);
    edit->setAccessibleName(accessible);
    edit->setPlaceholderText(tr("not known"));
    dimPlaceholder(edit);
    return edit;
  };
  mass_ = field("knownMass", tr("Weight in kg"));
  if (known.mass) mass_->setText(editableNumber(*known.mass));
  form->addRow(tr("Weight [kg]"), mass_);
  auto* centre = new QHBoxLayout;
  for (int i = 0; i < 3; ++i) {
    com_[i] = field("knownCom", tr("Centre of mass %1 in mm").arg(QChar("xyz"[i])));
    if (known.com) com_[i]->setText(editableNumber(1e3 * (*known.com)(i)));
    centre->addWidget(com_[i]);
  }
  form->addRow(tr("Centre x, y, z [mm]"), centre);
  const char* const names[] = {"xx", "yy", "zz", "xy", "xz", "yz"};
  auto* main = new QHBoxLayout;
  auto* products = new QHBoxLayout;
  for (int k = 0; k < 6; ++k) {
    inertia_[k] = field("knownInertia", tr("Inertia %1 in kg cm²").arg(QLatin1String(names[k])));
    if (known.inertiaCom) inertia_[k]->setText(editableNumber(1e4 * (*known.inertiaCom)(kPairs[k][0], kPairs[k][1])));
    (k < 3 ? main : products)->addWidget(inertia_[k]);
  }
  form->addRow(tr("Ixx, Iyy, Izz [kg cm²]"), main);
  form->addRow(tr("Ixy, Ixz, Iyz [kg cm²]"), products);
  form->addRow(wrappedLabel(frame, "caption", parent));
}

std::optional<PartialPayload> PayloadForm::fail(const QString& sentence) {
  problem_ = sentence;
  return std::nullopt;
}

std::optional<PartialPayload> PayloadForm::read() {
  PartialPayload out;
  problem_.clear();
  if (!mass_->text().trimmed().isEmpty()) {
    out.mass = typedNumber(mass_);
    if (zero_ && (!out.mass || *out.mass < 0)) return fail(tr("The weight must be a number, zero or above."));
    if (!zero_ && (!out.mass || *out.mass <= 0)) return fail(tr("The weight must be a number above zero."));
  }
  const auto filled = [](const auto& fields) {
    return std::count_if(fields.begin(), fields.end(),
                         [](const QLineEdit* f) { return !f->text().trimmed().isEmpty(); });
  };
  if (filled(com_) > 0) {
    Vector3d com;
    for (int i = 0; i < 3; ++i) {
      const auto value = typedNumber(com_[i]);
      if (!value) return fail(tr("The centre needs three numbers, or none."));
      com(i) = 1e-3 * *value;
    }
    out.com = com;
  }
  if (filled(inertia_) > 0) {
    Matrix3d inertia;
    for (int k = 0; k < 6; ++k) {
      const auto value =
          k >= 3 && inertia_[k]->text().trimmed().isEmpty() ? std::optional(0.0) : typedNumber(inertia_[k]);
      if (!value) return fail(tr("The inertia needs Ixx, Iyy and Izz, or nothing; empty products count as zero."));
      inertia(kPairs[k][0], kPairs[k][1]) = inertia(kPairs[k][1], kPairs[k][0]) = 1e-4 * *value;
    }
    out.inertiaCom = inertia;
  }
  return out;
}

}  // namespace heft
