#include "ui/reality_cards/cause_card.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/models/glossary.h"
#include "ui/models/numbers.h"
#include "ui/reality_cards/card_parts.h"
#include "ui/reality_cards/cause_charts.h"
#include "ui/reality_cards/cause_details.h"
#include "ui/reality_cards/cause_words.h"

namespace heft {
namespace {

/// The glossary's term for a cause; empty where its sentence says it all.
QString termOf(const std::string& cause) {
  const std::pair<const char*, const char*> terms[] = {
      {"bias_drift", "drift"},          {"sensor_bias", "bias"},       {"time_offset", "delay"},
      {"low_pass_lag", "filter"},       {"gain_error", "gain"},        {"crosstalk", "crosstalk"},
      {"coulomb_friction", "friction"}, {"hysteresis", "hysteresis"},  {"contact", "contact"},
      {"saturation", "saturation"},     {"frame_error", "conventions"}};
  for (const auto& [id, term] : terms)
    if (cause == id) return term;
  return {};
}

}  // namespace

QWidget* makeCauseCard(const DiagnosisReport& report, const DiagnosedCause& cause, const CardState& state,
                       const CardActions& actions, QWidget* parent) {
  const Card card = makeCard(state.next ? "cardChosen" : "card", parent);
  card.frame->setProperty("cause", QString::fromStdString(cause.id));
  const StrengthText strength = strengthOf(cause, report);
  const bool much = leavesMuch(report, cause);
  const QString words = cause.direct || cause.gain.blocks == 0
                            ? strength.word
                            : CardWords::tr("%1 · %2").arg(effectOf(cause), strength.word);
  card.layout->addLayout(tagRow(much
                                    ? makeVerdictTag(CardWords::tr("Explains a part"), Light::partly, false, card.frame)
                                    : makeVerdictTag(CardWords::tr("Cause found"), Light::measured, true, card.frame),
                                words, strength.meaning, card.frame));
  QLabel* sentence = wrappedLabel(sentenceOf(cause, report), "cardTitle", card.frame);
  sentence->setProperty("role", "sentence");
  sentence->setToolTip(glossaryTip(termOf(cause.id)));
  card.layout->addWidget(sentence);
  if (!state.applied && cause.before.cols() > 0) {
    auto* chart = new ChartWidget(card.frame);
    chart->setChart(errorChart(report, cause), true);
    chart->setFixedHeight(122);
    chart->setProperty("role", "unseen");
    chart->setAccessibleName(CardWords::tr("Error on a held-out segment, before and after"));
    chart->setToolTip(CardWords::tr("The model was fitted without this segment. Grey: twice the sensor’s noise."));
    card.layout->addWidget(chart);
  }
  if (cause.gain.forceBefore > 0.0) {
    const UnseenError unseen = unseenError(report, cause);
    card.layout->addWidget(makeGainBars(unseen, card.frame));
    card.layout->addWidget(
        wrappedLabel(CardWords::tr("Held-out error %1 → %2; dashed: noise floor %3.")
                         .arg(unseen.text(unseen.before), unseen.text(unseen.after), unseen.text(unseen.noise)),
                     "caption", card.frame));
  }
  if (much)
    card.layout->addWidget(wrappedLabel(
        CardWords::tr("The residual is %1 times the noise: something else contributes, or is the real cause.")
            .arg(numberText(unseenError(report, cause).after / std::max(1e-12, unseenError(report, cause).noise), 0)),
        "body", card.frame));
  if (const QString worse = worseText(cause); !worse.isEmpty() && !state.applied)
    card.layout->addWidget(wrappedLabel(worse, "caption", card.frame));
  if (!helpsUnseen(cause) && !state.applied) {
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(new LightIcon(Light::look, 18, card.frame), 0, Qt::AlignTop);
    row->addWidget(
        wrappedLabel(CardWords::tr("It fits this recording but does not improve held-out segments. Apply it only "
                                   "if a check on the robot confirms it."),
                     "body", card.frame),
        1);
    card.layout->addLayout(row);
  }
  if (!state.applied) {
    QLabel* check = boldFirst(CardWords::tr("Check on the robot:"), checkOf(cause, report), card.frame);
    card.layout->addWidget(check);
    card.layout->addWidget(
        boldFirst(strength.word.left(1).toUpper() + strength.word.mid(1) + ":", strength.meaning, card.frame));
  }
  if (cause.before.cols() > 0 && !state.applied) {
    auto* show = makeButton(CardWords::tr("Show it below the arm"), "linkButton", card.frame);
    show->setToolTip(CardWords::tr("Measured and simulated, without and with this cause, where it shows best"));
    QObject::connect(show, &QPushButton::clicked, card.frame, [actions, id = cause.id] { actions.show(id); });
    card.layout->addWidget(show, 0, Qt::AlignLeft);
  }
  addCauseButtons(card.layout, cause, state, actions, card.frame, makeCauseDetails(report, cause, card.frame));
  return card.frame;
}

QWidget* makeTieCard(const DiagnosisReport& report, const DiagnosedCause& cause, const CardState& state,
                     const CardActions& actions, QWidget* parent) {
  const Card card = makeCard(state.next ? "cardChosen" : "card", parent);
  card.frame->setProperty("cause", QString::fromStdString(cause.id));
  const bool two = cause.alternatives.size() == 1;
  card.layout->addLayout(
      tagRow(makeVerdictTag(two ? CardWords::tr("Two causes possible") : CardWords::tr("Several causes possible"),
                            Light::twoCauses, false, card.frame),
             CardWords::tr("not determined by this motion"), {}, card.frame));
  // One below the other, each with what would be seen on the robot: the same kind of sentence for all.
  const auto box = [&](const QString& title, const QString& text) {
    auto* frame = new QFrame(card.frame);
    frame->setObjectName("tieBox");
    auto* column = new QVBoxLayout(frame);
    column->setContentsMargins(10, 8, 10, 8);
    column->setSpacing(2);
    column->addWidget(wrappedLabel(title, "sectionTitle", frame));
    if (!text.isEmpty()) column->addWidget(wrappedLabel(text, "caption", frame));
    return frame;
  };
  card.layout->addWidget(wrappedLabel(sentenceOf(cause, report), "body", card.frame));
  card.layout->addWidget(box(titleOf(cause), checkOf(cause, report)));
  for (const auto& id : cause.alternatives) {
    card.layout->addWidget(styledLabel(CardWords::tr("or"), "caption", card.frame), 0, Qt::AlignHCenter);
    card.layout->addWidget(box(titleOf(id), checkOf(id)));
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(new IconLabel("bulb", 20, card.frame), 0, Qt::AlignTop);
  row->addWidget(boldFirst(CardWords::tr("To decide:"), decidesOf(cause.id), card.frame), 1);
  card.layout->addLayout(row);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  if (actions.showMotion && !causeMotion(cause.id).empty()) {
    auto* show = makeButton(CardWords::tr("Show the motion"), "showMotion", card.frame);
    show->setToolTip(CardWords::tr("The arm’s ghost shows the motion in the 3D view"));
    QObject::connect(show, &QPushButton::clicked, card.frame, [actions, id = cause.id] { actions.showMotion(id); });
    buttons->addWidget(show);
  }
  auto* record = makeButton(CardWords::tr("Record this motion"), "recordIt", card.frame);
  record->setToolTip(CardWords::tr("Goes to Record; the instruction stays visible there"));
  QObject::connect(record, &QPushButton::clicked, card.frame, [actions, id = cause.id] { actions.record(id); });
  buttons->addWidget(record);
  buttons->addStretch(1);
  card.layout->addLayout(buttons);
  card.layout->addWidget(wrappedLabel(
      CardWords::tr("“Apply” corrects the first one, “%1”, which fits slightly better.").arg(titleOf(cause)), "caption",
      card.frame));
  if (cause.gain.forceBefore > 0.0) {
    const UnseenError unseen = unseenError(report, cause);
    card.layout->addWidget(
        wrappedLabel(CardWords::tr("Either way: held-out error %1 → %2; noise floor %3.")
                         .arg(unseen.text(unseen.before), unseen.text(unseen.after), unseen.text(unseen.noise)),
                     "caption", card.frame));
  }
  addCauseButtons(card.layout, cause, state, actions, card.frame, makeCauseDetails(report, cause, card.frame));
  return card.frame;
}

}  // namespace heft
