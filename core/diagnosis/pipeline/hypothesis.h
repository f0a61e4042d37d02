#pragma once
// The search on one way to see a recording: contact set aside, causes found.
#include <functional>
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
struct Work {
  Signals signals;
  std::vector<Stretch> stretches;
  std::vector<Contact> contacts;
  std::string touchedOr;          ///< A cause that takes the place of most of the contacts, or none
  std::vector<Contact> odd;       ///< Set aside like contact, but no push
  std::string oddGoesWith;        ///< Not translated
  std::vector<Contact> smoothed;  ///< Left out as well, but nothing: left by the smoothing of the motion
  std::vector<Contact> again;     ///< Left out as well: what a cause of the model did there once more
  std::optional<Ringing> ringing;
  std::optional<Carried> carried;
  bool turnTold = false;                  ///< As of the way
  std::vector<std::string> madeByMotion;  ///< Causes found that are part of the model but nothing of the rig
  SignatureBank bank;                     ///< Of `signals`
  Search search;
};

/// SearchOptions::givesUp, of a work that has come as far.
using GivesUp = std::function<bool(const Work& work, SoFar soFar)>;

/// Contact on `way` must have been looked for. `givesUp`, if any, is asked by the first search, before
/// anything is compared.
Result<Work> worked(const Way& way, const DiagnoseOptions& options, double threshold, const Progress& progress,
                    const GivesUp& givesUp = {});

/// The way's signals as the work has them; nothing where its blocks are others.
std::optional<Signals> asIn(const Work& work, const Way& way);

/// Evidence of the work's final model when the motion is smoothed another way, less that with its own; next to nothing
/// where it is not believable there.
double evidenceAt(const Way& other, const Work& work);

/// The same for a work of one cause, which is looked for afresh: parameters that fit a motion smoothed far too much
/// lead astray.
double evidenceAfresh(const Way& other, const Work& work, const DiagnoseOptions& options);

}  // namespace heft::diagnosis
