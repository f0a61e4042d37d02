#include "ui/widgets/pane_header.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/widgets/basics.h"

namespace heft {

PaneHeader dressAsPane(QWidget* pane, const QString& title, int height) {
  pane->setObjectName("plotArea");
  pane->setAttribute(Qt::WA_StyledBackground);
  auto* column = new QVBoxLayout(pane);
  column->setContentsMargins(0, 1, 0, 0);
  column->setSpacing(0);
  auto* header = new QWidget(pane);
  header->setObjectName("plotHeader");
  header->setAttribute(Qt::WA_StyledBackground);
  header->setFixedHeight(height);
  auto* row = new QHBoxLayout(header);
  row->setContentsMargins(12, 0, 8, 0);
  row->addWidget(styledLabel(title, "plotTitle", header));
  column->addWidget(header);
  return {column, header, row};
}

}  // namespace heft
