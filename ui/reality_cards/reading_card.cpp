#include "ui/reality_cards/reading_card.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <cmath>

#include "core/motion/motion.h"
#include "ui/models/numbers.h"
#include "ui/models/said_now.h"
#include "ui/models/units.h"
#include "ui/reality_cards/card_parts.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/theme/icons.h"

namespace heft {
namespace {

struct ReadingWords {
  Q_DECLARE_TR_FUNCTIONS(ReadingCard)
};

Result<Motion> motionFor(const Recording& recording, const RobotModel* robot) {
  return recording.meta.kind == RecordingKind::poses ? standingPoses(recording, robot) : motionOf(recording, robot, {});
}

/// Root mean square of one row.
double sizeOf(const MatrixXd& left, Eigen::Index channel) {
  return left.cols() > 0 ? std::sqrt(left.row(channel).squaredNorm() / static_cast<double>(left.cols())) : 0.0;
}

/// The channel whose error falls most, force before torque where both do.
Eigen::Index tellingChannel(const ReadingCurves& curves) {
  constexpr double kForceFirst = 0.7;
  Eigen::Index best = 0;
  double most = -1.0;
  for (Eigen::Index c = 0; c < 6; ++c) {
    const double before = sizeOf(curves.stated.left, c), after = sizeOf(curves.read.left, c);
    const double falls = (c < 3 ? 1.0 : kForceFirst) * (1.0 - after / std::max(1e-12, before));
    // Of those that fall alike, the largest.
    const double weight = falls * (c < 3 ? before : 10.0 * before);
    if (falls > 0.0 && weight > most) {
      most = weight;
      best = c;
    }
  }
  return best;
}

Chart chartOf(const ReadingCurves& curves, Eigen::Index channel, bool poses) {
  Chart chart;
  chart.yTitle =
      ReadingWords::tr("Error in %1 [%2]").arg(channelText(static_cast<int>(channel)), wrenchUnit(channel >= 3).name);
  if (poses) {
    chart.xTitle = ReadingWords::tr("Pose");
  } else {
    chart.xUnit = QStringLiteral("s");
  }
  const auto add = [&](const QString& name, const conventions::LeftOver& left, ChartCurve::Colour colour, bool dashed) {
    QVector<QPointF> points;
    for (std::size_t k = 0; k < left.time.size(); ++k)
      points.push_back(
          {left.time[k], wrenchUnit(channel >= 3).scale * left.left(channel, static_cast<Eigen::Index>(k))});
    chart.curves.push_back({name, colour, points, dashed});
  };
  add(ReadingWords::tr("as stated"), curves.stated, ChartCurve::Colour::before, true);
  add(ReadingWords::tr("as suggested"), curves.read, ChartCurve::Colour::after, false);
  return chart;
}

void addCurves(QVBoxLayout* column, const ReadingCurves& curves, bool poses, QWidget* parent) {
  constexpr double kClearly = 0.9;
  const Eigen::Index channel = tellingChannel(curves);
  const double before = sizeOf(curves.stated.left, channel), after = sizeOf(curves.read.left, channel);
  if (after < kClearly * before) {
    auto* chart = new ChartWidget(parent);
    chart->setChart(chartOf(curves, channel, poses), true);
    chart->setFixedHeight(130);
    chart->setProperty("role", "reading");
    chart->setAccessibleName(ReadingWords::tr("Residual of a rigid tool, as stated and as suggested"));
    column->addWidget(chart);
  } else if (curves.stated.mass < 0.0) {
    column->addWidget(wrappedLabel(
        ReadingWords::tr("As stated, the tool would weigh %1.").arg(massText(curves.stated.mass, 2)), "body", parent));
  }
}

/// A bold word before a sentence.
QLabel* said(const QString& bold, const QString& rest, QWidget* parent) {
  QLabel* label = wrappedLabel({}, "caption", parent);
  label->setTextFormat(Qt::RichText);
  label->setText(QStringLiteral("<b>%1</b> %2").arg(bold.toHtmlEscaped(), rest.toHtmlEscaped()));
  return label;
}

/// A reading and the weight to it.
QString tiedWords(const QString& sentence, const Payload& payload) {
  return QStringLiteral("%1 %2").arg(sentence, ReadingWords::tr("(%1 kg)").arg(numberText(payload.mass, 2)));
}

}  // namespace

std::optional<ReadingCurves> readingCurves(const Recording& recording, const RobotModel* robot,
                                           const DiagnosisReport& report) {
  if (!report.mistake) return std::nullopt;
  const auto right = undone(recording, robot, *report.mistake);
  if (!right) return std::nullopt;
  const auto stated = motionFor(recording, robot), read = motionFor(*right, robot);
  if (!stated || !read) return std::nullopt;
  return ReadingCurves{conventions::leftOver(conventions::questionOf(recording, *stated)),
                       conventions::leftOver(conventions::questionOf(*right, *read))};
}

bool isReading(const DiagnosisReport& report, const DiagnosedCause& cause) {
  return report.mistake && cause.direct && (cause.id == "frame_error" || cause.id == "sensor_rotation");
}

QWidget* makeReadingCard(const DiagnosisReport& report, const DiagnosedCause& cause, const ReadingCurves* curves,
                         const CardState& state, const CardActions& actions, QWidget* parent) {
  const diagnosis::FrameMistake& mistake = *report.mistake;
  const Card card = makeCard(state.next ? "cardChosen" : "card", parent);
  card.frame->setProperty("cause", QString::fromStdString(cause.id));
  card.frame->setProperty("role", "reading");
  card.layout->addWidget(makeVerdictTag(mistake.tied ? ReadingWords::tr("Several interpretations possible")
                                                     : ReadingWords::tr("Differs from the setup file"),
                                        mistake.tied ? Light::twoCauses : Light::look, false, card.frame),
                         0, Qt::AlignLeft);
  QLabel* sentence = wrappedLabel(
      mistake.tied ? tiedWords(sentenceOf(cause, report), report.after.payload) : sentenceOf(cause, report),
      "cardTitle", card.frame);
  sentence->setProperty("role", "sentence");
  card.layout->addWidget(sentence);
  if (curves && !state.applied) addCurves(card.layout, *curves, report.meta.kind == RecordingKind::poses, card.frame);
  if (!state.applied) {
    for (const auto& tie : mistake.ties)
      card.layout->addWidget(
          said(ReadingWords::tr("Fits equally well:"), tiedWords(saidNow(tie.sentence), tie.payload), card.frame));
    if (mistake.tied && !mistake.decides.empty())
      card.layout->addWidget(said(ReadingWords::tr("To decide:"), saidNow(mistake.decides), card.frame));
    card.layout->addWidget(
        said(ReadingWords::tr("Check in the driver:"), QString::fromStdString(mistake.check()), card.frame));
  }
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  if (state.applied) {
    row->addWidget(new LightIcon(Light::measured, 18, card.frame));
    row->addWidget(styledLabel(ReadingWords::tr("Applied"), "captionBold", card.frame));
    row->addStretch(1);
    auto* back = new QPushButton(ReadingWords::tr("Back to the stated conventions"), card.frame);
    back->setObjectName("plainButton");
    back->setProperty("cause", QString::fromStdString(cause.id));
    QObject::connect(back, &QPushButton::clicked, card.frame, [actions, id = cause.id] { actions.undo(id); });
    row->addWidget(back);
  } else if (mistake.tied) {
    auto* stateIt = new QPushButton(ReadingWords::tr("Set it in Robot and sensor …"), card.frame);
    stateIt->setObjectName(state.next ? "mainButton" : "acceptButton");
    stateIt->setProperty("cause", QString::fromStdString(cause.id));
    QObject::connect(stateIt, &QPushButton::clicked, card.frame, [actions] { actions.state(); });
    row->addWidget(stateIt, 1);
  } else {
    auto* read = new QPushButton(ReadingWords::tr("Use these conventions"), card.frame);
    read->setObjectName(state.next ? "mainButton" : "acceptButton");
    read->setProperty("cause", QString::fromStdString(cause.id));
    read->setToolTip(ReadingWords::tr("Applies to this session only; the file is not changed. Ctrl+Z undoes it."));
    if (state.next) read->setIcon(QIcon(iconPixmap("check", 20, Qt::white, theme().accentFill, 2.0)));
    QObject::connect(read, &QPushButton::clicked, card.frame, [actions, id = cause.id] { actions.apply(id); });
    row->addWidget(read, 1);
  }
  card.layout->addLayout(row);
  return card.frame;
}

}  // namespace heft
