#include "core/coach/arm_surroundings.h"

namespace heft {

ArmSurroundings::ArmSurroundings(std::shared_ptr<const RobotModel> robot, const SensorMount& mount,
                                 std::optional<Shape> shape, Room room)
    : robot_(std::move(robot)), mount_(mount), shape_(std::move(shape)), room_(std::move(room)) {}

const Clearance* ArmSurroundings::clearance() {
  std::call_once(once_, [this] {
    const auto tool = robot_ ? guidedTool(*robot_, mount_) : Result<GuidedTool>(Error{});
    if (!tool) return;
    Findings findings;
    auto made = Clearance::of(*robot_, {tool->link, tool->X_LS, shape_}, room_, findings);
    if (!made) return;
    made_ = std::move(*made);
    ready_.store(&*made_, std::memory_order_release);
  });
  return ready();
}

}  // namespace heft
