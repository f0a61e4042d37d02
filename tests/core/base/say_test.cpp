#include "core/base/say.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <regex>
#include <sstream>

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
