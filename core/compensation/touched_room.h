#pragma once
// Walls and tables that were touched by hand: where a tool of known shape presses, a plane begins.
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <utility>
#include <vector>

#include "core/collision/room.h"
#include "core/compensation/compensation.h"
#include "core/payload/shape.h"

namespace heft {

struct TouchedPlane {
  RoomPlane plane;
  std::vector<std::pair<double, double>> when;  ///< Touches that it comes from [s]
  double normalSpread = 0.0;                    ///< Of the force's direction about the normal [rad]
  double offsetSpread = 0.0;                    ///< Of the plane along its normal [m]
  bool plumb = false;  ///< The normal was taken along or across gravity, which `normalSpread` allows
};

struct TouchedRoom {
  std::vector<TouchedPlane> planes;  ///< In the order of their first touch, base axes
  Findings findings;                 ///< Touches of which none was made, and why
};

/// Each contact of `compensated`, which is of this recording, is taken for a touch of something flat: its normal is the
/// mean direction of what presses on the tool, less what is along the way that the tool slides (friction), taken as
/// level or plumb where its spread allows; the plane begins where the tool's shape ends against that direction. Touches
/// of the same plane are one. Fails where the sensor's position is not known, and where the shape cannot be read.
Result<TouchedRoom> touchedRoom(const Recording& recording, const RobotModel* robot, const Compensated& compensated,
                                const Shape& tool);

/// From a recording and its payload (`result`: of heft estimate; `where` names it) to what was touched: compensates,
/// then touchedRoom(). Fails also where no touch gives a plane, and says why.
Result<TouchedRoom> findTouchedRoom(const Recording& recording, const RobotModel* robot, const nlohmann::json& result,
                                    const std::string& where, const Shape& tool, const Progress& progress = {});

/// The planes as obstacles: "table" where one faces up, "ceiling", "wall"; numbered where there are several.
Room roomOf(const TouchedRoom& touched, double margin);

}  // namespace heft
