#pragma once
// Where the motion turns too sharply for its smoothing, such as where a motor's force jumps: the model is less to be
// trusted there.
#include "core/diagnosis/work.h"

namespace heft::diagnosis {

/// Sets Signals::lost of each way, and Signals::louder, the least smoothed first: by how much the wrench that the
/// payload makes of the motion differs from that of the next smoother one, over the noise. Contact on the first way
/// must have been looked for. `held`: readings of the motion stood still and caught up, which looks sharp and says
/// nothing of the payload.
void weighSharpMotion(std::vector<Way>& ways, bool held);

}  // namespace heft::diagnosis
