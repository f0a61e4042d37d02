#pragma once
// What the motions of one run keep clear of, made when it is first asked for and shared between threads.
#include <atomic>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "core/coach/guided_tool.h"
#include "core/collision/clearance.h"

namespace heft {

class ArmSurroundings {
 public:
  /// Without `shape` the tool is what the robot's description has there.
  ArmSurroundings(std::shared_ptr<const RobotModel> robot, const SensorMount& mount, std::optional<Shape> shape,
                  Room room);

  /// Null where the arm's bodies cannot be read. The first call takes a tenth of a second.
  const Clearance* clearance();
  /// The same without waiting: null, too, until it is made.
  const Clearance* ready() const { return ready_.load(std::memory_order_acquire); }

 private:
  std::shared_ptr<const RobotModel> robot_;
  SensorMount mount_;
  std::optional<Shape> shape_;
  Room room_;
  std::once_flag once_;
  std::optional<Clearance> made_;
  std::atomic<const Clearance*> ready_{nullptr};
};

}  // namespace heft
