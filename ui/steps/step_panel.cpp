#include "ui/steps/step_panel.h"

#include <QVBoxLayout>

namespace heft {

StepPanel::StepPanel(const StudioParts& parts, PanelPage* page, QWidget* parent)
    : QWidget(parent), parts_(parts), page_(page ? page : new PanelPage) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->addWidget(page_);
}

}  // namespace heft
