#pragma once
// Joint velocities as a controller reports them, late, smoothed or scaled, against the slope of the joint angles.
#include "core/diagnosis/sample_tests.h"

namespace heft::diagnosis {

/// Empty where no velocities were reported, or where they agree with the angles.
std::vector<Direct> reportedVelocities(const Recording& recording, const Motion& motion);

}  // namespace heft::diagnosis
