#include "ui/reality_cards/cause_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "core/diagnosis/report/report.h"
#include "ui/models/numbers.h"
#include "ui/models/said_now.h"

namespace heft {

QString newtonText(double value) { return CardWords::tr("%1 N").arg(numberText(value, value < 0.1 ? 3 : 2)); }

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

QString worseText(const DiagnosedCause& cause) {
  const auto& gain = cause.gain;
  constexpr double kWorse = 1.02;
  if (gain.forceBefore > 0.0 && gain.forceAfter > kWorse * gain.forceBefore)
    return CardWords::tr("Forces fit less well with it there: %1 → %2.")
        .arg(newtonText(gain.forceBefore), newtonText(gain.forceAfter));
  if (gain.torqueBefore > 0.0 && gain.torqueAfter > kWorse * gain.torqueBefore)
    return CardWords::tr("Torques fit less well with it there: %1 → %2.")
        .arg(torqueText(gain.torqueBefore, 3), torqueText(gain.torqueAfter, 3));
  return {};
}

StrengthText strengthOf(const DiagnosedCause& cause, const DiagnosisReport& report) {
  if (cause.direct) return {CardWords::tr("seen directly"), CardWords::tr("The readings themselves show it.")};
  const double over = cause.deltaBic / std::max(1.0, report.threshold);
  StrengthText out;
  out.word = over > 3.0   ? CardWords::tr("very strong evidence")
             : over > 1.5 ? CardWords::tr("strong evidence")
                          : CardWords::tr("weak evidence");
  if (report.surrogates > 0) {
    const int alarms = std::max(0, static_cast<int>(std::lround(cause.pValue * (report.surrogates + 1))) - 1);
    out.meaning = CardWords::tr("%n false alarm(s) in %1 simulated clean runs.", "", alarms).arg(report.surrogates);
  } else {
    out.meaning = CardWords::tr("Far above what noise alone would produce.");
  }
  return out;
}

QString effectOf(const DiagnosedCause& cause) {
  // Shares of the squared error, in units of the noise.
  const double share = cause.gain.explainedFraction;
  return share > 0.5    ? CardWords::tr("large effect")
         : share > 0.15 ? CardWords::tr("moderate effect")
                        : CardWords::tr("small effect");
}

bool leavesMuch(const DiagnosisReport& report, const DiagnosedCause& cause) {
  if (cause.direct || cause.gain.blocks == 0) return false;
  constexpr double kMuch = 3.0;  // Times the noise
  const UnseenError unseen = unseenError(report, cause);
  return unseen.noise > 0.0 && unseen.after > kMuch * unseen.noise;
}

ChangeText payloadChange(const DiagnosisReport& report) {
  if (report.after.trust == Trust::none) return {{}, 0.0, {}, saidNow(report.after.whyNoTrust)};
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
        CardWords::tr("mass %1 → %2") + QChar(' ') + mass.name);
  for (int i = 0; i < 3; ++i)
    offer(moved(1 + i), shown(length, a.com(i), 1), shown(length, b.com(i), 1),
          CardWords::tr("centre %1 %2 → %3").arg(QChar('x' + i)) + QChar(' ') + length.name);
  constexpr std::array<std::array<int, 2>, 6> kPlaces{{{0, 0}, {0, 1}, {0, 2}, {1, 1}, {1, 2}, {2, 2}}};
  for (std::size_t k = 0; k < kPlaces.size(); ++k) {
    const auto [i, j] = kPlaces[k];
    // What is not known from the motion cannot be said to change.
    if (report.before.identifiability.inertia[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] == Source::none)
      continue;
    offer(moved(4 + static_cast<int>(k)), numberText(1e4 * a.inertiaCom(i, j), 1),
          numberText(1e4 * b.inertiaCom(i, j), 1),
          CardWords::tr("I%1%2 %3 → %4 kg cm²").arg(QChar('x' + i)).arg(QChar('x' + j)));
  }
  std::stable_sort(moves.begin(), moves.end(), [](const Move& x, const Move& y) { return x.sigmas > y.sigmas; });
  ChangeText out;
  for (const Move& move : moves) {
    if (out.text.isEmpty()) {
      out = {move.text, move.sigmas, {}};
    } else if (move.sigmas > kLeavesInterval) {
      out.text += CardWords::tr(", ") + move.text;
      break;
    }
  }
  const auto half = [](const Interval& interval) { return 0.5 * (interval.upper - interval.lower); };
  const double was = half(report.before.interval95.mass), is = half(report.after.interval95.mass);
  constexpr double kMuchWider = 2.0;
  if (was > 0.0 && is > kMuchWider * was)
    out.wider = CardWords::tr("mass ± %1 → ± %2")
                    .arg(shown(mass, was, decimalsFor(was, 4)), shown(mass, is, decimalsFor(is, 4))) +
                QChar(' ') + mass.name;
  return out;
}

diagnosis::TellingStretch telling(const DiagnosisReport& report, const DiagnosedCause& cause) {
  return diagnosis::tellingStretch(report.series, cause);
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

}  // namespace heft
