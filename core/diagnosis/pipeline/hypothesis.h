#pragma once
// The search on one way to see a recording: contact set aside, causes found.
#include <optional>
#include <string>
#include <vector>

#include "core/diagnosis/change_detection/carried_load.h"
#include "core/diagnosis/change_detection/ringing.h"
#include "core/diagnosis/change_detection/segments.h"
#include "core/diagnosis/pipeline/smoothing_candidate.h"
#include "core/diagnosis/search/search.h"

namespace heft::diagnosis {

/// Everything that a search needs, and what it found.
struct Hypothesis {
  Signals signals;
  std::vector<Stretch> stretches;
  std::vector<Contact> contacts;
  std::string contactAlternative;    ///< A cause that takes the place of most of the contacts, or none
  std::vector<Contact> unexplained;  ///< Set aside like contact, but no push
  Correlate unexplainedCorrelate;
  std::vector<Contact> smoothed;     ///< Left out as well, but nothing: left by the smoothing of the motion
  std::vector<Contact> recurrences;  ///< Left out as well: what a cause of the model did there once more
  std::optional<Ringing> ringing;
  std::optional<CarriedLoad> carriedLoad;
  bool mountTurnReported = false;            ///< As of the way
  std::vector<std::string> motionArtefacts;  ///< Causes found that are part of the model but nothing of the rig
  SignatureBank bank;                        ///< Of `signals`
  Search search;
};

/// The candidate's signals as the hypothesis has them; nothing where its blocks are others.
std::optional<Signals> asIn(const Hypothesis& hypothesis, const SmoothingCandidate& candidate);

}  // namespace heft::diagnosis
