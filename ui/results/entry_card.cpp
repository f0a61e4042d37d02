#include "ui/results/entry_card.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/controller/only_child.h"
#include "ui/models/entry_text.h"
#include "ui/models/numbers.h"
#include "ui/results/detail_rows.h"
#include "ui/results/entry_dialog.h"
#include "ui/robot_view/robot_view.h"
#include "ui/timeline/playback.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

ControllerLimits limitsOf(const ControllerChoice& choice) {
  return {choice.collisionForce, choice.collisionTorque, choice.stiffness};
}

/// "1,2,3" as a place in metres from millimetres.
std::optional<Vector3d> placeOf(const QString& text) {
  const QStringList parts = text.split(',');
  Vector3d out;
  for (int i = 0; i < 3; ++i) {
    bool ok = false;
    out(i) = 1e-3 * parts.value(i).toDouble(&ok);
    if (!ok || parts.size() != 3) return std::nullopt;
  }
  return out;
}

}  // namespace

std::optional<CauseMark> phantomMark(const EntryCost& cost, const Vector3d& p_SPcm_S, double time) {
  if (!cost.differs || cost.time.size() == 0) return std::nullopt;
  const double* first = cost.time.data();
  const auto at = std::lower_bound(first, first + cost.time.size() - 1, time) - first;
  CauseMark mark;
  mark.kind = CauseMark::Kind::push;
  mark.vector = cost.X_FS.linear().transpose() * cost.phantom.col(at).head<3>();
  mark.at = p_SPcm_S;
  mark.title = EntryCard::tr("Phantom force");
  mark.note = EntryCard::tr("%1 N").arg(numberText(mark.vector.norm(), 1));
  return mark;
}

EntryCard::EntryCard(const StudioParts& parts, QWidget* owner)
    : QObject(owner), parts_(parts), owner_(owner), costs_(onlyChild<EntryCosts>(*parts.workspace)) {
  parts_.followJobs(&costs_->jobs());
  connect(costs_, &EntryCosts::changed, this, [this] {
    showArrow();
    emit changed();
  });
  if (parts_.playback) connect(parts_.playback, &Playback::timeChanged, this, &EntryCard::showArrow);
}

void EntryCard::setShown(bool shown) {
  if (shown == shown_) return;
  shown_ = shown;
  if (shown_)
    showArrow();
  else if (parts_.view)
    parts_.view->marks().showCauses({});
}

void EntryCard::showArrow() {
  const auto report = parts_.workspace->report();
  if (!shown_ || !parts_.view || !parts_.playback) return;
  std::vector<CauseMark> marks;
  if (const auto cost = costs_->cost(); cost && report)
    if (auto mark = phantomMark(*cost, report->payload.com, parts_.playback->time())) marks.push_back(std::move(*mark));
  parts_.view->marks().showCauses(std::move(marks));
}

void EntryCard::addTo(QVBoxLayout* column, QWidget* content) {
  const Card card = makeCard("card", content);
  card.frame->setProperty("role", "entry");
  const auto entry = costs_->entry();
  if (entry) {
    addAnswer(card.layout, content);
  } else {
    card.layout->addWidget(styledLabel(tr("What does the controller’s current entry cost?"), "sectionTitle", content));
    card.layout->addWidget(wrappedLabel(tr("Enter the payload that the controller is set to. Heft then shows the "
                                           "phantom forces it would see, and their effect."),
                                        "body", content));
  }
  auto* row = new QHBoxLayout;
  const auto button = [&](const QString& text, const char* name, auto clicked) {
    auto* out = new QPushButton(text, content);
    out->setObjectName("linkButton");
    out->setProperty("role", name);
    connect(out, &QPushButton::clicked, this, clicked);
    row->addWidget(out);
  };
  button(entry ? tr("Change it …") : tr("Enter it …"), "enterEntry", [this] { ask(); });
  button(tr("From a payload file …"), "entryFile", [this] { askFile(); });
  row->addStretch(1);
  card.layout->addLayout(row);
  column->addWidget(card.frame);
}

void EntryCard::addAnswer(QVBoxLayout* card, QWidget* content) {
  const auto entry = costs_->entry();
  const auto cost = costs_->cost();
  const EntryText text = cost ? describeEntry(*cost, limitsOf(parts_.workspace->session().controller)) : EntryText();
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  using Grade = EntryText::Grade;
  if (cost)
    row->addWidget(new LightIcon(text.grade == Grade::stops   ? Light::notPossible
                                 : text.grade == Grade::costs ? Light::look
                                                              : Light::measured,
                                 22, content));
  row->addWidget(styledLabel(tr("What does the controller’s current entry cost?"), "sectionTitle", content), 1);
  card->addLayout(row);
  if (!cost) {
    const QString why = costs_->failure();
    card->addWidget(wrappedLabel(why.isEmpty() ? tr("Heft compares it along the motion …") : why, "body", content));
    return;
  }
  card->addWidget(wrappedLabel(text.headline, "findingText", content));
  card->addWidget(wrappedLabel(text.consequence, "body", content));
  addDetailRows(card, text.rows, content);
  const QString source = entry->byRecording        ? tr("Set as in the recording (%1).").arg(entry->source)
                         : entry->source.isEmpty() ? tr("Set as you typed it.")
                                                   : tr("Set as in %1.").arg(entry->source);
  QString notes = source;
  if (!text.note.isEmpty()) notes += " " + text.note;
  if (cost->differs) notes += " " + tr("The arrow on the tool shows the force at the current time.");
  card->addWidget(wrappedLabel(notes, "caption", content));
}

void EntryCard::ask() {
  const auto entry = costs_->entry();
  EntryDialog dialog(parts_.workspace->session().controller, entry ? entry->payload : PartialPayload(), owner_);
  if (dialog.exec() == QDialog::Accepted)
    parts_.workspace->setController(dialog.choice(), tr("the controller’s entry"));
}

void EntryCard::askFile() {
  const auto opened = parts_.workspace->opened();
  const QString folder = opened ? QFileInfo(opened->path).absolutePath() : QString();
  const QString file = QFileDialog::getOpenFileName(owner_, tr("What the controller is set to"), folder,
                                                    tr("Payload files (*.json);;All files (*)"));
  if (file.isEmpty()) return;
  if (const auto read = costs_->read(file); !read)
    parts_.say(Severity::error, QString::fromStdString(read.error().message));
}

ScriptForms EntryCard::scriptForms() {
  return {{"controller MASS [at X,Y,Z] | controller FILE | controller off",
           "what the controller is set to: kg, mm from the flange; or a payload file"}};
}

std::optional<Result<bool>> EntryCard::obey(const QStringList& words) {
  if (words[0] != "controller") return std::nullopt;
  ControllerChoice choice = parts_.workspace->session().controller;
  choice.told = {};
  choice.source.clear();
  bool isNumber = false;
  const double mass = words.value(1).toDouble(&isNumber);
  if (words.size() == 2 && !isNumber && words[1] != "off") return costs_->read(words[1]);
  if (isNumber) choice.told.mass = mass;
  if (words.size() == 4 && isNumber && words[2] == "at") {
    choice.told.com = placeOf(words[3]);
    if (!choice.told.com) return std::nullopt;
  } else if (words.size() != 2) {
    return std::nullopt;
  }
  if (isNumber && !(mass >= 0.0)) return std::nullopt;
  parts_.workspace->setController(choice, tr("the controller’s entry"));
  return Result<bool>(true);
}

}  // namespace heft
