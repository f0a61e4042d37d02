#include "ui/record_panel/record_panel.h"

#include <QFileInfo>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>

#include "ui/controller/workspace.h"
#include "ui/models/numbers.h"
#include "ui/widgets/basics.h"

namespace heft {

RecordPanel::RecordPanel(const StudioParts& parts) : StepPanel(parts) {
  connect(&workspace(), &Workspace::openedChanged, this, &RecordPanel::refresh);
  connect(&workspace(), &Workspace::reportChanged, this, &RecordPanel::refresh);
  connect(&workspace(), &Workspace::busyChanged, this, &StepPanel::stateChanged);
  refresh();
}

StepState RecordPanel::state() const {
  using P = StepState::Progress;
  const auto opened = workspace().opened();
  if (!opened) return {P::ready, Light::measured, workspace().busy() ? tr("opening …") : tr("nothing open yet")};
  const Recording& recording = opened->recording;
  return {P::done, Light::measured,
          recording.meta.kind == RecordingKind::poses ? tr("%n pose(s) recorded", "", static_cast<int>(recording.rows()))
                                                      : tr("%1 s recorded").arg(numberText(recording.duration(), 1))};
}

void RecordPanel::entered() { refresh(); }

void RecordPanel::refresh() {
  const auto opened = workspace().opened();
  QVBoxLayout* column = page()->restart(
      tr("What does your tool weigh?"),
      tr("Open a recording of the arm moving with its tool. Heft finds mass, centre of mass and inertia, "
         "and tells how sure each number is."));
  QWidget* content = page()->content();
  const Card card = makeCard("card", content);
  card.layout->addWidget(styledLabel(tr("What a recording holds"), "sectionTitle", content));
  card.layout->addWidget(wrappedLabel(tr("Time, joint angles or sensor poses, and force and torque: a CSV, a ROS bag, "
                                         "MCAP or HDF5. A file NAME.meta.json beside it may name the robot and how the "
                                         "sensor is mounted."),
                                      "caption", content));
  card.layout->addWidget(wrappedLabel(tr("You can also drop a file anywhere in this window."), "caption", content));
  column->addWidget(card.frame);
  addOpened(column);
  addRecent(column);
  column->addStretch(1);
  if (opened) {
    page()->setSecondButton(tr("Open another …"), [this] { parts().chooseFiles(); });
    page()->setMainButton(tr("See the result"), [this] { parts().goTo(Step::result); });
  } else {
    page()->setSecondButton({});
    page()->setMainButton(tr("Open a recording …"), [this] { parts().chooseFiles(); }, "open");
  }
  emit stateChanged();
}

void RecordPanel::addOpened(QVBoxLayout* column) {
  const Session& session = workspace().session();
  if (session.recordings.empty()) return;
  column->addSpacing(6);
  column->addWidget(styledLabel(tr("In this session"), "sectionTitle", page()->content()));
  for (int k = 0; k < static_cast<int>(session.recordings.size()); ++k) {
    const QString path = QString::fromStdString(session.recordings[static_cast<std::size_t>(k)].file.string());
    const auto opened = workspace().openedAt(k);
    const auto report = workspace().reportAt(k);
    QString text = QFileInfo(path).fileName();
    if (!opened) {
      text = tr("%1, not read").arg(text);
    } else if (report) {
      text = tr("%1, %2 kg").arg(text, numberText(report->payload.mass, 3));
    }
    auto* button = new QPushButton(text, page()->content());
    button->setObjectName(QStringLiteral("recording%1").arg(k));
    button->setProperty("role", k == session.active ? "chosen" : "plain");
    button->setToolTip(k == session.active ? tr("Shown now: %1").arg(path) : tr("Show %1").arg(path));
    button->setEnabled(opened != nullptr);
    connect(button, &QPushButton::clicked, this, [this, k] { workspace().activate(k); });
    column->addWidget(button);
  }
}

void RecordPanel::addRecent(QVBoxLayout* column) {
  const QStringList recent = parts().recentFiles();
  if (recent.isEmpty()) return;
  column->addSpacing(6);
  column->addWidget(styledLabel(tr("Opened lately"), "sectionTitle", page()->content()));
  for (const QString& path : recent) {
    auto* button = new QPushButton(QFileInfo(path).fileName(), page()->content());
    button->setObjectName("linkButton");
    button->setToolTip(path);
    button->setAccessibleName(tr("Open %1").arg(path));
    connect(button, &QPushButton::clicked, this, [this, path] { workspace().open(path); });
    column->addWidget(button);
  }
}

}  // namespace heft
