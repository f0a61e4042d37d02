// Every dialog of the program, in both languages and themes: nothing cut, everything named, remedies that exist in the
// window.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileIconProvider>
#include <QLabel>
#include <QLineEdit>
#include <QMap>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QScrollArea>
#include <QStyle>
#include <QTemporaryDir>
#include <QTest>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTimer>
#include <QUrl>

#include "core/base/remedy.h"
#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"
#include "ui/controller/autosave.h"
#include "ui/controller/workspace.h"
#include "ui/import_dialogs/sources_dialog.h"
#include "ui/main_window/main_window.h"
#include "ui/studio/studio.h"
#include "ui/studio/window_remedies.h"
#include "ui/theme/icons.h"
#include "ui/theme/theme.h"
#include "ui/widgets/message_bar.h"

namespace heft {
namespace {

class DialogsTest : public testing::Test {
 protected:
  DialogsTest() {
    qputenv("XDG_STATE_HOME", folder.path().toUtf8());
    setRecordedFolder(folder.filePath("recordings"));
    StudioOptions options;
    options.offscreen = true;
    options.size = QSize(1280, 800);
    studio = std::make_unique<Studio>(*qApp, options);
    studio->show();
    EXPECT_TRUE(QTest::qWaitForWindowExposed(&studio->window()));
    settle();
  }
  ~DialogsTest() override {
    studio->setTheme(ThemeKind::light);
    studio->setLanguage("en");
    settle();
    studio.reset();
    qunsetenv("XDG_STATE_HOME");
    setRecordedFolder({});
  }
  void settle(int more = 100) {
    ASSERT_TRUE(QTest::qWaitFor([&] { return studio->window().settled(); }, 120000));
    QTest::qWait(more);
  }
  QString simulated() {
    SimulateOptions options;
    options.duration = 8.0;
    Payload tool;
    tool.mass = 0.8;
    tool.com = {0, 0, 0.05};
    tool.inertiaCom = Vector3d(0.002, 0.002, 0.001).asDiagonal();
    const auto made = simulate(RobotModel::panda(), tool, options);
    const QString path = folder.filePath("simulated.csv");
    EXPECT_TRUE(made.ok() && writeRecording(made->recording, path.toStdString()).ok());
    return path;
  }
  QString write(const QString& name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(text);
    return file.fileName();
  }
  static void keep(QWidget* widget, const QString& name) {
    const QString to = qEnvironmentVariable("HEFT_TEST_PICTURES");
    if (!to.isEmpty()) widget->grab().save(QDir(to).filePath(name + ".png"));
  }
  /// Names of what one works with, and texts that are not cut.
  static void check(QWidget* dialog) {
    SCOPED_TRACE(dialog->windowTitle().toStdString());
    EXPECT_FALSE(dialog->windowTitle().isEmpty());
    int controls = 0;
    for (auto* widget : dialog->findChildren<QWidget*>()) {
      if (!widget->isVisibleTo(dialog)) continue;
      const std::string what =
          std::string(widget->metaObject()->className()) + " " + widget->objectName().toStdString();
      if (const auto* label = qobject_cast<QLabel*>(widget); label && !label->text().isEmpty()) {
        const int needed = label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
        EXPECT_GE(label->height() + 1, needed) << "cut: " << label->text().toStdString();
        const int wide = label->wordWrap() ? 0 : label->sizeHint().width();
        EXPECT_GE(label->width() + 1, wide) << "cut: " << label->text().toStdString();
      }
      const bool inner =
          qobject_cast<QAbstractSpinBox*>(widget->parentWidget()) || qobject_cast<QComboBox*>(widget->parentWidget());
      if (inner || widget->focusProxy()) continue;
      const auto* button = qobject_cast<QAbstractButton*>(widget);
      if (!button && !qobject_cast<QLineEdit*>(widget) && !qobject_cast<QComboBox*>(widget) &&
          !qobject_cast<QAbstractSpinBox*>(widget))
        continue;
      ++controls;
      auto* accessible = QAccessible::queryAccessibleInterface(widget);
      EXPECT_TRUE(accessible && !accessible->text(QAccessible::Name).trimmed().isEmpty()) << "no name: " << what;
      const int wide = button && !button->text().isEmpty() ? button->minimumSizeHint().width() : 0;
      EXPECT_GE(widget->width() + 1, wide) << "cut: " << what;
    }
    EXPECT_GE(controls, 1);
  }
  /// The parts that need most room, for whoever has to find them.
  static std::string widest(const QWidget* content) {
    std::string out;
    for (const auto* each : content->findChildren<QWidget*>())
      if (each->isVisible() && each->minimumSizeHint().width() > 300)
        out += std::string(each->metaObject()->className()) + " " + each->objectName().toStdString() + " " +
               std::to_string(each->minimumSizeHint().width()) + "\n";
    return out;
  }
  QAction* entry(const QString& object) {
    for (QAction* action : studio->window().findChildren<QAction*>())
      if (action->objectName() == object) return action;
    return nullptr;
  }
  /// What the next call opens and waits for: looked at, then closed.
  void lookAt(const QString& name, const std::function<void()>& open) {
    bool seen = false;
    QTimer poll;
    poll.setInterval(30);
    QObject::connect(&poll, &QTimer::timeout, [&] {
      QWidget* dialog = QApplication::activeModalWidget();
      if (!dialog || !dialog->isVisible()) return;
      poll.stop();
      QTest::qWait(60);
      auto* sources = qobject_cast<SourcesDialog*>(dialog);
      EXPECT_TRUE(QTest::qWaitFor([&] { return !sources || !sources->looking(); }, 60000));
      QTest::qWait(60);
      check(dialog);
      keep(dialog, name);
      seen = true;
      static_cast<QDialog*>(dialog)->reject();
    });
    poll.start();
    open();
    EXPECT_TRUE(QTest::qWaitFor([&] { return seen; }, 60000)) << name.toStdString();
    settle();
  }

  QTemporaryDir folder;
  std::unique_ptr<Studio> studio;
};

TEST_F(DialogsTest, EachInBothLanguagesAndThemes) {
  const QString recording = simulated();
  const QString foreign = write("foreign.csv", "stamp,a,b,c,d,e,f\n1,0,0,0,0,0,0\n2,0,0,0,0,0,1\n3,0,0,0,0,1,1\n");
  for (const auto& [language, theme] : {std::pair("en", ThemeKind::light), std::pair("de", ThemeKind::dark)}) {
    ASSERT_TRUE(studio->setLanguage(language));
    studio->setTheme(theme);
    settle();
    const QString ending = QStringLiteral("_%1").arg(QLatin1String(language));
    studio->workspace().open(foreign);
    settle();
    MessageBar* bar = studio->window().messageBar();
    ASSERT_TRUE(bar->isVisible());
    EXPECT_FALSE(bar->text().contains("--")) << bar->text().toStdString();
    auto* action = bar->findChild<QPushButton*>("messageAction");
    ASSERT_TRUE(action->isVisible()) << "what one can do about it is one click away";
    keep(&studio->window(), "dialog_unreadable" + ending);
    lookAt("dialog_sources_foreign" + ending, [&] { action->click(); });

    studio->workspace().open(recording);
    settle();
    ASSERT_TRUE(studio->workspace().opened());
    lookAt("dialog_sources" + ending, [&] { entry("editSources")->trigger(); });
    lookAt("dialog_rig" + ending, [&] { entry("editRig")->trigger(); });
    lookAt("dialog_about" + ending, [&] { entry("about")->trigger(); });
    lookAt("dialog_known" + ending, [&] {
      studio->window().showStep(Step::result);
      settle();
      for (auto* each : studio->window().panel(Step::result)->findChildren<QPushButton*>("linkButton"))
        if (each->property("role") == "known") return each->click();
      FAIL() << "no way to say what is known";
    });
    lookAt("dialog_part" + ending, [&] {
      studio->window().showStep(Step::exportFile);
      settle();
      auto* add = studio->window().panel(Step::exportFile)->findChild<QPushButton*>("linkButton");
      ASSERT_NE(add, nullptr);
      add->click();
    });
    keep(&studio->window(), "dialog_none" + ending);
  }
}

/// Qt's own dialogs, which a bare desktop shows, wear the studio's drawings and lead to its folders.
TEST_F(DialogsTest, FileDialogsAndMessageBoxesLookLikeTheRest) {
  const QString recording = simulated();
  QDir().mkpath(recordedFolder());
  studio->workspace().open(recording);
  settle();
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs);
  for (const auto& [language, theme] : {std::pair("en", ThemeKind::light), std::pair("de", ThemeKind::dark)}) {
    ASSERT_TRUE(studio->setLanguage(language));
    studio->setTheme(theme);
    settle();
    bool seen = false;
    QTimer poll;
    poll.setInterval(30);
    QObject::connect(&poll, &QTimer::timeout, [&, picture = QStringLiteral("dialog_file_%1").arg(language)] {
      auto* dialog = qobject_cast<QFileDialog*>(QApplication::activeModalWidget());
      if (!dialog || !dialog->isVisible()) return;
      poll.stop();
      QTest::qWait(300);
      QStringList places;
      for (const QUrl& url : dialog->sidebarUrls()) places << url.toLocalFile();
      EXPECT_TRUE(places.contains(QDir::homePath())) << places.join(' ').toStdString();
      EXPECT_TRUE(places.contains(recordedFolder())) << places.join(' ').toStdString();
      EXPECT_TRUE(places.contains(folder.path())) << "where the open recording is: " << places.join(' ').toStdString();
      EXPECT_EQ(dialog->iconProvider()->icon(QFileIconProvider::Folder).pixmap(20, 20).toImage(),
                themedIcon("folder").pixmap(20, 20).toImage());
      keep(dialog, picture);
      seen = true;
      dialog->reject();
    });
    poll.start();
    entry("openFiles")->trigger();
    EXPECT_TRUE(seen);
    QMessageBox box(QMessageBox::Question, "Heft", "?", QMessageBox::Yes, &studio->window());
    EXPECT_FALSE(box.iconPixmap().isNull());
    EXPECT_EQ(qApp->style()->standardIcon(QStyle::SP_MessageBoxWarning).pixmap(32, 32).toImage(),
              iconPixmap("light_look", 32, heft::theme().look, heft::theme().panel, 1.0).toImage());
    keep(&box, QStringLiteral("dialog_question_%1").arg(language));
    settle();
  }
  QApplication::setAttribute(Qt::AA_DontUseNativeDialogs, false);
}

/// A picture in the line of a heading makes the line as high as the picture, and the page looks empty.
TEST_F(DialogsTest, PicturesOfTheManualStandInLinesOfTheirOwn) {
  for (const char* language : {"en", "de"}) {
    ASSERT_TRUE(studio->setLanguage(language));
    settle();
    studio->window().showManual(true);
    QTest::qWait(100);
    const auto* text = studio->window().findChild<QTextBrowser*>("manualText");
    ASSERT_TRUE(text && text->isVisible());
    int pictures = 0;
    for (QTextBlock block = text->document()->begin(); block.isValid(); block = block.next()) {
      if (!block.text().contains(QChar::ObjectReplacementCharacter)) continue;
      ++pictures;
      EXPECT_EQ(block.text().trimmed().size(), 1) << block.text().toStdString();
    }
    EXPECT_GE(pictures, 12);
    for (const char* name : {"room", "entry", "what-if", "proof"}) {
      const QString source = QStringLiteral("picture:%1").arg(QLatin1String(name));
      EXPECT_TRUE(text->toHtml().contains(source)) << name;
      const QVariant shown = text->document()->resource(QTextDocument::ImageResource, QUrl(source));
      EXPECT_GT(shown.value<QImage>().width(), 200) << name << " " << language;
    }
    keep(&studio->window(), QStringLiteral("manual_%1").arg(QLatin1String(language)));
    studio->window().showManual(false);
  }
}

/// A panel scrolls down, never to the right: what is wider than it is cut.
TEST_F(DialogsTest, NoStepIsWiderThanItsPanelInASmallWindow) {
  const QString recording = simulated();
  for (const char* language : {"en", "de"}) {
    ASSERT_TRUE(studio->setLanguage(language));
    settle();
    studio->workspace().open(recording);
    settle();
    MainWindow& window = studio->window();
    window.resize(1024, 700);
    ASSERT_TRUE(window.panel(Step::shape)->obey({"shape", "gripper"})->ok());
    ASSERT_TRUE(
        window.panel(Step::exportFile)->obey({"export", "franka-desk", folder.filePath("tool.json"), "replace"})->ok());
    for (const bool details : {false, true}) {
      window.showDetails(details);
      for (const Step step : kAllSteps) {
        SCOPED_TRACE(std::string(stepId(step)) + " " + language);
        window.showStep(step);
        settle();
        int pages = 0;
        for (const auto* area : window.panel(step)->findChildren<QScrollArea*>("panelScroll")) {
          if (!area->isVisible()) continue;
          ++pages;
          EXPECT_LE(area->widget()->width(), area->viewport()->width()) << widest(area->widget());
        }
        EXPECT_GE(pages, 1);
      }
    }
  }
}

TEST_F(DialogsTest, NoMenuHasTwoEntriesOfOneLetter) {
  for (const char* language : {"en", "de"}) {
    ASSERT_TRUE(studio->setLanguage(language));
    settle();
    int letters = 0;
    for (const QMenu* menu : studio->window().findChildren<QMenu*>()) {
      QMap<QChar, QString> taken;
      for (const QAction* action : menu->actions()) {
        const int at = action->text().indexOf('&');
        if (at < 0 || at + 1 >= action->text().size()) continue;
        const QChar letter = action->text()[at + 1].toLower();
        EXPECT_FALSE(taken.contains(letter)) << action->text().toStdString() << " and " << taken[letter].toStdString();
        taken[letter] = action->text();
        ++letters;
      }
    }
    EXPECT_GE(letters, 40);
  }
}

TEST_F(DialogsTest, WhatIsToBeDoneExistsInTheWindow) {
  const Remedy all[] = {Remedy::showContents,     Remedy::chooseSource, Remedy::takeSource,  Remedy::addFile,
                        Remedy::chooseTime,       Remedy::stateOffset,  Remedy::stateRate,   Remedy::nameRobot,
                        Remedy::mountSensor,      Remedy::turnWrench,   Remedy::turnGravity, Remedy::correctMount,
                        Remedy::sayStandingPoses, Remedy::keepEndsOut,  Remedy::giveCentre,  Remedy::giveInertia};
  for (const char* language : {"en", "de"}) {
    SCOPED_TRACE(language);
    ASSERT_TRUE(studio->setLanguage(language));
    settle();
    QStringList entries;
    for (const QAction* action : studio->window().findChildren<QAction*>()) {
      QString text = action->text();
      entries << text.remove('&').remove(QStringLiteral(" …"));
    }
    static const QRegularExpression quoted(QStringLiteral("[“„]([^”“]+)[”“]"));
    for (const Remedy way : all) {
      const QString words = QString::fromStdString(remedy(way, "NAME"));
      EXPECT_EQ(words.toStdString(), windowRemedy(way, "NAME"));
      EXPECT_FALSE(words.isEmpty());
      EXPECT_FALSE(words.contains("--") || words.contains("setup file") || words.contains(".json"))
          << words.toStdString();
      for (auto it = quoted.globalMatch(words); it.hasNext();) {
        const QString named = it.next().captured(1);
        EXPECT_TRUE(entries.contains(named)) << "no menu has " << named.toStdString() << ": " << words.toStdString();
      }
    }
  }
}

}  // namespace
}  // namespace heft
