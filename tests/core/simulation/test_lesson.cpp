// The file of a lesson: what a teacher may write, and what is said where it is wrong.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/simulation/lesson.h"

namespace heft {
namespace {

nlohmann::json goodLesson() {
  return {{"schema", "heft.lesson/1"},
          {"title", {{"en", "Late"}, {"de", "Verspätet"}}},
          {"recording",
           {{"motion", "free"},
            {"duration_s", 3},
            {"tool",
             {{"mass_kg", 0.75},
              {"com_m", {0, 0, 0.06}},
              {"inertia_com_kgm2", {{0.0012, 0, 0}, {0, 0.0011, 0}, {0, 0, 0.0005}}}}}}},
          {"steps",
           {{{"say", "Look."}}, {{"say", "Turn."}, {"faults", {{"time_offset", 12}}}, {"sliders", {"time_offset"}}}}},
          {"question", "Well?"},
          {"answers",
           {{{"say", "Yes"}, {"because", "So it is."}, {"right", true}}, {{"say", "No"}, {"because", "Look again."}}}}};
}

TEST(LessonFile, HoldsTextsRecordingStepsAndAQuestion) {
  const auto lesson = parseLesson(goodLesson().dump(), "late.json");
  ASSERT_TRUE(lesson) << lesson.error().message;
  EXPECT_EQ(lesson->title.in("de"), "Verspätet");
  EXPECT_EQ(lesson->title.in("fr"), "Late");
  EXPECT_EQ(lesson->question.in("de"), "Well?");
  ASSERT_EQ(lesson->steps.size(), 2u);
  EXPECT_TRUE(lesson->steps[0].sliders.empty());
  EXPECT_EQ(lesson->steps[1].faults.front(), std::make_pair(std::string("time_offset"), 12.0));
  EXPECT_TRUE(lesson->answers[0].right);
  EXPECT_FALSE(lesson->answers[1].right);
  const auto made = lessonRecording(*lesson);
  ASSERT_TRUE(made);
  EXPECT_NEAR(made->recording.duration(), 3.0, 0.01);
}

TEST(LessonFile, SaysWhatIsWrongAndWhere) {
  const auto broken = [](const char* place, const nlohmann::json& value) {
    nlohmann::json lesson = goodLesson();
    lesson[nlohmann::json::json_pointer(place)] = value;
    return lesson;
  };
  const std::pair<nlohmann::json, const char*> cases[] = {
      {broken("/schema", "heft.lesson/2"), "heft.lesson/1"},
      {broken("/title", {{"de", "Nur deutsch"}}), "\"title\""},
      {broken("/recording/motion", "dance"), "\"motion\""},
      {broken("/recording/duration_s", 1e6), "\"duration_s\""},
      {broken("/recording/tool/mass_kg", -1), "tool"},
      {broken("/recording/tool/inertia_com_kgm2/0/0", 1.0), "\"tool\""},
      {broken("/steps", nlohmann::json::array()), "\"steps\""},
      {broken("/steps/1/say", 3), "\"steps[1].say\""},
      {broken("/steps/1/faults/time_offset", "12"), "\"steps[1].faults.time_offset\""},
      {broken("/steps/1/sliders", "time_offset"), "\"steps[1].sliders\""},
      {broken("/answers/1/right", true), "\"answers\""},
      {broken("/answers/0/because", ""), "\"answers[0].because\""},
      {nlohmann::json(3), "not a lesson"}};
  for (const auto& [lesson, place] : cases) {
    const auto read = parseLesson(lesson.dump(), "late.json");
    ASSERT_FALSE(read) << place;
    EXPECT_NE(read.error().message.find("late.json"), std::string::npos) << read.error().message;
    EXPECT_NE(read.error().message.find(place), std::string::npos) << read.error().message;
    EXPECT_EQ(read.error().message.find('\n'), std::string::npos);
  }
}

TEST(LessonFile, DamagedBytesNeverCrash) {
  const std::string good = goodLesson().dump();
  unsigned state = 99;
  const auto next = [&] { return state = state * 1664525u + 1013904223u; };
  for (int trial = 0; trial < 2000; ++trial) {
    std::string text = good;
    for (int k = 0; k < 3; ++k) text[next() % text.size()] = static_cast<char>(next() % 256);
    (void)parseLesson(text, "late.json");
  }
}

}  // namespace
}  // namespace heft
