#pragma once
// The virtual arm as a live source: somebody guides it, and samples come as from a robot with a sensor.
#include "core/live/source.h"
#include "core/simulation/virtual_rig.h"

namespace heft {

/// All functions may be called from any thread.
class VirtualSource : public LiveSource {
 public:
  enum class Pace {
    realTime,  ///< A thread goes on with the machine's clock.
    stepped,   ///< Time passes by advance() alone.
  };
  /// `robot` must outlive the source and have seven joints at most.
  static Result<std::unique_ptr<VirtualSource>> create(const RobotModel& robot, const VirtualRigOptions& options,
                                                       Pace pace);
  ~VirtualSource() override;

  Result<bool> start(SampleSink sink) override;
  void stop() override;
  SourceStatus status() const override;

  /// So many seconds pass, and their samples are passed on by this thread. Nothing happens before start().
  void advance(double seconds);
  /// `act` is called with the arm, which stands still meanwhile.
  void guide(const std::function<void(GuidedArm&)>& act);
  /// Another tool is on the arm from now on.
  Result<bool> changeTool(const Payload& payload);
  Payload payload() const;
  /// [s] since start()
  double elapsed() const;

 private:
  VirtualSource(VirtualRig rig, Pace pace);
  void emitNext();

  mutable std::mutex mutex_;
  VirtualRig rig_;
  const Pace pace_;
  SampleSink sink_;
  bool running_ = false;
  double origin_ = 0.0;  ///< [s] hostNow() of the rig's beginning
  double owed_ = 0.0;    ///< [s] that passed without having made a sample
  double newest_ = 0.0;  ///< [s] since the rig's beginning
  double started_ = 0.0;
  SourceStatus status_;
  std::jthread thread_;
};

}  // namespace heft
