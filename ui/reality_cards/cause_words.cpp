#include "ui/reality_cards/cause_words.h"

#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/wording/unseen.h"
#include "core/diagnosis/wording/words.h"

namespace heft {
namespace {

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
  for (const std::string& phrase : couldNotBeSeen(report.smallest, most)) out << typeset(phrase);
  return out;
}

}  // namespace heft
