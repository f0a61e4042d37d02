#include "ui/record_panel/recording_list.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/controller/workspace.h"
#include "ui/models/units.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

/// It takes part in the result of all.
bool isJoined(const EstimateReport& report) {
  return std::ranges::any_of(report.findings, [](const Finding& finding) { return finding.code == "joined"; });
}

}  // namespace

RecordingList::RecordingList(Workspace* workspace, QWidget* parent) : QWidget(parent), workspace_(workspace) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(8);
  column->addWidget(styledLabel(tr("In this session"), "sectionTitle", this));
  const auto count = static_cast<int>(workspace_->session().recordings.size());
  for (int k = 0; k < count; ++k) addRow(k);
  if (count > 1) addTogether();
}

void RecordingList::addRow(int index) {
  const Session& session = workspace_->session();
  const QString path = QString::fromStdString(session.recordings[static_cast<std::size_t>(index)].file.string());
  const auto opened = workspace_->openedAt(index);
  const auto report = workspace_->reportAt(index);
  QString text = workspace_->nameOf(index);
  if (!opened) {
    text = tr("%1 (could not be read)").arg(text);
  } else if (report && workspace_->joins() && !isJoined(*report)) {
    text = tr("%1, by itself %2").arg(text, massText(report->payload.mass, 3));
  } else if (report) {
    text = QStringLiteral("%1, %2").arg(text, massText(report->payload.mass, 3));
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(4);
  auto* button = new QPushButton(text, this);
  button->setObjectName(QStringLiteral("recording%1").arg(index));
  button->setProperty("role", index == session.active ? "chosen" : "plain");
  button->setToolTip(index == session.active ? tr("Shown now: %1").arg(path) : tr("Show %1").arg(path));
  button->setEnabled(opened != nullptr);
  button->setMinimumWidth(0);
  button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  button->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(button, &QPushButton::clicked, this, [this, index] { workspace_->activate(index); });
  connect(button, &QWidget::customContextMenuRequested, this,
          [this, index, button](const QPoint& at) { offer(index, button->mapToGlobal(at)); });
  row->addWidget(button, 1);
  auto* more = new IconButton("more", tr("Rename or close %1").arg(workspace_->nameOf(index)), this);
  more->setObjectName(QStringLiteral("recordingMore%1").arg(index));
  connect(more, &QToolButton::clicked, this,
          [this, index, more] { offer(index, more->mapToGlobal(QPoint(0, more->height()))); });
  row->addWidget(more);
  static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

void RecordingList::addTogether() {
  auto* together = new QCheckBox(tr("One tool: one result from all of them"), this);
  together->setObjectName("joinRecordings");
  together->setChecked(workspace_->session().joined);
  together->setToolTip(
      tr("Each recording keeps its own sensor zero and noise; mass, centre of mass and inertia are shared. "
         "A recording that contradicts the others is left out, with a note."));
  connect(together, &QCheckBox::toggled, this, [this](bool on) { workspace_->setJoined(on); });
  layout()->addWidget(together);
  const Session& session = workspace_->session();
  if (session.shape.answer == ShapeChoice::Answer::given || !session.settings.known.empty())
    layout()->addWidget(wrappedLabel(tr("The shape and your reference values apply to all of them. For another tool, "
                                        "start a new session: menu File, New."),
                                     "caption", this));
}

void RecordingList::offer(int index, const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setObjectName("recordingMenu");
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(tr("&Rename …"), this, [this, index] { askName(index); })->setObjectName("renameRecording");
  const auto close = [this, index] {
    workspace_->close(index);
    emit closed();
  };
  // Closing builds this list anew: not from within its own menu.
  menu->addAction(tr("&Close"), this, [this, close] { QMetaObject::invokeMethod(this, close, Qt::QueuedConnection); })
      ->setObjectName("closeRecording");
  menu->popup(at);
}

void RecordingList::askName(int index) {
  auto* dialog = new QInputDialog(window());
  dialog->setObjectName("renameDialog");
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  dialog->setWindowTitle(tr("Rename"));
  dialog->setLabelText(tr("Name in this session; the file keeps its own."));
  dialog->setTextValue(workspace_->nameOf(index));
  connect(dialog, &QInputDialog::textValueSelected, workspace_,
          [workspace = workspace_, index](const QString& name) { workspace->rename(index, name); });
  dialog->open();
}

}  // namespace heft
