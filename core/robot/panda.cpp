#include <stdexcept>

#include "core/robot/data_folder.h"
#include "core/robot/robot_model.h"

namespace heft {

extern const char* const kPandaUrdf;  // panda_urdf.cpp, generated from the file in resources

const RobotModel& RobotModel::panda() {
  static const RobotModel model = [] {
    Findings findings;  // A missing data folder costs the picture only; the caller of loadMesh is told then.
    Result<RobotModel> read = fromUrdfText(kPandaUrdf, dataFolder() / "robots" / "panda", findings);
    if (!read) throw std::logic_error("the embedded Panda: " + read.error().message);
    return std::move(read).value();
  }();
  return model;
}

}  // namespace heft
