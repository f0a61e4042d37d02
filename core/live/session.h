#pragma once
// Several sources, one stream of complete samples, a window of the newest ones, and a recording that grows.
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <vector>

#include "core/live/merger.h"
#include "core/live/recorder.h"
#include "core/live/source.h"

namespace heft {

/// The newest samples, for whoever looks now and then. Holds at most `capacity`; older ones fall out.
class SampleRing {
 public:
  explicit SampleRing(std::size_t capacity) : capacity_(capacity) {}
  void push(const LiveSample& sample);
  /// Number of all samples ever pushed.
  std::uint64_t total() const { return total_; }
  /// Appends what came after the first `seen` samples and is still there; returns total(). More than `capacity` later,
  /// the samples between are gone, and the caller can see how many.
  std::uint64_t since(std::uint64_t seen, std::vector<LiveSample>& out) const;

 private:
  std::size_t capacity_;
  std::deque<LiveSample> samples_;
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
  explicit LiveSession(std::size_t ringCapacity = 120000);  ///< Two minutes at 1 kHz
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
  /// See SampleRing.
  std::uint64_t since(std::uint64_t seen, std::vector<LiveSample>& out) const;

 private:
  void take(const LiveSample& part);

  std::uint64_t motions_ = 0, wrenches_ = 0;
  std::vector<std::unique_ptr<LiveSource>> sources_;
  mutable std::mutex mutex_;
  StreamMerger merger_;
  SampleRing ring_;
  std::optional<Recorder> recorder_;
  std::vector<LiveSample> complete_;
  double newest_ = 0.0;
  bool paused_ = false;
};

}  // namespace heft
