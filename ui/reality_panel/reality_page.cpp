#include "ui/reality_panel/reality_page.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/diagnosis/correction/check_on_other.h"
#include "ui/models/numbers.h"
#include "ui/reality_panel/cause_card.h"
#include "ui/reality_panel/cause_words.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(RealityPage)
};

}  // namespace

bool isTied(const DiagnosedCause& cause) { return !cause.direct && !cause.alternatives.empty(); }

VerdictText verdictText(const DiagnosisReport& report, int applied) {
  const int total = static_cast<int>(report.causes.size());
  const int open = static_cast<int>(std::count_if(report.causes.begin(), report.causes.end(), isTied));
  const QString where = Words::tr("This is where the simulation differs from your data.");
  if (report.verdict == Verdict::clean)
    return {Words::tr("The model fits"), Words::tr("Nothing in your data calls for a correction.")};
  if (report.verdict == Verdict::unexplained)
    return {total == 0 ? Words::tr("Something unknown") : Words::tr("%n cause(s) found, something is left", "", total),
            where};
  if (applied > 0 && applied == total)
    return {Words::tr("%n correction(s) applied", "", applied), Words::tr("Result, prediction and export use them.")};
  if (open == 0) return {Words::tr("%n cause(s) found", "", total), where};
  if (open == total)
    return {open == 1 ? Words::tr("Two causes are possible") : Words::tr("%n findings are still open", "", open),
            where};
  return {Words::tr("%n cause(s) found, ", "", total - open) + Words::tr("%n still open", "", open), where};
}

bool leftOutAlready(const DiagnosedCause& cause, const std::vector<Segment>& segments) {
  if (!cause.direct || (cause.id != "contact" && cause.id != "payload_change")) return false;
  double touched = 0, left = 0;
  for (const auto& [from, to] : cause.when) {
    touched += to - from;
    for (const Segment& segment : segments)
      if (segment.label != MarkLabel::free)
        left += std::max(0.0, std::min(to, segment.to) - std::max(from, segment.from));
  }
  constexpr double kNearlyAll = 0.85;  // The edges of a contact are told a little differently.
  return touched > 0 && left > kNearlyAll * touched;
}

void addChange(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, bool applied) {
  if (report.causes.empty()) return;
  const ChangeText change = payloadChange(report);
  const bool much = change.sigmas >= 2.0;
  const Card card = makeCard("cardQuiet", parent);
  card.frame->setProperty("role", "change");
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(new LightIcon(much && !applied ? Light::look : Light::measured, 20, card.frame));
  QLabel* text = wrappedLabel({}, "body", card.frame);
  text->setTextFormat(Qt::RichText);
  if (change.text.isEmpty()) {
    text->setText(applied ? Words::tr("Your result stayed the same.") : Words::tr("Your result stays the same."));
    row->addWidget(text, 1);
    card.layout->addLayout(row);
    card.layout->addWidget(
        wrappedLabel(Words::tr("Mass and centre change by less than their last digit here."), "caption", card.frame));
    return column->addWidget(card.frame);
  }
  const QString begin = applied ? Words::tr("Your result changed:") : Words::tr("Your result changes:");
  text->setText(QStringLiteral("%1 <b>%2</b>").arg(begin.toHtmlEscaped(), change.text.toHtmlEscaped()));
  row->addWidget(text, 1);
  card.layout->addLayout(row);
  card.layout->addWidget(wrappedLabel(change.sigmas >= 0.95
                                          ? Words::tr("That is %1 times the uncertainty it was stated with.")
                                                .arg(numberText(change.sigmas, change.sigmas < 10 ? 1 : 0))
                                          : Words::tr("That is less than the uncertainty it was stated with."),
                                      "caption", card.frame));
  column->addWidget(card.frame);
}

void addMetaProposal(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report,
                     const std::function<void()>& save) {
  const nlohmann::json changes = report.metaChanges();
  if (changes.empty()) return;
  const Card card = makeCard("card", parent);
  card.frame->setProperty("role", "meta");
  card.layout->addWidget(styledLabel(Words::tr("The meta file should say this instead"), "sectionTitle", card.frame));
  QLabel* text = wrappedLabel(QString::fromStdString(changes.dump(1)), "code", card.frame);
  text->setTextInteractionFlags(Qt::TextSelectableByMouse);
  card.layout->addWidget(text);
  auto* button = new QPushButton(Words::tr("Save the corrected meta file …"), card.frame);
  button->setObjectName("saveMeta");
  button->setToolTip(
      Words::tr("Writes a copy of the meta file with these entries; later recordings then start out right."));
  QObject::connect(button, &QPushButton::clicked, parent, [save] { save(); });
  card.layout->addWidget(button, 0, Qt::AlignLeft);
  column->addWidget(card.frame);
}

void addCheck(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, const QStringList& names,
              const std::function<void(int)>& check, const std::function<void()>& open) {
  if (report.causes.empty() || (report.model.terms.empty() && !report.mistake)) return;
  column->addSpacing(4);
  column->addWidget(styledLabel(Words::tr("Does it hold on another recording?"), "sectionTitle", parent));
  if (report.check) {
    const auto& there = *report.check;
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(new LightIcon(there.holds() ? Light::measured : Light::look, 18, parent), 0, Qt::AlignTop);
    QString said = QString::fromStdString(checkText(there));
    if (!there.checked.empty())
      said +=
          " " + Words::tr("Error there: %1 → %2.").arg(newtonText(there.before.force), newtonText(there.after.force));
    QLabel* text = wrappedLabel(said, "body", parent);
    text->setProperty("role", "checked");
    row->addWidget(text, 1);
    column->addLayout(row);
  }
  int index = 0;
  for (const QString& name : names) {
    auto* button = new QPushButton(Words::tr("Check on %1").arg(name), parent);
    button->setObjectName(QStringLiteral("checkOn%1").arg(index));
    QObject::connect(button, &QPushButton::clicked, parent, [check, index] { check(index); });
    column->addWidget(button, 0, Qt::AlignLeft);
    ++index;
  }
  if (names.isEmpty()) {
    auto* button = new QPushButton(Words::tr("Open another recording of the same rig …"), parent);
    button->setObjectName("linkButton");
    QObject::connect(button, &QPushButton::clicked, parent, [open] { open(); });
    column->addWidget(button, 0, Qt::AlignLeft);
  }
}

void addNoticed(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report) {
  const Finding* told = report.verdict == Verdict::unexplained ? seenInReadings(report) : nullptr;
  bool any = false;
  for (const Finding& finding : report.findings) {
    if (&finding == told) continue;
    if (!std::exchange(any, true)) {
      column->addSpacing(4);
      column->addWidget(styledLabel(Words::tr("Also noticed"), "sectionTitle", parent));
    }
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    if (finding.severity != Severity::info) row->addWidget(new LightIcon(Light::look, 16, parent), 0, Qt::AlignTop);
    const std::string said = errorAt({}, finding.text, finding.remedy).message;
    QLabel* text = wrappedLabel(QString::fromStdString(said), "caption", parent);
    text->setProperty("role", "noticed");
    row->addWidget(text, 1);
    column->addLayout(row);
  }
}

void addConsidered(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report) {
  QStringList names;
  for (const auto& s : report.smallest) names << titleOf(s.cause);
  if (names.isEmpty()) return;
  auto* head = new QPushButton(Words::tr("Also considered: %n cause(s)", "", names.size()), parent);
  head->setObjectName("consideredButton");
  head->setProperty("role", "plain");
  head->setCheckable(true);
  auto* list = wrappedLabel(names.join(QStringLiteral(" · ")) + QStringLiteral(". ") +
                                Words::tr("None of them explains anything beyond noise."),
                            "caption", parent);
  list->hide();
  QObject::connect(head, &QPushButton::toggled, list, &QWidget::setVisible);
  column->addWidget(head);
  column->addWidget(list);
}

void addNotSeen(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, bool details) {
  const QStringList all = couldNotBeSeen(report, details ? 12 : 3);
  if (all.isEmpty()) return;
  QLabel* label =
      wrappedLabel(Words::tr("Could not have been seen: %1.").arg(all.join(QStringLiteral(", "))), "caption", parent);
  label->setProperty("role", "notSeen");
  label->setToolTip(Words::tr("The smallest size of each cause that this motion and this sensor would have shown."));
  column->addWidget(label);
}

}  // namespace heft
