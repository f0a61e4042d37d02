#pragma once
// What a tool carries: the difference of two estimates, with the object and without it.
#include "core/estimation/joint.h"

namespace heft {

/// What the difference of the two recordings says about the object.
enum class ObjectVerdict {
  found,     ///< It has a mass and a place.
  nothing,   ///< It cannot be told from nothing.
  negative,  ///< The tool was heavier without it: the recordings are exchanged, or of different tools.
};
std::string_view toString(ObjectVerdict verdict);  ///< "found", "nothing", "negative"

struct CarriedObject {
  EstimateReport with, without;  ///< Each recording by itself.
  ObjectVerdict verdict = ObjectVerdict::nothing;
  /// phi of the object by the data alone, no matter whether such a body can exist, and its covariance: that of both
  /// recordings together.
  Vector10d difference = Vector10d::Zero();
  Matrix10d covariance = Matrix10d::Zero();
  /// Payload, std, interval95, identifiability and evidence of the object, the worse trust of the two recordings, and
  /// findings about the pair. Unless `found`, only the mass means something: it is that of `difference`.
  EstimateReport object;
};

/// What was said when the two files were read.
struct ReadingFindings {
  Findings with, without;
};

/// Estimates the object that `with` carries and `without` does not. The ten parameters are linear in the wrench, so
/// that those of the object are the difference and the noise of both adds up: the tool is eliminated from the whitened
/// rows of both recordings, and what is left is solved for a physical body as any recording's rows are. Needs the
/// method map, all parameters and no shape or stated payload, which would be that of one body only. Fails where the two
/// sensors are mounted differently: their axes would not be the same.
Result<CarriedObject> estimateCarriedObject(const JointInput& with, const JointInput& without,
                                            const EstimateOptions& options, const ReadingFindings& read = {},
                                            const Progress& progress = {});

/// heft.estimate/1 of the recording with the object, with "object" and "without".
nlohmann::json toJson(const CarriedObject& carried);
std::string toText(const CarriedObject& carried);

}  // namespace heft
