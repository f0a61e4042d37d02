#pragma once
// What the numbers of a stream mean, asked while it runs.
#include <deque>
#include <future>
#include <memory>
#include <optional>

#include "core/conventions/check.h"
#include "core/online/online_estimator.h"

namespace heft {

/// Samples as a recording in memory, in the form that the first one has; those that lack it are left out. Of joints the
/// first `dof` count.
Recording recordingOf(const std::deque<OnlineSample>& samples, const RecordingMeta& meta, int dof);

/// Asks core/conventions of the newest minute: after 5 s of samples, and whenever half as much again has come. A thread
/// beside does it. Nothing is asked of orientations alone: a swing that nobody recorded looks like anything.
class ConventionWatch {
 public:
  /// `meta`: what the samples' source states. `robot` (copied) is needed where samples have joints, else null.
  ConventionWatch(RecordingMeta meta, const RobotModel* robot);

  /// A sample in the plain form that the meta makes of it.
  void add(const OnlineSample& sample);

  /// True when the answer is another than before: report() is new. `wait`: for what is being asked.
  bool news(bool wait = false);
  /// The newest answer that is one; null until then, and where the stated conventions fit.
  const conventions::Report* report() const { return report_ ? &*report_ : nullptr; }

 private:
  RecordingMeta meta_;
  std::shared_ptr<const RobotModel> robot_;
  std::deque<OnlineSample> samples_;
  double first_ = 0.0, askAt_ = 0.0;  ///< [s]
  std::future<conventions::Report> asked_;
  std::optional<conventions::Report> report_;
};

}  // namespace heft
