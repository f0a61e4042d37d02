#pragma once
// A short guided lesson: a simulated recording, a few steps that turn faults on, and a question that the recording
// answers. A teacher writes it as JSON (resources/lessons/README.md).
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/base/progress.h"
#include "core/base/result.h"
#include "core/simulation/simulate.h"

namespace heft {

/// One text in several languages: "en" is always there.
class LessonText {
 public:
  LessonText() = default;
  explicit LessonText(std::map<std::string, std::string> byLanguage) : byLanguage_(std::move(byLanguage)) {}
  /// In the language ("de"), else in English.
  const std::string& in(const std::string& language) const;

 private:
  std::map<std::string, std::string> byLanguage_;
};

struct Lesson {
  LessonText title;
  Payload tool;             ///< That the recording hides
  SimulateOptions options;  ///< Of the recording
  struct Step {
    LessonText say;
    std::vector<std::pair<std::string, double>> faults;  ///< Causes and their sizes in the catalogue's units, set anew
    std::vector<std::string> sliders;                    ///< Causes that may be turned
  };
  std::vector<Step> steps;  ///< One at least
  LessonText question;      ///< Asked with the last step's sliders
  struct Answer {
    LessonText say, because;
    bool right = false;
  };
  std::vector<Answer> answers;  ///< Two at least, one of them right
};

/// Reads heft.lesson/1. `name` stands in messages, each of which says what is wrong and where in the file.
Result<Lesson> parseLesson(std::string_view text, const std::string& name);

Result<Simulated> lessonRecording(const Lesson& lesson, const Progress& progress = {});

}  // namespace heft
