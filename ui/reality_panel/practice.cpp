#include "ui/reality_panel/practice.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QPushButton>
#include <QRegularExpression>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <vector>

#include "core/simulation/practice.h"
#include "ui/reality_cards/card_parts.h"
#include "ui/reality_cards/cause_words.h"

namespace heft {
namespace {

struct PracticeWords {
  Q_DECLARE_TR_FUNCTIONS(Practice)
};

}  // namespace

QString practiceFolder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::CacheLocation)).absoluteFilePath("practice");
}

QString practiceFile(std::uint64_t seed) {
  return QDir(practiceFolder()).filePath(QStringLiteral("practice-%1.csv").arg(seed));
}

std::optional<std::uint64_t> practiceSeed(const QString& path) {
  const QFileInfo file(path);
  if (file.absolutePath() != practiceFolder()) return std::nullopt;
  static const QRegularExpression pattern(QStringLiteral("^practice-(\\d+)$"));
  const auto match = pattern.match(file.completeBaseName());
  if (!match.hasMatch()) return std::nullopt;
  bool ok = false;
  const auto seed = match.captured(1).toULongLong(&ok);
  return ok ? std::optional<std::uint64_t>(seed) : std::nullopt;
}

namespace {

void addTwin(QVBoxLayout* column, QWidget* parent, const RealityFindings::Found& found, const RiddleActions& does) {
  auto* twin = new QPushButton(
      found.twin ? PracticeWords::tr("Hide the clean twin") : PracticeWords::tr("Show the clean twin"), parent);
  twin->setObjectName("showTwin");
  twin->setToolTip(PracticeWords::tr("The same tool and motion without the fault, beside the recording in the curves"));
  QObject::connect(twin, &QPushButton::clicked, parent, [wanted = does.twinWanted] { wanted(); });
  column->addWidget(twin, 0, Qt::AlignLeft);
}

/// What may be known of the riddle before it is solved.
void addHint(QVBoxLayout* column, QWidget* parent, const std::string& truth, const RealityFindings::Found& found,
             const RiddleActions& does) {
  if (!found.tried.empty()) {
    const Card wrong = makeCard("cardLook", parent);
    wrong.frame->setProperty("role", "wrongGuess");
    wrong.layout->addWidget(wrappedLabel(PracticeWords::tr("Not “%1”. It would look like this: %2 Try once more.")
                                             .arg(titleOf(found.tried), looksOf(found.tried)),
                                         "body", wrong.frame));
    auto* giveUp = new QPushButton(PracticeWords::tr("Show the answer"), wrong.frame);
    giveUp->setObjectName("giveUp");
    QObject::connect(giveUp, &QPushButton::clicked, parent, [gaveUp = does.gaveUp] { gaveUp(); });
    wrong.layout->addWidget(giveUp, 0, Qt::AlignLeft);
    column->addWidget(wrong.frame);
  }
  const Card hint = makeCard("cardSuggested", parent);
  hint.layout->addWidget(styledLabel(found.hinted ? PracticeWords::tr("Hint") : PracticeWords::tr("How to look"),
                                     "sectionTitle", hint.frame));
  hint.layout->addWidget(wrappedLabel(
      found.hinted ? looksOf(truth)
                   : PracticeWords::tr(
                         "When is the residual large – during fast motion, at certain positions, from some time on, "
                         "always? Does it jump, drift or oscillate? The views below the arm show it by frequency and "
                         "against the motion."),
      "body", hint.frame));
  if (!found.hinted) {
    auto* ask = new QPushButton(PracticeWords::tr("Give me a hint"), hint.frame);
    ask->setObjectName("hintWanted");
    QObject::connect(ask, &QPushButton::clicked, parent, [wanted = does.hintWanted] { wanted(); });
    hint.layout->addWidget(ask, 0, Qt::AlignLeft);
  } else {
    addTwin(hint.layout, hint.frame, found, does);
  }
  column->addWidget(hint.frame);
}

}  // namespace

void addGuesses(QVBoxLayout* column, QWidget* parent, const std::string& truth, const RealityFindings::Found& found,
                const RiddleActions& does) {
  addHint(column, parent, truth, found, does);
  column->addWidget(styledLabel(PracticeWords::tr("Your guess"), "sectionTitle", parent));
  auto* grid = new QGridLayout;
  grid->setSpacing(8);
  std::vector<QPushButton*> buttons;
  int widest = 0;
  for (const auto& id : practiceKinds()) {
    auto* button = new QPushButton(titleOf(id), parent);
    button->setObjectName("guess_" + QString::fromStdString(id));
    button->setProperty("role", "plain");
    button->setToolTip(looksOf(id));
    QObject::connect(button, &QPushButton::clicked, parent, [guessed = does.guessed, id] { guessed(id); });
    button->setEnabled(id != found.tried);
    button->ensurePolished();
    widest = std::max(widest, button->sizeHint().width());
    buttons.push_back(button);
  }
  // Beside each other only where the longest name has room.
  const int room = parent->parentWidget() ? parent->parentWidget()->width() - 2 * 20 : 0;
  const int columns = 2 * widest + grid->spacing() <= room ? 2 : 1;
  for (int place = 0; place < static_cast<int>(buttons.size()); ++place)
    grid->addWidget(buttons[static_cast<std::size_t>(place)], place / columns, place % columns);
  column->addLayout(grid);
}

void addFeedback(QVBoxLayout* column, QWidget* parent, const std::string& truth, const RealityFindings::Found& found,
                 const RealityFindings::Score& score, const RiddleActions& does) {
  const std::string& guess = found.guess;
  const bool right = truth == guess;
  const Card card = makeCard(right ? "card" : "cardLook", parent);
  card.frame->setProperty("role", "feedback");
  card.layout->addWidget(makeVerdictTag(right ? PracticeWords::tr("Right") : PracticeWords::tr("Not quite"),
                                        right ? Light::measured : Light::look, false, card.frame));
  card.layout->addWidget(
      wrappedLabel(PracticeWords::tr("The hidden fault was: %1.").arg(titleOf(truth)), "cardTitle", card.frame));
  card.layout->addWidget(wrappedLabel(looksOf(truth), "body", card.frame));
  if (!right) {
    card.layout->addWidget(wrappedLabel(
        PracticeWords::tr("Your guess, “%1”, would look like this: %2").arg(titleOf(guess), looksOf(guess)), "caption",
        card.frame));
    card.layout->addWidget(wrappedLabel(
        PracticeWords::tr("How to tell them apart on a real robot: %1").arg(decidesOf(truth)), "caption", card.frame));
  }
  auto* points =
      wrappedLabel(PracticeWords::tr("Solved at the first try: %1 of %2. With a hint or at the second try: %3.")
                       .arg(score.first)
                       .arg(score.asked)
                       .arg(score.second),
                   "caption", card.frame);
  points->setProperty("role", "score");
  card.layout->addWidget(points);
  addTwin(card.layout, card.frame, found, does);
  auto* next = new QPushButton(PracticeWords::tr("Next exercise"), card.frame);
  next->setObjectName("anotherRiddle");
  QObject::connect(next, &QPushButton::clicked, parent, [another = does.another] { another(); });
  card.layout->addWidget(next, 0, Qt::AlignLeft);
  column->addWidget(card.frame);
}

}  // namespace heft
