#include "core/recording/recording.h"

#include <algorithm>

namespace heft {

std::string_view toString(MarkLabel label) {
  switch (label) {
    case MarkLabel::free:
      return "free";
    case MarkLabel::contact:
      return "contact";
    case MarkLabel::ignore:
      return "ignore";
  }
  return "ignore";
}

std::optional<MarkLabel> markLabelFromString(std::string_view text) {
  if (text == "free") return MarkLabel::free;
  if (text == "contact") return MarkLabel::contact;
  if (text == "ignore") return MarkLabel::ignore;
  return std::nullopt;
}

double Recording::rateHz() const {
  if (time.size() < 2) return 0.0;
  VectorXd steps = time.tail(time.size() - 1) - time.head(time.size() - 1);
  const auto middle = steps.begin() + steps.size() / 2;
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle > 0.0 ? 1.0 / *middle : 0.0;
}

Recording excerpt(const Recording& recording, Eigen::Index from, Eigen::Index to) {
  Recording out;
  out.file = recording.file;
  out.meta = recording.meta;
  out.wrenchNeedsPose = recording.wrenchNeedsPose;
  out.configured = recording.configured;
  out.time = recording.time.segment(from, to - from);
  const auto take = [&](const auto& all, auto& some) {
    if (all.rows() > 0) some = all.middleRows(from, to - from);
  };
  take(recording.q, out.q);
  take(recording.dq, out.dq);
  take(recording.position, out.position);
  take(recording.quaternion, out.quaternion);
  take(recording.twist, out.twist);
  take(recording.accelerometer, out.accelerometer);
  take(recording.gyroscope, out.gyroscope);
  take(recording.wrench, out.wrench);
  if (!recording.labels.empty()) out.labels.assign(recording.labels.begin() + from, recording.labels.begin() + to);
  return out;
}

}  // namespace heft
