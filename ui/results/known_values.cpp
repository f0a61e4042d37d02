#include "ui/results/known_values.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>

#include "ui/results/payload_form.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/dialog_buttons.h"

namespace heft {

KnownValuesDialog::KnownValuesDialog(const PartialPayload& known, QWidget* parent) : QDialog(parent), values_(known) {
  setWindowTitle(tr("What do you already know?"));
  setMinimumWidth(460);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 18, 20, 16);
  form->setSpacing(10);
  form->addRow(wrappedLabel(tr("From a scale or from CAD. Used for comparison only; leave unknown fields empty."),
                            "answer", this));
  fields_ = new PayloadForm(known,
                            tr("Centre from the sensor’s origin, inertia about the centre of mass, along the sensor’s "
                               "axes. Products as in the inertia matrix."),
                            form, this);
  problem_ = wrappedLabel({}, "body", this);
  form->addRow(problem_);
  form->addRow(dialogButtons(this, tr("Compare"), [this] { return read(); }));
}

bool KnownValuesDialog::read() {
  const auto typed = fields_->read();
  problem_->setText(fields_->problem());
  if (typed) values_ = *typed;
  return typed.has_value();
}

}  // namespace heft
