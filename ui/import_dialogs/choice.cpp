#include "ui/import_dialogs/choice.h"

#include "ui/widgets/choice_box.h"

namespace heft {

QComboBox* makeChoice(const QString& name, const QString& accessible, const QString& tip, int characters,
                      QWidget* parent) {
  auto* box = new ChoiceBox(parent);
  box->setObjectName(name);
  box->setAccessibleName(accessible);
  box->setToolTip(tip);
  box->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  box->setMinimumContentsLength(characters);
  return box;
}

}  // namespace heft
