#include "core/conventions/check.h"
#include "core/conventions/fit.h"
#include "core/recording/frozen.h"
#include "core/segmentation/user_marks.h"

namespace heft::conventions {

Question questionOf(const Recording& recording, const Motion& motion) {
  Question out;
  out.motion = &motion;
  out.kind = recording.meta.kind;
  out.stated = statedIn(recording.meta);
  // Where a recording has both, the motion comes from its poses: see motionOf().
  out.posesInFile = recording.hasOrientation();
  const Conventions& c = out.stated.conventions;
  if (c.wrenchAxes == Conventions::WrenchAxes::sensor && c.wrenchOrder == Conventions::WrenchOrder::forceFirst &&
      c.wrenchPoint.kind == Conventions::WrenchPoint::Kind::sensor)
    out.silent = silentChannels(recording.wrench);
  const bool marked = !recording.meta.marks.empty() || !recording.labels.empty();
  if (recording.meta.kind == RecordingKind::motion && marked)
    for (Eigen::Index k = 0; k < motion.size(); ++k)
      out.use.push_back(markedAt(recording, motion.time(k)).value_or(MarkLabel::free) == MarkLabel::free);
  return out;
}

LeftOver leftOver(const Question& question) {
  constexpr int kRounds = 8;
  const bool standing = question.kind == RecordingKind::poses;
  Blocks blocks = blocksOf(*question.motion, question.motion->wrench, question.use, standing);
  blocks.silent = question.silent;
  Way way;
  way.axes = kStated;
  Place place;
  place.gravity = question.stated.gravity;
  const Fit fit = robustFit(blocks, way, Free::nothing, place, question.stated.gravity, kRounds);
  LeftOver out;
  out.left = fit.left;
  out.mass = fit.x(0);
  out.time = blocks.time;
  for (std::size_t k = 0; standing && k < out.time.size(); ++k) out.time[k] = static_cast<double>(k + 1);
  return out;
}

}  // namespace heft::conventions
