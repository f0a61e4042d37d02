#pragma once
// The search on one recording: its motion smoothed one way, contact set aside, frames put right, causes found.
#include <functional>
#include <optional>

#include "core/base/result.h"
#include "core/diagnosis/carried.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/events.h"
#include "core/diagnosis/frames.h"
#include "core/diagnosis/ringing.h"
#include "core/diagnosis/search.h"
#include "core/motion/motion.h"

namespace heft::diagnosis {

/// The recording with its motion smoothed one way, and what may be judged of it.
struct Way {
  Motion motion;
  Signals signals;
  double cutoffHz = 0.0;                      ///< Above which next to nothing is left
  std::optional<std::vector<Stretch>> holes;  ///< Blocks that automatic segmentation takes for contact, once looked for
  std::optional<FrameMistake> mistake;        ///< With frames, once looked for
  bool mistakeKnown = false;                  ///< It was, or the recording's was undone: no other is looked for
};

/// Of several ways to smooth a motion, the one that is taken unless another is clearly better: those before it smooth
/// less.
constexpr std::size_t kUsualWay = 1;

/// `cleaned`: `recording` without what the tests of single readings removed; `badRows` (one a row, or none) are not
/// judged.
Result<Way> wayOf(const Recording& recording, const Recording& cleaned, const RobotModel* robot,
                  const MotionOptions& smoothing, const DiagnoseOptions& options, const std::vector<bool>& badRows);

/// Fills `way.holes` the first time that it is asked: none where marks decide or contact is hidden. `way.mistake`, if
/// any, is put right before.
void lookForContact(Way& way, const Recording& cleaned, const DiagnoseOptions& options);

/// The stretches of `judged` that the contact on `way`, which must have been looked for, leaves; all of them where it
/// takes most of the time, or leaves none.
std::vector<Stretch> untouched(Signals judged, const Way& way);

/// What is mixed up in it as far as nothing touches, where contact was looked for.
std::optional<FrameMistake> frameMistake(const Way& way);

/// lookForContact(), and fills `way.mistake` the first time that it is asked: with frameMistake(), or `otherwise`, that
/// of a way which smooths the motion less and may show what this one does not. Contact is looked for once more without
/// the mistake, if any.
void lookForBoth(Way& way, const Recording& cleaned, const DiagnoseOptions& options,
                 const std::optional<FrameMistake>& otherwise = std::nullopt);

/// What bias and payload alone make of each way: evidence on the blocks that all of them judge, the contact of the
/// first way left out, frames and signs put right.
std::vector<double> nullEvidence(const std::vector<Way>& ways);

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
  std::optional<FrameMistake> mistake;
  std::vector<std::string> madeByMotion;  ///< Causes found that are part of the model but nothing of the rig
  SignatureBank bank;                     ///< Of `signals`
  Search search;
};

/// SearchOptions::givesUp, of a work that has come as far.
using GivesUp = std::function<bool(const Work& work, SoFar soFar)>;

/// Contact and a mistake on `way` must have been looked for. `givesUp`, if any, is asked by the first search, before
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
