#include "ui/results/detail_rows.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/widgets/basics.h"

namespace heft {

void addDetailRows(QVBoxLayout* column, const std::vector<DetailText>& rows, QWidget* content) {
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  int r = 0;
  for (const DetailText& detail : rows) {
    QLabel* name = styledLabel(detail.name, "caption", content);
    QLabel* value = styledLabel(detail.value, "detailValue", content);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setWordWrap(true);
    name->setToolTip(detail.tip);
    value->setToolTip(detail.tip);
    grid->addWidget(name, r, 0);
    grid->addWidget(value, r, 1);
    ++r;
  }
  column->addLayout(grid);
}

}  // namespace heft
