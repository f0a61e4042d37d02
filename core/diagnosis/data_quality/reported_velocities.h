#pragma once
// Velocities as a controller reports them, late, smoothed or scaled: of joints against the slope of the angles, of the
// sensor against that of its poses.
#include <vector>

#include "core/diagnosis/data_quality/direct.h"
#include "core/motion/motion.h"
#include "core/recording/recording.h"

namespace heft::diagnosis {

/// Empty where no velocities were reported, or where they agree with the angles or poses.
std::vector<Direct> reportedVelocities(const Recording& recording, const Motion& motion);

/// Of joints and of the sensor: where they disagree, angles and poses alone tell how it moved.
void dropReportedVelocities(Recording& recording);

}  // namespace heft::diagnosis
