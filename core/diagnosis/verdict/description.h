#pragma once
// What is said of a cause, by the way in which it was found.
#include "core/diagnosis/artefacts/noisy_motion.h"
#include "core/diagnosis/change_detection/carried_load.h"
#include "core/diagnosis/change_detection/ringing.h"
#include "core/diagnosis/change_detection/segments.h"
#include "core/diagnosis/data_quality/direct.h"
#include "core/diagnosis/result.h"

namespace heft::diagnosis {

/// Fills parameters and time of a cause of `fit`, which judges `stretches`. `spread`: see Found.
void describe(DiagnosedCause& cause, const Fit& fit, const VectorXd& spread, const Signals& signals,
              const std::vector<Stretch>& stretches);

DiagnosedCause fromDirect(const Direct& direct);
/// `before` and `after` undoing the mistake.
DiagnosedCause fromMistake(const FrameMistake& mistake, const WrenchRms& before, const WrenchRms& after);
DiagnosedCause fromNoisyMotion(const NoisyMotion& noisy);
DiagnosedCause fromRinging(const Ringing& ringing);
DiagnosedCause fromCarriedLoad(const CarriedLoad& carried);
/// `contacts` must not be empty. `left`, 6 x blocks, is what all causes together leave: its mean over three blocks is
/// at its greatest the force, known to `noise` [N] (one block by itself adds the most that the noise does in any).
/// `contactAlternative`: a cause that may be meant instead, or none.
DiagnosedCause fromContacts(const std::vector<Contact>& contacts, const Wrenches& left,
                            const std::string& contactAlternative, double noise);

}  // namespace heft::diagnosis
