#include "core/diagnosis/long_recording.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/say.h"
#include "core/base/stop.h"
#include "core/diagnosis/calibration.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/pipeline/hypothesis_search.h"
#include "core/math/linear_algebra.h"
#include "core/recording/row_at.h"
#include "core/wrench/regressor.h"

namespace heft::diagnosis {

namespace {

/// [s] Parts are as long as a demonstration that tells a payload well.
constexpr double kPart = 40.0;

/// Rows of a recording: [from, to).
struct Rows {
  Eigen::Index from = 0, to = 0;
};

/// What a search asks of them, of these rows alone.
Readings cut(const Readings& readings, const Rows& rows) {
  Readings out;
  out.mistake = readings.mistake;
  out.cleaned = excerpt(readings.cleaned, rows.from, rows.to);
  out.directs = readings.directs;
  out.cutsMost = readings.cutsMost;
  if (!readings.bad.empty()) out.bad.assign(readings.bad.begin() + rows.from, readings.bad.begin() + rows.to);
  return out;
}

Rows rowsBetween(const Recording& recording, double from, double to) {
  return {rowAt(recording.time, from), rowAt(recording.time, to)};
}

/// The kPart seconds in which payload and zero are told best by rows that may be judged.
Rows tellingPart(const Recording& recording, const Readings& readings) {
  constexpr double kStep = 5.0;        // [s] From one candidate to the next
  constexpr Eigen::Index kEvery = 20;  // Instants: motion is slow beside a tenth of a second
  const Motion& motion = readings.motion;
  Rows best;
  double most = -1e300;
  const double end = motion.time(motion.size() - 1);
  for (double from = motion.startTime; from + kPart <= end; from += kStep) {
    stopPoint();
    const Rows rows = rowsBetween(recording, from, from + kPart);
    double judged = 1.0;
    if (!readings.bad.empty()) {
      const auto bad = std::count(readings.bad.begin() + rows.from, readings.bad.begin() + rows.to, true);
      judged -= static_cast<double>(bad) / static_cast<double>(std::max<Eigen::Index>(1, rows.to - rows.from));
    }
    Eigen::Matrix<double, 16, 16> gram = Eigen::Matrix<double, 16, 16>::Identity() * 1e-9;
    const auto first = static_cast<Eigen::Index>((from - motion.startTime) * motion.rateHz);
    for (Eigen::Index k = first; k < motion.size() && motion.time(k) < from + kPart; k += kEvery) {
      Eigen::Matrix<double, 6, 16> row;
      row << Matrix6d::Identity(), regressor({motion.specificForce.col(k), motion.omega.col(k), motion.alpha.col(k)});
      gram += row.transpose() * row;
    }
    const double told = symmetricEigen(gram).values.cwiseMax(1e-300).array().log().sum() + 16.0 * std::log(judged);
    if (told <= most) continue;
    most = told;
    best = rows;
  }
  return best;
}

/// The kPart seconds in which `whole` leaves most of what it judges.
Rows worstPart(const Recording& recording, const Hypothesis& whole) {
  const Signals& signals = whole.signals;
  VectorXd left = VectorXd::Zero(signals.blocks());
  Vector6d usual = Vector6d::Constant(1e-12);
  for (Eigen::Index c = 0; c < 6; ++c) usual(c) += whole.search.final.noise.channels[static_cast<std::size_t>(c)].sigma;
  for (const Stretch& s : whole.stretches)
    for (Eigen::Index n = s.from; n < s.to; ++n)
      left(n) = whole.search.final.residual.col(n).cwiseQuotient(usual).squaredNorm();
  const auto length = std::min(signals.blocks(), static_cast<Eigen::Index>(kPart * signals.blockRate()));
  double sum = left.head(length).sum(), most = sum;
  Eigen::Index at = 0;
  for (Eigen::Index n = length; n < signals.blocks(); ++n) {
    sum += left(n) - left(n - length);
    if (sum <= most) continue;
    most = sum;
    at = n - length + 1;
  }
  return rowsBetween(recording, signals.blockTime(at), signals.blockTime(at) + kPart);
}

/// Acts from one moment on, for a while or by and by: a part may lie before it, or be too short for it.
bool takesTime(const CauseInfo& cause) {
  return cause.begins || cause.family == Family::sensorZero || cause.family == Family::load ||
         cause.family == Family::contact;
}

/// Of what acts all the time, all that no part showed nor had to compare with what it showed.
std::vector<std::string> absentFrom(const std::vector<SearchedPart>& parts) {
  std::vector<std::string> out;
  for (const auto& cause : catalogue()) {
    const auto isIt = [&](const auto& other) { return other.cause == cause->id(); };
    const bool seen = std::ranges::any_of(parts, [&](const SearchedPart& part) {
      return std::ranges::any_of(part.found.hypothesis.search.found,
                                 [&](const Found& f) { return isIt(f) || std::ranges::any_of(f.rivals, isIt); });
    });
    if (!seen && !takesTime(cause->info())) out.emplace_back(cause->id());
  }
  return out;
}

Result<SearchedPart> searchedIn(const Recording& recording, const Readings& readings, const RobotModel* robot,
                                const DiagnoseOptions& options, const Rows& rows, const Progress& progress) {
  const Recording stated = excerpt(recording, rows.from, rows.to);
  Readings there = cut(readings, rows);
  auto found = searched(stated, there, robot, options, progress);
  if (!found) return found.error();
  found->hypothesis.bank.forget();  // Of minutes a third of all memory; only the detection limits ask again
  return SearchedPart{std::move(*found), std::move(there.cleaned), {}};
}

/// Of the way from `from` to `to`.
Progress within(const Progress& progress, double from, double to) {
  return {progress.stop, [&progress, from, to](double fraction, std::string_view what) {
            progress(from + fraction * (to - from), what);
          }};
}

std::optional<Error> searchWhole(const Recording& recording, const Readings& readings, const RobotModel* robot,
                                 DiagnoseOptions options, const Progress& progress, SearchedInParts& found) {
  const auto absent = absentFrom(found.parts);
  options.hidden.insert(options.hidden.end(), absent.begin(), absent.end());
  auto whole = searchedOnWhole(recording, readings, robot, options, found.parts.front().found, progress);
  if (!whole) return whole.error();
  found.whole = std::move(*whole);
  return std::nullopt;
}

}  // namespace

Findings findingsOf(const SearchedInParts& searches) {
  const double step = 1.0 / searches.whole.hypothesis.signals.blockRate();  // [s]
  Findings out;
  for (const SearchedPart& part : searches.parts)
    out.push_back(
        {Severity::info,
         "searched_in_part",
         heft::say("All causes were searched for from {:.0f} to {:.0f} s; the rest of this long recording was checked "
                   "against the result, in steps of {:.1f} s.",
                   part.cleaned.time(0), part.cleaned.time(part.cleaned.time.size() - 1), step),
         heft::say("A brief disturbance elsewhere may go unnoticed: diagnose a recording of at most {:.0f} s of it.",
                   kLongRecording),
         {}});
  return out;
}

Result<SearchedInParts> searchedAtAnyLength(const Recording& recording, const Readings& readings,
                                            const RobotModel* robot, const DiagnoseOptions& options,
                                            const Progress& progress) {
  SearchedInParts out;
  if (recording.duration() <= kLongRecording) {
    auto found = searched(recording, readings, robot, options, progress);
    if (!found) return found.error();
    out.whole = std::move(*found);
    return out;
  }
  auto part =
      searchedIn(recording, readings, robot, options, tellingPart(recording, readings), within(progress, 0.08, 0.45));
  if (!part) return part.error();
  out.parts.push_back(std::move(*part));
  if (auto error = searchWhole(recording, readings, robot, options, within(progress, 0.45, 0.8), out)) return *error;
  return out;
}

std::optional<Error> searchWorstPart(const Recording& recording, const Readings& readings, const RobotModel* robot,
                                     const DiagnoseOptions& options, const Progress& progress, SearchedInParts& found) {
  const Rows worst = worstPart(recording, found.whole.hypothesis);
  auto part = searchedIn(recording, readings, robot, options, worst, within(progress, 0.8, 0.82));
  if (!part) return part.error();
  found.parts.push_back(std::move(*part));
  return searchWhole(recording, readings, robot, options, within(progress, 0.82, 0.85), found);
}

void unlessCausesExplainMore(const Recording& recording, const RobotModel* robot, DiagnoseOptions options,
                             const Progress& progress, Readings& readings, SearchedInParts& found) {
  // Numbers in other units have another likelihood.
  if (!readings.mistake || readings.mistake->has(conventions::Change::unit)) return;
  auto stated = readingsOf(recording, robot, options, Progress{progress.stop, {}}, true);
  if (!stated) return;
  const int surrogates = std::exchange(options.surrogates, 0);
  auto plain = searchedAtAnyLength(stated->asRead(recording), *stated, robot, options, progress);
  if (!plain || !believable(plain->whole.hypothesis.search.final)) return;
  const auto perBlock = [](const Hypothesis& of) { return of.search.final.evidence / blocksIn(of.stretches); };
  if ((perBlock(plain->whole.hypothesis) - perBlock(found.whole.hypothesis)) *
          blocksIn(found.whole.hypothesis.stretches) <
      kClearEvidence)
    return;
  if (surrogates > 0) {
    options.surrogates = surrogates;
    plain = searchedAtAnyLength(stated->asRead(recording), *stated, robot, options, progress);
    if (!plain) return;
  }
  readings = std::move(*stated);
  found = std::move(*plain);
}

}  // namespace heft::diagnosis
