#include <gtest/gtest.h>

#include <QDialogButtonBox>
#include <QLineEdit>
#include <QPushButton>

#include "tests/ui/fixtures.h"
#include "ui/models/method_table.h"
#include "ui/models/result_text.h"
#include "ui/results/known_values.h"

namespace heft {
namespace {

TEST(MethodTable, HasARowAMethodAlsoForThoseThatFailed) {
  const EstimateReport report = test::reportOn(test::sineRecording(1000, 100));
  std::vector<ComparedMethod> methods{{Method::map, report, ""}, {Method::tls, std::nullopt, "It diverged."}};
  const MethodTable plain = methodTable(methods, Method::map);
  ASSERT_EQ(plain.rows.size(), 2u);
  for (const MethodRow& row : plain.rows) EXPECT_EQ(row.cells.size(), plain.headers.size());
  EXPECT_EQ(plain.headers.size(), plain.headerTips.size());
  EXPECT_EQ(plain.rows[0].cells[1], QString::fromUtf8("0.812 ± 0.004"));
  EXPECT_TRUE(plain.rows[0].chosen);
  EXPECT_EQ(plain.rows[1].tip, "It diverged.");
  EXPECT_FALSE(plain.rows[1].usable);
  methods[0].report->relativeError = RelativeError{0.004, 0.1, 0.2, 0.3, true, true, false};
  const MethodTable known = methodTable(methods, Method::map);
  EXPECT_EQ(known.headers.size(), plain.headers.size() + 3);
  EXPECT_EQ(known.rows[0].cells[6], "0.40");
  EXPECT_EQ(known.rows[0].cells[8], QString(QChar(0x2014)));
}

TEST(KnownValues, AreComparedAsInThePaper) {
  const EstimateReport report = test::reportOn(test::sineRecording(1000, 100));
  PartialPayload known;
  known.mass = 0.8;
  known.com = Vector3d(0.0014, -0.0005, 0.0408);
  const ResultText text = describeResult(report, {known});
  ASSERT_EQ(text.known.size(), 2u);
  EXPECT_EQ(text.known[0].value, "0.800 kg known, 1.50 % off");
  EXPECT_TRUE(text.known[1].value.startsWith("5.0 mm off (12.2 %)")) << text.known[1].value.toStdString();
}

TEST(KnownValues, TheDialogTakesHalfOfThemButNoHalfVectors) {
  KnownValuesDialog dialog({});
  dialog.findChild<QLineEdit*>("knownMass")->setText("0.815");
  auto* ok = dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
  const auto com = dialog.findChildren<QLineEdit*>("knownCom");
  ASSERT_EQ(com.size(), 3);
  com[0]->setText("1.5");
  ok->click();
  EXPECT_EQ(dialog.result(), QDialog::Rejected);
  com[1]->setText("-0.5");
  com[2]->setText("46");
  ok->click();
  EXPECT_EQ(dialog.result(), QDialog::Accepted);
  EXPECT_EQ(dialog.values().mass, 0.815);
  EXPECT_NEAR(dialog.values().com->z(), 0.046, 1e-12);
  EXPECT_FALSE(dialog.values().inertiaCom);
}

}  // namespace
}  // namespace heft
