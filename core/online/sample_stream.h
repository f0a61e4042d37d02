#pragma once
// The newest samples, brought onto one uniform grid so that the batch's filters can work on windows of them.
#include <deque>

#include "core/online/even_stamps.h"
#include "core/online/online_estimator.h"

namespace heft {

/// What became of a sample.
enum class Took {
  yes,
  dropped,  ///< Not finite, time not rising, or without the motion that the others have.
  gap,      ///< Not taken: it comes after a gap, and the samples before it have to be finished first.
};

/// One stretch without gaps, its samples at the times that EvenStamps tells. Grid instants k = 0, 1, ... lie at
/// startTime() + k / rateHz().
class SampleStream {
 public:
  /// `dof` of the robot, 0 if there is none.
  SampleStream(const RecordingMeta& meta, int dof);

  Took add(const OnlineSample& sample);
  /// Starts a new stretch; the rate stays known.
  void clear();

  /// True once the sampling rate is known.
  bool ready() const { return rateHz_ > 0.0; }
  double rateHz() const { return rateHz_; }
  double startTime() const { return startTime_; }
  double newestTime() const { return samples_.empty() ? 0.0 : samples_.back().time; }
  /// Grid instants that the samples reach: [0, size()).
  Eigen::Index size() const;
  /// Grid instants [from, to), as a recording; spikes of the wrench removed.
  Recording window(Eigen::Index from, Eigen::Index to) const;
  /// Removes isolated spikes among the samples that came since the last call, the newest three excepted.
  void removeSpikes();
  /// Drops samples that lie before grid instant `from`.
  void forget(Eigen::Index from);

 private:
  bool usable(const OnlineSample& sample) const;
  void findRate();
  /// Gives the newest sample, and those before it where that is known only now, the time at which it was measured.
  void setTimes();

  RecordingMeta meta_;
  int dof_;
  std::deque<OnlineSample> samples_;
  std::uint64_t first_ = 0;    ///< Number of samples of this stretch that were dropped from the front.
  std::uint64_t cleaned_ = 0;  ///< Number of samples of this stretch whose spikes have been looked for.
  double startTime_ = 0.0, rateHz_ = 0.0;
  double newestStamp_ = 0.0;  ///< [s] As it came
  EvenStamps even_;
};

}  // namespace heft
