#include "core/online/lane.h"

#include <algorithm>
#include <cmath>

#include "core/estimation/prepare.h"
#include "core/motion/motion.h"

namespace heft {

namespace {
constexpr double kStandByTime = 2.0;  // [s] where nobody waits for it
constexpr double kEdge = 0.1;         // [s] at a stretch's ends that is not used, as in the batch
constexpr double kNewestDelay = 0.1;  // [s]
}  // namespace

WrenchRows LaneBlocks::rows(Eigen::Index from, Eigen::Index to) const {
  WrenchRows out;
  out.rateHz = rateHz;
  out.startTime = from < size() ? time[static_cast<std::size_t>(from)] : 0.0;
  out.Y.assign(Y.begin() + from, Y.begin() + to);
  out.wrench.resize(6, to - from);
  for (Eigen::Index k = from; k < to; ++k) out.wrench.col(k - from) = wrench[static_cast<std::size_t>(k)];
  return out;
}

void LaneBlocks::append(const LaneBlocks& other, Eigen::Index from, Eigen::Index to) {
  rateHz = other.rateHz;
  time.insert(time.end(), other.time.begin() + from, other.time.begin() + to);
  Y.insert(Y.end(), other.Y.begin() + from, other.Y.begin() + to);
  wrench.insert(wrench.end(), other.wrench.begin() + from, other.wrench.begin() + to);
  usable.insert(usable.end(), other.usable.begin() + from, other.usable.begin() + to);
}

void LaneBlocks::append(const WrenchRows& other, Eigen::Index from, Eigen::Index to, bool use) {
  rateHz = other.rateHz;
  for (Eigen::Index k = from; k < to; ++k) {
    time.push_back(other.time(k));
    Y.push_back(other.Y[static_cast<std::size_t>(k)]);
    wrench.push_back(other.wrench.col(k));
    usable.push_back(use ? 1 : 0);
  }
}

void LaneBlocks::keep(Eigen::Index from, Eigen::Index to) {
  LaneBlocks kept;
  kept.append(*this, from, to);
  *this = std::move(kept);
}

bool Lane::advance(const SampleStream& stream, const RobotModel* robot, bool eager, bool last) {
  if (!stream.ready()) return false;
  const double rate = stream.rateHz();
  MotionOptions options;
  options.cutoffHz = cutoffHz_;
  // As motionOf and rowsOf divide the grid.
  const auto stride =
      std::max<Eigen::Index>(1, static_cast<Eigen::Index>(std::floor(rate / options.outputRateHz + 1e-6)));
  const auto perBlock = std::max<Eigen::Index>(1, std::lround(rate / static_cast<double>(stride) / kBlockRate));
  const Eigen::Index block = stride * perBlock;
  const auto reach = static_cast<Eigen::Index>(std::ceil(delay() * rate));
  const Eigen::Index size = stream.size();
  const Eigen::Index ready = last ? size / block : std::max<Eigen::Index>(0, (size - reach) / block);
  const double blockRate = rate / static_cast<double>(block);
  const double stepTime = eager ? kStepTime * kDefaultCutoffHz / cutoffHz_ : kStandByTime;
  const auto step = std::max<Eigen::Index>(1, static_cast<Eigen::Index>(stepTime * blockRate));
  if (ready - next_ < (last ? 1 : step)) return false;

  const Eigen::Index firstBlock = std::max<Eigen::Index>(0, next_ - (reach + block - 1) / block);
  if (size - firstBlock * block < 10) return false;
  const auto motion = motionOf(stream.window(firstBlock * block, size), robot, options);
  if (!motion) return false;
  for (const Finding& finding : motion->findings)
    if (std::none_of(findings.begin(), findings.end(), [&](const Finding& f) { return f.code == finding.code; }))
      findings.push_back(finding);
  const WrenchRows rows = rowsOf(*motion, kBlockRate);
  const Eigen::Index end = std::min(ready - firstBlock, rows.size());
  const double from = stream.startTime() + kEdge;
  const double to = last ? stream.newestTime() - kEdge : INFINITY;
  for (Eigen::Index k = next_ - firstBlock; k < end; ++k)
    blocks.append(rows, k, k + 1, rows.time(k) >= from && rows.time(k) < to);
  blocks.rateHz = blockRate;
  newest = LaneBlocks();
  const auto fresh = static_cast<Eigen::Index>(kNewestDelay * blockRate);
  const Eigen::Index seen = rows.size() - fresh;
  if (!last && seen > end) newest.append(rows, std::max(end, seen - 3), seen, true);
  next_ = firstBlock + end;
  needed_ = std::max<Eigen::Index>(0, next_ - (reach + block - 1) / block - 1) * block;
  return true;
}

}  // namespace heft
