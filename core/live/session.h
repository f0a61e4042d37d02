#pragma once
// Several sources, one stream of complete samples and a recording that grows.
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/live/merger.h"
#include "core/live/recorder.h"
#include "core/live/source.h"

namespace heft {

/// Samples on their way to whoever takes them now and then. Holds at most `capacity`: when it is full, the oldest tenth
/// falls out.
class SampleQueue {
 public:
  explicit SampleQueue(std::size_t capacity) : capacity_(capacity) {}
  void push(const LiveSample& sample);
  /// Number of all samples ever pushed.
  std::uint64_t total() const { return total_; }
  /// Replaces what `out` holds by all that waited; its memory is used on.
  void takeAll(std::vector<LiveSample>& out);

 private:
  std::size_t capacity_;
  std::vector<LiveSample> samples_;
  std::uint64_t total_ = 0;
};

struct SessionStatus {
  std::vector<SourceStatus> sources;
  std::uint64_t samples = 0;     ///< Complete ones
  std::uint64_t motions = 0;     ///< Parts with joint angles or a pose
  std::uint64_t wrenches = 0;    ///< Parts with a wrench
  std::uint64_t late = 0;        ///< Parts that came after their time
  std::uint64_t unmatched = 0;   ///< Parts without a partner
  std::uint64_t recorded = 0;    ///< Rows on disk or on their way
  std::string recordingProblem;  ///< The disk is full, or gone
  double newest = 0.0;           ///< [s] hostNow() of the newest complete sample
  std::vector<int> wrapped;      ///< Joints, from 0, out of whose angles whole turns were taken
};

/// Which of motion and wrench has not come and what to do about it, in a sentence or two; empty where both have.
std::string missingPart(const SessionStatus& status);

/// All functions may be called from any thread.
class LiveSession {
 public:
  explicit LiveSession(std::size_t queueCapacity = 120000);  ///< Two minutes at 1 kHz
  ~LiveSession();

  void addSource(std::unique_ptr<LiveSource> source);
  /// What the sources' numbers mean; before start(). Samples stay in these conventions: see PlainSamples.
  void setConventions(const Conventions& conventions);
  /// Starts every source; on failure those that run are stopped again.
  Result<bool> start();
  void stop();

  /// While paused samples are neither recorded nor passed on.
  void setPaused(bool paused);

  /// From the next sample on into a new file; see Recorder.
  Result<bool> record(const std::filesystem::path& csv, const RecordingMeta& meta);
  /// Closes the recording; returns its number of rows.
  std::uint64_t endRecording();

  SessionStatus status() const;
  /// Complete samples that came since the last call, instead of what `out` holds; see SampleQueue.
  void takeNew(std::vector<LiveSample>& out);

 private:
  void take(const LiveSample& part);

  std::uint64_t motions_ = 0, wrenches_ = 0;
  std::vector<std::unique_ptr<LiveSource>> sources_;
  mutable std::mutex mutex_;
  StreamMerger merger_;
  SampleQueue queue_;
  std::optional<Recorder> recorder_;
  std::vector<LiveSample> complete_;
  double newest_ = 0.0;
  bool paused_ = false;
};

}  // namespace heft
