#include "ui/main_window/preferences.h"

#include <QAction>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>

#include "ui/widgets/basics.h"

namespace heft {
namespace {

using KeyRows = QList<QPair<QString, QString>>;

void addKeys(const QMenu* menu, KeyRows& rows) {
  for (const QAction* action : menu->actions()) {
    if (action->menu()) addKeys(action->menu(), rows);
    if (action->shortcut().isEmpty()) continue;
    QString text = action->text();
    text.remove(QLatin1Char('&')).remove(QStringLiteral(" …"));
    rows << qMakePair(text, action->shortcut().toString(QKeySequence::NativeText));
  }
}

}  // namespace

Preferences::Preferences(const Choice& now, const QList<QPair<QString, QString>>& languages, const QMenuBar* bar,
                         QWidget* parent)
    : QDialog(parent) {
  setObjectName("preferences");
  setWindowTitle(tr("Preferences"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(20, 16, 20, 16);
  column->setSpacing(12);
  auto* form = new QFormLayout;
  form->setSpacing(10);
  language_ = new QComboBox(this);
  language_->setObjectName("preferredLanguage");
  for (const auto& [code, name] : languages) language_->addItem(name, code);
  language_->setCurrentIndex(std::max(0, language_->findData(now.language)));
  form->addRow(tr("&Language"), language_);
  theme_ = new QComboBox(this);
  theme_->setObjectName("preferredTheme");
  theme_->addItems({tr("Light"), tr("Dark")});
  theme_->setCurrentIndex(now.theme == ThemeKind::dark ? 1 : 0);
  form->addRow(tr("&Theme"), theme_);
  auto* place = new QWidget(this);
  auto* where = new QHBoxLayout(place);
  where->setContentsMargins(0, 0, 0, 0);
  folder_ = new QLineEdit(now.folder, this);
  folder_->setObjectName("preferredFolder");
  folder_->setMinimumWidth(300);
  where->addWidget(folder_, 1);
  auto* choose = new QPushButton(tr("Choose …"), this);
  where->addWidget(choose);
  place->setFocusProxy(folder_);
  form->addRow(tr("&Recordings folder"), place);
  connect(choose, &QPushButton::clicked, this, [this] {
    const QString folder = QFileDialog::getExistingDirectory(this, tr("Recordings folder"), folder_->text());
    if (!folder.isEmpty()) folder_->setText(folder);
  });
  const auto addUnit = [&](const QString& label, const char* name, const QStringList& names, bool second) {
    auto* choice = new QComboBox(this);
    choice->setObjectName(name);
    choice->addItems(names);
    choice->setCurrentIndex(second ? 1 : 0);
    form->addRow(label, choice);
    return choice;
  };
  mass_ = addUnit(tr("&Masses in"), "preferredMass", {QStringLiteral("kg"), QStringLiteral("g")}, now.units.grams);
  length_ = addUnit(tr("L&engths in"), "preferredLength", {QStringLiteral("mm"), tr("inch")}, now.units.inches);
  torque_ = addUnit(tr("T&orques in"), "preferredTorque", {QStringLiteral("N m"), QStringLiteral("N mm")},
                    now.units.newtonMillimetres);
  angle_ = addUnit(tr("&Angles in"), "preferredAngle", {tr("degrees"), tr("radians")}, now.units.radians);
  column->addLayout(form);
  column->addWidget(wrappedLabel(tr("For the result and the plots. Files keep the units of their format, and lengths "
                                    "that you enter are in mm."),
                                 "caption", this));
  column->addWidget(styledLabel(tr("Keyboard shortcuts"), "sectionTitle", this));
  column->addWidget(makeKeys(bar), 1);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
  column->addWidget(buttons);
  resize(560, 640);
}

QWidget* Preferences::makeKeys(const QMenuBar* bar) {
  KeyRows rows{{tr("Play or pause"), tr("Space")},
               {tr("Back or forward in time; with Shift, further"), tr("Left, Right")},
               {tr("Beginning, end of the recording"), tr("Home, End")},
               {tr("Zoom the plots; whole recording"), QStringLiteral("+, −, 0")},
               {tr("Next part of the window"), QStringLiteral("F6")},
               {tr("Press the button that has the focus"), tr("Enter")}};
  for (const QAction* top : bar->actions())
    if (top->menu()) addKeys(top->menu(), rows);
  auto* table = new QTableWidget(static_cast<int>(rows.size()), 2, this);
  table->setObjectName("keyTable");
  table->horizontalHeader()->hide();
  table->verticalHeader()->hide();
  table->setShowGrid(false);
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  for (int r = 0; r < rows.size(); ++r) {
    table->setItem(r, 0, new QTableWidgetItem(rows[r].first));
    table->setItem(r, 1, new QTableWidgetItem(rows[r].second));
  }
  return table;
}

Preferences::Choice Preferences::choice() const {
  return {language_->currentData().toString(),
          theme_->currentIndex() == 1 ? ThemeKind::dark : ThemeKind::light,
          QDir::cleanPath(folder_->text().trimmed()),
          {mass_->currentIndex() == 1, length_->currentIndex() == 1, torque_->currentIndex() == 1,
           angle_->currentIndex() == 1}};
}

}  // namespace heft
