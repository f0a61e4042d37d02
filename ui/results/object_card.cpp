#include "ui/results/object_card.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <utility>

#include "ui/controller/only_child.h"
#include "ui/models/object_text.h"
#include "ui/results/detail_rows.h"
#include "ui/widgets/basics.h"

namespace heft {

ObjectCard::ObjectCard(const StudioParts& parts, QWidget* owner)
    : QObject(owner), parts_(parts), owner_(owner), objects_(onlyChild<CarriedObjects>(*parts.workspace)) {
  parts_.followJobs(&objects_->jobs());
  connect(objects_, &CarriedObjects::changed, this, [this] {
    emit changed();
    if (objects_->object() && std::exchange(waiting_, false)) emit answered();
  });
}

void ObjectCard::addTo(QVBoxLayout* column, QWidget* content) {
  const Card card = makeCard("card", content);
  card.frame->setProperty("role", "object");
  if (objects_->asked()) {
    addAnswer(card.layout, content);
  } else {
    card.layout->addWidget(styledLabel(tr("Something picked up?"), "sectionTitle", content));
    card.layout->addWidget(
        wrappedLabel(tr("Heft can weigh what the tool carries: from this recording, if the object is picked up or put "
                        "down in it, or with a second recording of the tool alone."),
                     "body", content));
  }
  auto* buttons = new QVBoxLayout;
  buttons->setSpacing(2);
  const auto button = [&](const QString& text, const char* name, auto clicked) {
    auto* out = new QPushButton(text, content);
    out->setObjectName("linkButton");
    out->setProperty("role", name);
    out->setEnabled(!objects_->jobs().running());
    connect(out, &QPushButton::clicked, this, clicked);
    buttons->addWidget(out, 0, Qt::AlignLeft);
  };
  button(tr("Picked up in this recording"), "pickedUp", [this] { findPickedUp(); });
  button(tr("Compare with a recording without it …"), "minus", [this] { askMinus(); });
  card.layout->addLayout(buttons);
  column->addWidget(card.frame);
}

void ObjectCard::addAnswer(QVBoxLayout* card, QWidget* content) {
  const auto object = objects_->object();
  const ObjectText text = object ? describeObject(*object) : ObjectText();
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  if (object) row->addWidget(new LightIcon(text.sure ? Light::measured : Light::look, 22, content));
  row->addWidget(styledLabel(tr("What is carried"), "sectionTitle", content), 1);
  card->addLayout(row);
  if (!object) {
    const QString why = objects_->failure();
    card->addWidget(wrappedLabel(why.isEmpty() ? tr("Heft weighs what is carried …") : why, "body", content));
    return;
  }
  card->addWidget(wrappedLabel(text.headline, "findingText", content));
  if (!text.note.isEmpty()) card->addWidget(wrappedLabel(text.note, "body", content));
  addDetailRows(card, text.rows, content);
  for (const FindingText& finding : text.findings)
    card->addWidget(wrappedLabel(finding.text + ' ' + finding.remedy, "caption", content));
  QString source =
      objects_->without().isEmpty()
          ? tr("From the parts of this recording with and without it, in the sensor’s axes.")
          : tr("This recording minus %1, in the sensor’s axes.").arg(QFileInfo(objects_->without()).fileName());
  if (!parts_.workspace->corrections().causes.empty()) source += ' ' + tr("Applied corrections are not used here.");
  card->addWidget(wrappedLabel(source, "caption", content));
}

void ObjectCard::tell(const Result<bool>& outcome) {
  waiting_ = outcome.ok();
  if (!outcome) parts_.say(Severity::error, QString::fromStdString(outcome.error().message));
}

void ObjectCard::findPickedUp() { tell(objects_->findPickedUp()); }

void ObjectCard::askMinus() {
  const auto opened = parts_.workspace->opened();
  const QString folder = opened ? QFileInfo(opened->path).absolutePath() : QString();
  const QString file =
      QFileDialog::getOpenFileName(owner_, tr("The same tool without the object"), folder, tr("All files (*)"));
  if (!file.isEmpty()) tell(objects_->findMinus(file));
}

ScriptForms ObjectCard::scriptForms() {
  return {{"object picked-up | object minus FILE | object off",
           "what the tool carries: from this recording, or by one without it"}};
}

std::optional<Result<bool>> ObjectCard::obey(const QStringList& words) {
  if (words[0] != "object") return std::nullopt;
  if (words.size() == 2 && words[1] == "picked-up") return waiting_ = true, objects_->findPickedUp();
  if (words.size() == 3 && words[1] == "minus") return waiting_ = true, objects_->findMinus(words[2]);
  if (words.size() == 2 && words[1] == "off") return objects_->forget(), Result<bool>(true);
  return std::nullopt;
}

}  // namespace heft
