#pragma once
// Where the motion turns too sharply for its smoothing, such as where a motor's force jumps: nothing is told from such blocks.
#include "core/diagnosis/work.h"

namespace heft::diagnosis {

/// Blocks of `way` in which the wrench that its payload makes of the motion differs from that of a `smoother` one by much more than
/// elsewhere and more than the noise are not judged any more; none where these are many, since then it is the noise of the motion.
void leaveOutCorners(Way& way, const Way& smoother);

}  // namespace heft::diagnosis
