#include "ui/report/session_report.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "core/base/json_file.h"
#include "ui/charts/chart.h"
#include "ui/controller/entry_costs.h"
#include "ui/controller/only_child.h"
#include "ui/models/entry_text.h"
#include "ui/models/numbers.h"
#include "ui/models/proof_text.h"
#include "ui/models/result_text.h"
#include "ui/reality_cards/cause_charts.h"
#include "ui/reality_cards/cause_numbers.h"
#include "ui/reality_cards/cause_words.h"
#include "ui/reality_cards/open_question.h"
#include "ui/reality_cards/reality_page.h"
#include "ui/report/paper.h"

namespace heft {

using paper::escaped, paper::heading, paper::paragraph, paper::row, paper::table;

namespace {

struct Words {
  Q_DECLARE_TR_FUNCTIONS(SessionReport)
};

QString pictureOf(const QImage& image, const QString& what, int width = paper::kWidth) {
  QByteArray bytes;
  QBuffer buffer(&bytes);
  buffer.open(QIODevice::WriteOnly);
  image.save(&buffer, "PNG");
  return QStringLiteral("<p><img width=\"%1\" alt=\"%2\" src=\"data:image/png;base64,%3\"></p>\n")
      .arg(width)
      .arg(escaped(what), QString::fromLatin1(bytes.toBase64()));
}

QString pictureOf(const Chart& chart, int height = 190) {
  return pictureOf(chartImage(chart, {paper::kWidth, height}, themeOf(ThemeKind::light)), chart.yTitle);
}

/// Three channels of the recording against the simulation, or their difference, thinned to what a page can show.
Chart wrenchChart(const EstimateReport& report, bool torque, bool difference) {
  Chart chart;
  const auto& s = report.series;
  chart.yTitle = difference ? (torque ? Words::tr("Torque, measured minus simulated [N m]")
                                      : Words::tr("Force, measured minus simulated [N]"))
                            : (torque ? Words::tr("Torque [N m]") : Words::tr("Force [N]"));
  chart.xTitle = Words::tr("Time [s]");
  const int first = torque ? 3 : 0;
  if (difference) chart.band = 2.0 * report.noiseStd.segment<3>(first).maxCoeff();
  const Eigen::Index stride = std::max<Eigen::Index>(1, s.time.size() / 1500);
  using C = ChartCurve::Colour;
  constexpr C colours[] = {C::x, C::y, C::z};
  for (int c = 0; c < 3; ++c) {
    QVector<QPointF> measured, simulated;
    for (Eigen::Index n = 0; n < s.time.size(); n += stride) {
      const double m = s.measured(n, first + c), b = s.simulated(n, first + c);
      measured.push_back({s.time(n), difference ? m - b : m});
      simulated.push_back({s.time(n), b});
    }
    chart.curves.push_back({QString(QChar('x' + c)), colours[c], measured, false});
    if (!difference)
      chart.curves.push_back({c == 2 ? Words::tr("dashed: simulated") : QString(), C::text, simulated, true});
  }
  return chart;
}

QString labelWord(MarkLabel label) {
  return label == MarkLabel::free      ? Words::tr("free")
         : label == MarkLabel::contact ? Words::tr("contact")
                                       : Words::tr("ignored");
}

QString recordingPart(const OpenRecording& opened) {
  const Recording& r = opened.recording;
  QString rows = row({Words::tr("File"), QFileInfo(opened.path).fileName()});
  if (r.meta.kind == RecordingKind::poses)
    rows += row({Words::tr("Standing poses"), QString::number(r.rows())});
  else
    rows += row({Words::tr("Length"), Words::tr("%1 s at %2 Hz, %3 samples")
                                          .arg(numberText(r.duration(), 1), numberText(r.rateHz(), 0))
                                          .arg(r.rows())});
  if (r.meta.robot) rows += row({Words::tr("Robot"), QString::fromStdString(*r.meta.robot)});
  if (!r.meta.sensorModel.empty()) rows += row({Words::tr("Sensor"), QString::fromStdString(r.meta.sensorModel)});
  if (!r.meta.note.empty()) rows += row({Words::tr("Note"), QString::fromStdString(r.meta.note)});
  return heading(Words::tr("Recording")) + table(rows);
}

QString resultPart(Workspace& workspace, const EstimateReport& report) {
  const ResultText text = describeResult(report, knownPayload(workspace), openQuestion(workspace));
  QString out = heading(text.question) + paragraph(text.answer);
  QString rows =
      row({Words::tr("Number"), Words::tr("Value"), Words::tr("95 %"), Words::tr("Unit"), Words::tr("Source")}, true);
  // The interval's own text holds the unit where it stands beside the number.
  rows += row({Words::tr("Mass"), text.mass.value, text.mass.plusMinus, {}, sourceWord(text.mass.source)});
  for (const NumberText& n : text.com)
    rows += row({Words::tr("Centre %1").arg(n.name), n.value, n.plusMinus,
                 n.plusMinus.contains("mm") ? QString() : QStringLiteral("mm"), sourceWord(n.source)});
  for (const NumberText& n : text.inertia)
    rows += row({n.name, n.value, n.plusMinus, text.inertiaUnit, sourceWord(n.source)});
  out += table(rows);
  if (!text.known.empty()) {
    QString compared;
    for (const DetailText& d : text.known) compared += row({d.name, d.value});
    out += QStringLiteral("<h3>%1</h3>\n").arg(escaped(Words::tr("Compared with reference values"))) + table(compared);
  }
  QString details;
  for (const DetailText& d : text.details) details += row({d.name, d.value});
  const QString frames[] = {Words::tr("%1 (sensor)"), Words::tr("%1 (flange)")};
  for (std::size_t k = 0; k < text.frames.size(); ++k)
    for (const DetailText& d : text.frames[k]) details += row({frames[k].arg(d.name), d.value});
  out += QStringLiteral("<h3>%1</h3>\n").arg(escaped(Words::tr("Details"))) + table(details);
  if (!text.findings.empty()) {
    out += QStringLiteral("<h3>%1</h3>\n<ul>").arg(escaped(Words::tr("Notes")));
    for (const FindingText& f : text.findings)
      out += QStringLiteral("<li>%1</li>\n").arg(escaped((f.text + " " + f.remedy).trimmed()));
    out += QStringLiteral("</ul>\n");
  }
  return out;
}

QString entryPart(Workspace& workspace) {
  const auto cost = onlyChild<EntryCosts>(workspace)->cost();
  if (!cost) return {};
  const ControllerChoice& choice = workspace.session().controller;
  const EntryText text = describeEntry(*cost, {choice.collisionForce, choice.collisionTorque, choice.stiffness});
  QString rows;
  for (const DetailText& d : text.rows) rows += row({d.name, d.value});
  return heading(Words::tr("What the controller’s current entry costs")) +
         paragraph(text.headline + ' ' + text.consequence) + table(rows) +
         (text.note.isEmpty() ? QString() : paragraph(text.note));
}

QString proofPart(const Workspace& workspace, const EstimateReport& report) {
  const auto text = describeProof(workspace.session().proof, &report.payload);
  if (!text) return {};
  QString out = heading(Words::tr("Proof")) +
                QStringLiteral("<p><b>%1</b></p>\n").arg(escaped(QString::fromStdString(text->headline)));
  if (text->outdated) out += paragraph(Words::tr("It was made with different numbers."));
  for (const auto& reason : text->reasons)
    out += paragraph(QString::fromStdString(reason.text + ' ' + reason.remedy).trimmed());
  QStringList facts;
  for (const std::string& fact : text->facts) facts << QString::fromStdString(fact);
  return out + paragraph(facts.join(' '));
}

QString marksPart(const Workspace& workspace) {
  const auto segments = workspace.segments();
  if (segments.empty()) return {};
  QString rows = row({Words::tr("From [s]"), Words::tr("To [s]"), Words::tr("Label"), Words::tr("Reason")}, true);
  for (const Segment& s : segments)
    rows += row({numberText(s.from, 2), numberText(s.to, 2), labelWord(s.label), QString::fromStdString(s.reason)});
  return heading(Words::tr("Labelled segments")) + table(rows);
}

QString causePart(const DiagnosisReport& report, const DiagnosedCause& cause, bool applied) {
  QString out = QStringLiteral("<h3>%1</h3>\n").arg(escaped(titleOf(cause.id)));
  out += QStringLiteral("<p><b>%1</b>%2</p>\n")
             .arg(escaped(sentenceOf(cause, report)), applied ? escaped(Words::tr(" (applied)")) : QString());
  if (cause.before.cols() > 0) out += pictureOf(errorChart(report, cause), 150);
  if (cause.gain.forceBefore > 0.0)
    out += paragraph(Words::tr("Held-out error %1 → %2; noise floor %3.")
                         .arg(newtonText(cause.gain.forceBefore), newtonText(cause.gain.forceAfter),
                              newtonText(report.noise.force)));
  if (isTied(cause)) {
    QStringList names;
    for (const auto& id : cause.alternatives) names << titleOf(id);
    out += paragraph(
        Words::tr("Equally possible with this motion: %1. To decide: %2").arg(names.join(", "), decidesOf(cause.id)));
  }
  QString rows;
  for (const auto& p : cause.parameters) rows += row({parameterTitle(p), parameterText(p)});
  out += table(rows);
  out += paragraph(Words::tr("Check on the robot: %1").arg(checkOf(cause, report)));
  const StrengthText strength = strengthOf(cause, report);
  return out + paragraph(QStringLiteral("%1: %2").arg(strength.word.left(1).toUpper() + strength.word.mid(1),
                                                      strength.meaning));
}

QString diagnosisPart(const Workspace& workspace, const DiagnosisReport& report) {
  const auto& applied = workspace.corrections().causes;
  const VerdictText verdict = verdictText(report, static_cast<int>(applied.size()));
  QString out = heading(Words::tr("Reality check: %1").arg(verdict.question));
  if (report.verdict == Verdict::clean)
    out += paragraph(Words::tr("The remaining error is sensor noise: %1.").arg(newtonText(report.noise.force)));
  for (const auto& cause : report.causes)
    out += causePart(report, cause, std::find(applied.begin(), applied.end(), cause.id) != applied.end());
  if (report.verdict == Verdict::unexplained)
    out += paragraph(Words::tr("The remaining error is related to %1; no known cause accounts for it.")
                         .arg(goesWithText(report.remaining.goesWith)));
  if (!report.causes.empty()) {
    const ChangeText change = payloadChange(report);
    out += paragraph(
        !change.notReliable.isEmpty()
            ? Words::tr("The result is not reliable, even with the causes corrected: %1").arg(change.notReliable)
        : change.text.isEmpty()
            ? Words::tr("With all causes applied, mass and centre stay the same.")
            : Words::tr("With all causes applied, the result changes: %1 (%2 times its stated uncertainty).")
                  .arg(change.text, numberText(change.sigmas, 1)));
  }
  for (const bool torque : {false, true}) {
    const auto spectrum = diagnosis::spectrumOf(report.series, torque);
    if (spectrum.frequency.size() == 0) continue;
    Chart chart;
    chart.yTitle =
        torque ? Words::tr("Torque residual spectrum [N m/√Hz]") : Words::tr("Force residual spectrum [N/√Hz]");
    chart.xTitle = Words::tr("Frequency [Hz]");
    chart.logX = chart.logY = true;
    addNoise(chart, report, spectrum, torque);
    for (const bool after : {false, true}) {
      QVector<QPointF> points;
      for (Eigen::Index i = 0; i < spectrum.frequency.size(); ++i)
        points.push_back({spectrum.frequency(i), (after ? spectrum.after : spectrum.before)(i)});
      chart.curves.push_back({after ? Words::tr("causes corrected") : Words::tr("uncorrected"),
                              after ? ChartCurve::Colour::after : ChartCurve::Colour::before, points, !after});
    }
    out += pictureOf(chart, 170);
  }
  const QStringList unseen = couldNotBeSeen(report, 12);
  if (!unseen.isEmpty()) out += paragraph(Words::tr("Not detectable in this recording: %1.").arg(unseen.join(", ")));
  return out;
}

}  // namespace

QString sessionReportHtml(const ReportParts& parts) {
  Workspace& workspace = *parts.workspace;
  const auto opened = workspace.opened();
  const QString title = Words::tr("Heft report: %1").arg(opened ? QFileInfo(opened->path).fileName() : QString());
  QString out = paper::beginning(title);
  out += paragraph(Words::tr("Heft Studio %1, %2")
                       .arg(QCoreApplication::applicationVersion(),
                            QLocale().toString(QDateTime::currentDateTime(), QLocale::ShortFormat)));
  if (!opened) return out + paragraph(Words::tr("No recording is open.")) + paper::ending();
  const auto report = workspace.report();
  if (report) out += resultPart(workspace, *report) + entryPart(workspace) + proofPart(workspace, *report);
  if (!parts.view.isNull()) out += pictureOf(parts.view, Words::tr("The motion of the arm"));
  out += recordingPart(*opened);
  if (report && report->series.time.size() > 2)
    for (const bool torque : {false, true})
      for (const bool difference : {false, true})
        out += pictureOf(wrenchChart(*report, torque, difference), difference ? 140 : 190);
  out += marksPart(workspace);
  if (parts.diagnosis) out += diagnosisPart(workspace, *parts.diagnosis);
  return out + paper::ending();
}

Result<bool> writeSessionReport(const ReportParts& parts, const QString& file, bool replace) {
  const bool pdf = file.endsWith(QLatin1String(".pdf"), Qt::CaseInsensitive);
  if (!pdf && !file.endsWith(QLatin1String(".html"), Qt::CaseInsensitive))
    return Error{Words::tr("%1: the name of a report must end in .html or .pdf.").arg(file).toStdString()};
  if (!replace && QFileInfo::exists(file))
    return Error{Words::tr("%1 already exists and was not overwritten.").arg(file).toStdString()};
  const QString html = sessionReportHtml(parts);
  if (!pdf) return writeTextFile(file.toStdString(), html.toStdString());
  return writeTextFile(file.toStdString(), paper::pdf(html, Words::tr("Heft report")).toStdString());
}

}  // namespace heft
