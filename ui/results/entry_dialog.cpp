#include "ui/results/entry_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "ui/results/payload_form.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/dialog_buttons.h"

namespace heft {
namespace {

constexpr double ControllerChoice::*kLimits[3] = {&ControllerChoice::collisionForce, &ControllerChoice::collisionTorque,
                                                  &ControllerChoice::stiffness};

}  // namespace

EntryDialog::EntryDialog(const ControllerChoice& choice, const PartialPayload& shown, QWidget* parent)
    : QDialog(parent), choice_(choice) {
  setWindowTitle(tr("What is the controller set to?"));
  setMinimumWidth(480);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(20, 18, 20, 16);
  form->setSpacing(10);
  form->addRow(wrappedLabel(tr("As entered in the controller, with everything beyond the flange. A weight of 0 means "
                               "that nothing was entered."),
                            "answer", this));
  fields_ = new PayloadForm(shown,
                            tr("Centre from the flange, inertia about the centre of mass, along the flange’s axes. "
                               "Empty fields use the estimate."),
                            form, this);
  fields_->allowZero();
  form->addRow(styledLabel(tr("What it reacts to"), "sectionTitle", this));
  const struct {
    const char* name;
    QString title;
  } rows[3] = {{"limitForce", tr("Collision force [N]")},
               {"limitTorque", tr("Collision torque [N m]")},
               {"limitStiffness", tr("Stiffness of the arm [N/m]")}};
  for (std::size_t i = 0; i < 3; ++i) {
    limits_[i] = new QLineEdit(editableNumber(choice.*kLimits[i]), this);
    limits_[i]->setObjectName(rows[i].name);
    limits_[i]->setAccessibleName(rows[i].title);
    form->addRow(rows[i].title, limits_[i]);
  }
  form->addRow(
      wrappedLabel(tr("Defaults as in libfranka’s examples: 10 N, 10 N m, 3000 N/m. Use the values of your program."),
                   "caption", this));
  problem_ = wrappedLabel({}, "body", this);
  form->addRow(problem_);
  form->addRow(dialogButtons(this, tr("Compare"), [this] { return read(); }));
}

bool EntryDialog::read() {
  const auto told = fields_->read();
  problem_->setText(fields_->problem());
  if (!told) return false;
  if (!told->mass && !told->empty()) {
    problem_->setText(tr("The weight is missing."));
    return false;
  }
  ControllerChoice next = choice_;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto value = typedNumber(limits_[i]);
    if (!value || *value <= 0) {
      problem_->setText(tr("%1 must be a number above zero.").arg(limits_[i]->accessibleName()));
      return false;
    }
    next.*kLimits[i] = *value;
  }
  next.told = *told;
  next.source.clear();
  choice_ = next;
  return true;
}

}  // namespace heft
