#include "ui/results/method_pane.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/theme/theme.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/pane_header.h"

namespace heft {

MethodPane::MethodPane(QWidget* parent) : QWidget(parent) {
  const PaneHeader top = dressAsPane(this, tr("All methods side by side"));
  QVBoxLayout* column = top.column;
  QWidget* header = top.header;
  QHBoxLayout* row = top.row;
  row->addStretch(1);
  auto* close = new IconButton("close", tr("Back to the plots"), header);
  close->setObjectName("closeMethods");
  connect(close, &QToolButton::clicked, this, &MethodPane::closeWanted);
  row->addWidget(close);
  working_ = styledLabel(tr("Running all methods…"), "caption", this);
  working_->setContentsMargins(12, 12, 12, 12);
  column->addWidget(working_, 0, Qt::AlignTop);
  table_ = new QTableWidget(this);
  table_->setObjectName("methodTable");
  table_->setAccessibleName(tr("All methods side by side"));
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setFrameShape(QFrame::NoFrame);
  table_->setShowGrid(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(30);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  column->addWidget(table_, 1);
  showWorking();
}

void MethodPane::showWorking() {
  working_->show();
  table_->hide();
}

void MethodPane::showTable(const MethodTable& table) {
  working_->hide();
  table_->show();
  table_->clear();
  table_->setColumnCount(table.headers.size());
  table_->setRowCount(static_cast<int>(table.rows.size()));
  for (int c = 0; c < table.headers.size(); ++c) {
    auto* item = new QTableWidgetItem(table.headers[c]);
    item->setToolTip(table.headerTips[c]);
    if (c > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    table_->setHorizontalHeaderItem(c, item);
  }
  for (int r = 0; r < table_->rowCount(); ++r) {
    const MethodRow& row = table.rows[static_cast<std::size_t>(r)];
    for (int c = 0; c < row.cells.size(); ++c) {
      auto* item = new QTableWidgetItem(row.cells[c]);
      item->setToolTip(row.tip);
      if (c > 0) item->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
      QFont font = uiFont(type::kSection, row.chosen ? QFont::DemiBold : QFont::Normal);
      item->setFont(font);
      table_->setItem(r, c, item);
    }
  }
  table_->resizeColumnsToContents();
}

}  // namespace heft
