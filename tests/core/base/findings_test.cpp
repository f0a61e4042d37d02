#include "core/base/findings.h"

#include <gtest/gtest.h>

namespace heft {
namespace {

TEST(Findings, LineNamesEveryPartThatIsThere) {
  Finding finding{Severity::warning, "time_gap", "A gap.", "Record again.", {"rec.csv", 12, 5}};
  EXPECT_EQ(toLine(finding), "warning: rec.csv:12:5: A gap. Record again.");
  finding.where.column = 0;
  EXPECT_EQ(toLine(finding), "warning: rec.csv:12: A gap. Record again.");
  finding.where.line = 0;
  EXPECT_EQ(toLine(finding), "warning: rec.csv: A gap. Record again.");
  finding.remedy.clear();
  finding.severity = Severity::info;
  EXPECT_EQ(toLine(finding), "info: rec.csv: A gap.");
  finding.where.file.clear();
  EXPECT_EQ(toLine(finding), "info: A gap.");
}

TEST(Findings, WholeColumnIsNamed) { EXPECT_EQ(toString(Location{"rec.csv", 0, 5}), "rec.csv, column 5"); }

TEST(Findings, ErrorAtReadsLikeAFindingWithoutSeverity) {
  EXPECT_EQ(errorAt({"rec.csv", 3, 2}, "bad.", "Repair it.").message, "rec.csv:3:2: bad. Repair it.");
  EXPECT_FALSE(errorAt({}, "bad.").cancelled);
}

TEST(Findings, OnlyErrorsAreErrors) {
  Findings findings{{Severity::info, "a", "", "", {}}, {Severity::warning, "b", "", "", {}}};
  EXPECT_FALSE(hasErrors(findings));
  findings.push_back({Severity::error, "c", "", "", {}});
  EXPECT_TRUE(hasErrors(findings));
  EXPECT_FALSE(hasErrors({}));
}

TEST(Findings, SeveritiesHaveTheContractsNames) {
  EXPECT_EQ(toString(Severity::info), "info");
  EXPECT_EQ(toString(Severity::warning), "warning");
  EXPECT_EQ(toString(Severity::error), "error");
}

}  // namespace
}  // namespace heft
