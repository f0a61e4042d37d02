#include "core/base/say.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "core/base/said_again.h"
#include "core/base/time_span.h"

namespace heft {
namespace {

class Said : public testing::Test {
 protected:
  void speakGerman() {
    setTranslator(
        [](const char* pattern) -> std::string {
          const std::string text = pattern;
          if (text == "{:.1f} s of {} look touched.") return "Von {1} sehen {0:.1f} s berührt aus.";
          if (text == "the whole") return "allem";
          if (text == "{} kg") return "{} kg und {}";
          if (text == "{} pieces") return "{:.1f} Teile";
          return {};
        },
        ',');
  }
  ~Said() override { setTranslator({}); }
};

TEST_F(Said, EnglishUnlessAnotherLanguageWasChosen) {
  EXPECT_EQ(heft::say("{:.1f} s of {} look touched.", 2.54, heft::say("the whole")),
            "2.5 s of the whole look touched.");
  speakGerman();
  EXPECT_EQ(heft::say("{:.1f} s of {} look touched.", 2.54, heft::say("the whole")),
            "Von allem sehen 2,5 s berührt aus.");
  setTranslator({});
  EXPECT_EQ(heft::say("the whole"), "the whole");
}

TEST_F(Said, AShortTimeDoesNotBeginWhereItEnds) {
  EXPECT_EQ(timeSpan(1.2, 3.44), "1.2 to 3.4 s");
  EXPECT_EQ(timeSpan(1.16, 1.24), "1.16 to 1.24 s");
}

TEST_F(Said, WhatHasNoTranslationStaysEnglish) {
  speakGerman();
  EXPECT_EQ(heft::say("{:.1f} rows of {{x}}", 3.0), "3.0 rows of {x}");
  EXPECT_EQ(joined({heft::say("the whole"), "q1"}), "allem, q1");
}

TEST_F(Said, AWrongTranslationGivesWayToEnglish) {
  speakGerman();
  EXPECT_EQ(heft::say("{} kg", 1.5), "1.5 kg") << "a place too many";
  EXPECT_EQ(heft::say("{} pieces", "4"), "4 pieces") << "a format that does not fit";
}

/// What is kept as text follows the language, alone, among other words, within another sentence, and out of a file.
TEST_F(Said, WhatWasSaidIsSaidAgainInAnotherLanguage) {
  rememberSentences(100);
  const std::string english = heft::say("{:.1f} s of {} look touched.", 2.54, heft::say("the whole"));
  const std::string kept = makingOf("rec.csv: " + english + " " + english).dump();
  speakGerman();
  const std::string german = "Von allem sehen 2,5 s berührt aus.";
  EXPECT_EQ(sayAgain(english), german);
  EXPECT_EQ(sayAgain("rec.csv: " + english + " Look at the whole."), "rec.csv: " + german + " Look at the whole.");
  EXPECT_EQ(sayAgain(english + " " + english), german + " " + german);
  EXPECT_EQ(sayAgain("nobody said this, ever"), "nobody said this, ever");
  setTranslator({});
  EXPECT_EQ(sayAgain(german), english) << "and back";
  rememberSentences(0);
  EXPECT_EQ(sayAgain(german), german);
  EXPECT_TRUE(makingOf(english).is_null());
  speakGerman();
  EXPECT_EQ(sayFrom(nlohmann::json::parse(kept), "?"), "rec.csv: " + german + " " + german);
}

TEST_F(Said, OnlyTheLastSentencesAreRemembered) {
  rememberSentences(3);
  std::vector<std::string> texts;
  for (const double seconds : {1.0, 2.0, 3.0, 4.0})
    texts.push_back(heft::say("{:.1f} s of {} look touched.", seconds, "it"));
  EXPECT_TRUE(makingOf(texts[0]).is_null());
  for (int i = 1; i < 4; ++i) EXPECT_FALSE(makingOf(texts[static_cast<std::size_t>(i)]).is_null());
  rememberSentences(0);
}

TEST_F(Said, DamagedMakingsGiveTheTextItself) {
  for (const char* damaged :
       {"null", "3", "\"x\"", "{}", R"({"template": 3, "values": []})", R"({"template": "{}", "values": []})",
        R"({"template": "{:1000000000}", "values": [1]})", R"({"template": "{:.999}", "values": [1.5]})",
        R"({"template": "{", "values": [1]})", R"({"template": "{:d}", "values": ["x"]})",
        R"({"template": "{}", "values": [[[[[["deep"]]]]]]})", R"([{"template": "{}"}])",
        R"({"template": "{}", "values": {"a": null}})"})
    EXPECT_EQ(sayFrom(nlohmann::json::parse(damaged), "itself"), "itself") << damaged;
}

std::vector<std::string> placesOf(const std::string& text) {
  static const std::regex kPlace(R"(\{[^{}]*\})");
  std::vector<std::string> places;
  for (std::sregex_iterator it(text.begin(), text.end(), kPlace), end; it != end; ++it) places.push_back(it->str());
  std::sort(places.begin(), places.end());
  return places;
}

TEST(Translations, EveryGermanTemplateHasThePlacesOfItsEnglishOne) {
  std::ifstream file(HEFT_SOURCE_DIR "/resources/translations/heft_de.ts");
  std::stringstream all;
  all << file.rdbuf();
  std::string text = all.str();
  const auto from = text.find("<name>heft</name>"), to = text.find("</context>", from);
  ASSERT_NE(from, std::string::npos);
  text = text.substr(from, to - from);
  static const std::regex kPair(R"(<source>([^<]*)</source>\s*<translation>([^<]*)</translation>)");
  int templates = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), kPair), end; it != end; ++it, ++templates)
    EXPECT_EQ(placesOf((*it)[1].str()), placesOf((*it)[2].str())) << (*it)[1].str();
  EXPECT_GT(templates, 300) << "what core says is among the translations";
}

}  // namespace
}  // namespace heft
