// What the page of Record shows: the three ways to a recording, or what goes on while one is made.
#include <QButtonGroup>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <tuple>

#include "ui/controller/workspace.h"
#include "ui/record_panel/live_board.h"
#include "ui/record_panel/record_panel.h"
#include "ui/record_panel/recording_list.h"
#include "ui/record_panel/room_row.h"
#include "ui/record_panel/samples.h"
#include "ui/record_panel/source_form.h"
#include "ui/theme/icons.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/choice_card.h"
#include "ui/widgets/segments.h"

namespace heft {

void RecordPanel::refresh() {
  if (run_->running()) return;
  if (way_ == Way::live && form_) {
    emit stateChanged();
    return;  // What is typed in stays.
  }
  form_ = nullptr;
  const auto opened = workspace().opened();
  QVBoxLayout* column = nullptr;
  const QString
      forFiles =
          tr("Open a recording of the arm moving with its tool. Heft estimates mass, centre of mass and inertia, and "
             "how certain each value is."),
      forLive = tr("Heft only listens. It never moves the robot or changes settings."),
      forVirtual =
          tr("Drag the virtual arm with the mouse as if guiding it by hand, and find out what its hidden tool weighs.");
  switch (way_) {
    case Way::files:
      column = page()->restart(tr("Start with a recording"), forFiles);
      addWays(column);
      addFiles(column);
      if (workspace().opened()) addRoom(column);
      break;
    case Way::live: {
      column = page()->restart(tr("Listen to your robot"), forLive);
      addWays(column);
      form_ = new SourceForm(page()->content());
      column->addWidget(form_);
      addRoom(column);
      page()->setSecondButton({});
      page()->setMainButton(tr("Connect and record"), [this] { startListening(); });
      break;
    }
    case Way::virtualArm:
      column = page()->restart(tr("Try it without a robot"), forVirtual);
      addWays(column);
      addVirtual(column);
      addRoom(column);
      break;
  }
  column->addStretch(1);
  // The tabs below stay under the pointer.
  page()->reserveAnswers({forFiles, forLive, forVirtual});
  if (way_ == Way::files) {
    if (opened) {
      page()->setSecondButton(tr("Open another …"), [this] { parts().chooseFiles(); });
      page()->setMainButton(tr("See the result"), [this] { parts().goTo(Step::result); });
    } else {
      page()->setSecondButton({});
      page()->setMainButton(
          tr("Open a recording …"), [this] { parts().chooseFiles(); }, "open");
    }
  }
  emit stateChanged();
}

void RecordPanel::addWays(QVBoxLayout* column) {
  static constexpr std::pair<Way, const char*> kWays[] = {
      {Way::live, "hand"}, {Way::files, "folder"}, {Way::virtualArm, "tool"}};
  const auto spaced = [](const QString& text) { return QStringLiteral(" ") + text; };
  auto* ways = new Segments({spaced(tr("Live robot")), spaced(tr("Open files")), spaced(tr("Virtual arm"))},
                            {"wayLive", "wayFiles", "wayVirtual"}, page()->content());
  for (int i = 0; i < 3; ++i) {
    ways->button(i)->setIcon(themedIcon(kWays[i].second));
    if (kWays[i].first == way_) ways->setChosen(i);
  }
  connect(ways, &Segments::picked, this, [this](int i) { setWay(kWays[i].first); });
  column->addWidget(ways);
}

void RecordPanel::addFiles(QVBoxLayout* column) {
  QWidget* content = page()->content();
  const Card card = makeCard("card", content);
  card.layout->addWidget(styledLabel(tr("What a recording contains"), "sectionTitle", content));
  card.layout->addWidget(wrappedLabel(
      tr("Time, joint angles or sensor poses, and force and torque: a CSV, a ROS bag, "
         "MCAP or HDF5. A file NAME.meta.json in the same folder can specify the robot and the sensor mounting."),
      "caption", content));
  card.layout->addWidget(wrappedLabel(tr("You can also drop a file anywhere in this window."), "caption", content));
  column->addWidget(card.frame);
  addOpened(column);
  addRecent(column);
  if (!workspace().opened()) addSamples(column);
}

/// For the first minutes: something to open, to guide, to find out.
void RecordPanel::addSamples(QVBoxLayout* column) {
  QWidget* content = page()->content();
  column->addSpacing(6);
  column->addWidget(styledLabel(tr("No recording at hand?"), "sectionTitle", content));
  if (parts().startTour) {
    auto* tour = new QPushButton(tr("Two-minute tour with a sample"), content);
    tour->setObjectName("tourButton");
    tour->setProperty("role", "plain");
    tour->setIcon(themedIcon("bulb"));
    connect(tour, &QPushButton::clicked, this, [this] { parts().startTour(); });
    column->addWidget(tour);
  }
  for (const Sample& sample : samples()) {
    auto* button = new QPushButton(sample.title, content);
    button->setObjectName("sampleButton");
    button->setProperty("role", "plain");
    button->setToolTip(tr("Makes this recording with the simulation and opens it"));
    connect(button, &QPushButton::clicked, this, [this, sample] { openSample(sample); });
    column->addWidget(button);
  }
  column->addWidget(
      wrappedLabel(tr("Or guide the virtual arm yourself (third tab above), or find a hidden fault: menu Practice."),
                   "caption", content));
}

void RecordPanel::openSample(const Sample& sample) {
  sampling_.start(
      tr("Making a sample recording"), [sample](const Progress& progress) { return sampleFile(sample, progress); },
      [this](Result<QString> made) {
        if (!made) return parts().say(Severity::error, QString::fromStdString(made.error().message));
        workspace().open(*made);
      });
}

void RecordPanel::addVirtual(QVBoxLayout* column) {
  QWidget* content = page()->content();
  column->addWidget(styledLabel(tr("Which tool does it carry?"), "sectionTitle", content));
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  auto* group = new QButtonGroup(content);
  const std::tuple<QString, QString, double, double> tools[] = {{tr("Random"), tr("any tool"), 0.25, 1.6},
                                                                {tr("Light"), tr("below 0.5 kg"), 0.25, 0.5},
                                                                {tr("Heavy"), tr("over 1.1 kg"), 1.1, 1.6}};
  for (const auto& [name, detail, lightest, heaviest] : tools) {
    auto* card = new ChoiceCard(name, detail, content);
    group->addButton(card);
    card->setChecked(group->buttons().size() == 1);
    connect(card, &QAbstractButton::clicked, this, [this, a = lightest, b = heaviest] { tool_ = toolBetween(a, b); });
    row->addWidget(card);
  }
  column->addLayout(row);
  tool_ = toolBetween(0.25, 1.6);
  const Card card = makeCard("card", content);
  card.layout->addWidget(styledLabel(tr("How to guide it"), "sectionTitle", content));
  for (const QString& line : {tr("Drag the tool to move the arm."), tr("Drag a ring to rotate the tool."),
                              tr("Or use the arrow keys and Page Up/Down; hold Shift to rotate."),
                              tr("The coach suggests the most useful motion. Click \"Show me\" to see it.")})
    card.layout->addWidget(wrappedLabel(line, "caption", content));
  column->addWidget(card.frame);
  page()->setSecondButton(tr("Standing poses"), [this] { startVirtual(tool_, true, true); });
  page()->setMainButton(
      tr("Start guiding"), [this] { startVirtual(tool_, false, true); }, "hand");
}

void RecordPanel::addRoom(QVBoxLayout* column) {
  auto* row = new RoomRow(&workspace(), page()->content());
  connect(row, &RoomRow::chooseWanted, this, &RecordPanel::chooseRoom);
  connect(row, &RoomRow::touchedWanted, this, &RecordPanel::findTouchedWalls);
  column->addWidget(row);
}

void RecordPanel::addOpened(QVBoxLayout* column) {
  if (workspace().session().recordings.empty()) return;
  column->addSpacing(6);
  auto* list = new RecordingList(&workspace(), page()->content());
  connect(list, &RecordingList::closed, this, [this] { parts().goTo(Step::record); });
  column->addWidget(list);
}

void RecordPanel::addRecent(QVBoxLayout* column) {
  const QStringList recent = parts().recentFiles();
  if (recent.isEmpty()) return;
  column->addSpacing(6);
  column->addWidget(styledLabel(tr("Recent files"), "sectionTitle", page()->content()));
  for (const QString& path : recent) {
    // Names alone repeat: with the folder and the day.
    const QFileInfo file(path);
    auto* button = new QPushButton(tr("%1   ·   %2, %3")
                                       .arg(file.fileName(), QDir(file.absolutePath()).dirName(),
                                            QLocale().toString(file.lastModified().date(), QLocale::ShortFormat)),
                                   page()->content());
    button->setObjectName("linkButton");
    button->setToolTip(path);
    button->setAccessibleName(tr("Open %1").arg(path));
    connect(button, &QPushButton::clicked, this, [this, path] { workspace().open(path); });
    column->addWidget(button);
  }
}

void RecordPanel::showLive() {
  const bool poses = run_->poses();
  QVBoxLayout* column =
      poses
          ? page()->restart(
                tr("Hold the tool still in several orientations"),
                tr("Heft captures a pose automatically after one second without motion. Touch nothing with the tool."))
          : page()->restart(tr("Move the arm – Heft is recording"),
                            tr("Guide it as usual. Don’t let the tool touch anything."));
  board_ = new LiveBoard(run_, page()->content());
  connect(board_, &LiveBoard::posesWanted, this, &RecordPanel::changeWay);
  connect(board_, &LiveBoard::anotherToolWanted, this, &RecordPanel::changeTool);
  column->addWidget(board_);
  column->addStretch(1);
  if (poses) {
    page()->setSecondButton(tr("Discard"), [this] { discardPoses(); });
  } else {
    showPause();
  }
  page()->setMainButton(
      tr("Stop and save"), [this] { stopAndKeep(); }, "check");
  page()->setMainEnabled(false, tr("Nothing has been received yet."));
}

void RecordPanel::showPause() {
  page()->setSecondButton(
      run_->paused() ? tr("Resume") : tr("Pause"),
      [this] {
        run_->setPaused(!run_->paused());
        showPause();
        emit stateChanged();
      },
      run_->paused() ? "play" : "pause");
}

}  // namespace heft
