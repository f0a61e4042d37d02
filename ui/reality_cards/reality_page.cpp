#include "ui/reality_cards/reality_page.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/said_again.h"
#include "core/diagnosis/correction/check_on_other.h"
#include "ui/models/numbers.h"
#include "ui/models/setup_words.h"
#include "ui/reality_cards/cause_numbers.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/choice_box.h"

namespace heft {
namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(RealityPage)
};

}  // namespace

VerdictText verdictText(const DiagnosisReport& report, int applied) {
  const int total = static_cast<int>(report.causes.size());
  const int open = static_cast<int>(std::count_if(report.causes.begin(), report.causes.end(), isTied));
  const QString where = Words::tr("Differences between simulation and measurement:");
  if (report.verdict == Verdict::clean) return {Words::tr("The model fits"), Words::tr("No correction needed.")};
  if (report.verdict == Verdict::unexplained)
    return {total == 0 ? Words::tr("Something unknown") : Words::tr("%n cause(s) found, part unexplained", "", total),
            where};
  if (applied > 0 && applied == total)
    return {Words::tr("%n correction(s) applied", "", applied),
            Words::tr("Included in result, simulation and export.")};
  if (open == 0) return {Words::tr("%n cause(s) found", "", total), where};
  if (open == total)
    return {open == 1 ? Words::tr("Two causes are possible") : Words::tr("%n findings are still open", "", open),
            where};
  return {Words::tr("%n cause(s) found, ", "", total - open) + Words::tr("%n still open", "", open), where};
}

void addChange(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, int count) {
  if (report.causes.empty()) return;
  const ChangeText change = payloadChange(report);
  const bool much = change.sigmas >= 2.0 || !change.wider.isEmpty() || !change.notReliable.isEmpty();
  const bool several = report.causes.size() > 1;
  const bool applied = count > 0;
  const Card card = makeCard("cardQuiet", parent);
  card.frame->setProperty("role", "change");
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(new LightIcon(much && (!applied || !change.notReliable.isEmpty()) ? Light::look : Light::measured, 20,
                               card.frame));
  QLabel* text = wrappedLabel({}, "body", card.frame);
  text->setTextFormat(Qt::RichText);
  row->addWidget(text, 1);
  card.layout->addLayout(row);
  const auto caption = [&](const QString& words) {
    card.layout->addWidget(wrappedLabel(words, "caption", card.frame));
  };
  if (!change.notReliable.isEmpty()) {
    text->setText(Words::tr("Your result is not reliable, even with the causes corrected.").toHtmlEscaped());
    caption(change.notReliable);
  } else if (change.text.isEmpty()) {
    text->setText((applied   ? Words::tr("Your result stayed the same.")
                   : several ? Words::tr("With all causes applied your result stays the same.")
                             : Words::tr("If you apply it, your result stays the same."))
                      .toHtmlEscaped());
    caption(Words::tr("Mass, centre and inertia stay the same to the digits shown."));
  } else {
    const QString begin = applied   ? Words::tr("Your result changed:")
                          : several ? Words::tr("With all causes applied your result changes:")
                                    : Words::tr("If you apply it, your result changes:");
    text->setText(QStringLiteral("%1 <b>%2</b>").arg(begin.toHtmlEscaped(), change.text.toHtmlEscaped()));
    caption(change.sigmas >= 0.95 ? Words::tr("That is %1 times the stated uncertainty.")
                                        .arg(numberText(change.sigmas, change.sigmas < 10 ? 1 : 0))
                                  : Words::tr("That is within the stated uncertainty."));
  }
  if (!change.wider.isEmpty())
    caption(Words::tr("It becomes less certain: %1. Payload and cause are hard to distinguish with this motion.")
                .arg(change.wider));
  column->addWidget(card.frame);
}

namespace {

/// "rotation 4.8°, 0.2°, −0.1°" instead of seventeen digits of radians; entries of other kinds as name and value.
QStringList metaWords(const nlohmann::json& changes) {
  QStringList out;
  for (const auto& [key, value] : changes.items()) {
    const QString name = QString::fromStdString(key);
    if (value.is_object()) {
      out << metaWords(value);
    } else if (value.is_array() && value.size() == 3 && value[0].is_number()) {
      const bool angle = name.endsWith(QLatin1String("_rad")),
                 length = name.endsWith(QLatin1String("_m")) || name == QLatin1String("wrench_point");
      QStringList numbers;
      for (const auto& each : value) {
        const double v = each.get<double>();
        numbers << (angle ? numberText(v * 180.0 / M_PI, 1) + QStringLiteral("°")
                          : numberText(length ? 1e3 * v : v, length ? 1 : 3));
      }
      out << QStringLiteral("%1: %2%3")
                 .arg(setupWords(name).title, numbers.join(QStringLiteral(", ")),
                      length                       ? QStringLiteral(" mm")
                      : name.startsWith("gravity") ? QStringLiteral(" m/s²")
                                                   : QString());
    } else {
      const QString text = value.is_string()   ? setupAnswer(name, QString::fromStdString(value.get<std::string>()))
                           : value.is_number() ? numberText(value.get<double>(), 4)
                                               : setupAnswer(name, QString::fromStdString(value.dump()));
      out << QStringLiteral("%1: %2").arg(setupWords(name).title, text);
    }
  }
  return out;
}

}  // namespace

void addMetaProposal(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, bool details,
                     const std::function<void()>& save, const std::function<void()>& edit) {
  const nlohmann::json changes = report.metaChanges();
  if (changes.empty()) return;
  const Card card = makeCard("card", parent);
  card.frame->setProperty("role", "meta");
  card.layout->addWidget(wrappedLabel(Words::tr("Enter this under Robot and sensor"), "sectionTitle", card.frame));
  for (const QString& line : metaWords(changes)) {
    QLabel* text = wrappedLabel(line, "body", card.frame);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    card.layout->addWidget(text);
  }
  if (details) {
    QLabel* text = wrappedLabel(QString::fromStdString(changes.dump(1)), "code", card.frame);
    text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    card.layout->addWidget(text);
  }
  // One above the other: beside each other they are wider than the panel in German.
  if (edit) {
    auto* open = new QPushButton(Words::tr("Robot and sensor …"), card.frame);
    open->setObjectName("editMeta");
    QObject::connect(open, &QPushButton::clicked, parent, [edit] { edit(); });
    card.layout->addWidget(open);
  }
  auto* button = new QPushButton(Words::tr("Save as a setup file …"), card.frame);
  button->setObjectName("saveMeta");
  button->setToolTip(Words::tr("Writes a copy of the setup file with these entries, for later recordings."));
  QObject::connect(button, &QPushButton::clicked, parent, [save] { save(); });
  card.layout->addWidget(button);
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
  if (names.size() == 1) {
    auto* button = new QPushButton(Words::tr("Check on %1").arg(names.front()), parent);
    button->setObjectName("checkOn0");
    QObject::connect(button, &QPushButton::clicked, parent, [check] { check(0); });
    column->addWidget(button, 0, Qt::AlignLeft);
  } else if (!names.isEmpty()) {
    auto* row = new QHBoxLayout;
    auto* which = new ChoiceBox(parent);
    which->setObjectName("checkWhich");
    which->setAccessibleName(Words::tr("Recording to check on"));
    which->addItems(names);
    which->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    row->addWidget(which, 1);
    auto* button = new QPushButton(Words::tr("Check"), parent);
    button->setObjectName("checkOn0");
    QObject::connect(button, &QPushButton::clicked, which, [check, which] { check(which->currentIndex()); });
    row->addWidget(button);
    column->addLayout(row);
  }
  if (names.isEmpty()) {
    auto* button = new QPushButton(Words::tr("Open another recording of the same setup …"), parent);
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
    const std::string said = errorAt({}, sayAgain(finding.text), sayAgain(finding.remedy)).message;
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
  auto* head = new QPushButton(Words::tr("Also tested: %n cause(s)", "", names.size()), parent);
  head->setObjectName("consideredButton");
  head->setProperty("role", "plain");
  head->setCheckable(true);
  QString items;
  for (const QString& name : names) items += QStringLiteral("<li>%1</li>").arg(name.toHtmlEscaped());
  auto* list = wrappedLabel({}, "caption", parent);
  list->setTextFormat(Qt::RichText);
  list->setText(Words::tr("None of them explains anything beyond noise.").toHtmlEscaped() +
                QStringLiteral("<ul style=\"margin-left:-22px\">%1</ul>").arg(items));
  list->hide();
  QObject::connect(head, &QPushButton::toggled, list, &QWidget::setVisible);
  column->addWidget(head);
  column->addWidget(list);
}

void addNotSeen(QVBoxLayout* column, QWidget* parent, const DiagnosisReport& report, bool details) {
  const QStringList all = couldNotBeSeen(report, details ? 12 : 3);
  if (all.isEmpty()) return;
  QLabel* label = wrappedLabel(Words::tr("Not detectable in this recording: %1.").arg(all.join(QStringLiteral(", "))),
                               "caption", parent);
  label->setProperty("role", "notSeen");
  label->setToolTip(Words::tr("The smallest size of each cause that this motion and sensor would have revealed."));
  column->addWidget(label);
}

}  // namespace heft
