#include "ui/models/result_text.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "core/base/doubts.h"
#include "core/estimation/uncertainty.h"
#include "ui/models/detail_text.h"
#include "ui/models/numbers.h"
#include "ui/models/said_now.h"
#include "ui/models/units.h"

namespace heft {
namespace {

/// Gives free functions a translation context that lupdate finds.
struct ResultWords {
  Q_DECLARE_TR_FUNCTIONS(ResultText)
};

constexpr double kOutside = 1.96;  ///< Own deviations to the edge of a 95 % interval

QString capitalised(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

NumberText number(const QString& name, double value, const Interval& interval, double scale, int mostDecimals,
                  const QString& unit, Source source, const QString& meaning) {
  NumberText out;
  const double half = 0.5 * (interval.upper - interval.lower) * scale;
  const int decimals = decimalsFor(half, mostDecimals);
  out.name = name;
  out.value = numberText(value * scale, decimals);
  out.plusMinus = QStringLiteral("± ") + numberText(std::max(half, 0.5 * std::pow(10.0, -decimals)), decimals);
  out.source = source;
  out.tip = ResultWords::tr("%1\n95 % interval: %2 to %3 %4")
                .arg(meaning, numberText(interval.lower * scale, decimals + 1),
                     numberText(interval.upper * scale, decimals + 1), unit);
  return out;
}

MassScale massScale(const EstimateReport& report, const std::optional<double>& stated) {
  MassScale scale;
  const Interval& interval = report.interval95.mass;
  const double half = 0.5 * (interval.upper - interval.lower);
  if (!std::isfinite(half)) return scale;
  double reach = std::max(8.0 * half, 0.002 * std::abs(report.payload.mass));
  if (stated) reach = std::max(reach, 1.3 * std::abs(*stated - report.payload.mass));
  reach = std::max(reach, 1e-4);
  // Ends on round numbers, so that the scale can be read.
  const double step = std::pow(10.0, std::floor(std::log10(reach)));
  const double lowest = std::max(0.0, std::floor((report.payload.mass - reach) / step) * step);
  const double highest = std::ceil((report.payload.mass + reach) / step) * step;
  const auto share = [&](double mass) { return std::clamp((mass - lowest) / (highest - lowest), 0.0, 1.0); };
  const ShownUnit unit = massUnit();
  const int decimals = std::clamp(static_cast<int>(-std::floor(std::log10(unit.scale * step))), 0, 4);
  scale.value = share(report.payload.mass);
  scale.from = share(interval.lower);
  scale.to = share(interval.upper);
  scale.lowest = numberText(unit.scale * lowest, decimals);
  scale.highest = numberText(unit.scale * highest, decimals) + QChar(' ') + unit.name;
  if (stated) scale.stated = share(*stated);
  return scale;
}

Source most(Source a, Source b) { return static_cast<int>(a) > static_cast<int>(b) ? a : b; }

QString answerText(Source mass, Source com, Source inertia) {
  if (mass == Source::data && com == Source::data && inertia == Source::data) {
    return ResultWords::tr("Mass, centre of mass and inertia: all measured.");
  }
  const struct {
    QString name;
    Source source;
  } parts[] = {
      {ResultWords::tr("mass"), mass}, {ResultWords::tr("centre"), com}, {ResultWords::tr("inertia"), inertia}};
  QStringList clauses;
  for (const Source source : {Source::data, Source::doubted, Source::prior, Source::none}) {
    QStringList names;
    for (const auto& part : parts) {
      if (part.source == source) names << part.name;
    }
    if (names.isEmpty()) continue;
    const bool several = names.size() > 1;
    const QString who = names.size() == 3 ? ResultWords::tr("%1, %2 and %3").arg(names[0], names[1], names[2])
                        : several         ? ResultWords::tr("%1 and %2").arg(names[0], names[1])
                                          : names[0];
    clauses << (source == Source::data
                    ? (several ? ResultWords::tr("%1 are measured") : ResultWords::tr("%1 is measured"))
                : source == Source::doubted
                    ? (several ? ResultWords::tr("%1 are doubtful") : ResultWords::tr("%1 is doubtful"))
                : source == Source::prior
                    ? (several ? ResultWords::tr("%1 rely on your shape") : ResultWords::tr("%1 relies on your shape"))
                    : (several ? ResultWords::tr("%1 are not fully determined by this motion")
                               : ResultWords::tr("%1 is not fully determined by this motion")))
                   .arg(who);
  }
  return capitalised(clauses.join(ResultWords::tr("; "))) + ResultWords::tr(".");
}

/// An interval far wider than any inertia of this tool says no more than its tag; the tip keeps it.
void hideHopeless(NumberText& number, const Interval& interval, double largest) {
  if (number.source != Source::none || interval.upper - interval.lower < 20.0 * largest) return;
  number.value = QString(QChar(0x2014));
  number.plusMinus.clear();
}

std::vector<NumberText> inertiaNumbers(const EstimateReport& report, double scale, const QString& unit) {
  static constexpr int kIndex[6][2] = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};
  static constexpr const char* kNames[6] = {"Ixx", "Iyy", "Izz", "Ixy", "Ixz", "Iyz"};
  const auto& id = report.identifiability.inertia;
  std::vector<NumberText> rows;
  const double largest = report.payload.inertiaCom.diagonal().cwiseAbs().maxCoeff();
  const bool productsUnknown = id[0][1] == Source::none && id[0][2] == Source::none && id[1][2] == Source::none;
  for (int k = 0; k < (productsUnknown ? 3 : 6); ++k) {
    const auto [i, j] = std::pair(kIndex[k][0], kIndex[k][1]);
    rows.push_back(number(
        QString::fromLatin1(kNames[k]), report.payload.inertiaCom(i, j), report.interval95.inertiaCom[i][j], scale, 3,
        unit, id[i][j],
        i == j ? ResultWords::tr("Resistance to rotation about the axis %1").arg(QChar("xyz"[i]))
               : ResultWords::tr("Coupling of rotations about %1 and %2").arg(QChar("xyz"[i])).arg(QChar("xyz"[j]))));
    hideHopeless(rows.back(), report.interval95.inertiaCom[i][j], largest);
  }
  if (productsUnknown) {
    NumberText widest;
    double width = -1.0;
    for (int k = 3; k < 6; ++k) {
      const Interval& interval = report.interval95.inertiaCom[kIndex[k][0]][kIndex[k][1]];
      if (interval.upper - interval.lower <= width) continue;
      width = interval.upper - interval.lower;
      const double middle = 0.5 * (interval.upper + interval.lower);
      widest = number(ResultWords::tr("Ixy, Ixz, Iyz"), middle, interval, scale, 3, unit, Source::none,
                      ResultWords::tr("Products of inertia; the widest of the three intervals"));
      hideHopeless(widest, interval, largest);
    }
    rows.push_back(widest);
  }
  return rows;
}

QString adviceText(const EstimateReport& report) {
  const auto& id = report.identifiability;
  if (!id.weakDirections.empty()) return capitalised(QString::fromStdString(id.weakDirections.front()));
  return {};
}

/// Of the precision of the result in these components (their mean), what the motion alone gives: where what was stated
/// halves a deviation, a quarter. Of the components as in Evidence.
double motionShare(const EstimateReport& report, std::initializer_list<int> components) {
  const Vector10d std = componentsOf(report.std);
  double sum = 0.0;
  for (const int k : components) {
    const double alone = report.evidence.dataStd(k);
    if (std::isfinite(alone) && alone > 0.0) sum += std::min(1.0, std::pow(std(k) / alone, 2));
  }
  return sum / static_cast<double>(components.size());
}

/// Mass, centre and inertia: what the data said, what was stated, and what became of it.
std::vector<ShareText> shareTexts(const EstimateReport& report) {
  std::vector<ShareText> rows;
  if (!report.evidence.hasPrior) return rows;
  const auto add = [&](const QString& name, double share, int first, int count, double scale, const QString& unit) {
    const bool mostlyData = share >= 0.5;
    double farthest = 0.0;
    const QString percent = numberText(100 * (mostlyData ? share : 1 - share), 0);
    QStringList lines;
    for (int k = first; k < first + count; ++k) {
      const double data = scale * report.evidence.data(k), told = scale * report.evidence.prior(k);
      const double shift = report.evidence.shift(k);
      if (std::isfinite(shift)) farthest = std::max(farthest, std::abs(shift));
      if (!std::isfinite(data) || !std::isfinite(told)) continue;
      lines << ResultWords::tr("The motion alone gives %1 %3, your shape gives %2 %3.")
                   .arg(numberText(data, 3), numberText(told, 3), unit);
      if (std::isfinite(shift)) lines << ResultWords::tr("That shifted the result by %1 σ.").arg(numberText(shift, 1));
    }
    // By more than its interval: then it is not the motion's number, whatever the widths say.
    const bool pulled = farthest > kOutside && mostlyData;
    rows.push_back({name, share,
                    pulled       ? ResultWords::tr("shifted by your shape, %1 σ").arg(numberText(farthest, 1))
                    : mostlyData ? ResultWords::tr("%1 % data").arg(percent)
                                 : ResultWords::tr("%1 % your shape").arg(percent),
                    lines.join('\n'), pulled});
  };
  const ShownUnit mass = massUnit(), length = lengthUnit();
  add(ResultWords::tr("Mass"), motionShare(report, {0}), 0, 1, mass.scale, mass.name);
  add(ResultWords::tr("Centre"), motionShare(report, {1, 2, 3}), 1, 3, length.scale, length.name);
  add(ResultWords::tr("Inertia"), motionShare(report, {4, 7, 9}), 4, 6, 1e4, ResultWords::tr("kg cm²"));
  return rows;
}

/// What a cause that is not applied would move out of its interval is not called measured.
void doubt(NumberText& number, double moved) {
  if (moved > kOutside && number.source == Source::data) number.source = Source::doubted;
}

void doubtInertia(std::vector<NumberText>& rows, const Vector10d& moved) {
  // As payloadShift() has them: xx, xy, xz, yy, yz, zz from the fifth on.
  static const std::pair<const char*, int> kPlaces[] = {{"Ixx", 4}, {"Iyy", 7}, {"Izz", 9},
                                                        {"Ixy", 5}, {"Ixz", 6}, {"Iyz", 8}};
  for (NumberText& row : rows)
    for (const auto& [name, place] : kPlaces)
      if (row.name.contains(QLatin1String(name))) doubt(row, moved(place));
}

std::vector<DetailText> knownTexts(const EstimateReport& report, const PartialPayload& known) {
  std::vector<DetailText> rows;
  if (known.mass && *known.mass > 0) {
    rows.push_back({ResultWords::tr("Mass"),
                    ResultWords::tr("%1 known, %2 % off")
                        .arg(massText(*known.mass, 3),
                             numberText(100 * std::abs(report.payload.mass - *known.mass) / *known.mass, 2)),
                    ResultWords::tr("|estimate − known| / known")});
  }
  if (known.com) {
    const double away = (report.payload.com - *known.com).norm();
    const ShownUnit length = lengthUnit();
    QString value = ResultWords::tr("%1 %2 off").arg(numberText(length.scale * away, 1 + length.decimals), length.name);
    if (known.com->norm() > 0) value += ResultWords::tr(" (%1 %)").arg(numberText(100 * away / known.com->norm(), 1));
    rows.push_back({ResultWords::tr("Centre of mass"), value,
                    ResultWords::tr("|estimate − known|, and by the length of the known")});
  }
  if (report.relativeError && report.relativeError->hasInertia) {
    rows.push_back(
        {ResultWords::tr("Inertia"),
         ResultWords::tr("%1 % off, about the sensor %2 %")
             .arg(numberText(100 * report.relativeError->inertiaCom, 1),
                  numberText(100 * report.relativeError->inertiaOrigin, 1)),
         ResultWords::tr("‖estimate − known‖ / ‖known‖, Frobenius, about the centre of mass and about the sensor’s "
                         "origin")});
  }
  return rows;
}

/// Without what is said elsewhere. What a joined estimate is of belongs to the numbers: that is returned.
QString addFindings(const EstimateReport& report, ResultText& out) {
  QString joined;
  for (const Finding& finding : report.findings) {
    if (finding.code == "joined") {  // Belongs to the numbers, not below them.
      joined = saidNow(finding.text);
      continue;
    }
    // Already said as advice.
    if (finding.code == "weak_direction" && capitalised(saidNow(finding.text)) == out.advice) continue;
    FindingText said;
    said.severity = finding.severity;
    said.text = capitalised(saidNow(finding.text));
    said.remedy = capitalised(saidNow(finding.remedy));
    said.doubt = doubtsNumbers(finding.severity, finding.code);
    said.noTrust = finding.code == "no_trust";
    if (finding.code == "shape_contradicts_data" || finding.code == "shape_left_out")
      said.leads = FindingText::Leads::shape;
    if (finding.code == "payload_change") said.leads = FindingText::Leads::object;
    out.findings.push_back(std::move(said));
    out.doubtful = out.doubtful || out.findings.back().doubt;
  }
  return joined;
}

/// Numbers that leave their intervals with causes that the reality check found, and that it did.
void doubtNumbers(const OpenQuestion& open, ResultText& out) {
  doubt(out.mass, open.moved(0));
  for (int i = 0; i < 3; ++i) doubt(out.com[static_cast<std::size_t>(i)], open.moved(1 + i));
  doubtInertia(out.inertia, open.moved);
  out.doubted = out.doubtful || !open.causes.isEmpty();
  if (!open.causes.isEmpty())
    out.findings.push_back(
        {Severity::warning,
         open.causes.size() == 1
             ? ResultWords::tr("The reality check found a cause that is not applied: %1").arg(open.causes.front())
             : ResultWords::tr("The reality check found %1 causes that are not applied: %2")
                   .arg(QString::number(open.causes.size()), open.causes.join(' ')),
         open.change.isEmpty() ? QString() : ResultWords::tr("With it: %1.").arg(open.change), true, false,
         FindingText::Leads::realityCheck});
}

/// What is wrong and what to do next, in place of numbers.
void withholdNumbers(const EstimateReport& report, ResultText& out) {
  out.withheld = true;
  out.question = ResultWords::tr("The weight cannot be determined yet.");
  out.answer = capitalised(saidNow(report.whyNoTrust));
  out.advice = capitalised(saidNow(report.whatToDo));
  std::erase_if(out.findings, [](const FindingText& finding) { return finding.noTrust; });
  const auto hide = [](NumberText& number) {
    number.value = QString(QChar(0x2014));
    number.plusMinus.clear();
    number.tip = ResultWords::tr("The readings do not determine it with this interpretation.");
    number.source = Source::none;
  };
  hide(out.mass);
  std::ranges::for_each(out.com, hide);
  std::ranges::for_each(out.inertia, hide);
  for (QString* note : {&out.massNote, &out.comNote, &out.inertiaNote}) note->clear();
  out.shares.clear();
  out.known.clear();
}

}  // namespace

QString sourceWord(Source source) {
  switch (source) {
    case Source::data:
      return ResultWords::tr("measured");
    case Source::doubted:
      return ResultWords::tr("doubtful");
    case Source::prior:
      return ResultWords::tr("from your shape");
    case Source::none:
      return ResultWords::tr("not known from this motion");
  }
  return {};
}

Source jointSource(const std::vector<NumberText>& numbers) {
  Source joint = Source::data;
  for (const NumberText& n : numbers) joint = most(joint, n.source);
  return joint;
}

ResultText describeResult(const EstimateReport& report, const KnownPayload& known, const OpenQuestion& open) {
  ResultText out;
  const PartialPayload& stated = known.payload;
  const auto& id = report.identifiability;
  const auto& interval = report.interval95;

  const ShownUnit mass = massUnit(), length = lengthUnit();
  out.mass = number(ResultWords::tr("Mass"), report.payload.mass, interval.mass, mass.scale, 4 + mass.decimals,
                    mass.name, id.mass, ResultWords::tr("Mass of the tool"));
  out.mass.plusMinus += QChar(' ') + mass.name;
  out.massScale = massScale(report, stated.mass);
  if (stated.mass && *stated.mass > 0) {
    const double away = 100.0 * std::abs(report.payload.mass - *stated.mass) / *stated.mass;
    out.massNote =
        (known.byUser ? ResultWords::tr("you entered %1, %2 % off") : ResultWords::tr("the recording has %1, %2 % off"))
            .arg(massText(*stated.mass, 3), numberText(away, 1));
  }

  double comAway = -1.0;
  if (stated.com) comAway = length.scale * (report.payload.com - *stated.com).norm();
  for (int i = 0; i < 3; ++i) {
    out.com.push_back(
        number(QString(QChar("xyz"[i])), report.payload.com(i), interval.com[i], length.scale, 1 + length.decimals,
               length.name, id.com[i],
               ResultWords::tr("Centre of mass from the sensor's origin along its axis %1").arg(QChar("xyz"[i]))));
    out.com.back().plusMinus += QChar(' ') + length.name;
  }
  if (comAway >= 0)
    out.comNote = (known.byUser ? ResultWords::tr("%1 %2 off the centre you entered")
                                : ResultWords::tr("%1 %2 off the centre that the recording states"))
                      .arg(numberText(comAway, 1 + length.decimals), length.name);

  // Small tools read better in g cm² than as 0.02 kg cm².
  const double largest = report.payload.inertiaCom.diagonal().cwiseAbs().maxCoeff();
  const bool small = largest * 1e4 < 0.5;
  out.inertiaUnit = small ? ResultWords::tr("kg mm²") : ResultWords::tr("kg cm²");
  out.inertia = inertiaNumbers(report, small ? 1e6 : 1e4, out.inertiaUnit);
  const Source comSource = jointSource(out.com), inertiaSource = jointSource(out.inertia);
  // A placeholder is not compared.
  if (report.relativeError && report.relativeError->hasInertia && inertiaSource != Source::none)
    out.inertiaNote = (known.byUser ? ResultWords::tr("%1 % off the inertia you entered")
                                    : ResultWords::tr("%1 % off the inertia that the recording states"))
                          .arg(numberText(100 * report.relativeError->inertiaCom, 1));
  const double half = 0.5 * (interval.mass.upper - interval.mass.lower);
  const int roughly = units().grams ? 3 : std::min(2, decimalsFor(half, 2));
  QString weight = massText(report.payload.mass, roughly);
  out.question = id.mass == Source::none ? ResultWords::tr("This motion does not determine the mass.")
                                         : ResultWords::tr("Your tool weighs %1.").arg(weight);
  out.answer = answerText(id.mass, comSource, inertiaSource);
  out.advice = adviceText(report);
  out.shares = shareTexts(report);
  out.known = knownTexts(report, stated);

  const QString joined = addFindings(report, out);
  doubtNumbers(open, out);
  if ((out.doubtful || out.mass.source == Source::doubted) && id.mass != Source::none)
    out.question = ResultWords::tr("Your tool seems to weigh %1.")
                       .arg(weight.replace(' ', QChar(0xA0)));  // The unit does not stand alone on the next line.
  if (out.doubtful || open.moved.maxCoeff() > kOutside)
    out.answer = ResultWords::tr("Check the warnings first: the errors may be larger than the intervals.");
  if (!joined.isEmpty()) out.answer += QChar(' ') + joined;
  std::stable_sort(out.findings.begin(), out.findings.end(), [](const FindingText& a, const FindingText& b) {
    return static_cast<int>(a.severity) > static_cast<int>(b.severity);
  });
  out.details = detailTexts(report);
  out.correlation = matrixText(report);
  for (const DetailFrame frame : {DetailFrame::sensor, DetailFrame::flange})
    out.frames.push_back(frameTexts(report, frame));
  if (report.trust == Trust::none) withholdNumbers(report, out);
  return out;
}

}  // namespace heft
