#include "ui/reality_panel/lesson_guide.h"

#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/json_file.h"
#include "core/recording/csv_reader.h"
#include "ui/controller/free_file.h"
#include "ui/controller/workspace.h"
#include "ui/reality_panel/practice.h"
#include "ui/reality_panel/what_if_knobs.h"
#include "ui/widgets/basics.h"

// Outside of the namespace: Qt's macro names functions of the program.
static void initialiseLessons() { Q_INIT_RESOURCE(lessons); }

namespace heft {
namespace {

constexpr int kBuiltIn = 6;

std::string lessonLanguage() { return QLocale().name().left(2).toStdString(); }

QString wordsOf(const LessonText& text) { return QString::fromStdString(text.in(lessonLanguage())); }

}  // namespace

std::vector<Lesson> builtInLessons() {
  initialiseLessons();
  std::vector<Lesson> out;
  for (int k = 1; k <= kBuiltIn; ++k) {
    QFile file(QStringLiteral(":/lessons/%1.json").arg(k));
    if (!file.open(QIODevice::ReadOnly)) continue;
    auto lesson = parseLesson(file.readAll().toStdString(), file.fileName().toStdString());
    if (lesson) out.push_back(std::move(*lesson));
  }
  return out;
}

LessonGuide::LessonGuide(const StudioParts& parts, WhatIfKnobs* knobs, QObject* owner)
    : QObject(owner), parts_(parts), knobs_(knobs) {
  parts_.followJobs(&jobs_);
  connect(knobs_, &WhatIfKnobs::changed, this, &LessonGuide::applyFaults);
  connect(parts_.workspace, &Workspace::openedChanged, this, [this] {
    const auto opened = parts_.workspace->opened();
    // Somebody turned to another recording.
    if (on() && !jobs_.running() && opened && opened->path != file_) end();
  });
}

void LessonGuide::begin(const Lesson& lesson) {
  lesson_ = lesson;
  answered_.reset();
  // A name of its own each time: a file that is open already would not be read again.
  QDir().mkpath(practiceFolder());
  QString name = QString::fromStdString(lesson.title.in("en")).toLower();
  name.replace(QRegularExpression(QStringLiteral("[^a-z0-9]+")), QStringLiteral(" "));
  name = name.left(60).trimmed().replace(' ', '-');
  file_ = freeFile(practiceFolder(), QStringLiteral("lesson-") + name, QStringLiteral("csv"));
  knobs_->setOn(false);
  setStep(0);
  jobs_.start(
      tr("Making the lesson’s recording"),
      [lesson, path = file_](const Progress& progress) -> Result<bool> {
        auto made = lessonRecording(lesson, progress);
        if (!made) return made.error();
        return writeRecording(made->recording, path.toStdString());
      },
      [this](Result<bool> made) {
        if (!made) {
          end();
          if (!made.error().cancelled) parts_.say(Severity::error, QString::fromStdString(made.error().message));
          return;
        }
        parts_.workspace->open(file_);
        parts_.goTo(Step::realityCheck);
        knobs_->setOn(true);
      });
}

Result<bool> LessonGuide::beginFile(const QString& file) {
  const auto text = readTextFile(file.toStdString());
  if (!text) return text.error();
  const auto lesson = parseLesson(*text, QFileInfo(file).fileName().toStdString());
  if (!lesson) return lesson.error();
  begin(*lesson);
  return true;
}

void LessonGuide::end() {
  if (!on()) return;
  jobs_.cancel();
  lesson_.reset();
  knobs_->showOnly(std::nullopt);
  knobs_->setOn(false);
  emit changed();
}

void LessonGuide::setStep(std::size_t step) {
  step_ = step;
  due_ = !asking();
  if (!asking()) {
    QStringList sliders;
    for (const std::string& cause : lesson_->steps[step_].sliders) sliders << QString::fromStdString(cause);
    knobs_->showOnly(sliders);
  }
  applyFaults();
  emit changed();
}

void LessonGuide::applyFaults() {
  const auto opened = parts_.workspace->opened();
  if (!on() || !due_ || !knobs_->ready() || !opened || opened->path != file_) return;
  due_ = false;
  knobs_->allOff();
  for (const auto& [cause, size] : lesson_->steps[step_].faults)
    if (const auto turned = knobs_->turnTo(QString::fromStdString(cause), size); !turned)
      parts_.say(Severity::error, QString::fromStdString(turned.error().message));
}

void LessonGuide::next() {
  if (on() && !asking()) setStep(step_ + 1);
}

void LessonGuide::back() {
  answered_.reset();
  if (on() && step_ > 0) setStep(step_ - 1);
}

void LessonGuide::answer(int index) {
  if (!on() || !asking() || index < 0 || index >= static_cast<int>(lesson_->answers.size())) return;
  answered_ = index;
  emit changed();
}

bool LessonGuide::asking() const { return on() && step_ == lesson_->steps.size(); }

bool LessonGuide::solved() const {
  return asking() && answered_ && lesson_->answers[static_cast<std::size_t>(*answered_)].right;
}

QString LessonGuide::title() const { return on() ? wordsOf(lesson_->title) : QString(); }

QString LessonGuide::words() const {
  if (!on()) return {};
  return asking() ? wordsOf(lesson_->question) : wordsOf(lesson_->steps[step_].say);
}

void LessonGuide::addTo(QVBoxLayout* column, QWidget* content) {
  if (asking()) {
    for (int k = 0; k < static_cast<int>(lesson_->answers.size()); ++k) {
      const Lesson::Answer& each = lesson_->answers[static_cast<std::size_t>(k)];
      auto* button = new QPushButton(wordsOf(each.say), content);
      button->setObjectName(QStringLiteral("lessonAnswer%1").arg(k + 1));
      connect(button, &QPushButton::clicked, this, [this, k] { answer(k); });
      column->addWidget(button);
    }
    if (answered_) {
      const Lesson::Answer& chosen = lesson_->answers[static_cast<std::size_t>(*answered_)];
      const Card card = makeCard(chosen.right ? "cardSuggested" : "cardLook", content);
      card.layout->addWidget(styledLabel(chosen.right ? tr("Right.") : tr("Look once more."), "sectionTitle", content));
      card.layout->addWidget(wrappedLabel(wordsOf(chosen.because), "body", content));
      column->addWidget(card.frame);
    }
    column->addSpacing(8);
  }
  knobs_->addTo(column, content);
}

void LessonGuide::addActions(QMenu* practice, QWidget* owner) {
  QMenu* menu = practice->addMenu(tr("&Lessons"));
  const auto lessons = builtInLessons();
  for (std::size_t k = 0; k < lessons.size(); ++k)
    menu->addAction(QStringLiteral("&%1 %2").arg(k + 1).arg(wordsOf(lessons[k].title)), this,
                    [this, lesson = lessons[k]] { begin(lesson); });
  menu->addSeparator();
  menu->addAction(tr("From a &file …"), this, [this, owner] {
    const QString file =
        QFileDialog::getOpenFileName(owner, tr("Open a lesson"), {}, tr("Lessons (*.json);;All files (*)"));
    if (file.isEmpty()) return;
    if (const auto begun = beginFile(file); !begun)
      parts_.say(Severity::error, QString::fromStdString(begun.error().message));
  });
}

ScriptForms LessonGuide::scriptForms() {
  return {{"lesson NUMBER | lesson FILE | lesson next|back|off | lesson answer NUMBER",
           "a guided lesson: 1 to 6, or a teacher's"}};
}

std::optional<Result<bool>> LessonGuide::obey(const QStringList& words) {
  if (words[0] != "lesson") return std::nullopt;
  const auto refuse = [](const QString& why) { return Result<bool>(Error{why.toStdString()}); };
  bool number = false;
  const int which = words.value(words.size() - 1).toInt(&number);
  if (words.size() == 3 && words[1] == "answer" && number) {
    if (!asking()) return refuse(tr("Answers come after the last step of a lesson."));
    return answer(which - 1), Result<bool>(true);
  }
  if (words.size() != 2) return std::nullopt;
  if (words[1] == "off") return end(), Result<bool>(true);
  if (words[1] == "next" || words[1] == "back") {
    if (!on()) return refuse(tr("No lesson is running."));
    words[1] == "next" ? next() : back();
    return Result<bool>(true);
  }
  if (!number) return beginFile(words[1]);
  const auto lessons = builtInLessons();
  if (which < 1 || which > static_cast<int>(lessons.size())) return refuse(tr("There is no lesson %1.").arg(which));
  begin(lessons[static_cast<std::size_t>(which - 1)]);
  return Result<bool>(true);
}

}  // namespace heft
