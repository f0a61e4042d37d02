#include "ui/shape_panel/shape_panel.h"

#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QApplication>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMimeData>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>
#include <QUrl>

#include "ui/controller/workspace.h"
#include "ui/widgets/stepper.h"

namespace heft {
namespace {

using Answer = ShapeChoice::Answer;

class ShapePanelTest : public testing::Test {
 protected:
  ShapePanelTest() {
    parts.workspace = &workspace;
    parts.goTo = [this](Step step) { went = step; };
    panel = std::make_unique<ShapePanel>(parts);
    panel->resize(440, 900);
    panel->show();
    QApplication::setActiveWindow(panel.get());
  }
  void click(const char* name) {
    auto* button = panel->findChild<QAbstractButton*>(name);
    ASSERT_NE(button, nullptr) << name;
    QTest::mouseClick(button, Qt::LeftButton);
    QApplication::processEvents();
  }
  void type(const char* stepper, const QString& text) {
    auto* widget = panel->findChild<Stepper*>(stepper);
    ASSERT_NE(widget, nullptr) << stepper;
    auto* field = widget->findChild<QLineEdit*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, text);
    QTest::keyClick(field, Qt::Key_Return);
    QApplication::processEvents();
  }
  void typeWeight(const char* name, const QString& text) {
    auto* field = panel->findChild<QLineEdit*>(name);
    ASSERT_NE(field, nullptr) << name;
    field->setFocus();
    field->selectAll();
    if (text.isEmpty()) {
      QTest::keyClick(field, Qt::Key_Delete);
    } else {
      QTest::keyClicks(field, text);
    }
    QTest::keyClick(field, Qt::Key_Return);
    QApplication::processEvents();
  }
  /// The sentence at a field; empty if there is none.
  QString complaint() {
    for (const QLabel* label : panel->findChildren<QLabel*>("fieldError"))
      if (label->isVisible()) return label->text();
    return {};
  }
  const ShapeChoice& choice() { return workspace.session().shape; }
  const Shape& shape() { return choice().shape; }
  QUndoStack* undo() { return workspace.undoStack(); }

  QTemporaryDir folder;
  Workspace workspace;
  StudioParts parts;
  std::optional<Step> went;
  std::unique_ptr<ShapePanel> panel;
};

TEST_F(ShapePanelTest, APictureIsChosenMeasuredAndTakenBack) {
  EXPECT_EQ(panel->state().progress, StepState::Progress::later) << "nothing is recorded yet";
  click("picture_box");
  ASSERT_EQ(choice().answer, Answer::given);
  ASSERT_EQ(shape().bodies.size(), 1u);
  EXPECT_EQ(panel->state().progress, StepState::Progress::done);
  type("size_0_2", "120");
  type("size_0_0", "4,5 cm");
  EXPECT_EQ(shape().bodies[0].dims[2], 0.12);
  EXPECT_NEAR(shape().bodies[0].dims[0], 0.045, 1e-12);
  EXPECT_NEAR(shape().bodies[0].X_SB.translation().z(), 0.06, 1e-12) << "its near end stays at the sensor";
  auto* field = panel->findChild<Stepper*>("size_0_2")->findChild<QLineEdit*>();
  EXPECT_EQ(field->text(), "120");
  QTest::keyClick(field, Qt::Key_Up);
  EXPECT_NEAR(shape().bodies[0].dims[2], 0.121, 1e-12);
  QTest::keyClick(field, Qt::Key_PageDown);
  EXPECT_NEAR(shape().bodies[0].dims[2], 0.111, 1e-12);
  EXPECT_EQ(undo()->count(), 5);
  for (int i = 0; i < 5; ++i) undo()->undo();
  EXPECT_EQ(choice().answer, Answer::notGiven);
  undo()->redo();
  EXPECT_EQ(choice().answer, Answer::given);
  click("mainButton");
  EXPECT_EQ(went, Step::result);
}

TEST_F(ShapePanelTest, HoldingAButtonIsOneEdit) {
  click("picture_cylinder");
  const int before = undo()->count();
  const double length = shape().bodies[0].dims[1];
  auto* more = panel->findChild<Stepper*>("size_0_1")->findChildren<QToolButton*>().last();
  // What a button that repeats sends while it is held.
  emit more->pressed();
  for (int i = 0; i < 7; ++i) emit more->clicked();
  EXPECT_NEAR(shape().bodies[0].dims[1], length + 0.007, 1e-12);
  EXPECT_EQ(undo()->count(), before + 1);
  undo()->undo();
  EXPECT_NEAR(shape().bodies[0].dims[1], length, 1e-12);
}

TEST_F(ShapePanelTest, WhatIsNoLengthStaysAtItsFieldWithASentence) {
  click("picture_tube");
  const Shape before = shape();
  const int edits = undo()->count();
  type("size_0_0", "wide");
  EXPECT_TRUE(complaint().contains("wide")) << complaint().toStdString();
  EXPECT_EQ(undo()->count(), edits);
  type("size_0_0", "-5");
  EXPECT_FALSE(complaint().isEmpty());
  type("size_0_1", "500");  // A hole wider than the tube.
  EXPECT_TRUE(complaint().contains("inner")) << complaint().toStdString();
  EXPECT_EQ(shape().bodies[0].dims, before.bodies[0].dims);
  EXPECT_EQ(undo()->count(), edits);
  type("size_0_1", "10");
  EXPECT_TRUE(complaint().isEmpty()) << complaint().toStdString();
  EXPECT_NEAR(shape().bodies[0].dims[1], 0.005, 1e-12);
}

TEST_F(ShapePanelTest, NotKnowingIsAnAnswerAndKeepsWhatWasSaid) {
  click("picture_box");
  type("size_0_2", "93");
  click("picture_unknown");
  EXPECT_EQ(choice().answer, Answer::unknown);
  EXPECT_FALSE(estimateOptions(workspace.session()).shape.has_value());
  EXPECT_EQ(panel->state().light, Light::unknown);
  click("picture_box");
  EXPECT_EQ(choice().answer, Answer::given);
  EXPECT_NEAR(shape().bodies[0].dims[2], 0.093, 1e-12);
  EXPECT_TRUE(estimateOptions(workspace.session()).shape.has_value());
}

TEST_F(ShapePanelTest, EachPictureHasItsOwnSizesAndKeepsThem) {
  click("picture_sphere");
  type("size_0_0", "67");
  click("picture_capsule");
  EXPECT_GT(shape().bodies[0].dims[1], 1.2 * 2.0 * shape().bodies[0].dims[0]) << "a capsule, not a sphere again";
  click("picture_plate");
  click("picture_gripper");
  const Vector3d gripper = extentOf(shape()).sizes();
  EXPECT_GT(gripper.z(), 0.05) << "not as flat as the plate";
  click("picture_box");
  type("size_0_2", "200");
  click("picture_cylinder");
  EXPECT_NE(shape().bodies[0].dims[1], 0.2);
  click("picture_box");
  EXPECT_NEAR(shape().bodies[0].dims[2], 0.2, 1e-12) << "as it was left";
}

TEST_F(ShapePanelTest, WeightMaterialAndInsideAreTakenOrRefused) {
  click("picture_box");
  typeWeight("weight", "812 g");
  ASSERT_TRUE(shape().totalMass);
  EXPECT_NEAR(*shape().totalMass, 0.812, 1e-12);
  typeWeight("weight", "heavy");
  EXPECT_TRUE(complaint().contains("heavy"));
  EXPECT_NEAR(*shape().totalMass, 0.812, 1e-12);
  typeWeight("weight", "0,9 kg");
  EXPECT_NEAR(*shape().totalMass, 0.9, 1e-12);
  EXPECT_TRUE(complaint().isEmpty());
  // 60 x 60 x 80 mm of steel would be 2.26 kg.
  auto* material = panel->findChild<QComboBox*>("material");
  material->setCurrentIndex(1);
  emit material->activated(1);
  EXPECT_TRUE(complaint().contains("2.26")) << complaint().toStdString();
  EXPECT_FALSE(shape().bodies[0].density);
  click("insideHollow");
  ASSERT_TRUE(shape().bodies[0].wall);
  EXPECT_NEAR(*shape().bodies[0].wall, 0.003, 1e-12);
  type("wall", "40");
  EXPECT_TRUE(complaint().contains("too thick")) << complaint().toStdString();
  EXPECT_NEAR(*shape().bodies[0].wall, 0.003, 1e-12);
  click("insideSolid");
  EXPECT_FALSE(shape().bodies[0].wall);
  typeWeight("weight", "");
  EXPECT_FALSE(shape().totalMass);
  click("sureExact");
  EXPECT_EQ(shape().certainty, Certainty::exact);
}

TEST_F(ShapePanelTest, PartsAreAddedChosenWeighedAndTakenAway) {
  click("picture_gripper");
  click("picture_several");
  ASSERT_EQ(shape().bodies.size(), 2u) << "the gripper's boxes become parts";
  auto* add = panel->findChild<QPushButton*>("addPart");
  ASSERT_NE(add, nullptr);
  for (QAction* action : add->menu()->actions())
    if (action->objectName() == "add_sphere") action->trigger();
  QApplication::processEvents();
  ASSERT_EQ(shape().bodies.size(), 3u);
  EXPECT_EQ(shape().bodies[2].kind, BodyKind::sphere);
  EXPECT_NE(panel->findChild<Stepper*>("size_2_0"), nullptr) << "the new part is the chosen one";
  typeWeight("partWeight", "0.2");
  EXPECT_NEAR(shape().bodies[2].mass.value_or(0), 0.2, 1e-12);
  typeWeight("weight", "0.15");
  EXPECT_FALSE(shape().totalMass);
  EXPECT_TRUE(complaint().contains("0.200 kg")) << complaint().toStdString();
  click("part_0");
  QTest::qWait(20);
  EXPECT_NE(panel->findChild<Stepper*>("size_0_0"), nullptr);
  click("removePart_0");
  EXPECT_EQ(shape().bodies.size(), 2u);
  EXPECT_TRUE(shapeLine(choice()).startsWith("2 part"));
}

TEST_F(ShapePanelTest, PlaceAndTiltAreNumbersToo) {
  click("picture_box");
  click("placeButton");
  type("place_z", "25");
  EXPECT_NEAR(nearEnd(shape().bodies[0]).z(), 0.025, 1e-12);
  type("tilt_x", "90");
  EXPECT_NEAR((nearEnd(shape().bodies[0]) - Vector3d(0, 0, 0.025)).norm(), 0, 1e-9);
  EXPECT_NEAR(shape().bodies[0].X_SB.translation().y(), -0.04, 1e-9);
  undo()->undo();
  undo()->undo();
  EXPECT_NEAR(nearEnd(shape().bodies[0]).norm(), 0, 1e-12);
}

/// A closed cuboid as ASCII STL; without its top on request.
QString writeStl(const QString& path, double size, bool open = false) {
  QFile file(path);
  if (!file.open(QIODevice::WriteOnly)) return {};
  QString text = "solid box\n";
  const auto corner = [&](int i) {
    return QString("%1 %2 %3").arg(i & 1 ? size : 0).arg(i & 2 ? size : 0).arg(i & 4 ? size : 0);
  };
  const int faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 5, 4}, {1, 3, 5}, {3, 7, 5},
                            {3, 2, 7}, {2, 6, 7}, {2, 0, 6}, {0, 4, 6}, {4, 5, 6}, {5, 7, 6}};
  for (int f = 0; f < (open ? 10 : 12); ++f) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const int v : faces[f]) text += "vertex " + corner(v) + "\n";
    text += "endloop\nendfacet\n";
  }
  file.write((text + "endsolid box\n").toUtf8());
  return path;
}

TEST_F(ShapePanelTest, ACadMeshIsDroppedItsUnitGuessedAndChanged) {
  const QString file = writeStl(folder.filePath("tool.stl"), 80);
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(file)});
  QDragEnterEvent enter(QPoint(100, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(panel.get(), &enter);
  EXPECT_TRUE(enter.isAccepted());
  QDropEvent drop(QPointF(100, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(panel.get(), &drop);
  ASSERT_TRUE(QTest::qWaitFor([&] { return choice().answer == Answer::given; }, 20000));
  ASSERT_EQ(shape().bodies.size(), 1u);
  EXPECT_EQ(shape().bodies[0].unit, 0.001);
  EXPECT_NEAR(extentOf(shape()).sizes().x(), 0.08, 1e-6);
  QApplication::processEvents();
  bool explained = false;
  for (const QLabel* label : panel->findChildren<QLabel*>())
    explained = explained || (label->isVisible() && label->text().contains("Assuming millimetres"));
  EXPECT_TRUE(explained);
  click("meshPlace");
  EXPECT_NEAR((shape().bodies[0].X_SB.translation() - Vector3d(-0.04, -0.04, 0)).norm(), 0, 1e-6);
  click("unit_cm");
  ASSERT_TRUE(QTest::qWaitFor([&] { return shape().bodies[0].unit == 0.01; }, 20000));
  undo()->undo();
  EXPECT_EQ(shape().bodies[0].unit, 0.001);
}

TEST_F(ShapePanelTest, SeveralBodiesMayHoldACadMesh) {
  ASSERT_TRUE(panel->obey({"shape", "several"})->ok());
  const double end = extentOf(shape()).max().z();
  ASSERT_EQ(shape().bodies.size(), 2u);
  EXPECT_NE(panel->findChild<QAction*>("add_mesh"), nullptr) << "offered beside the other parts";
  panel->addMeshPart(writeStl(folder.filePath("tip.stl"), 40));
  ASSERT_TRUE(QTest::qWaitFor([&] { return shape().bodies.size() == 3; }, 20000));
  EXPECT_EQ(shape().bodies[2].kind, BodyKind::mesh);
  EXPECT_EQ(shape().bodies[2].unit, 0.001) << "guessed";
  Shape tip = shape();
  tip.bodies = {shape().bodies[2]};
  const auto box = extentOf(tip);
  EXPECT_NEAR(box.min().z(), end, 1e-6) << "it begins where the others end";
  EXPECT_NEAR(box.center().head<2>().norm(), 0.0, 1e-6);
  QApplication::processEvents();
  EXPECT_NE(panel->findChild<QPushButton*>("part_2"), nullptr);
  EXPECT_EQ(panel->findChild<QPushButton*>("part_2")->property("role").toString(), "chosen");
  // A second one dropped joins, too; one that is no mesh changes nothing.
  QFile bad(folder.filePath("bad.stl"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("no mesh at all");
  bad.close();
  panel->addMeshPart(bad.fileName());
  QTest::qWait(200);
  EXPECT_EQ(shape().bodies.size(), 3u);
  undo()->undo();
  EXPECT_EQ(shape().bodies.size(), 2u);
}

TEST_F(ShapePanelTest, AMeshThatIsOpenOrNoMeshIsSaid) {
  const auto open = panel->obey({"shape", "mesh", writeStl(folder.filePath("open.stl"), 80, true)});
  ASSERT_TRUE(open && open->ok());
  QApplication::processEvents();
  bool said = false;
  for (const QLabel* label : panel->findChildren<QLabel*>())
    said = said || (label->isVisible() && label->text().contains("open edges"));
  EXPECT_TRUE(said);
  QFile bad(folder.filePath("bad.stl"));
  ASSERT_TRUE(bad.open(QIODevice::WriteOnly));
  bad.write("no mesh at all");
  bad.close();
  const auto none = panel->obey({"shape", "mesh", bad.fileName()});
  ASSERT_TRUE(none);
  ASSERT_FALSE(none->ok());
  EXPECT_NE(none->error().message.find("bad.stl"), std::string::npos);
}

TEST_F(ShapePanelTest, AScriptSaysTheSameThings) {
  EXPECT_FALSE(panel->obey({"export", "x"}).has_value());
  ASSERT_TRUE(panel->obey({"shape", "box", "60x40x120", "at", "0,0,60", "good", "weighs", "0.8"})->ok());
  EXPECT_EQ(shape().bodies[0].dims, (std::vector<double>{0.06, 0.04, 0.12}));
  EXPECT_NEAR((shape().bodies[0].X_SB.translation() - Vector3d(0, 0, 0.06)).norm(), 0, 1e-12);
  EXPECT_EQ(shape().certainty, Certainty::good);
  EXPECT_EQ(shape().totalMass, 0.8);
  ASSERT_TRUE(panel->obey({"shape", "tube", "50x20x90"})->ok());
  EXPECT_NEAR(shape().bodies[0].dims[1], 0.010, 1e-12);
  ASSERT_TRUE(panel->obey({"shape", "gripper", "74x120x64", "24x86x46"})->ok());
  EXPECT_NEAR(extentOf(shape()).max().z(), 0.110, 1e-12);
  EXPECT_FALSE(panel->obey({"shape", "spoon"})->ok());
  EXPECT_FALSE(panel->obey({"shape", "box", "60x40"})->ok());
  EXPECT_FALSE(panel->obey({"shape", "box", "60x40x120", "at", "0"})->ok());
  EXPECT_FALSE(panel->obey({"shape", "box", "60x40x120", "wall", "30"})->ok());
  ASSERT_TRUE(panel->obey({"shape", "unknown"})->ok());
  EXPECT_EQ(choice().answer, Answer::unknown);
}

TEST(ToolHandles, ADragMakesWholeMillimetresAndKeepsTheNearEnd) {
  Shape shape;
  shape.bodies = sketch(ToolPicture::box, Vector3d(0.06, 0.04, 0.12));
  const auto handles = toolHandles(shape, ToolPicture::box, 0, ToolMode::size);
  ASSERT_EQ(handles.size(), 3u);
  HandleDrag drag;
  drag.handle = handles[2];
  EXPECT_NEAR((drag.handle.point - Vector3d(0, 0, 0.12)).norm(), 0, 1e-12);
  drag.along = 0.01234;
  Shape longer = dragTool(shape, ToolPicture::box, 0, drag);
  EXPECT_NEAR(longer.bodies[0].dims[2], 0.132, 1e-12);
  EXPECT_NEAR(nearEnd(longer.bodies[0]).norm(), 0, 1e-12);
  drag.handle = handles[0];
  drag.along = 0.005;  // The other side moves as far.
  EXPECT_NEAR(dragTool(shape, ToolPicture::box, 0, drag).bodies[0].dims[0], 0.07, 1e-12);
  drag.along = -1;
  EXPECT_GT(dragTool(shape, ToolPicture::box, 0, drag).bodies[0].dims[0], 0);

  const auto moves = toolHandles(shape, ToolPicture::box, 0, ToolMode::move);
  drag.handle = moves[1];
  drag.shift = {0, 0.0204, 0};
  EXPECT_NEAR((nearEnd(dragTool(shape, ToolPicture::box, 0, drag).bodies[0]) - Vector3d(0, 0.02, 0)).norm(), 0, 1e-12);
  const auto turns = toolHandles(shape, ToolPicture::box, 0, ToolMode::turn);
  drag.handle = turns[2];
  drag.angle = 0.53;
  const Shape turned = dragTool(shape, ToolPicture::box, 0, drag);
  EXPECT_NEAR(rpyFromRotation(turned.bodies[0].X_SB.linear()).z() * 180 / 3.14159265358979, 30.0, 1e-6);
  EXPECT_NEAR(nearEnd(turned.bodies[0]).norm(), 0, 1e-12);
}

TEST(Stepper, UnderstandsWhatPeopleType) {
  EXPECT_EQ(parseMeasure("12", "mm"), 12.0);
  EXPECT_EQ(parseMeasure(" 1,5 cm ", "mm"), 15.0);
  EXPECT_EQ(parseMeasure("0.12 m", "mm"), 120.0);
  EXPECT_EQ(parseMeasure("1in", "mm"), 25.4);
  EXPECT_EQ(parseMeasure(QString::fromUtf8("−30"), QString(QChar(0xb0))), -30.0);
  EXPECT_EQ(parseMeasure("3 kg", "mm"), std::nullopt);
  EXPECT_EQ(parseMeasure("1.2.3", "mm"), std::nullopt);
  EXPECT_EQ(parseMeasure("", "mm"), std::nullopt);
}

}  // namespace
}  // namespace heft
