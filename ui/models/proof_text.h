#pragma once
// What a proof of exported numbers says, from its JSON: computed without widgets.
#include <QString>
#include <QStringList>
#include <optional>
#include <string>
#include <vector>

#include "core/payload/inertial_parameters.h"

namespace heft {

struct ProofText {
  bool passed = false;
  QString headline;  ///< "PASS: only the sensor’s noise is left."
  struct Reason {
    QString text, remedy;
  };
  std::vector<Reason> reasons;  ///< Unless it passed; the most important first
  QStringList facts;            ///< On which recording, what was left, what would have shown
  bool outdated = false;        ///< The numbers are others now.
};

/// Of a heft.prove/1 as JSON text; nothing if it is none. `now`: the numbers as they stand, or null.
std::optional<ProofText> describeProof(const std::string& proof, const Payload* now);

}  // namespace heft
