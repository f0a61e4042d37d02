#pragma once
// Which stretches of a demonstration touched nothing, and what happened in the others.
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/recording/recording.h"
#include "core/segmentation/sensor_trouble.h"
#include "core/wrench/rows.h"

namespace heft {

enum class SegmentKind {
  freeMotion,     ///< Free, in motion.
  standing,       ///< Free, at rest.
  contact,        ///< Something pushes: the environment, or a hand on the tool side.
  pickUp,         ///< The payload grows here,
  putDown,        ///< or shrinks.
  otherPayload,   ///< Free, but with another payload than the part that is used.
  sensorTrouble,  ///< Values that no sensor measured: hung, cut off at its range.
  ignored,        ///< Left out because the user said so.
};
/// "free_motion", "standing_still", "contact", "pick_up", "put_down", "other_payload", "sensor_trouble", "ignored".
std::string_view toString(SegmentKind kind);

struct Segment {
  double from = 0, to = 0;  ///< [s]
  MarkLabel label = MarkLabel::free;
  std::string reason;  ///< In plain words.
  SegmentKind kind = SegmentKind::freeMotion;
  double confidence = 1.0;  ///< That the label is right, 0..1; 1 for what the user marked.
};

enum class SegmentMode { automatic, marks, all };

/// A first estimate of the payload, with its standard deviations in the same places.
struct PayloadGuess {
  Payload payload;
  Payload std;
};

struct Segmentation {
  std::vector<MarkLabel> labels;  ///< One a block.
  std::vector<Segment> segments;  ///< The whole recording, without gaps, in order.
  Findings findings;              ///< Payload changes and sensor trouble.
};

/// Labels by what the user marked (meta marks, then the label column) and, in automatic mode, by how far a rigid
/// payload explains the wrench. Marks always win. `rows` must not be averaged over more than 50 ms.
///
/// Automatic: a fit whose cost is capped in windows of 0.2 s finds the payload and bias that explain most of the
/// motion, however much of it is contact; blocks whose residual stays far above that fit's own scatter for longer than
/// a spike are contact, and the fit is repeated without them. With `guess` the fit starts from that payload, and gives
/// way where the data say otherwise. Where two payloads explain two parts far better than one payload and a moved bias
/// explain both, the part with more free motion (or the one that fits the guess) is used and the other left out.
/// `trouble`: sensorTrouble() of the recording, where it is known already.
Segmentation segmentRows(const Recording& recording, const WrenchRows& rows, SegmentMode mode,
                         const std::optional<PayloadGuess>& guess = std::nullopt,
                         const std::vector<Trouble>* trouble = nullptr);

/// Marks if the recording has any, otherwise automatic.
SegmentMode defaultSegmentMode(const Recording& recording);

/// [{"from_s", "to_s", "label", "kind", "reason", "confidence"}].
nlohmann::json toJson(const std::vector<Segment>& segments);

}  // namespace heft
