#include "ui/reality_panel/cause_words.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/wording/words.h"
#include "ui/models/numbers.h"

namespace heft {
namespace {

QString translated(const char* text) { return QCoreApplication::translate("heft::Causes", text); }

/// As it is set in the window: with a real minus and a curved apostrophe.
QString typeset(const std::string& words) {
  QString out = QString::fromStdString(words);
  out.replace(QLatin1Char('\''), QChar(0x2019));
  for (int at = 0; at + 1 < out.size(); ++at)
    if (out[at] == '-' && out[at + 1].isDigit() && (at == 0 || out[at - 1].isSpace())) out[at] = QChar(0x2212);
  return out;
}

}  // namespace

QString titleOf(const std::string& id) { return typeset(causeTitle(id)); }
QString titleOf(const DiagnosedCause& cause) { return typeset(causeTitle(cause)); }
QString sentenceOf(const DiagnosedCause& cause, const DiagnosisReport& report) {
  return typeset(causeSentence(cause, report.mistake));
}
QString checkOf(const DiagnosedCause& cause, const DiagnosisReport& report) {
  return typeset(causeCheck(cause, report));
}
QString checkOf(const std::string& id) { return typeset(causeCheck(id)); }
QString decidesOf(const std::string& id) { return typeset(causeDecides(id)); }
QString looksOf(const std::string& id) { return typeset(causeLooks(id)); }
QString channelText(int channel) { return typeset(channelWords(channel)); }
QString parameterTitle(const CauseParameter& parameter) { return typeset(parameterName(parameter.name)); }
QString parameterText(const CauseParameter& parameter) { return typeset(parameterWords(parameter)); }
QString goesWithText(const diagnosis::Correlate& goesWith) { return typeset(goesWith.words()); }

bool isNoiseOnly(const DiagnosisReport* report) {
  return report && (report->verdict == Verdict::clean || report->verdict == Verdict::explained);
}

void addNoise(Chart& chart, const DiagnosisReport& report, const diagnosis::Spectrum& spectrum, bool torque) {
  if (!isNoiseOnly(&report) || spectrum.frequency.size() == 0) {
    chart.band = spectrum.floor;
    return;
  }
  const VectorXd level = diagnosis::noiseLevel(report.series, torque, spectrum.frequency);
  for (Eigen::Index k = 0; k < level.size(); ++k) chart.floor.push_back({spectrum.frequency(k), level(k)});
}

std::string causeMotion(const std::string& id) { return std::string(diagnosis::infoOf(id).decidingMotion); }

QStringList couldNotBeSeen(const DiagnosisReport& report, int most) {
  QStringList out;
  const auto add = [&](const char* id, const char* shown) {
    for (const Smallest& s : report.smallest) {
      if (s.cause != id || out.size() >= most || !std::isfinite(s.value) || !(s.value > 0.0)) continue;
      const int decimals = std::clamp(static_cast<int>(std::ceil(1.0 - std::log10(s.value) - 1e-9)), 0, 5);
      out << translated(shown).arg(
          numberText(s.value, decimals) +
          (s.unit == "deg" ? QStringLiteral("°") : QStringLiteral(" ") + QString::fromStdString(s.unit)));
    }
  };
  add("payload_change", QT_TRANSLATE_NOOP("heft::Causes", "load changes under %1"));
  add("cable_pull", QT_TRANSLATE_NOOP("heft::Causes", "cables softer than %1"));
  add("time_offset", QT_TRANSLATE_NOOP("heft::Causes", "delays under %1"));
  add("gravity_tilt", QT_TRANSLATE_NOOP("heft::Causes", "tilts under %1"));
  add("bias_drift", QT_TRANSLATE_NOOP("heft::Causes", "drifts under %1"));
  add("loose_mass", QT_TRANSLATE_NOOP("heft::Causes", "loose parts under %1"));
  add("sensor_rotation", QT_TRANSLATE_NOOP("heft::Causes", "a sensor turned by less than %1"));
  add("low_pass_lag", QT_TRANSLATE_NOOP("heft::Causes", "smoothing under %1"));
  add("gain_error", QT_TRANSLATE_NOOP("heft::Causes", "wrong gains under %1"));
  add("joint_offset", QT_TRANSLATE_NOOP("heft::Causes", "joint angles off by less than %1"));
  add("constant_pull", QT_TRANSLATE_NOOP("heft::Causes", "steady pulls under %1"));
  add("lever_arm", QT_TRANSLATE_NOOP("heft::Causes", "a sensor misplaced by less than %1"));
  return out;
}

}  // namespace heft
