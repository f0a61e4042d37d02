// Findings in words.
#include "core/diagnosis/wording/words.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/causes/ids.h"
#include "core/diagnosis/model/found_values.h"

namespace heft {

using namespace diagnosis;

namespace {

/// Empty where there is none.
std::string said(const char* words) { return *words == '\0' ? std::string() : heft::say(fmt::runtime(words)); }

std::string sentenceOf(const DiagnosedCause& cause, const std::string& ending,
                       const std::optional<FrameMistake>& mistake) {
  if (cause.ofMistake) return mistake ? mistake->sentence() : std::string();
  const Cause* known = findCause(cause.id);
  return known ? known->sentence({cause.parameters, cause.when, cause.direct, ending}) : std::string();
}

}  // namespace

std::vector<std::string> causeIds() {
  std::vector<std::string> ids;
  for (const auto& cause : catalogue()) ids.emplace_back(cause->id());
  return ids;
}

std::string causeTitle(std::string_view id) {
  const std::string title = said(infoOf(id).title);
  return title.empty() ? std::string(id) : title;
}
std::string causeCheck(std::string_view id) { return said(infoOf(id).check); }
std::string causeDecides(std::string_view id) { return said(infoOf(id).decides); }
std::string causeLooks(std::string_view id) { return said(infoOf(id).looks); }

std::string causeCheck(const DiagnosedCause& cause, const DiagnosisReport& report) {
  if (report.ofPoses && mountIsWrong(cause))
    return heft::say(
        "Correct how the sensor is mounted where the recorded poses are worked out: the recording states them itself, "
        "and the setup file's mount is not used.");
  if (cause.ofMistake && report.mistake) return report.mistake->check();
  const Cause* known = findCause(cause.id);
  const Vector3d& gravity = report.mistake ? report.mistake->reading.gravity : report.meta.gravity;
  return known ? known->check({cause.parameters, cause.when, cause.direct}, gravity) : std::string();
}

std::string causeSentence(const DiagnosedCause& cause, const std::optional<FrameMistake>& mistake) {
  std::string text = sentenceOf(cause, {}, mistake);
  for (int i = 2;; ++i) {
    const std::string ending = fmt::format("_{}", i);
    if (std::none_of(cause.parameters.begin(), cause.parameters.end(),
                     [&](const auto& p) { return p.name.ends_with(ending); }))
      break;
    if (const std::string more = sentenceOf(cause, ending, mistake); !text.ends_with(more)) text += " " + more;
  }
  return text.empty() ? cause.sentence : text;
}

std::string causeTitle(const DiagnosedCause& cause) {
  const CauseParameter* delay = findParameter(cause.parameters, "delay");
  if (cause.id == ids::timeOffset && delay && delay->value < 0.0) return heft::say("Motion late");
  return causeTitle(cause.id);
}

std::optional<int> sentenceChannel(const DiagnosedCause& cause) {
  const CauseParameter* strongest = FoundValues{cause.parameters, cause.when, cause.direct}.strongest();
  if (!strongest) return std::nullopt;
  const std::string_view name = strongest->name;
  if (cause.id == ids::biasDrift) return channelOf(name);
  if (cause.id == ids::gainError && name.starts_with("gain_") && !name.starts_with("gain_force"))
    return channelOf(name.substr(5));
  if (const auto to = name.find("_to_"); cause.id == ids::crosstalk && to != std::string_view::npos)
    return channelOf(name.substr(to + 4));
  return std::nullopt;
}

}  // namespace heft
