#include "core/estimation/picked_up.h"

#include <algorithm>

#include "core/base/numbers.h"
#include "core/base/say.h"
#include "core/estimation/segment_recording.h"

namespace heft {

Result<PickedUp> partsWithAndWithout(const Recording& recording, const RobotModel* robot,
                                     const EstimateOptions& options, const Progress& progress) {
  const auto segmented = segmentRecording(recording, robot, options, progress);
  if (!segmented) return segmented.error();
  std::vector<Segment> events;
  std::ranges::copy_if(segmented->segmentation.segments, std::back_inserter(events), [](const Segment& s) {
    return s.kind == SegmentKind::pickUp || s.kind == SegmentKind::putDown;
  });
  if (events.empty())
    return Error{
        heft::say("{}: nothing was picked up or put down in it. Give two recordings instead, one with the object and "
                  "one without.",
                  recording.file)};
  for (std::size_t i = 1; i < events.size(); ++i)
    if (events[i].kind == events[i - 1].kind)
      return Error{
          heft::say("{}: the payload changes in the same direction at {:.1f} and {:.1f} s, so there are three of "
                    "them. Give two recordings, one with the object and one without.",
                    recording.file, events[i - 1].from, events[i].from)};
  PickedUp out{recording, recording, {}, {}};
  bool held = events.front().kind == SegmentKind::putDown;
  double from = recording.time(0);
  const double end = recording.time(recording.rows() - 1);
  const auto leaveOut = [](Recording& part, double start, double stop) {
    part.meta.marks.push_back({start, stop, MarkLabel::ignore});
  };
  for (const Segment& event : events) {
    leaveOut(held ? out.without : out.with, from, event.to);
    // What happens at the moment itself belongs to neither.
    leaveOut(held ? out.with : out.without, event.from, event.to);
    (held ? out.putDownAt : out.pickedUpAt).push_back(0.5 * (event.from + event.to));
    held = !held;
    from = event.to;
  }
  leaveOut(held ? out.without : out.with, from, end);
  return out;
}

Result<CarriedObject> estimatePickedUp(const JointInput& recording, const EstimateOptions& options,
                                       const Findings& read, const Progress& progress) {
  const auto parts = partsWithAndWithout(*recording.recording, recording.robot, options, progress);
  if (!parts) return parts.error();
  ReadingFindings findings{read, read};
  const auto tell = [&](const char* code, const char* sentence, const std::vector<double>& times) {
    std::vector<std::string> said;
    for (const double time : times) said.push_back(sayNumber(time, 1));
    if (!said.empty())
      findings.with.push_back({Severity::info, code, heft::say(fmt::runtime(sentence), joined(said)), {}, {}});
  };
  tell("picked_up", toSay("Picked up at {} s."), parts->pickedUpAt);
  tell("put_down", toSay("Put down at {} s."), parts->putDownAt);
  EstimateOptions settings = options;
  settings.segments = SegmentMode::automatic;
  return estimateCarriedObject({&parts->with, recording.robot}, {&parts->without, recording.robot}, settings, findings,
                               progress);
}

}  // namespace heft
