#pragma once
// What is no other convention and yet bends mass and centre without a trace in the misfit: a sensor that is turned a
// little, and a gain of force or torque. Both show in one linear fit beside payload and zero.
//
// Of the payload m and m c stand in the force, m c and I in the torque. A turn by a small angle d adds d x f and d x
// tau to the readings; gravity shows it in poses, too. A gain of one of the two makes their m c differ by a factor,
// which only turning shows: the force holds m c beside angular accelerations alone. A gain that force and torque share
// is another mass, and a gain of the force in standing poses another mass and centre: nothing tells these.
#include "core/conventions/fit.h"

namespace heft::conventions {

struct Agreement {
  double turn = 0.0, turnStd = 0.0;    ///< Of the sensor against where it is stated to be [rad]
  double ratio = 1.0, ratioStd = 0.0;  ///< m c of the torque over m c of the force, along the centre; 1 for poses

  bool turned() const;          ///< By more than can hardly be avoided, surely
  bool ratioDisagrees() const;  ///< Likewise
};

/// Beside `fit`, which is of `way` with nothing free. Deviations count that what is left over lasts.
Agreement agreementOf(const Blocks& blocks, const Way& way, const Fit& fit);

}  // namespace heft::conventions
