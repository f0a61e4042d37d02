#pragma once
// Where live samples come from. A source runs in a thread of its own between start() and stop().
//
// A source gives what its device gives: a force/torque sensor the wrench alone, a robot the joints alone. StreamMerger
// brings parts from several sources together. All times are on one clock, hostNow().
#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "core/base/result.h"
#include "core/math/rigid.h"
#include "core/recording/recording.h"

namespace heft {

/// One instant of one or more devices. What a device does not measure is absent.
struct LiveSample {
  double time = 0.0;                        ///< [s] hostNow() when it was measured, as well as that is known
  int joints = 7;                           ///< How many of q and dq count, from the first
  std::optional<std::array<double, 7>> q;   ///< [rad] unless the meta states other conventions, as all of this
  std::optional<std::array<double, 7>> dq;  ///< [rad/s]; only together with q
  std::optional<Vector3d> position;         ///< p_BSo_B [m]; only together with orientation
  std::optional<Quaterniond> orientation;   ///< R_BS
  std::optional<Vector6d> wrench;           ///< As the sensor gives it: force [N], torque [N m], S axes
  /// Of an inertial sensor on the tool side, in its own axes [m/s2], [rad/s]: see Recording. The gyroscope's only
  /// together with the accelerometer's.
  std::optional<Vector3d> accelerometer, gyroscope;

  bool hasMotion() const { return q.has_value() || orientation.has_value(); }
};

enum class LinkState { idle, connecting, live, lost, failed, finished };
std::string_view toString(LinkState state);

/// What has happened to a source's packets. All of it is survived.
struct SourceStatus {
  std::string name;  ///< "Net F/T 192.168.1.1"
  LinkState state = LinkState::idle;
  std::string text;             ///< What to do if it does not work; empty while all is well.
  std::uint64_t samples = 0;    ///< Passed on.
  std::uint64_t lost = 0;       ///< Missing by their sequence numbers.
  std::uint64_t reordered = 0;  ///< Older than the one before, or repeated; not used.
  std::uint64_t malformed = 0;  ///< Not of the expected form; not used.
  std::uint64_t flagged = 0;    ///< Used, although the device reported an error or saturation with them.
  std::uint64_t disconnects = 0;
  std::vector<std::string> topics;              ///< That samples come from.
  std::vector<std::string> notes;               ///< What was set aside, or cannot be read; whole sentences.
  std::optional<ConfiguredPayload> configured;  ///< What the controller says that it carries
};

/// Called from the source's thread; must be quick.
using SampleSink = std::function<void(const LiveSample&)>;

class LiveSource {
 public:
  virtual ~LiveSource() = default;
  /// Begins; fails only where nothing could ever come (an address that is none, a port in use).
  virtual Result<bool> start(SampleSink sink) = 0;
  /// Ends; no call of the sink comes after it has returned. May be called at any time, also twice.
  virtual void stop() = 0;
  virtual SourceStatus status() const = 0;
};

/// Seconds of the machine's monotonic clock.
double hostNow();

/// Base of sources with a thread: keeps the status and joins the thread.
class ThreadedSource : public LiveSource {
 public:
  explicit ThreadedSource(std::string name) { status_.name = std::move(name); }
  ~ThreadedSource() override;
  Result<bool> start(SampleSink sink) override;
  void stop() override;
  SourceStatus status() const override;

 protected:
  /// What must work before the thread starts.
  virtual Result<bool> prepare() { return true; }
  /// Runs until `stopping` is requested.
  virtual void run(const std::stop_token& stopping) = 0;

  void passOn(const LiveSample& sample);
  void setState(LinkState state, std::string text = {});
  /// Changes the counters under the lock.
  template <class Act>
  void count(Act act) {
    const std::lock_guard lock(mutex_);
    act(status_);
  }

 private:
  SampleSink sink_;
  mutable std::mutex mutex_;
  SourceStatus status_;
  std::jthread thread_;
};

/// Sources by their address, as on the command line:
///   rtde:HOST[:PORT]                 Universal Robots' controller: joints and the raw wrench of its sensor
///   rdt:HOST[:PORT][?cpf=N&cpt=N]    Net F/T; counts per N and N m are asked of the sensor over HTTP unless given
///   foxglove:HOST[:PORT]             Foxglove WebSocket bridge
///   rosbridge:HOST[:PORT]            rosbridge; ?wrench=TOPIC&joints=TOPIC where it cannot list topics
///   udp:[HOST:]PORT                  JSON objects in datagrams; without a host only from this machine
///   replay:FILE[?speed=N]            a recording, in real time
///   virtual:[SEED]                   a simulated Panda with a tool that the seed chooses, moving by itself
/// `replayMeta`: the setup file of a recording that is replayed; empty: its own, if it exists. A replay's samples are
/// in the plain form. `jointNames`: of the arm, from base to tip, where it is known; joints are then found by name.
/// `conventions`: which the samples keep, but for units that the names of numbers state. Fails with a sentence that
/// lists these forms.
Result<std::unique_ptr<LiveSource>> makeLiveSource(const std::string& address,
                                                   const std::filesystem::path& replayMeta = {},
                                                   const std::vector<std::string>& jointNames = {},
                                                   const Conventions& conventions = {});

/// Names of the joints that move on the way to the sensor; none where no robot is named or it cannot be read.
std::vector<std::string> jointNamesOf(const RecordingMeta& meta);

}  // namespace heft
