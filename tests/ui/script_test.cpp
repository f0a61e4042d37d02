#include <gtest/gtest.h>

#include "ui/steps/script_help.h"
#include "ui/studio/script.h"

namespace heft {
namespace {

TEST(Script, SplitsWordsAndKeepsLineNumbers) {
  const auto lines =
      parseScript("# a walk\nopen \"my rec.csv\" b.csv\n\n  step  mark # then\npicture \"\"\n", "walk.txt");
  ASSERT_TRUE(lines.ok());
  ASSERT_EQ(lines->size(), 3u);
  EXPECT_EQ((*lines)[0].number, 2);
  EXPECT_EQ((*lines)[0].words, (QStringList{"open", "my rec.csv", "b.csv"}));
  EXPECT_EQ((*lines)[1].number, 4);
  EXPECT_EQ((*lines)[1].words, (QStringList{"step", "mark"}));
  EXPECT_EQ((*lines)[2].words, (QStringList{"picture", ""}));
  const auto broken = parseScript("open \"a\nstep mark", "walk.txt");
  ASSERT_FALSE(broken.ok());
  EXPECT_EQ(broken.error().message.find("walk.txt:1:"), 0u) << broken.error().message;
}

TEST(Script, FormsAreFoundByTheirVerb) {
  const ScriptForms forms{{"mark FROM TO LABEL", "marks"}, {"undo | redo", ""}, {"live stop | live go on", "a run"}};
  EXPECT_EQ(formsOf(forms, "mark"), "mark FROM TO LABEL");
  EXPECT_EQ(formsOf(forms, "redo"), "redo");
  EXPECT_EQ(formsOf(forms, "live"), "live stop | live go on");
  EXPECT_EQ(formsOf(forms, "liv"), "");
  EXPECT_EQ(scriptHelp(forms),
            "  mark FROM TO LABEL                marks\n  undo | redo\n  live stop | live go on            a run\n");
}

TEST(Script, TheScreenHoldsTheLargestWindow) {
  const auto lines = parseScript("size 1280x800\nsize 1920x1080\nsize 99x99", "s");
  EXPECT_EQ(screenFor(*lines, {1440, 900}), QSize(1920, 1080));
  EXPECT_EQ(parseSize("1280x800"), QSize(1280, 800));
  for (const char* bad : {"1280", "x800", "100x100", "9999x800", "axb", ""}) EXPECT_FALSE(parseSize(bad)) << bad;
}

}  // namespace
}  // namespace heft
