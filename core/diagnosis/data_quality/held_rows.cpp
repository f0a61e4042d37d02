#include "core/diagnosis/data_quality/held_rows.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/diagnosis/calibration.h"
#include "core/math/statistics.h"
#include "core/motion/resample.h"
#include "core/recording/wrench_runs.h"

namespace heft::diagnosis {

namespace {

template <class Series>
bool repeats(const Series& series, Eigen::Index row) {
  return series.rows() == 0 || series.row(row) == series.row(row - 1);
}

/// Rows of a series from those at `at`, by Lagrange's polynomial in time.
template <class Series>
void fill(Series& series, const VectorXd& time, const Held& rows, const std::array<Eigen::Index, 4>& at) {
  if (series.rows() == 0) return;
  for (Eigen::Index i = rows.from; i < rows.to; ++i) interpolate(at, time(i), time, series, series.row(i));
}

bool motionRepeats(const Recording& recording, Eigen::Index row) {
  return repeats(recording.q, row) && repeats(recording.position, row) && repeats(recording.quaternion, row);
}

bool stoodStill(const Recording& recording, const Held& rows) {
  for (Eigen::Index i = rows.from; i < rows.to; ++i)
    if (!motionRepeats(recording, i)) return false;
  return true;
}

/// How far the motion goes from the row before to this one: angles [rad], or position [m] and twice the quaternion.
double stepTo(const Recording& recording, Eigen::Index row) {
  const auto step = [&](const auto& series) {
    return series.rows() == 0 ? 0.0 : (series.row(row) - series.row(row - 1)).norm();
  };
  return step(recording.q) + step(recording.position) + 2.0 * step(recording.quaternion);
}

/// Whether the motion makes up at once, at row `to`, for the rows that it stood still before, as it goes on beside
/// them.
bool makesUp(const Recording& recording, Eigen::Index from, Eigen::Index to) {
  const Eigen::Index length = to - from, reach = 3 * length;
  std::vector<double> steps;
  Eigen::Index moves = 0;
  const auto take = [&](Eigen::Index row) {
    steps.push_back(stepTo(recording, row));
    moves += motionRepeats(recording, row) ? 0 : 1;
  };
  for (Eigen::Index i = std::max<Eigen::Index>(1, from - reach); i < from; ++i) take(i);
  for (Eigen::Index i = to + 1; i < std::min(recording.rows(), to + 1 + reach); ++i) take(i);
  return static_cast<double>(moves) > kLargeShare * static_cast<double>(steps.size()) &&
         stepTo(recording, to) > kMajority * static_cast<double>(length + 1) * median(std::move(steps));
}

}  // namespace

std::vector<Held> heldRows(const Recording& recording) {
  const auto runs = wrenchRuns(recording.wrench);
  const double usual = static_cast<double>(recording.rows()) / std::max(1.0, static_cast<double>(runs.size()));
  std::vector<Held> out;
  Eigen::Index count = 0;
  for (const auto& [from, to] : runs) {
    const double lasts = recording.time(to - 1) - recording.time(from);
    if (lasts < kShortestGap || static_cast<double>(to - from) < kStandsOut * usual) continue;
    Held run{from + 1, to};
    run.motionToo = stoodStill(recording, run);
    out.push_back(run);
    count += run.to - run.from;
  }
  if (static_cast<double>(count) > kMinorShare * static_cast<double>(recording.rows())) out.clear();
  return out;
}

Runs motionHolds(const Recording& recording) {
  constexpr double kShortest = 0.0039;  // [s], share of the rows
  constexpr Eigen::Index kFewest = 2;
  const Eigen::Index rows = recording.rows();
  Runs out;
  Eigen::Index count = 0;
  for (Eigen::Index from = 1; from < rows; ++from) {
    Eigen::Index to = from;
    bool readingsToo = true;
    while (to < rows && motionRepeats(recording, to)) readingsToo = repeats(recording.wrench, to++) && readingsToo;
    if (to == from) continue;
    if (to < rows && to - from >= kFewest && recording.time(to) - recording.time(from) >= kShortest && !readingsToo &&
        makesUp(recording, from, to)) {
      out.emplace_back(from, to);
      count += to - from;
    }
    from = to;
  }
  if (static_cast<double>(count) > kTinyShare * static_cast<double>(rows)) out.clear();
  return out;
}

Runs staleRuns(const Recording& recording) {
  const auto runs = wrenchRuns(recording.wrench);
  Vector6d still = Vector6d::Zero();
  Runs out;
  Eigen::Index stale = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const auto& [from, to] = runs[k];
    const bool last = k + 1 == runs.size();
    const Vector6d moved = last ? Vector6d::Ones()
                                : (recording.wrench.row(to).array() != recording.wrench.row(from).array())
                                      .cast<double>()
                                      .matrix()
                                      .transpose()
                                      .eval();
    if (!last) still += Vector6d::Ones() - moved;
    if (to - from < 2 || moved.sum() < 4.0) continue;
    out.emplace_back(from + 1, to);
    stale += to - from - 1;
  }
  // Coarse or smoothed readings stand still on all channels at once by chance, too.
  const double byChance = (still / std::max(1.0, static_cast<double>(runs.size()) - 1.0)).prod();
  if (static_cast<double>(stale) < 3.0 * static_cast<double>(recording.rows()) * byChance) out.clear();
  return out;
}

Runs zeroRuns(const Recording& recording) {
  Runs out;
  Eigen::Index count = 0;
  for (const auto& [from, to] : wrenchRuns(recording.wrench)) {
    if (!recording.wrench.row(from).isZero(0.0)) continue;
    out.emplace_back(from, to);
    count += to - from;
  }
  if (std::cmp_less(count, kAgainAndAgain)) out.clear();
  return out;
}

void refresh(Recording& cleaned, const Recording& recording, Runs stale, const std::vector<Held>& notJudged) {
  // Across more than that, a hand's tremor is guessed: then readings had better be late.
  std::erase_if(stale, [&](const auto& run) {
    return stoodStill(recording, {run.first, run.second}) ||
           std::ranges::any_of(notJudged, [&](const Held& held) { return held.from == run.first; });
  });
  double sum = 0.0, squares = 0.0;
  for (const auto& [from, to] : stale) {
    const double lasts = recording.time(to - 1) - recording.time(from - 1);
    sum += lasts;
    squares += lasts * lasts;
  }
  if (squares > kShortestGap * sum) return;
  std::vector<bool> old(static_cast<std::size_t>(recording.rows()), false);
  for (const auto& [from, to] : stale) std::fill(old.begin() + from, old.begin() + to, true);
  const VectorXd& time = cleaned.time;
  // The fresh row nearest to `at` on the way on from `row`, or none.
  const auto freshBeyond = [&](Eigen::Index row, Eigen::Index step, double at) {
    const double way = static_cast<double>(step);
    while (row >= 0 && row < time.size() && (old[static_cast<std::size_t>(row)] || way * (time(row) - at) < 0.0))
      row += step;
    return row;
  };
  for (const auto& [from, to] : stale) {
    if (to == time.size()) continue;
    // As far away as the reading was held: slopes between close rows are mostly noise.
    const double lasted = time(to) - time(from - 1);
    const Eigen::Index before = freshBeyond(from - 2, -1, time(from - 1) - lasted),
                       behind = freshBeyond(to + 1, 1, time(to) + lasted);
    if (before < 0 || behind >= time.size())
      straightOver({{from, to}}, time, cleaned.wrench);
    else
      fill(cleaned.wrench, time, {from, to}, {before, from - 1, to, behind});
  }
}

void bridge(Recording& recording, const std::vector<Held>& held, const Runs& motionHeld) {
  std::vector<Held> all = held;
  for (const auto& [from, to] : motionHeld) all.push_back({from, to, true});
  for (const Held& rows : all) {
    // As far away as the gap is long: slopes between close rows are mostly noise.
    const Eigen::Index away = rows.to - rows.from;
    if (!rows.motionToo || rows.from <= away || rows.to + away >= recording.rows()) continue;
    const std::array<Eigen::Index, 4> at{rows.from - 1 - away, rows.from - 1, rows.to, rows.to + away};
    fill(recording.q, recording.time, rows, at);
    fill(recording.dq, recording.time, rows, at);
    fill(recording.position, recording.time, rows, at);
    fill(recording.twist, recording.time, rows, at);
    fill(recording.accelerometer, recording.time, rows, at);
    fill(recording.gyroscope, recording.time, rows, at);
    if (!recording.hasOrientation()) continue;
    fill(recording.quaternion, recording.time, rows, at);
    for (Eigen::Index i = rows.from; i < rows.to; ++i) recording.quaternion.row(i).normalize();
  }
}

}  // namespace heft::diagnosis
