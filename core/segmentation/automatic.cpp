#include <algorithm>
#include <cmath>

#include "core/base/say.h"
#include "core/base/time_span.h"
#include "core/math/statistics.h"
#include "core/segmentation/blocks.h"
#include "core/segmentation/payload_change.h"
#include "core/segmentation/sensor_trouble.h"
#include "core/segmentation/user_marks.h"

namespace heft {

namespace {

constexpr int kFirstStarts = 60;       // random starts of the first fit; each costs a few small factorisations
constexpr double kOuter = 6.0;         // scatter multiples that open a contact,
constexpr double kInner = 3.5;         // and those that end it
constexpr double kOuterAllowed = 2.0;  // but never less than so many allowances
constexpr double kInnerAllowed = 1.0;
constexpr double kMargin = 0.06;     // [s] kept away from a contact on both sides
constexpr double kShortest = 0.05;   // [s] shorter excursions are spikes, which the robust fit handles
constexpr double kSliver = 0.1;      // [s]
constexpr double kTransition = 0.1;  // [s] on both sides of a payload change, which has no sharp moment
constexpr double kRest = 0.5;        // [s] that the tool must keep still to count as standing
constexpr double kBrief = 0.3;       // [s]
constexpr std::size_t kFewestWindows = 10;

void scoreBlocks(const WrenchRows& rows, const FitVector& x, const Vector6d& allowed, Range range,
                 SegmentBlocks& blocks) {
  const auto residual = residualOf(rows, x);
  Vector6d inner, outer;
  for (int c = 0; c < 6; ++c) {
    std::vector<double> values;
    for (Eigen::Index k = range.from; k < range.to; ++k)
      if (blocks.labels[at(k)] == MarkLabel::free) values.push_back(residual(c, k));
    const double scatter = robustStd(values);
    inner(c) = std::max(kInner * scatter, kInnerAllowed * allowed(c));
    outer(c) = std::max(kOuter * scatter, kOuterAllowed * allowed(c));
  }
  for (Eigen::Index k = range.from; k < range.to; ++k) {
    const Vector6d size = residual.col(k).cwiseAbs();
    // 1 at the inner limit, 2 at the outer one.
    const double in = size.cwiseQuotient(inner).maxCoeff(), out = size.cwiseQuotient(outer).maxCoeff();
    blocks.scores(k) = out >= 1.0 ? 2.0 * out : std::min(in, 1.999);
  }
}

/// Contact where the score passes 2, grown while it stays above 1, widened by kMargin, spikes left out.
void labelFromScores(double rateHz, Range range, SegmentBlocks& blocks) {
  for (Eigen::Index k = range.from; k < range.to; ++k)
    if (blocks.labels[at(k)] == MarkLabel::contact) blocks.set(k, MarkLabel::free, SegmentKind::freeMotion);
  const auto margin = static_cast<Eigen::Index>(std::ceil(kMargin * rateHz));
  const auto shortest = static_cast<Eigen::Index>(std::ceil(kShortest * rateHz));
  const auto above = [&](Eigen::Index k) { return k < range.to && blocks.scores(k) >= 1.0; };
  for (Eigen::Index k = range.from; k < range.to; ++k) {
    if (!above(k)) continue;
    Eigen::Index end = k;
    double peak = 0.0;
    // Two blocks below the inner limit end the stretch; one may be a zero crossing.
    for (Eigen::Index j = k; above(j) || (j < range.to && above(j + 1)); ++j) {
      end = j;
      peak = std::max(peak, blocks.scores(j));
    }
    if (peak >= 2.0 && end - k + 1 >= shortest)
      for (Eigen::Index j = std::max(range.from, k - margin); j <= std::min(range.to - 1, end + margin); ++j)
        if (blocks.labels[at(j)] == MarkLabel::free) blocks.set(j, MarkLabel::contact, SegmentKind::contact);
    k = end;
  }
}

/// Free motion for less than kSliver between two contacts is none.
void closeSlivers(double rateHz, Range range, SegmentBlocks& blocks) {
  const auto longest = static_cast<Eigen::Index>(std::floor(kSliver * rateHz));
  Eigen::Index lastContact = -1;
  for (Eigen::Index k = range.from; k < range.to; ++k) {
    if (blocks.labels[at(k)] != MarkLabel::contact) continue;
    if (lastContact >= 0 && k - lastContact - 1 <= longest)
      for (Eigen::Index j = lastContact + 1; j < k; ++j)
        if (blocks.labels[at(j)] == MarkLabel::free) blocks.set(j, MarkLabel::contact, SegmentKind::contact);
    lastContact = k;
  }
}

/// Labels the blocks of one payload, alternating with the fit; x is the robust start.
void labelPart(const WrenchRows& rows, const FitWindows& windows, const Vector6d& allowed, const FitPrior& prior,
               PayloadPart& part, Range range, SegmentBlocks& blocks) {
  for (int round = 0; round < 4; ++round) {
    const auto before = blocks.labels;
    scoreBlocks(rows, part.x, allowed, range, blocks);
    labelFromScores(rows.rateHz, range, blocks);
    closeSlivers(rows.rateHz, range, blocks);
    WindowMatrix sum = WindowMatrix::Zero();
    std::vector<std::size_t> free;
    for (std::size_t w = part.from; w < part.to; ++w) {
      const auto first = blocks.labels.begin() + static_cast<std::ptrdiff_t>(w) * windows.length;
      if (!std::all_of(first, first + windows.length, [](MarkLabel l) { return l == MarkLabel::free; })) continue;
      sum += windows.matrices[w];
      free.push_back(w);
    }
    if (free.size() >= 5) part.free = free;
    if (blocks.labels == before || free.size() < 5) break;
    part.x = solveNormal(sum, prior);
  }
}

/// Contiguous blocks around k that are contact.
Range contactAround(const SegmentBlocks& blocks, Eigen::Index k) {
  const auto touching = [&](Eigen::Index j) { return blocks.labels[at(j)] == MarkLabel::contact; };
  Range range{k, k};
  while (range.from > 0 && touching(range.from - 1)) --range.from;
  while (range.to < static_cast<Eigen::Index>(blocks.labels.size()) && touching(range.to)) ++range.to;
  return range;
}

/// Leaves out the parts whose payload is not that of the reference part, and names the changes.
void chooseParts(const WrenchRows& rows, const FitWindows& windows, const std::vector<PayloadPart>& parts,
                 const std::vector<Range>& ranges, std::size_t reference, SegmentBlocks& blocks, Findings& findings) {
  std::vector<PayloadStep> steps;
  for (const auto& part : parts) steps.push_back(compareParts(windows, parts[reference], part, weakPrior()));
  steps[reference] = {};
  std::vector<std::string> changes, used;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const double from = rows.time(ranges[p].from), to = rows.time(ranges[p].to - 1);
    if (steps[p].same) {
      used.push_back(timeSpan(from, to));
    } else {
      const int note = blocks.addReason(
          !steps[p].payload ? heft::say("Free, but with a different sensor bias or payload.")
          : steps[p].massStep > 0.0
              ? heft::say("Free, but {:.2g} kg heavier than where the payload is estimated.", steps[p].massStep)
              : heft::say("Free, but {:.2g} kg lighter than where the payload is estimated.", -steps[p].massStep));
      for (Eigen::Index k = ranges[p].from; k < ranges[p].to; ++k)
        if (blocks.labels[at(k)] == MarkLabel::free) blocks.set(k, MarkLabel::ignore, SegmentKind::otherPayload, note);
    }
    if (p == 0 || steps[p].same == steps[p - 1].same) continue;
    const double step = (steps[p].same ? 0.0 : steps[p].massStep) - (steps[p - 1].same ? 0.0 : steps[p - 1].massStep);
    const bool payload = (steps[p].same || steps[p].payload) && (steps[p - 1].same || steps[p - 1].payload);
    changes.push_back(payload ? heft::say("{:+.2g} kg at {:.1f} s", step, from)
                              : heft::say("at {:.1f} s, or the sensor's bias moved there", from));
    const SegmentKind kind = step > 0.0 ? SegmentKind::pickUp : SegmentKind::putDown;
    const int note = blocks.addReason(
        !payload     ? heft::say("The payload changes here, or the sensor's bias moves: this motion cannot show which.")
        : step > 0.0 ? heft::say("The payload grows by {:.2g} kg: something was picked up.", step)
                     : heft::say("The payload shrinks by {:.2g} kg: something was put down.", -step));
    const auto half = static_cast<Eigen::Index>(std::ceil(kTransition * rows.rateHz));
    const Range first = contactAround(blocks, std::max<Eigen::Index>(0, ranges[p].from - half));
    const Range last = contactAround(blocks, std::min(rows.size() - 1, ranges[p].from + half));
    for (Eigen::Index k = std::min(first.from, ranges[p].from - half);
         k < std::max(last.to, std::min(rows.size(), ranges[p].from + half)); ++k)
      if (k >= 0) blocks.set(k, MarkLabel::contact, kind, note);
  }
  if (!changes.empty())
    findings.push_back({Severity::warning,
                        "payload_change",
                        heft::say("The payload changes inside the recording ({}); only {} is used, so that two "
                                  "payloads are not mixed.",
                                  joined(changes), joined(used)),
                        heft::say("To estimate the other payload, mark its part as free."),
                        {}});
}

/// What is free with hardly any motion.
void markStanding(const WrenchRows& rows, SegmentBlocks& blocks) {
  const auto window = static_cast<Eigen::Index>(std::ceil(kRest * rows.rateHz));
  if (rows.size() < window) return;
  std::vector<char> still(at(rows.size()), 0);
  // Column 0 of the regressor is the specific force; the trace of the next three columns' upper block is -2 |omega|^2.
  const auto force = [&](Eigen::Index k) { return Vector3d(rows.Y[at(k)].block<3, 1>(0, 0)); };
  const Eigen::Index half = window / 2, stride = std::max<Eigen::Index>(1, window / 4);
  for (Eigen::Index next = 0; next < rows.size() - window + stride; next += stride) {
    const Eigen::Index from = std::min(next, rows.size() - window);
    Vector3d first = Vector3d::Zero(), second = Vector3d::Zero();
    double turning = 0.0;
    for (Eigen::Index k = from; k < from + window; ++k) {
      (k < from + half ? first : second) += force(k);
      turning += std::max(0.0, -0.5 * rows.Y[at(k)].block<3, 3>(0, 1).trace());
    }
    first /= static_cast<double>(half);
    second /= static_cast<double>(window - half);
    const double omega = std::sqrt(turning / static_cast<double>(window));
    if ((second - first).norm() < 0.15 && omega < 0.08)
      std::fill(still.begin() + from, still.begin() + from + window, char{1});
  }
  for (Eigen::Index k = 0; k < rows.size(); ++k)
    if (still[at(k)] != 0 && blocks.kinds[at(k)] == SegmentKind::freeMotion)
      blocks.kinds[at(k)] = SegmentKind::standing;
  // Rest or motion for a moment only is that of its free neighbour.
  const auto brief = static_cast<Eigen::Index>(kBrief * rows.rateHz);
  const auto isFree = [&](Eigen::Index k) {
    return k >= 0 && k < rows.size() && blocks.labels[at(k)] == MarkLabel::free;
  };
  for (Eigen::Index from = 0, to = 0; from < rows.size(); from = to) {
    to = from + 1;
    while (to < rows.size() && isFree(to) && blocks.kinds[at(to)] == blocks.kinds[at(from)]) ++to;
    if (!isFree(from) || to - from > brief || (!isFree(from - 1) && !isFree(to))) continue;
    const SegmentKind kind = blocks.kinds[at(isFree(from - 1) ? from - 1 : to)];
    std::fill(blocks.kinds.begin() + from, blocks.kinds.begin() + to, kind);
  }
}

/// A long stretch that one payload does not explain may be another payload between two parts of the first: picked up
/// and put down again. Cuts the one part there.
void splitAtStretches(const WrenchRows& rows, const FitWindows& windows, const Vector6d& allowed,
                      const std::vector<char>& usable, std::vector<PayloadPart>& parts, std::vector<Range>& ranges,
                      SegmentBlocks& blocks) {
  const PayloadPart whole = parts.front();
  const auto pieceOf = [&](Range range) {
    PayloadPart piece{static_cast<std::size_t>((range.from + windows.length - 1) / windows.length),
                      static_cast<std::size_t>(range.to / windows.length),
                      whole.x,
                      {}};
    for (const std::size_t w : whole.free)
      if (w >= piece.from && w < piece.to) piece.free.push_back(w);
    return piece;
  };
  std::vector<PayloadPart> cutParts;
  std::vector<Range> cutRanges;
  Eigen::Index done = 0;
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    if (blocks.labels[at(k)] != MarkLabel::contact) continue;
    const Range stretch = contactAround(blocks, k);
    k = stretch.to;
    PayloadPart inner = pieceOf(stretch);
    if (inner.to < inner.from + kFewestWindows) continue;
    inner = partOf(windows, usable, weakPrior(), inner.from, inner.to, kFirstStarts);
    if (compareParts(windows, whole, inner, weakPrior()).same) continue;
    if (stretch.from > done) {
      cutRanges.push_back({done, stretch.from});
      cutParts.push_back(pieceOf(cutRanges.back()));
    }
    for (Eigen::Index j = stretch.from; j < stretch.to; ++j) blocks.set(j, MarkLabel::free, SegmentKind::freeMotion);
    labelPart(rows, windows, allowed, weakPrior(), inner, stretch, blocks);
    cutRanges.push_back(stretch);
    cutParts.push_back(std::move(inner));
    done = stretch.to;
  }
  if (cutParts.empty()) return;
  if (done < rows.size()) {
    cutRanges.push_back({done, rows.size()});
    cutParts.push_back(pieceOf(cutRanges.back()));
  }
  parts = std::move(cutParts);
  ranges = std::move(cutRanges);
}

void labelAllowing(const WrenchRows& rows, const Vector6d& allowed, const std::optional<PayloadGuess>& guess,
                   SegmentBlocks& blocks, Findings& findings) {
  const FitWindows windows = windowsOf(rows, allowed);
  if (windows.size() < kFewestWindows) return;
  std::vector<char> usable(windows.size(), 1);
  for (std::size_t w = 0; w < windows.size(); ++w)
    for (Eigen::Index k = 0; k < windows.length; ++k)
      if (blocks.labels[w * at(windows.length) + at(k)] != MarkLabel::free) usable[w] = 0;
  const FitPrior prior = guess ? priorFrom(guess->payload, guess->std) : weakPrior();
  auto parts = payloadParts(windows, usable, weakPrior());
  // With one payload the first estimate helps from the start; with several it only says which one is meant.
  if (parts.size() == 1 && guess) parts[0].x = cappedFit(windows, 0, windows.size(), usable, prior, kFirstStarts).x;
  std::vector<Range> ranges;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const Range range{static_cast<Eigen::Index>(parts[p].from) * windows.length,
                      p + 1 < parts.size() ? static_cast<Eigen::Index>(parts[p].to) * windows.length : rows.size()};
    labelPart(rows, windows, allowed, parts.size() == 1 ? prior : weakPrior(), parts[p], range, blocks);
    ranges.push_back(range);
  }
  if (parts.size() == 1) splitAtStretches(rows, windows, allowed, usable, parts, ranges, blocks);
  if (parts.size() < 2) return;
  const auto reference = std::max_element(parts.begin(), parts.end(), [&](const PayloadPart& a, const PayloadPart& b) {
    if (guess) return std::abs(a.x(0) - guess->payload.mass) > std::abs(b.x(0) - guess->payload.mass);
    return a.free.size() < b.free.size();
  });
  chooseParts(rows, windows, parts, ranges, static_cast<std::size_t>(reference - parts.begin()), blocks, findings);
}

/// "1.20 to 1.35 s and 2.00 to 2.10 s"; of many, the first.
std::string listed(const std::vector<Trouble>& stretches) {
  constexpr std::size_t kListed = 3;
  std::vector<std::string> where;
  double lasts = 0.0;
  for (const auto& stretch : stretches) {
    lasts += stretch.to - stretch.from;
    if (where.size() < kListed) where.push_back(heft::say("{:.2f} to {:.2f} s", stretch.from, stretch.to));
  }
  if (stretches.size() <= kListed) return joined(where);
  const std::size_t more = stretches.size() - kListed;
  return more == 1 ? heft::say("{} and {} more segment, {:.2g} s in total", joined(where), more, lasts)
                   : heft::say("{} and {} more segments, {:.2g} s in total", joined(where), more, lasts);
}

}  // namespace

void markTrouble(const std::vector<Trouble>& troubles, const Recording& recording, const WrenchRows& rows,
                 SegmentBlocks& blocks, Findings& findings) {
  const double half = 0.5 / rows.rateHz;
  std::vector<std::pair<std::string, std::vector<Trouble>>> byReason;
  for (const auto& trouble : troubles) {
    const auto known = std::find_if(byReason.begin(), byReason.end(),
                                    [&](const auto& other) { return other.first == trouble.reason; });
    (known == byReason.end() ? byReason.emplace_back(trouble.reason, std::vector<Trouble>{}) : *known)
        .second.push_back(trouble);
  }
  for (const auto& [reason, stretches] : byReason) {
    const int note = blocks.addReason(reason);
    std::vector<Trouble> excluded, used;
    for (const auto& trouble : stretches) {
      const std::vector<Trouble>* last = nullptr;
      const auto first =
          static_cast<Eigen::Index>(std::floor((trouble.from - half - rows.startTime) * rows.rateHz)) + 1;
      for (Eigen::Index k = std::max<Eigen::Index>(0, first); k < rows.size() && rows.time(k) - half < trouble.to;
           ++k) {
        blocks.set(k, MarkLabel::ignore, SegmentKind::sensorTrouble, note);
        auto& part = markedAt(recording, rows.time(k)) == MarkLabel::free ? used : excluded;
        if (last == &part) {
          part.back().to = std::min(trouble.to, rows.time(k) + half);
          continue;
        }
        part.push_back({std::max(trouble.from, rows.time(k) - half), std::min(trouble.to, rows.time(k) + half), {}});
        last = &part;
      }
      if (!last) excluded.push_back(trouble);
    }
    if (!excluded.empty())
      findings.push_back({Severity::warning,
                          "sensor_trouble",
                          heft::say("{}: {}", listed(excluded), reason),
                          heft::say("It is excluded; mark it as free to use it."),
                          {}});
    if (!used.empty())
      findings.push_back({Severity::info,
                          "sensor_trouble",
                          heft::say("{}: {}", listed(used), reason),
                          heft::say("It is used, since it is marked as free."),
                          {}});
  }
}

/// Where a rigid tool explains next to nothing, the misfit is larger than usual rather than everything contact: more is
/// allowed until a quarter of the recording is free.
SegmentBlocks automaticBlocks(const WrenchRows& rows, const std::optional<PayloadGuess>& guess,
                              const SegmentBlocks& clean, Findings& findings) {
  Vector6d allowed = allowancesOf(rows);
  SegmentBlocks blocks = clean;
  Findings changes;
  const auto usable = std::count(clean.labels.begin(), clean.labels.end(), MarkLabel::free);
  for (int attempt = 0; attempt < 6; ++attempt, allowed *= 2.0) {
    blocks = clean;
    changes.clear();
    labelAllowing(rows, allowed, guess, blocks, changes);
    const auto free = std::count(blocks.labels.begin(), blocks.labels.end(), MarkLabel::free);
    const auto other = std::count(blocks.kinds.begin(), blocks.kinds.end(), SegmentKind::otherPayload);
    if (static_cast<double>(free + other) >= 0.25 * static_cast<double>(usable)) break;
  }
  findings.insert(findings.end(), changes.begin(), changes.end());
  markStanding(rows, blocks);
  return blocks;
}

}  // namespace heft
