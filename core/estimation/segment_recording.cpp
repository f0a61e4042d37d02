#include "core/estimation/segment_recording.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/say.h"

namespace heft {

namespace {

double secondsOf(const std::vector<Segment>& segments, MarkLabel label) {
  double sum = 0.0;
  for (const auto& segment : segments)
    if (segment.label == label) sum += segment.to - segment.from;
  return sum;
}

std::string_view wordsOf(SegmentKind kind) {
  switch (kind) {
    case SegmentKind::freeMotion:
      return "free motion";
    case SegmentKind::standing:
      return "standing still";
    case SegmentKind::contact:
      return "contact";
    case SegmentKind::pickUp:
      return "pick-up";
    case SegmentKind::putDown:
      return "put-down";
    case SegmentKind::otherPayload:
      return "other payload";
    case SegmentKind::sensorTrouble:
      return "sensor trouble";
    case SegmentKind::ignored:
      break;
  }
  return "left out";
}

}  // namespace

Result<SegmentedRecording> segmentRecording(const Recording& recording, const RobotModel* robot,
                                            const EstimateOptions& options, const Progress& progress) {
  if (recording.meta.kind == RecordingKind::poses)
    return Error{heft::say("Standing poses have no segments: each row is a measurement of its own.")};
  auto prepared = prepare(recording, robot, options, progress);
  if (!prepared && prepared.error().cancelled) return prepared.error();
  if (prepared) {
    SegmentedRecording out{std::move(prepared->motion), {}, true, std::move(prepared->findings)};
    out.segmentation.labels = std::move(prepared->labels);
    out.segmentation.segments = std::move(prepared->segments);
    out.findings.insert(out.findings.end(), out.motion.findings.begin(), out.motion.findings.end());
    return out;
  }
  auto motion = motionOf(recording, robot, options.motion);
  if (!motion) return motion.error();
  SegmentedRecording out{std::move(*motion), {}, false, {}};
  out.segmentation = segmentRows(recording, rowsOf(out.motion, kBlockRate),
                                 options.segments.value_or(defaultSegmentMode(recording)), options.firstEstimate);
  out.findings = out.segmentation.findings;
  out.findings.push_back({Severity::warning, "nothing_to_estimate", prepared.error().message, "", {}});
  return out;
}

Result<PayloadGuess> payloadGuessFromJson(const nlohmann::json& object, const std::string& where) {
  auto payload = payloadFromJson(object, where);
  if (!payload) return payload.error();
  PayloadGuess guess{*payload, {}};
  if (object.is_object() && object.contains("std")) {
    auto std = partialPayloadFromJson(object["std"], where);
    if (!std) return std.error();
    guess.std.mass = std->mass.value_or(0.0);
    guess.std.com = std->com.value_or(Vector3d::Zero());
  }
  return guess;
}

nlohmann::json toJson(const SegmentedRecording& segmented, const Recording& recording) {
  const auto& segments = segmented.segmentation.segments;
  return {{"schema", "heft.segment/1"},
          {"recording",
           {{"file", recording.file},
            {"samples", recording.rows()},
            {"rate_hz", recording.rateHz()},
            {"duration_s", recording.duration()}}},
          {"free_s", secondsOf(segments, MarkLabel::free)},
          {"contact_s", secondsOf(segments, MarkLabel::contact)},
          {"ignore_s", secondsOf(segments, MarkLabel::ignore)},
          {"segments", toJson(segments)}};
}

std::string toText(const SegmentedRecording& segmented, const Recording& recording) {
  const auto& segments = segmented.segmentation.segments;
  const double ignored = secondsOf(segments, MarkLabel::ignore);
  std::string text = fmt::format("{:.1f} of {:.1f} s free, {:.1f} s contact", secondsOf(segments, MarkLabel::free),
                                 recording.duration(), secondsOf(segments, MarkLabel::contact));
  if (ignored > 0.0) text += fmt::format(", {:.1f} s excluded", ignored);
  text += ".\n\n      from        to   label     what             sure   why\n";
  for (const auto& s : segments)
    text += fmt::format("  {:8.2f}  {:8.2f} s {:<9} {:<15} {:4.0f} %   {}\n", std::max(0.0, s.from), s.to,
                        toString(s.label), wordsOf(s.kind), 100.0 * s.confidence, s.reason);
  if (!segmented.findings.empty()) text += "\n";
  for (const auto& finding : segmented.findings) text += "  " + toLine(finding) + "\n";
  return text;
}

}  // namespace heft
