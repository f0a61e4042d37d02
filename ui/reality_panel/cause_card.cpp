#include "ui/reality_panel/cause_card.h"

#include <QCoreApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/diagnosis/report/report.h"
#include "ui/controller/diagnosis.h"
#include "ui/models/glossary.h"
#include "ui/models/numbers.h"
#include "ui/models/said_now.h"
#include "ui/models/units.h"
#include "ui/reality_panel/cause_words.h"
#include "ui/theme/icons.h"

namespace heft {
namespace {

struct Say {
  Q_DECLARE_TR_FUNCTIONS(CauseCard)
};

/// Of forces or of torques, as the curves of the cause.
struct UnseenError {
  double before = 0.0, after = 0.0, noise = 0.0;
  bool torque = false;

  QString text(double value) const { return torque ? torqueText(value, value < 0.01 ? 4 : 3) : newtonText(value); }
};

UnseenError unseenError(const DiagnosisReport& report, const DiagnosedCause& cause) {
  const auto& gain = cause.gain;
  // Squared, in units of the noise: the share that went away.
  const auto lost = [](double before, double after, double noise) {
    return noise > 0.0 ? (before * before - after * after) / (noise * noise) : 0.0;
  };
  // Bars, curves and sentence speak of the same.
  const bool torque = cause.before.cols() > 0 ? telling(report, cause).channel >= 3
                                              : lost(gain.torqueBefore, gain.torqueAfter, report.noise.torque) >
                                                    lost(gain.forceBefore, gain.forceAfter, report.noise.force);
  if (torque) return {gain.torqueBefore, gain.torqueAfter, report.noise.torque, true};
  return {gain.forceBefore, gain.forceAfter, report.noise.force, false};
}

/// What the cause makes worse, where it makes something worse; else empty.
QString worseText(const DiagnosedCause& cause) {
  const auto& gain = cause.gain;
  constexpr double kWorse = 1.02;
  if (gain.forceBefore > 0.0 && gain.forceAfter > kWorse * gain.forceBefore)
    return Say::tr("Forces fit less well with it there: %1 → %2.")
        .arg(newtonText(gain.forceBefore), newtonText(gain.forceAfter));
  if (gain.torqueBefore > 0.0 && gain.torqueAfter > kWorse * gain.torqueBefore)
    return Say::tr("Torques fit less well with it there: %1 → %2.")
        .arg(torqueText(gain.torqueBefore, 3), torqueText(gain.torqueAfter, 3));
  return {};
}

/// Two bars and the noise floor as a dashed line.
class GainBars : public QWidget {
 public:
  GainBars(const UnseenError& unseen, QWidget* parent)
      : QWidget(parent), unseen_(unseen), before_(unseen.before), after_(unseen.after), noise_(unseen.noise) {
    setFixedHeight(46);
    setAccessibleName(Say::tr("Held-out error %1 before, %2 after, noise floor %3")
                          .arg(unseen.text(before_), unseen.text(after_), unseen.text(noise_)));
    setToolTip(Say::tr("Root mean square of the residual on segments that were not used for fitting.") +
               QStringLiteral("\n") + glossaryTip("held_out"));
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter p(this);
    p.setRenderHint(QPainter::Antialiasing);
    const Theme& t = theme();
    p.setFont(uiFont(type::kCaption));
    const QFontMetrics metrics(p.font());
    const QString words[] = {Say::tr("before"), Say::tr("after")};
    const int left = std::max(metrics.horizontalAdvance(words[0]), metrics.horizontalAdvance(words[1])) + 10;
    QFont bold = uiFont(type::kCaption, QFont::DemiBold);
    const double most = std::max({before_, after_, noise_, 1e-12}), full = width() - left - 90.0;
    const double values[] = {before_, after_};
    for (int i = 0; i < 2; ++i) {
      const double y = 4 + 22 * i;
      p.setFont(uiFont(type::kCaption));
      p.setPen(t.text2);
      p.drawText(QRectF(0, y - 2, left, 18), Qt::AlignVCenter | Qt::AlignLeft, words[i]);
      p.setPen(Qt::NoPen);
      p.setBrush(i == 0 ? t.text3 : t.accent);
      const double length = std::max(3.0, full * values[i] / most);
      p.drawRoundedRect(QRectF(left, y, length, 14), 3, 3);
      p.setPen(t.text);
      p.setFont(bold);
      p.drawText(QRectF(left + length + 8, y - 2, 90, 18), Qt::AlignVCenter | Qt::AlignLeft, unseen_.text(values[i]));
      p.setBrush(Qt::NoBrush);
    }
    QPen dash(t.text, 1.3);
    dash.setDashPattern({2.5, 2.0});
    p.setPen(dash);
    const double x = left + full * noise_ / most;
    p.drawLine(QPointF(x, 0), QPointF(x, height()));
  }

 private:
  UnseenError unseen_;
  double before_, after_, noise_;
};

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

QPushButton* makeButton(const QString& text, const char* name, QWidget* parent) {
  auto* button = new QPushButton(text, parent);
  button->setObjectName(name);
  return button;
}

QHBoxLayout* tagRow(QWidget* tag, const QString& right, const QString& tip, QWidget* parent) {
  auto* row = new QHBoxLayout;
  row->addWidget(tag);
  row->addStretch(1);
  // May break: other languages need more room.
  QLabel* word = wrappedLabel(right, "caption", parent);
  word->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  word->setToolTip(tip);
  row->addWidget(word, 3);
  return row;
}

void addDetails(QVBoxLayout* column, const DiagnosisReport& report, const DiagnosedCause& cause, QWidget* parent) {
  if (cause.before.cols() > 0) {
    auto* chart = new ChartWidget(parent);
    chart->setChart(overlayChart(report, cause), true);
    chart->setFixedHeight(140);
    chart->setAccessibleName(Say::tr("Measured, old and improved simulation on the held-out segment"));
    column->addWidget(chart);
  }
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(4);
  grid->setColumnStretch(1, 1);
  int r = 0;
  const auto add = [&](const QString& name, const QString& value, const QString& tip = {}) {
    QLabel* left = styledLabel(name, "caption", parent);
    QLabel* right = styledLabel(value, "detailValue", parent);
    right->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    right->setTextInteractionFlags(Qt::TextSelectableByMouse);
    right->setWordWrap(true);
    left->setToolTip(tip);
    right->setToolTip(tip);
    grid->addWidget(left, r, 0);
    grid->addWidget(right, r++, 1);
  };
  for (const auto& p : cause.parameters)
    add(parameterTitle(p), parameterText(p),
        Say::tr("Value and half of its 95 % interval; in files: %1").arg(QString::fromStdString(p.name)));
  for (const auto& [from, to] : cause.when)
    add(Say::tr("When"), Say::tr("%1 to %2 s").arg(numberText(from, 1), numberText(to, 1)));
  if (!cause.direct) {
    add(Say::tr("Evidence (ΔBIC)"), numberText(cause.deltaBic, 0),
        Say::tr("How much better the recording is explained, after paying for the extra numbers; under %1 nothing is "
                "named.")
            .arg(numberText(report.threshold, 1)));
    add(Say::tr("p-value"), cause.pValue < 1e-4 ? QStringLiteral("< 0.0001") : numberText(cause.pValue, 4),
        Say::tr("How often a clean recording with this motion and noise looks at least as conspicuous"));
    if (cause.gain.blocks > 0) {
      add(Say::tr("Better on"),
          Say::tr("%1 of %2 held-out segments").arg(cause.gain.blocksBetter).arg(cause.gain.blocks));
      add(Say::tr("Variance explained"),
          Say::tr("%1 % (95 %: %2 to %3 %)")
              .arg(numberText(100 * cause.gain.explainedFraction, 0), numberText(100 * cause.gain.lower, 0),
                   numberText(100 * cause.gain.upper, 0)),
          Say::tr("Share of the squared error that goes away on held-out segments"));
      add(Say::tr("Torque"),
          QStringLiteral("%1 → %2").arg(torqueText(cause.gain.torqueBefore, 4), torqueText(cause.gain.torqueAfter, 4)));
    }
  }
  add(Say::tr("ID in files"), QString::fromStdString(cause.id));
  column->addLayout(grid);
}

void addButtons(QVBoxLayout* column, const DiagnosedCause& cause, const CardState& state, const CardActions& actions,
                QWidget* parent, QWidget* details) {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  if (state.applied) {
    row->addWidget(new LightIcon(Light::measured, 18, parent));
    row->addWidget(styledLabel(Say::tr("Applied"), "captionBold", parent));
    row->addStretch(1);
    auto* undo = makeButton(Say::tr("Undo"), "plainButton", parent);
    undo->setProperty("cause", QString::fromStdString(cause.id));
    undo->setToolTip(Say::tr("Estimates the payload again, without this correction"));
    QObject::connect(undo, &QPushButton::clicked, parent, [actions, id = cause.id] { actions.undo(id); });
    row->addWidget(undo);
  } else if (state.applicable) {
    auto* apply = makeButton(state.next ? Say::tr("Apply this correction") : Say::tr("Apply"),
                             state.next ? "mainButton" : "acceptButton", parent);
    apply->setProperty("cause", QString::fromStdString(cause.id));
    apply->setToolTip(Say::tr("The cause becomes part of the model: result, prediction and export use it"));
    if (state.next) apply->setIcon(QIcon(iconPixmap("check", 20, Qt::white, theme().accentFill, 2.0)));
    QObject::connect(apply, &QPushButton::clicked, parent, [actions, id = cause.id] { actions.apply(id); });
    row->addWidget(apply, state.next ? 1 : 0);
    if (!state.next) row->addStretch(1);
  } else {
    row->addWidget(wrappedLabel(state.leftOut ? Say::tr("These segments are already excluded (see Mark).")
                                              : Say::tr("Already compensated; fix it on the robot."),
                                "caption", parent),
                   1);
  }
  auto* more = makeButton(Say::tr("Details"), state.next && !state.applied ? "secondButton" : "plainButton", parent);
  more->setCheckable(true);
  more->setChecked(state.details);
  QObject::connect(more, &QPushButton::toggled, details, &QWidget::setVisible);
  if (actions.detailsShown)
    QObject::connect(more, &QPushButton::toggled, details,
                     [actions, id = cause.id](bool on) { actions.detailsShown(id, on); });
  row->addWidget(more);
  column->addLayout(row);
  column->addWidget(details);
  details->setVisible(state.details);
}

QWidget* detailsOf(const DiagnosisReport& report, const DiagnosedCause& cause, QWidget* parent) {
  auto* out = new QWidget(parent);
  out->setProperty("role", "details");
  auto* column = new QVBoxLayout(out);
  column->setContentsMargins(0, 4, 0, 0);
  addDetails(column, report, cause, out);
  return out;
}

/// "Check on the rig: ...": bold beginning, plain rest.
QLabel* boldFirst(const QString& bold, const QString& rest, QWidget* parent) {
  QLabel* label = wrappedLabel({}, "caption", parent);
  label->setTextFormat(Qt::RichText);
  label->setText(QStringLiteral("<b>%1</b> %2").arg(bold.toHtmlEscaped(), rest.toHtmlEscaped()));
  return label;
}

QVector<QPointF> pointsOf(const DiagnosisReport& report, const VectorXd& y, double from, double to) {
  QVector<QPointF> out;
  const auto& s = report.series;
  for (Eigen::Index n = 0; n < s.time.size(); ++n) {
    if (s.time(n) < from || s.time(n) > to) continue;
    out.push_back({s.time(n), s.judged[static_cast<std::size_t>(n)] ? y(n) : std::nan("")});
  }
  return out;
}

}  // namespace

QString newtonText(double value) {
  return QCoreApplication::translate("CauseCard", "%1 N").arg(numberText(value, value < 0.1 ? 3 : 2));
}

StrengthText strengthOf(const DiagnosedCause& cause, const DiagnosisReport& report) {
  if (cause.direct) return {Say::tr("seen directly"), Say::tr("The readings themselves show it.")};
  const double over = cause.deltaBic / std::max(1.0, report.threshold);
  StrengthText out;
  out.word = over > 3.0   ? Say::tr("very strong evidence")
             : over > 1.5 ? Say::tr("strong evidence")
                          : Say::tr("weak evidence");
  if (report.surrogates > 0) {
    const int alarms = std::max(0, static_cast<int>(std::lround(cause.pValue * (report.surrogates + 1))) - 1);
    out.meaning = Say::tr("%n false alarm(s) in %1 simulated clean runs.", "", alarms).arg(report.surrogates);
  } else {
    out.meaning = Say::tr("Far above what noise alone would produce.");
  }
  return out;
}

QString effectOf(const DiagnosedCause& cause) {
  // Shares of the squared error, in units of the noise.
  const double share = cause.gain.explainedFraction;
  return share > 0.5 ? Say::tr("large effect") : share > 0.15 ? Say::tr("moderate effect") : Say::tr("small effect");
}

bool leavesMuch(const DiagnosisReport& report, const DiagnosedCause& cause) {
  if (cause.direct || cause.gain.blocks == 0) return false;
  constexpr double kMuch = 3.0;  // Times the noise
  const UnseenError unseen = unseenError(report, cause);
  return unseen.noise > 0.0 && unseen.after > kMuch * unseen.noise;
}

ChangeText payloadChange(const DiagnosisReport& report) {
  const Payload &a = report.before.payload, &b = report.after.payload;
  const Vector10d moved = payloadShift(report);
  struct Move {
    double sigmas;
    QString text;
  };
  std::vector<Move> moves;
  const auto offer = [&](double sigmas, const QString& before, const QString& after, const QString& text) {
    if (before != after) moves.push_back({sigmas, text.arg(before, after)});  // Else nothing that one could see.
  };
  const int digits = std::abs(a.mass - b.mass) < 0.01 ? 4 : std::abs(a.mass - b.mass) < 0.1 ? 3 : 2;
  const ShownUnit mass = massUnit(), length = lengthUnit();
  const auto shown = [](const ShownUnit& unit, double value, int decimals) {
    return numberText(unit.scale * value, std::max(0, decimals + unit.decimals));
  };
  offer(moved(0), shown(mass, a.mass, digits), shown(mass, b.mass, digits),
        Say::tr("mass %1 → %2") + QChar(' ') + mass.name);
  for (int i = 0; i < 3; ++i)
    offer(moved(1 + i), shown(length, a.com(i), 1), shown(length, b.com(i), 1),
          Say::tr("centre %1 %2 → %3").arg(QChar('x' + i)) + QChar(' ') + length.name);
  constexpr std::array<std::array<int, 2>, 6> kPlaces{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  for (std::size_t k = 0; k < kPlaces.size(); ++k) {
    const auto [i, j] = kPlaces[k];
    // What is not known from the motion cannot be said to change.
    if (report.before.identifiability.inertia[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] == Source::none)
      continue;
    offer(moved(4 + static_cast<int>(k)), numberText(1e4 * a.inertiaCom(i, j), 1),
          numberText(1e4 * b.inertiaCom(i, j), 1),
          Say::tr("I%1%2 %3 → %4 kg cm²").arg(QChar('x' + i)).arg(QChar('x' + j)));
  }
  std::stable_sort(moves.begin(), moves.end(), [](const Move& x, const Move& y) { return x.sigmas > y.sigmas; });
  ChangeText out;
  for (const Move& move : moves) {
    if (out.text.isEmpty()) {
      out = {move.text, move.sigmas, {}};
    } else if (move.sigmas > kLeavesInterval) {
      out.text += Say::tr(", ") + move.text;
      break;
    }
  }
  const auto half = [](const Interval& interval) { return 0.5 * (interval.upper - interval.lower); };
  const double was = half(report.before.interval95.mass), is = half(report.after.interval95.mass);
  constexpr double kMuchWider = 2.0;
  if (was > 0.0 && is > kMuchWider * was)
    out.wider =
        Say::tr("mass ± %1 → ± %2").arg(shown(mass, was, decimalsFor(was, 4)), shown(mass, is, decimalsFor(is, 4))) +
        QChar(' ') + mass.name;
  return out;
}

diagnosis::TellingStretch telling(const DiagnosisReport& report, const DiagnosedCause& cause) {
  return diagnosis::tellingStretch(report.series, cause);
}

Chart errorChart(const DiagnosisReport& report, const DiagnosedCause& cause) {
  const auto stretch = telling(report, cause);
  Chart chart;
  const bool torque = stretch.channel >= 3;
  const ShownUnit unit = wrenchUnit(torque);
  chart.yTitle = Say::tr("Error in %1 [%2]").arg(channelText(static_cast<int>(stretch.channel)), unit.name);
  chart.xUnit = QStringLiteral("s");
  chart.band = 2.0 * unit.scale * (torque ? report.noise.torque : report.noise.force);
  chart.curves.push_back(
      {Say::tr("before"), ChartCurve::Colour::before,
       pointsOf(report, unit.scale * cause.before.row(stretch.channel).transpose(), stretch.from, stretch.to), true});
  chart.curves.push_back(
      {Say::tr("after"), ChartCurve::Colour::after,
       pointsOf(report, unit.scale * cause.after.row(stretch.channel).transpose(), stretch.from, stretch.to), false});
  return chart;
}

Chart overlayChart(const DiagnosisReport& report, const DiagnosedCause& cause) {
  const auto stretch = telling(report, cause);
  const VectorXd measured = report.series.measured.row(stretch.channel).transpose();
  const ShownUnit unit = wrenchUnit(stretch.channel >= 3);
  Chart chart;
  chart.yTitle = QStringLiteral("%1 [%2]").arg(channelText(static_cast<int>(stretch.channel)), unit.name);
  chart.xTitle = Say::tr("Time [s]");
  const auto add = [&](const QString& name, ChartCurve::Colour colour, const VectorXd& y, bool dashed) {
    chart.curves.push_back({name, colour, pointsOf(report, unit.scale * y, stretch.from, stretch.to), dashed});
  };
  add(Say::tr("measured"), ChartCurve::Colour::text, measured, false);
  add(Say::tr("old model"), ChartCurve::Colour::before, measured - cause.before.row(stretch.channel).transpose(), true);
  add(Say::tr("improved"), ChartCurve::Colour::after, measured - cause.after.row(stretch.channel).transpose(), false);
  return chart;
}

QWidget* makeVerdictTag(const QString& text, Light light, bool accent, QWidget* parent) {
  auto* tag = new QFrame(parent);
  tag->setObjectName(accent                      ? "verdictAccent"
                     : light == Light::measured  ? "verdictGood"
                     : light == Light::twoCauses ? "verdictLook"
                                                 : "verdictQuiet");
  auto* row = new QHBoxLayout(tag);
  row->setContentsMargins(7, 2, 8, 2);
  row->setSpacing(6);
  if (accent) {
    auto* icon = new QLabel(tag);
    icon->setPixmap(iconPixmap("check", 14, theme().accent, theme().accentTint, 2.0));
    row->addWidget(icon);
  } else {
    row->addWidget(new LightIcon(light, 14, tag));
  }
  row->addWidget(styledLabel(text, "verdictWord", tag));
  tag->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
  tag->setAccessibleName(text);
  return tag;
}

QWidget* makeCauseCard(const DiagnosisReport& report, const DiagnosedCause& cause, const CardState& state,
                       const CardActions& actions, QWidget* parent) {
  const Card card = makeCard(state.next ? "cardChosen" : "card", parent);
  card.frame->setProperty("cause", QString::fromStdString(cause.id));
  const StrengthText strength = strengthOf(cause, report);
  const bool much = leavesMuch(report, cause);
  const QString words =
      cause.direct || cause.gain.blocks == 0 ? strength.word : Say::tr("%1 · %2").arg(effectOf(cause), strength.word);
  card.layout->addLayout(tagRow(much ? makeVerdictTag(Say::tr("Explains a part"), Light::partly, false, card.frame)
                                     : makeVerdictTag(Say::tr("Cause found"), Light::measured, true, card.frame),
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
    chart->setAccessibleName(Say::tr("Error on a held-out segment, before and after"));
    chart->setToolTip(Say::tr("The model was fitted without this segment. Grey: twice the sensor’s noise."));
    card.layout->addWidget(chart);
  }
  if (cause.gain.forceBefore > 0.0) {
    const UnseenError unseen = unseenError(report, cause);
    card.layout->addWidget(new GainBars(unseen, card.frame));
    card.layout->addWidget(
        wrappedLabel(Say::tr("Held-out error %1 → %2; dashed: noise floor %3.")
                         .arg(unseen.text(unseen.before), unseen.text(unseen.after), unseen.text(unseen.noise)),
                     "caption", card.frame));
  }
  if (much)
    card.layout->addWidget(wrappedLabel(
        Say::tr("The residual is %1 times the noise: something else contributes, or is the real cause.")
            .arg(numberText(unseenError(report, cause).after / std::max(1e-12, unseenError(report, cause).noise), 0)),
        "body", card.frame));
  if (const QString worse = worseText(cause); !worse.isEmpty() && !state.applied)
    card.layout->addWidget(wrappedLabel(worse, "caption", card.frame));
  if (!helpsUnseen(cause) && !state.applied) {
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    row->addWidget(new LightIcon(Light::look, 18, card.frame), 0, Qt::AlignTop);
    row->addWidget(wrappedLabel(Say::tr("It fits this recording but does not improve held-out segments. Apply it only "
                                        "if a check on the robot confirms it."),
                                "body", card.frame),
                   1);
    card.layout->addLayout(row);
  }
  if (!state.applied) {
    QLabel* check = boldFirst(Say::tr("Check on the robot:"), checkOf(cause, report), card.frame);
    card.layout->addWidget(check);
    card.layout->addWidget(
        boldFirst(strength.word.left(1).toUpper() + strength.word.mid(1) + ":", strength.meaning, card.frame));
  }
  if (cause.before.cols() > 0 && !state.applied) {
    auto* show = makeButton(Say::tr("Show it below the arm"), "linkButton", card.frame);
    show->setToolTip(Say::tr("Measured and simulated, without and with this cause, where it shows best"));
    QObject::connect(show, &QPushButton::clicked, card.frame, [actions, id = cause.id] { actions.show(id); });
    card.layout->addWidget(show, 0, Qt::AlignLeft);
  }
  addButtons(card.layout, cause, state, actions, card.frame, detailsOf(report, cause, card.frame));
  return card.frame;
}

QWidget* makeTieCard(const DiagnosisReport& report, const DiagnosedCause& cause, const CardState& state,
                     const CardActions& actions, QWidget* parent) {
  const Card card = makeCard(state.next ? "cardChosen" : "card", parent);
  card.frame->setProperty("cause", QString::fromStdString(cause.id));
  const bool two = cause.alternatives.size() == 1;
  card.layout->addLayout(
      tagRow(makeVerdictTag(two ? Say::tr("Two causes possible") : Say::tr("Several causes possible"), Light::twoCauses,
                            false, card.frame),
             Say::tr("not determined by this motion"), {}, card.frame));
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
    card.layout->addWidget(styledLabel(Say::tr("or"), "caption", card.frame), 0, Qt::AlignHCenter);
    card.layout->addWidget(box(titleOf(id), checkOf(id)));
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(new IconLabel("bulb", 20, card.frame), 0, Qt::AlignTop);
  row->addWidget(boldFirst(Say::tr("To decide:"), decidesOf(cause.id), card.frame), 1);
  card.layout->addLayout(row);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  if (actions.showMotion && !causeMotion(cause.id).empty()) {
    auto* show = makeButton(Say::tr("Show the motion"), "showMotion", card.frame);
    show->setToolTip(Say::tr("The arm’s ghost shows the motion in the 3D view"));
    QObject::connect(show, &QPushButton::clicked, card.frame, [actions, id = cause.id] { actions.showMotion(id); });
    buttons->addWidget(show);
  }
  auto* record = makeButton(Say::tr("Record this motion"), "recordIt", card.frame);
  record->setToolTip(Say::tr("Goes to Record; the instruction stays visible there"));
  QObject::connect(record, &QPushButton::clicked, card.frame, [actions, id = cause.id] { actions.record(id); });
  buttons->addWidget(record);
  buttons->addStretch(1);
  card.layout->addLayout(buttons);
  card.layout->addWidget(
      wrappedLabel(Say::tr("“Apply” corrects the first one, “%1”, which fits slightly better.").arg(titleOf(cause)),
                   "caption", card.frame));
  if (cause.gain.forceBefore > 0.0) {
    const UnseenError unseen = unseenError(report, cause);
    card.layout->addWidget(
        wrappedLabel(Say::tr("Either way: held-out error %1 → %2; noise floor %3.")
                         .arg(unseen.text(unseen.before), unseen.text(unseen.after), unseen.text(unseen.noise)),
                     "caption", card.frame));
  }
  addButtons(card.layout, cause, state, actions, card.frame, detailsOf(report, cause, card.frame));
  return card.frame;
}

const Finding* seenInReadings(const DiagnosisReport& report) {
  constexpr std::array<std::string_view, 11> kTelling{
      "faint_stretches", "channel_stands_still", "glitch",   "struck", "stuck_bit",
      "dead_band",       "readings_hum",         "switches", "knocks", "odd_stretches",
      "bursts"};
  const auto found = std::ranges::find_if(report.findings, [&](const Finding& finding) {
    return finding.severity == Severity::warning && std::ranges::find(kTelling, finding.code) != kTelling.end();
  });
  return found == report.findings.end() ? nullptr : &*found;
}

QWidget* makeUnknownCard(const DiagnosisReport& report, const CardActions& actions, QWidget* parent) {
  const Card card = makeCard("card", parent);
  card.frame->setProperty("role", "unknown");
  card.layout->addLayout(tagRow(makeVerdictTag(Say::tr("Something unknown"), Light::unknown, false, card.frame),
                                Say::tr("shown, not named"), {}, card.frame));
  card.layout->addWidget(
      wrappedLabel(Say::tr("The remaining error is related to %1.").arg(goesWithText(report.remaining.goesWith)),
                   "cardTitle", card.frame));
  const auto spectrum = diagnosis::spectrumOf(report.series, false);
  const Eigen::Index lines = spectrum.frequency.size();
  // What is faster than the curve reaches shows in it at a place where it is not.
  if (lines > 0 && report.remaining.lowHz < spectrum.frequency(lines - 1)) {
    Chart chart;
    chart.yTitle = Say::tr("Residual spectrum [N/√Hz]");
    chart.xTitle = Say::tr("Frequency [Hz]");
    chart.logX = chart.logY = true;
    chart.band = spectrum.floor;
    QVector<QPointF> points;
    for (Eigen::Index i = 0; i < spectrum.frequency.size(); ++i)
      points.push_back({spectrum.frequency(i), spectrum.after(i)});
    chart.curves.push_back({{}, ChartCurve::Colour::after, points, false});
    auto* widget = new ChartWidget(card.frame);
    widget->setChart(chart, false);
    widget->setFixedHeight(140);
    widget->setToolTip(Say::tr("Grey: the level of the sensor’s fast noise. What rises far above it is unexplained."));
    widget->setAccessibleName(chart.yTitle);
    card.layout->addWidget(widget);
  }
  const double share = 100.0 * std::clamp(report.remaining.share, 0.0, 1.0);
  QString band;
  if (report.remaining.highHz > report.remaining.lowHz)
    band = Say::tr(" Most of it lies between %1 and %2 Hz.")
               .arg(numberText(report.remaining.lowHz, 1), numberText(report.remaining.highHz, 1));
  else if (report.remaining.highHz > 0.0)
    band = Say::tr(" Most of it lies at %1 Hz.").arg(numberText(report.remaining.lowHz, 1));
  const QString part = share > 0.0
                           ? Say::tr("It accounts for %1 % of the residual.").arg(numberText(share, share < 10 ? 1 : 0))
                           : QString();
  card.layout->addWidget(wrappedLabel(
      (part + band + Say::tr(" No known cause explains it, so Heft neither names nor corrects it.")).trimmed(),
      "caption", card.frame));
  QString helps = Say::tr("record the same motion once more, without touching anything, and compare.");
  if (const Finding* seen = seenInReadings(report)) {
    card.layout->addWidget(wrappedLabel(saidNow(seen->text), "caption", card.frame));
    helps = saidNow(seen->remedy);
  }
  auto* row = new QHBoxLayout;
  row->addWidget(boldFirst(Say::tr("What helps:"), helps, card.frame), 1);
  auto* record = makeButton(Say::tr("Record this motion"), "plainButton", card.frame);
  QObject::connect(record, &QPushButton::clicked, card.frame, [actions] { actions.record({}); });
  row->addWidget(record);
  card.layout->addLayout(row);
  return card.frame;
}

QWidget* makeCleanCard(const DiagnosisReport& report, QWidget* parent) {
  const Card card = makeCard("card", parent);
  card.layout->addLayout(
      tagRow(makeVerdictTag(Say::tr("Model fits"), Light::measured, false, card.frame), {}, {}, card.frame));
  card.layout->addWidget(wrappedLabel(Say::tr("The remaining error is sensor noise."), "cardTitle", card.frame));
  card.layout->addWidget(wrappedLabel(Say::tr("Error %1, noise floor %2; torque %3.")
                                          .arg(newtonText(report.baseline.force), newtonText(report.noise.force),
                                               torqueText(report.baseline.torque, 4)),
                                      "caption", card.frame));
  return card.frame;
}

}  // namespace heft
