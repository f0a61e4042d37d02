#include "core/segmentation/segmentation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <random>

#include "core/math/statistics.h"

namespace heft {

namespace {

using Matrix17d = Eigen::Matrix<double, 17, 17>;
using Vector16d = Eigen::Matrix<double, 16, 1>;

constexpr double kWindow = 0.2;  // [s] unit of the robust fit
constexpr int kStarts = 60;      // random starts; each costs a few small factorisations
constexpr double kCap = 4.0;     // root-mean-square misfit of a window, in allowances, beyond which it is not free
constexpr double kOuter = 6.0;   // scatter multiples that open a contact,
constexpr double kInner = 3.5;   // and those that end it
constexpr double kOuterAllowed = 2.0;  // but never less than so many allowances
constexpr double kInnerAllowed = 1.0;
constexpr double kMargin = 0.06;    // [s] kept away from a contact on both sides
constexpr double kShortest = 0.05;  // [s] shorter excursions are spikes, which the robust fit handles

/// Normal matrix of [Y, bias, y] over a stretch of blocks, channels scaled by what they may miss.
Matrix17d normalMatrix(const WrenchRows& rows, const Vector6d& scale, Eigen::Index from, Eigen::Index to) {
  Matrix17d N = Matrix17d::Zero();
  Eigen::Matrix<double, 6, 17> A;
  for (Eigen::Index k = from; k < to; ++k) {
    A.leftCols<10>() = rows.Y[static_cast<std::size_t>(k)];
    A.middleCols<6>(10).setIdentity();
    A.col(16) = rows.wrench.col(k);
    A = scale.cwiseInverse().asDiagonal() * A;
    N.selfadjointView<Eigen::Lower>().rankUpdate(A.transpose());
  }
  return N.selfadjointView<Eigen::Lower>();
}

/// Weak information that keeps unexcited directions at zero instead of anywhere.
Vector16d solveNormal(const Matrix17d& N) {
  Eigen::Matrix<double, 16, 16> H = N.topLeftCorner<16, 16>();
  Vector16d ridge;
  ridge << 1e-2, Eigen::Matrix<double, 3, 1>::Constant(1.0), Eigen::Matrix<double, 6, 1>::Constant(1e2),
      Eigen::Matrix<double, 6, 1>::Constant(1e-6);
  H.diagonal() += ridge;
  return H.ldlt().solve(N.topRightCorner<16, 1>());
}

double energy(const Matrix17d& N, const Vector16d& x) {
  Eigen::Matrix<double, 17, 1> z;
  z << -x, 1.0;
  return std::max(0.0, z.dot(N * z));
}

/// Wrench that a fit leaves over.
Eigen::Matrix<double, 6, Eigen::Dynamic> residualOf(const WrenchRows& rows, const Vector16d& x) {
  Eigen::Matrix<double, 6, Eigen::Dynamic> residual(6, rows.size());
  for (Eigen::Index k = 0; k < rows.size(); ++k)
    residual.col(k) = rows.wrench.col(k) - rows.Y[static_cast<std::size_t>(k)] * x.head<10>() - x.tail<6>();
  return residual;
}

/// What a rigid model may miss in each channel without anything touching the tool: three times the sensor's own scatter
/// (from steps between neighbouring blocks of what a plain fit leaves over, blind to slow misfit and to contact), or
/// what delay, drift and cables usually do, up to 0.15 N and 0.015 N m.
Vector6d allowances(const WrenchRows& rows) {
  Vector6d scale;
  scale << Vector3d::Constant(0.1), Vector3d::Constant(0.01);
  const auto residual = residualOf(rows, solveNormal(normalMatrix(rows, scale, 0, rows.size())));
  Vector6d allowed;
  for (int c = 0; c < 6; ++c) {
    std::vector<double> steps;
    for (Eigen::Index k = 1; k < rows.size(); ++k) steps.push_back(std::abs(residual(c, k) - residual(c, k - 1)));
    // A normal distribution has 30 % of its values within 0.385 standard deviations; contact may fill more than half.
    const auto low = steps.begin() + static_cast<std::ptrdiff_t>(0.3 * static_cast<double>(steps.size()));
    std::nth_element(steps.begin(), low, steps.end());
    const double scatter = *low / 0.385;
    const double range = rows.wrench.row(c).maxCoeff() - rows.wrench.row(c).minCoeff();
    allowed(c) = std::max(3.0 * scatter, std::min(c < 3 ? 0.15 : 0.015, 0.03 * range));
  }
  // A channel that hardly moves is no better than its neighbours.
  const double force = std::max(allowed.head<3>().maxCoeff(), 1e-3),
               torque = std::max(allowed.tail<3>().maxCoeff(), 1e-4);
  for (int c = 0; c < 6; ++c) allowed(c) = std::max(allowed(c), 0.5 * (c < 3 ? force : torque));
  return allowed;
}

/// The fit with the least sum of window energies, each capped: windows beyond the cap are not free and pull no further.
/// Random starts and concentration on the windows below the cap (after Rousseeuw & Van Driessen's fast LTS).
Vector16d cappedFit(const std::vector<Matrix17d>& windows, double rowsPerWindow) {
  const auto count = windows.size();
  const double cap = kCap * kCap * rowsPerWindow;
  const auto concentrate = [&](Vector16d x, int steps, double& total) {
    for (int s = 0; s < steps; ++s) {
      Matrix17d N = Matrix17d::Zero();
      std::size_t kept = 0;
      for (const auto& window : windows)
        if (energy(window, x) < cap) {
          N += window;
          ++kept;
        }
      if (kept < 5) break;
      x = solveNormal(N);
    }
    total = 0.0;
    for (const auto& window : windows) total += std::min(cap, energy(window, x));
    return x;
  };
  std::mt19937 random(20240229);  // raw engine output only: the same on every platform
  std::vector<std::pair<double, Vector16d>> best;
  for (int start = 0; start <= kStarts; ++start) {
    Matrix17d N = Matrix17d::Zero();
    if (start == 0) {
      for (const auto& window : windows) N += window;
    } else {
      for (int i = 0; i < 8; ++i) N += windows[random() % count];
    }
    double total = 0.0;
    const Vector16d x = concentrate(solveNormal(N), 2, total);
    best.emplace_back(total, x);
  }
  const auto byEnergy = [](const auto& a, const auto& b) { return a.first < b.first; };
  std::sort(best.begin(), best.end(), byEnergy);
  best.resize(std::min<std::size_t>(best.size(), 5));
  for (auto& candidate : best) candidate.second = concentrate(candidate.second, 15, candidate.first);
  return std::min_element(best.begin(), best.end(), byEnergy)->second;
}

/// Residual of every block, worst channel: 1 where a contact ends, 2 where one opens.
VectorXd blockScores(const WrenchRows& rows, const Vector16d& x, const std::vector<MarkLabel>& labels,
                     const Vector6d& allowed) {
  const auto residual = residualOf(rows, x);
  Vector6d inner, outer;
  for (int c = 0; c < 6; ++c) {
    std::vector<double> values;
    for (Eigen::Index k = 0; k < rows.size(); ++k)
      if (labels[static_cast<std::size_t>(k)] == MarkLabel::free) values.push_back(residual(c, k));
    const double scatter = robustStd(values);
    inner(c) = std::max(kInner * scatter, kInnerAllowed * allowed(c));
    outer(c) = std::max(kOuter * scatter, kOuterAllowed * allowed(c));
  }
  VectorXd scores(rows.size());
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    const Vector6d size = residual.col(k).cwiseAbs();
    // 1 at the inner limit, 2 at the outer one.
    const double in = size.cwiseQuotient(inner).maxCoeff(), out = size.cwiseQuotient(outer).maxCoeff();
    scores(k) = out >= 1.0 ? 2.0 * out : std::min(in, 1.999);
  }
  return scores;
}

/// Contact where the score passes 2, grown while it stays above 1, widened by kMargin, spikes left out.
std::vector<MarkLabel> labelsFromScores(const VectorXd& scores, double rateHz) {
  const Eigen::Index n = scores.size();
  std::vector<MarkLabel> labels(static_cast<std::size_t>(n), MarkLabel::free);
  const auto margin = static_cast<Eigen::Index>(std::ceil(kMargin * rateHz));
  const auto shortest = static_cast<Eigen::Index>(std::ceil(kShortest * rateHz));
  for (Eigen::Index k = 0; k < n; ++k) {
    if (scores(k) < 1.0) continue;
    Eigen::Index end = k;
    double peak = 0.0;
    // Two blocks below the inner limit end the stretch; one may be a zero crossing.
    for (Eigen::Index j = k; j < n && (scores(j) >= 1.0 || (j + 1 < n && scores(j + 1) >= 1.0)); ++j) {
      end = j;
      peak = std::max(peak, scores(j));
    }
    if (peak >= 2.0 && end - k + 1 >= shortest)
      for (Eigen::Index j = std::max<Eigen::Index>(0, k - margin); j <= std::min(n - 1, end + margin); ++j)
        labels[static_cast<std::size_t>(j)] = MarkLabel::contact;
    k = end;
  }
  return labels;
}

std::vector<MarkLabel> labelsAllowing(const WrenchRows& rows, const Vector6d& allowed) {
  std::vector<MarkLabel> labels(static_cast<std::size_t>(rows.size()), MarkLabel::free);
  const auto length = std::max<Eigen::Index>(1, std::lround(kWindow * rows.rateHz));
  std::vector<Matrix17d> windows;
  for (Eigen::Index k = 0; k + length <= rows.size(); k += length)
    windows.push_back(normalMatrix(rows, allowed, k, k + length));
  if (windows.size() < 10) return labels;
  Vector16d x = cappedFit(windows, 6.0 * static_cast<double>(length));
  for (int round = 0; round < 4; ++round) {
    const auto next = labelsFromScores(blockScores(rows, x, labels, allowed), rows.rateHz);
    Matrix17d N = Matrix17d::Zero();
    std::size_t used = 0;
    for (std::size_t w = 0; w < windows.size(); ++w) {
      const auto first = next.begin() + static_cast<std::ptrdiff_t>(w) * length;
      if (std::find(first, first + length, MarkLabel::contact) != first + length) continue;
      N += windows[w];
      ++used;
    }
    const bool settled = next == labels;
    labels = next;
    if (settled || used < 5) break;
    x = solveNormal(N);
  }
  return labels;
}

/// Where a rigid tool explains next to nothing, the misfit is larger than usual rather than everything contact: more is
/// allowed until a quarter of the recording is free.
std::vector<MarkLabel> automaticLabels(const WrenchRows& rows) {
  Vector6d allowed = allowances(rows);
  std::vector<MarkLabel> labels;
  for (int attempt = 0; attempt < 6; ++attempt, allowed *= 2.0) {
    labels = labelsAllowing(rows, allowed);
    const auto free = std::count(labels.begin(), labels.end(), MarkLabel::free);
    if (static_cast<double>(free) >= 0.25 * static_cast<double>(labels.size())) break;
  }
  return labels;
}

/// What the user said about time t, if anything: the last mark that covers it wins.
std::optional<MarkLabel> markAt(const std::vector<Mark>& marks, double t) {
  std::optional<MarkLabel> label;
  for (const auto& mark : marks)
    if (t >= mark.from && t <= mark.to) label = mark.label;
  return label;
}

/// The label column's cell at or before t.
std::optional<MarkLabel> columnAt(const Recording& recording, double t) {
  if (recording.labels.empty()) return std::nullopt;
  const double* begin = recording.time.data();
  const double* end = begin + recording.time.size();
  const auto index = std::max<std::ptrdiff_t>(0, std::upper_bound(begin, end, t) - begin - 1);
  return recording.labels[static_cast<std::size_t>(index)];
}

std::optional<MarkLabel> userLabelAt(const Recording& recording, double t) {
  const auto mark = markAt(recording.meta.marks, t);
  return mark ? mark : columnAt(recording, t);
}

bool userMarkedFree(const Recording& recording) {
  const auto isFree = [](const auto& label) { return label == MarkLabel::free; };
  return std::any_of(recording.meta.marks.begin(), recording.meta.marks.end(),
                     [&](const Mark& mark) { return isFree(mark.label); }) ||
         std::any_of(recording.labels.begin(), recording.labels.end(), isFree);
}

}  // namespace

SegmentMode defaultSegmentMode(const Recording& recording) {
  const bool marked = !recording.meta.marks.empty() || std::any_of(recording.labels.begin(), recording.labels.end(),
                                                                   [](const auto& l) { return l.has_value(); });
  return marked ? SegmentMode::marks : SegmentMode::automatic;
}

std::vector<MarkLabel> labelBlocks(const Recording& recording, const WrenchRows& rows, SegmentMode mode) {
  std::vector<MarkLabel> labels(static_cast<std::size_t>(rows.size()), MarkLabel::free);
  if (mode == SegmentMode::all) return labels;
  if (mode == SegmentMode::automatic) labels = automaticLabels(rows);
  // Where the user marked free parts, what they left unmarked is not free; where they only marked contact, it is.
  const bool onlyMarked = mode == SegmentMode::marks && userMarkedFree(recording);
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    auto& label = labels[static_cast<std::size_t>(k)];
    if (const auto user = userLabelAt(recording, rows.time(k))) {
      label = *user;
    } else if (onlyMarked) {
      label = MarkLabel::ignore;
    }
  }
  return labels;
}

std::vector<Segment> segmentsOf(const Recording& recording, const WrenchRows& rows,
                                const std::vector<MarkLabel>& labels, SegmentMode mode) {
  std::vector<Segment> segments;
  const double half = 0.5 / rows.rateHz;
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    const MarkLabel label = labels[static_cast<std::size_t>(k)];
    const bool byUser = mode != SegmentMode::all && userLabelAt(recording, rows.time(k)).has_value();
    std::string reason;
    if (mode == SegmentMode::all) {
      reason = "Everything was asked for.";
    } else if (byUser) {
      reason = "Marked by you.";
    } else if (label == MarkLabel::free) {
      reason = "A rigid tool explains the forces here.";
    } else if (label == MarkLabel::contact) {
      reason = "A push that the motion does not explain.";
    } else {
      reason = "Not marked as free.";
    }
    if (!segments.empty() && segments.back().label == label && segments.back().reason == reason) {
      segments.back().to = rows.time(k) + half;
    } else {
      segments.push_back({rows.time(k) - half, rows.time(k) + half, label, reason});
    }
  }
  return segments;
}

}  // namespace heft
