#include "core/diagnosis/model/step_candidates.h"

#include <algorithm>
#include <cmath>

#include "core/diagnosis/calibration.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

std::vector<StepCandidate> stepCandidatesIn(const Signals& signals, const std::vector<Stretch>& stretches,
                                            const Wrenches& residual, double over) {
  const auto length = std::max<Eigen::Index>(3, static_cast<Eigen::Index>(std::lround(over * signals.blockRate())));
  const auto stepOf = [&](const Wrenches& course, Eigen::Index n) -> Vector6d {
    return course.middleCols(n, length).rowwise().mean() - course.middleCols(n - length, length).rowwise().mean();
  };
  std::vector<Eigen::Index> at;
  std::vector<Vector6d> steps;
  for (const auto& s : stretches)
    for (Eigen::Index n = s.from + length; n + length <= s.to; ++n) {
      at.push_back(n);
      steps.push_back(stepOf(residual, n));
    }
  if (at.size() < 100) return {};
  Vector6d usual;
  for (Eigen::Index c = 0; c < 6; ++c) {
    std::vector<double> sizes;
    for (const Vector6d& step : steps) sizes.push_back(std::abs(step(c)));
    usual(c) = std::max(1e-12, 1.4826 * median(std::move(sizes)));
  }
  std::vector<double> size;
  for (const Vector6d& step : steps) size.push_back(step.cwiseQuotient(usual).squaredNorm());
  std::vector<std::size_t> peaks;
  for (std::size_t i = 0; i < size.size(); ++i) {
    const auto near = [&](std::size_t j) { return std::abs(at[i] - at[j]) <= length; };
    bool highest = size[i] > kClearEvidence;
    for (std::size_t j = i; highest && j-- > 0 && near(j);) highest = size[j] < size[i];
    for (std::size_t j = i + 1; highest && j < size.size() && near(j); ++j) highest = size[j] <= size[i];
    if (highest) peaks.push_back(i);
  }
  std::erase_if(peaks, [&](std::size_t i) {
    const Vector6d step = steps[i].cwiseQuotient(usual);
    return signals.lost != nullptr && std::ranges::any_of(*signals.lost, [&](const Wrenches& lost) {
             const Vector6d taken = stepOf(lost, at[i]).cwiseQuotient(usual);
             const double share = std::clamp(taken.dot(step) / std::max(taken.squaredNorm(), 1e-300), 0.0, 1.0);
             return (step - share * taken).squaredNorm() < kMajority * size[i] ||
                    taken.squaredNorm() > kStandsOut * size[i];
           });
  });
  std::vector<StepCandidate> out;
  for (const std::size_t i : peaks) out.push_back({signals.blockTime(at[i]) - 0.5 / signals.blockRate(), size[i]});
  return out;
}

}  // namespace heft::diagnosis
