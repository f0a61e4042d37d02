#include "core/estimation/prepare.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace heft {

namespace {

using Wrenches = Eigen::Matrix<double, 6, Eigen::Dynamic>;

/// The blocks' residual under a linear fit with a whisper of prior information: enough to keep what the motion does not
/// excite near zero, far too little to bend what it does.
Wrenches residualOf(const WrenchRows& blocks, const Triangle& whitened) {
  MatrixXd A(2 * kColumns + 1, kColumns);
  VectorXd y = VectorXd::Zero(2 * kColumns + 1);
  A.topRows<kColumns + 1>() = whitened.leftCols<kColumns>();
  y.head<kColumns + 1>() = whitened.col(kColumns);
  VectorXd sd(kColumns);
  sd << VectorXd::Constant(6, 1e4), 30.0, VectorXd::Constant(3, 3.0), VectorXd::Constant(6, 1.0);
  A.bottomRows<kColumns>() = sd.cwiseInverse().asDiagonal();
  const VectorXd x = A.colPivHouseholderQr().solve(y);
  Wrenches residual(6, blocks.size());
  for (Eigen::Index k = 0; k < blocks.size(); ++k)
    residual.col(k) = blocks.wrench.col(k) - x.head<6>() - blocks.Y[static_cast<std::size_t>(k)] * x.tail<10>();
  return residual;
}

/// A noise model to begin with: white, with forces a hundred times noisier than torques in SI units.
NoiseModel firstGuess() {
  NoiseModel noise;
  Vector6d whitener;
  whitener << Vector3d::Constant(10.0), Vector3d::Constant(500.0);
  noise.whitener = whitener.asDiagonal();
  return noise;
}

std::vector<Run> runsOf(const std::vector<MarkLabel>& labels, Eigen::Index from, Eigen::Index to,
                        Eigen::Index shortest) {
  std::vector<Run> runs;
  for (Eigen::Index k = from; k < to; ++k) {
    if (labels[static_cast<std::size_t>(k)] != MarkLabel::free) continue;
    const Eigen::Index start = k;
    while (k < to && labels[static_cast<std::size_t>(k)] == MarkLabel::free) ++k;
    if (k - start >= shortest) runs.push_back({start, k});
  }
  return runs;
}

}  // namespace

bool Prepared::used(Eigen::Index block) const {
  return std::any_of(runs.begin(), runs.end(), [block](const Run& run) { return block >= run.from && block < run.to; });
}

int Prepared::foldOf(Eigen::Index block) const {
  Eigen::Index before = 0;
  for (const auto& run : runs) {
    if (block < run.to) {
      before += std::max<Eigen::Index>(0, block - run.from);
      break;
    }
    before += run.to - run.from;
  }
  return static_cast<int>(std::min<Eigen::Index>(kFolds - 1, before * kFolds / std::max<Eigen::Index>(1, usedBlocks)));
}

Eigen::Matrix<double, Eigen::Dynamic, 6> withoutSpikes(const Eigen::Matrix<double, Eigen::Dynamic, 6>& wrench,
                                                       Eigen::Index& replaced) {
  Eigen::Matrix<double, Eigen::Dynamic, 6> out = wrench;
  const Eigen::Index n = wrench.rows();
  std::vector<bool> touched(static_cast<std::size_t>(n), false);
  for (int c = 0; c < 6; ++c) {
    // Scatter from steps between rows that differ: repeated rows of a polled sensor say nothing about its noise.
    std::vector<double> steps;
    for (Eigen::Index i = 1; i < n; ++i)
      if (wrench(i, c) != wrench(i - 1, c)) steps.push_back(std::abs(wrench(i, c) - wrench(i - 1, c)));
    if (steps.size() < 20) continue;
    const double limit = 8.0 * 1.4826 / std::sqrt(2.0) * median(std::move(steps));
    for (Eigen::Index i = 3; i + 3 < n; ++i) {
      const auto near = wrench.col(c).segment(i - 3, 7);
      // Cheap test first: a spike stands out from both of its outer neighbours, to the same side.
      const double before = wrench(i, c) - near(0), after = wrench(i, c) - near(6);
      if (std::abs(before) < limit || std::abs(after) < limit || before * after < 0.0) continue;
      const double centre = median(std::vector<double>(near.data(), near.data() + 7));
      if (std::abs(wrench(i, c) - centre) < limit) continue;
      out(i, c) = centre;
      touched[static_cast<std::size_t>(i)] = true;
    }
  }
  replaced = std::count(touched.begin(), touched.end(), true);
  return out;
}

Result<Prepared> prepare(const Recording& recording, const RobotModel* robot, const EstimateOptions& options,
                         const Progress& progress) {
  Prepared out;
  const bool poses = recording.meta.kind == RecordingKind::poses;
  progress(0.1, "Working out how the tool moved");
  Eigen::Index spikes = 0;
  if (poses) {
    auto motion = standingPoses(recording, robot);
    if (!motion) return motion.error();
    out.motion = std::move(*motion);
    out.blocks = rowsOf(out.motion, 0.0);
    out.labels = labelBlocks(recording, out.blocks, SegmentMode::all);
    out.segments = segmentsOf(recording, out.blocks, out.labels, SegmentMode::all);
    out.runs = runsOf(out.labels, 0, out.blocks.size(), 1);
    // Poses are independent measurements: each is a run of its own.
    std::vector<Run> single;
    for (Eigen::Index k = 0; k < out.blocks.size(); ++k) single.push_back({k, k + 1});
    out.runs = std::move(single);
    out.usedDuration = 0.0;
  } else {
    Recording cleaned = recording;
    cleaned.wrench = withoutSpikes(recording.wrench, spikes);
    auto motion = motionOf(cleaned, robot, options.motion);
    if (!motion) return motion.error();
    if (progress.cancelled()) return Error{"Stopped.", true};
    out.motion = std::move(*motion);
    out.blocks = rowsOf(out.motion, kBlockRate);
    progress(0.4, "Finding the parts that touched nothing");
    const SegmentMode mode = options.segments.value_or(defaultSegmentMode(recording));
    out.labels = labelBlocks(recording, out.blocks, mode);
    out.segments = segmentsOf(recording, out.blocks, out.labels, mode);
    const double start = recording.time(0), span = recording.duration();
    const double edge = std::max(options.trim * span, options.motion.smoothing == SmoothingKind::lowPass ? 0.1 : 0.0);
    const auto index = [&](double t) {
      return static_cast<Eigen::Index>(std::ceil((t - out.blocks.startTime) * out.blocks.rateHz));
    };
    const Eigen::Index from = std::clamp<Eigen::Index>(index(start + edge), 0, out.blocks.size());
    const Eigen::Index to = std::clamp<Eigen::Index>(index(start + span - edge), from, out.blocks.size());
    out.runs = runsOf(out.labels, from, to, kMaxArOrder + 4);
  }
  for (const auto& run : out.runs) out.usedBlocks += run.to - run.from;
  if (!poses) out.usedDuration = static_cast<double>(out.usedBlocks) / out.blocks.rateHz;
  if (6 * out.usedBlocks < 2 * kColumns) {
    if (poses)
      return Error{
          fmt::format("Only {} standing poses are there; at least 6 in different tilts are needed.", out.usedBlocks)};
    return Error{fmt::format(
        "No free motion is left to estimate from: of {:.1f} s only {:.1f} s touch nothing inside the trimmed "
        "range. Check the marks, or lower the trim.",
        recording.duration(), out.usedDuration)};
  }
  if (spikes > 0)
    out.findings.push_back(
        {Severity::info,
         "spikes_removed",
         fmt::format("{} samples ({:.2g} %) held isolated spikes in the wrench and were replaced by their "
                     "neighbours' median.",
                     spikes, 100.0 * static_cast<double>(spikes) / static_cast<double>(recording.rows())),
         "",
         {}});

  progress(0.6, "Learning the sensor's noise");
  out.noise = firstGuess();
  out.weights = Wrenches::Ones(6, out.blocks.size());
  Wrenches keep = out.weights;
  for (int round = 0; round < 4; ++round) {
    const auto whitened = merged(whitenedTriangles(out.blocks, out.noise, out.weights, out.runs, 1));
    const Wrenches residual = residualOf(out.blocks, whitened);
    out.noise = fitNoise(residual, keep, out.runs, kColumns);
    const Wrenches u = innovations(out.noise, residual, out.runs);
    // Huber weights: beyond three standard deviations an innovation counts with its sign only. What lies beyond five is
    // no part of the noise and leaves the noise model.
    out.weights = u.unaryExpr([](double e) { return std::abs(e) > 3.0 ? 3.0 / std::abs(e) : 1.0; });
    if (!poses) keep = u.unaryExpr([](double e) { return std::abs(e) > 5.0 ? 0.0 : 1.0; });
    if (progress.cancelled()) return Error{"Stopped.", true};
  }
  out.whitened = whitenedTriangles(out.blocks, out.noise, out.weights, out.runs, kFolds);
  return out;
}

}  // namespace heft
