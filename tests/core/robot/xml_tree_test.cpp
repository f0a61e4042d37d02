#include "core/robot/xml_tree.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace heft {
namespace {

using ::testing::HasSubstr;

TEST(XmlTree, remembersPlacesAndValues) {
  const auto root = parseXml(
      "\xEF\xBB\xBF<?xml version=\"1.0\"?>\n<!DOCTYPE robot [<!ELEMENT a (b)>]>\n<!-- <c> -->\n<a x='1 &lt; 2'>\n"
      "  <b y=\"&#65;&#x42;&amp;&quot;\"/>text <![CDATA[<d>]]>\n\t<e>\n</e ></a>\n",
      "f.xml");
  ASSERT_TRUE(root) << root.error().message;
  EXPECT_EQ(root->name, "a");
  EXPECT_EQ(root->line, 4);
  EXPECT_EQ(root->column, 1);
  EXPECT_EQ(*root->attribute("x"), "1 < 2");
  ASSERT_EQ(root->children.size(), 2u);
  EXPECT_EQ(root->children[0].attributeOr("y"), "AB&\"");
  EXPECT_EQ(root->children[0].line, 5);
  EXPECT_EQ(root->children[0].column, 3);
  EXPECT_EQ(root->child("e")->line, 6);
  EXPECT_EQ(root->child("e")->column, 2);
  EXPECT_EQ(root->child("d"), nullptr);
  EXPECT_EQ(root->attribute("y"), nullptr);
  EXPECT_EQ(root->attributeOr("y"), "");
}

TEST(XmlTree, refusesWhatIsBrokenAndSaysWhere) {
  const struct {
    std::string text, message;
  } cases[] = {
      {"", "f.xml contains no XML element"},
      {"words", "f.xml contains no XML element"},
      {std::string("\0\1\2", 3), "f.xml is a binary file"},
      {"<a>\n<b>\n</a>", "f.xml:3:1: this closing tag does not match <b> of line 2"},
      {"<a>\n<b></bc></a>", "f.xml:2:4: this closing tag does not match"},
      {"<a>\n <b", "f.xml:2:4: the tag <b> is never closed"},
      {"<a><b>", "f.xml:1:4: <b> is never closed; the file may be cut off"},
      {"</a>", "f.xml:1:1: this closing tag has no opening one"},
      {"<a/><b/>", "second root element"},
      {"<a x/>", "'=' is missing after \"x\""},
      {"<a x=1/>", "\"x\" is not in quotation marks"},
      {"<a x=\"1/>", "\"x\" is never closed"},
      {"<a x='1' x='2'/>", "\"x\" appears twice"},
      {"<a x='&nope;'/>", "\"&nope\" is not a known entity"},
      {"<a x='1 & 2'/>", "a plain '&' is written &amp;"},
      {"<a x='&#0;'/>", "not a known entity"},
      {"<a x='&#x110000;'/>", "not a known entity"},
      {"< a/>", "a tag's name is missing"},
      {"<a><!-- </a>", "this comment is never closed"},
      {"<a><![CDATA[ </a>", "this CDATA block is never closed"},
      {"<!DOCTYPE a [", "this DOCTYPE is never closed"},
      {"<?xml", "this processing instruction is never closed"},
      {"<a></a", "'>' is missing"},
  };
  for (const auto& test : cases) {
    const auto root = parseXml(test.text, "f.xml");
    ASSERT_FALSE(root) << test.text;
    EXPECT_THAT(root.error().message, HasSubstr(test.message));
  }
}

TEST(XmlTree, endsAtTooMuchOfAnything) {
  std::string deep;
  for (int k = 0; k < 100000; ++k) deep += "<a>";
  EXPECT_THAT(parseXml(deep, "f").error().message, HasSubstr("nested deeper than 64"));
  std::string wide = "<a";
  for (int k = 0; k < 100000; ++k) wide += " x" + std::to_string(k) + "='1'";
  EXPECT_THAT(parseXml(wide + "/>", "f").error().message, HasSubstr("too many attributes"));
}

}  // namespace
}  // namespace heft
