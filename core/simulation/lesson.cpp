#include "core/simulation/lesson.h"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/json_file.h"
#include "core/base/say.h"
#include "core/base/text.h"

namespace heft {
namespace {

using nlohmann::json;

constexpr std::string_view kLessonSchema = "heft.lesson/1";
constexpr std::size_t kMostSteps = 20, kMostAnswers = 6;
constexpr double kLongestLesson = 60.0;  // [s] A longer recording only takes longer to make.

/// Reads one lesson; the first thing that is wrong is kept, with its place.
class LessonReader {
 public:
  explicit LessonReader(std::string name) : name_(std::move(name)) {}

  Result<Lesson> read(const json& file) {
    Lesson out;
    if (!file.is_object() || file.value("schema", json()) != json(kLessonSchema))
      return Error{heft::say("{} is not a lesson: its \"schema\" should be \"{}\".", name_, kLessonSchema)};
    out.title = text(file, "title", "title");
    readRecording(file, out);
    readSteps(file, out);
    out.question = text(file, "question", "question");
    readAnswers(file, out);
    if (!wrong_.empty()) return Error{wrong_};
    return out;
  }

 private:
  void refuse(const std::string& where, const std::string& what) {
    if (wrong_.empty()) wrong_ = heft::say("{}: \"{}\" {}.", name_, where, what);
  }

  /// A text, or an object with one a language, "en" among them.
  LessonText text(const json& object, const char* key, const std::string& where) {
    const json value = object.value(key, json());
    std::map<std::string, std::string> out;
    if (value.is_string()) out["en"] = value.get<std::string>();
    if (value.is_object())
      for (const auto& [language, words] : value.items())
        if (words.is_string()) out[language] = words.get<std::string>();
    if (out["en"].empty())
      refuse(where, heft::say("should be a text, or one for each language with \"en\" among them"));
    return LessonText(std::move(out));
  }

  double number(const json& object, const char* key, double usual, double most) {
    const json value = object.value(key, json());
    if (value.is_null()) return usual;
    if (value.is_number() && value.get<double>() > 0.0 && value.get<double>() <= most) return value.get<double>();
    refuse(key, heft::say("should be a number above 0, up to {}", most));
    return usual;
  }

  void readRecording(const json& file, Lesson& out) {
    out.options.rateHz = 500.0;
    const json recording = file.value("recording", json());
    if (!recording.is_object()) return refuse("recording", heft::say("should be an object with motion, seed ..."));
    const json motion = recording.value("motion", json());
    const auto kind = motion.is_string() ? motionKindFromString(motion.get<std::string>()) : std::nullopt;
    if (!kind) return refuse("motion", heft::say("should be a motion of 'heft simulate': free, excitation ..."));
    out.options.motion = *kind;
    out.options.seed = static_cast<std::uint64_t>(number(recording, "seed", 1.0, 1e9));
    out.options.duration = number(recording, "duration_s", 12.0, kLongestLesson);
    out.options.speed = number(recording, "speed", 1.0, 3.0);
    auto tool = payloadFromJson(recording.value("tool", json()), name_ + ": tool");
    if (!tool) {
      if (wrong_.empty()) wrong_ = tool.error().message;
      return;
    }
    out.tool = *tool;
    if (const auto real = checkPhysical(out.tool); !real.physical)
      refuse("tool", heft::say("cannot exist: {}", real.reason));
  }

  void readSteps(const json& file, Lesson& out) {
    const json steps = file.value("steps", json());
    if (!steps.is_array() || steps.empty() || steps.size() > kMostSteps)
      return refuse("steps", heft::say("should be a list of 1 to {} steps", kMostSteps));
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string where = "steps[" + std::to_string(i) + "]";
      const json& step = steps[i];
      if (!step.is_object()) return refuse(where, heft::say("should be an object with \"say\""));
      Lesson::Step next;
      next.say = text(step, "say", where + ".say");
      const json faults = step.value("faults", json::object());
      if (!faults.is_object()) refuse(where + ".faults", heft::say("should hold causes and their sizes"));
      for (const auto& [cause, size] : faults.items()) {
        if (!size.is_number() || !(size.get<double>() >= 0.0))
          return refuse(where + ".faults." + printable(cause), heft::say("should be a number from 0"));
        next.faults.emplace_back(cause, size.get<double>());
      }
      const json sliders = step.value("sliders", json::array());
      if (!sliders.is_array()) return refuse(where + ".sliders", heft::say("should be a list of causes"));
      for (const json& cause : sliders) {
        if (!cause.is_string()) return refuse(where + ".sliders", heft::say("should be a list of causes"));
        next.sliders.push_back(cause.get<std::string>());
      }
      out.steps.push_back(std::move(next));
    }
  }

  void readAnswers(const json& file, Lesson& out) {
    const json answers = file.value("answers", json());
    if (!answers.is_array() || answers.size() < 2 || answers.size() > kMostAnswers)
      return refuse("answers", heft::say("should be a list of 2 to {} answers", kMostAnswers));
    int right = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const std::string where = "answers[" + std::to_string(i) + "]";
      const json& answer = answers[i];
      if (!answer.is_object()) return refuse(where, heft::say("should be an object with \"say\" and \"because\""));
      const json isRight = answer.value("right", json(false));
      out.answers.push_back({text(answer, "say", where + ".say"), text(answer, "because", where + ".because"),
                             isRight.is_boolean() && isRight.get<bool>()});
      right += out.answers.back().right ? 1 : 0;
    }
    if (right != 1) refuse("answers", heft::say("should have one that is \"right\": true"));
  }

  std::string name_, wrong_;
};

}  // namespace

const std::string& LessonText::in(const std::string& language) const {
  static const std::string nothing;
  auto found = byLanguage_.find(language);
  if (found == byLanguage_.end()) found = byLanguage_.find("en");
  return found == byLanguage_.end() ? nothing : found->second;
}

Result<Lesson> parseLesson(std::string_view text, const std::string& name) {
  const auto file = parseJson(text, name);
  if (!file) return file.error();
  return LessonReader(name).read(*file);
}

Result<Simulated> lessonRecording(const Lesson& lesson, const Progress& progress) {
  return simulate(RobotModel::panda(), lesson.tool, lesson.options, progress);
}

}  // namespace heft
