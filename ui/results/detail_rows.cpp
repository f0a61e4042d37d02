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
    constexpr int kMostLines = 2;  // Beside the name; more stand below it in its whole width.
    if (detail.value.count(QLatin1Char('\n')) < kMostLines) {
      name->setAlignment(Qt::AlignLeft | Qt::AlignTop);
      grid->addWidget(name, r, 0);
      grid->addWidget(value, r++, 1);
    } else {
      value->setAlignment(Qt::AlignLeft);
      value->setObjectName("caption");
      value->setContentsMargins(12, 0, 0, 0);
      grid->addWidget(name, r++, 0, 1, 2);
      grid->addWidget(value, r++, 0, 1, 2);
    }
  }
  column->addLayout(grid);
}

}  // namespace heft
