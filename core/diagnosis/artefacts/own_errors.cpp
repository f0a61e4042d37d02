#include "core/diagnosis/artefacts/own_errors.h"

#include <algorithm>

#include "core/base/say.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/search/evidence.h"
#include "core/diagnosis/wording/words.h"

namespace heft::diagnosis {

bool madeByAlignment(const Hypothesis& hypothesis, const Found& found) {
  bool all = false;
  for (const Term& term : hypothesis.search.final.model.terms) {
    const Cause& cause = *term.form->cause;
    if (cause.id() != found.cause) continue;
    all = cause.mayBeAlignment(*term.form, term.v, hypothesis.signals);
    if (!all) break;
  }
  return all;
}

bool ownErrors(const Hypothesis& hypothesis, const Found& found) {
  constexpr double kEnlarged = 3.0;  // By corners of the motion, or by what swings
  const std::string_view cause = found.cause;
  if (std::ranges::find(hypothesis.motionArtefacts, found.cause) != hypothesis.motionArtefacts.end()) return true;
  if (madeByAlignment(hypothesis, found)) return true;
  if ((lags(cause) || enlarges(cause)) && found.gain < leftByNoise(hypothesis.signals)) return true;
  double over = 0.0, enough = found.gain > 2.0 * kFaint ? 0.0 : 1.0;
  bool swings = false;
  for (const Term& term : hypothesis.search.final.model.terms) {
    const Cause& other = *term.form->cause;
    swings = swings || other.id() == ids::flexibleMount;
    if (other.id() != cause) continue;
    over += other.overOwnErrors(*term.form, term.v, hypothesis.signals);
    enough = std::max(enough, other.enoughIfPlain(*term.form));
  }
  return over < enough * (found.gain < 2.0 * kFaint || swings ? kEnlarged : 1.0);
}

void sayOwnErrors(const std::vector<Found>& own, DiagnosisReport& out) {
  const auto most = std::ranges::max_element(own, {}, &Found::gain);
  if (most == own.end() || most->gain < kOverwhelming) return;
  out.findings.push_back({Severity::info,
                          "too_small_to_name",
                          heft::say("\"{}\" would explain some of the misfit, but it is so small that Heft's own "
                                    "smoothing of the motion may cause as much. It is not reported.",
                                    causeTitle(most->cause)),
                          heft::say("No action is needed: the estimate accounts for it."),
                          {}});
}

void sayAlignment(const std::vector<DiagnosedCause>& aligned, double std, DiagnosisReport& out) {
  for (const DiagnosedCause& cause : aligned)
    out.findings.push_back(
        {Severity::info,
         "clocks_aligned",
         heft::say(
             "{} This is not attributed to the setup: Heft aligned the two clocks from the data, to within {:.1f} ms.",
             causeSentence(cause, {}), 2e3 * std),
         heft::say("To judge delays, record force and motion on one clock."),
         {}});
}

void saySmoothing(double cutoffHz, double evidence, DiagnosisReport& out) {
  if (evidence < kOverwhelming) return;
  out.findings.push_back({Severity::info,
                          "motion_smoothed",
                          heft::say("The motion was smoothed to {:.0f} Hz, since above that its accelerations are "
                                    "noisier than the sensor; faster effects cannot be checked.",
                                    cutoffHz),
                          heft::say("Record angles with more digits and at a higher rate, if the robot has them."),
                          {}});
}

}  // namespace heft::diagnosis
