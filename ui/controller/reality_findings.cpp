#include "ui/controller/reality_findings.h"

#include <algorithm>

#include "core/diagnosis/report/report.h"
#include "ui/controller/only_child.h"

namespace heft {

bool isTied(const DiagnosedCause& cause) { return !cause.direct && !cause.alternatives.empty(); }

bool leftOutAlready(const DiagnosedCause& cause, const std::vector<Segment>& segments) {
  if (!cause.direct || (cause.id != "contact" && cause.id != "payload_change")) return false;
  double touched = 0, left = 0;
  for (const auto& [from, to] : cause.when) {
    touched += to - from;
    for (const Segment& segment : segments)
      if (segment.label != MarkLabel::free)
        left += std::max(0.0, std::min(to, segment.to) - std::max(from, segment.from));
  }
  constexpr double kNearlyAll = 0.85;  // The two do not agree exactly on where a contact begins and ends.
  return touched > 0 && left > kNearlyAll * touched;
}

bool helpsUnseen(const DiagnosedCause& cause) {
  return cause.direct || cause.gain.blocks == 0 || cause.gain.explainedFraction > 0.0;
}

const RealityFindings::Found* RealityFindings::current(const Workspace& workspace) const {
  const auto opened = workspace.opened();
  const auto it = opened ? found.find(opened->path) : found.end();
  // A file that was read again may have other contents.
  return it == found.end() || !it->report || it->of.lock() != opened ? nullptr : &*it;
}

OpenCauses openCauses(Workspace& workspace) {
  OpenCauses out;
  const auto* found = onlyChild<RealityFindings>(workspace)->current(workspace);
  if (!found || found->secret) return out;
  const auto& applied = workspace.corrections().causes;
  const std::vector<Segment> segments = workspace.segments();
  for (const DiagnosedCause& cause : found->report->causes)
    if (canApply(*found->report, cause) && !leftOutAlready(cause, segments) && helpsUnseen(cause) && !isTied(cause) &&
        std::find(applied.begin(), applied.end(), cause.id) == applied.end())
      out.causes.push_back(&cause);
  if (out.causes.empty()) return out;
  out.report = found->report;
  // Of those that are applied the numbers know already.
  if (applied.empty()) {
    out.moved = payloadShift(*out.report);
  } else if (const auto now = workspace.report()) {
    DiagnosisReport rest;
    rest.before = *now;
    rest.after = out.report->after;
    out.moved = payloadShift(rest);
  }
  return out;
}

}  // namespace heft
