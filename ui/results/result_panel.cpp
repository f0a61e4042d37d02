#include "ui/results/result_panel.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/models/glossary.h"
#include "ui/results/detail_rows.h"
#include "ui/results/detail_section.h"
#include "ui/results/mass_scale.h"
#include "ui/results/share_rows.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

Light lightOf(Source source) {
  return source == Source::data      ? Light::measured
         : source == Source::doubted ? Light::look
         : source == Source::prior   ? Light::partly
                                     : Light::unknown;
}

Light lightOf(Severity severity) {
  return severity == Severity::error ? Light::notPossible : severity == Severity::warning ? Light::look : Light::info;
}

/// A light for several numbers: partly known if only some of them are.
Light jointLight(const std::vector<NumberText>& numbers) {
  const Source worst = jointSource(numbers);
  const bool any = std::ranges::any_of(numbers, [](const NumberText& n) { return n.source != Source::none; });
  return worst <= Source::doubted ? lightOf(worst) : any ? Light::partly : Light::unknown;
}

QString tagText(Source source) {
  return source == Source::doubted ? ResultPanel::tr("doubtful – see warnings") : sourceWord(source);
}

/// Where there is little room.
QString shortTagText(Source source) {
  return source == Source::none ? ResultPanel::tr("not known") : sourceWord(source);
}

/// The title of a card, with what the term means.
QLabel* termLabel(const QString& text, const char* term, QWidget* parent) {
  QLabel* label = styledLabel(text, "cardTitle", parent);
  label->setToolTip(glossaryTip(term));
  return label;
}

/// Where a number comes from: a light, a word, and what the word means.
QLabel* sourceTag(const QString& text, Source source, QWidget* parent) {
  QLabel* tag = makeTag(text, lightOf(source), parent);
  tag->setToolTip(glossaryTip(source == Source::data      ? "measured"
                              : source == Source::doubted ? "doubtful"
                              : source == Source::prior   ? "from_shape"
                                                          : "not_known"));
  return tag;
}

/// What a row of parts needs to stand side by side.
int widthOf(const std::vector<QWidget*>& parts, int spacing) {
  int needed = 0;
  for (QWidget* part : parts) {
    part->ensurePolished();
    needed += part->sizeHint().width() + spacing;
  }
  return needed;
}

}  // namespace

ResultPanel::ResultPanel(QWidget* parent) : PanelPage(parent) {}

void ResultPanel::showNothing() {
  again_ = [this] { showNothing(); };
  restart(tr("What does your tool weigh?"), tr("Open a recording first, or make one under Record."))->addStretch(1);
  setMainButton(tr("Go to Record"), [this] { emit recordWanted(); });
  setSecondButton({});
}

void ResultPanel::showWorking(const QString& fileName) {
  again_ = [this, fileName] { showWorking(fileName); };
  restart(tr("Estimating …"), tr("From the motion and the forces in %1.").arg(fileName))->addStretch(1);
  setMainButton({});
  setSecondButton({});
}

void ResultPanel::showNoResult(const QString& reason) {
  again_ = [this, reason] { showNoResult(reason); };
  restart(tr("No estimate yet"), reason)->addStretch(1);
  setSecondButton({});
  setMainButton(tr("Estimate"), [this] { emit estimateWanted(); });
}

void ResultPanel::showResult(const ResultText& result) {
  again_ = [this, result] { showResult(result); };
  auto* column = restart(result.question, result.answer);
  QWidget* content = this->content();

  // What calls for a decision comes before the numbers it concerns.
  std::vector<FindingText> first, later, calm;
  for (const FindingText& finding : result.findings) {
    (finding.severity == Severity::error || finding.doubt ? first
     : finding.severity == Severity::warning              ? later
                                                          : calm)
        .push_back(finding);
  }
  if (!first.empty()) addFindings(column, first);
  if (result.withheld && !result.advice.isEmpty()) {
    const Card card = makeCard("cardLook", content);
    card.layout->addWidget(styledLabel(tr("What to do"), "sectionTitle", content));
    card.layout->addWidget(wrappedLabel(result.advice, "body", content));
    column->addWidget(card.frame);
  }
  addMass(column, result);
  addCentre(column, result);
  addInertia(column, result);
  if (!result.shares.empty()) addShares(column, result.shares);
  if (!result.advice.isEmpty() && !result.withheld) addAdvice(column, result.advice);
  if (!later.empty()) addFindings(column, later);
  if (details_) {
    addDetailSection(column, content, result, frame_, [this](int frame) { frame_ = frame; });
    if (!calm.empty()) addFindings(column, calm);
  } else if (!calm.empty()) {
    column->addWidget(wrappedLabel(
        calm.size() == 1 ? tr("1 more note in Details.") : tr("%1 more notes in Details.").arg(calm.size()), "caption",
        content));
  }
  addKnown(column, result.known);
  if (further_ && !result.withheld) further_(column, content);
  column->addStretch(1);
  setSecondButton(
      tr("All methods"), [this] { emit methodsWanted(); }, "table");
  if (result.withheld) {
    setMainButton(tr("Run reality check"), [this] { emit causeWanted(); });
  } else {
    setMainButton(tr("Export these numbers"), [this] { emit exportWanted(); });
  }
}

void ResultPanel::addMass(QVBoxLayout* column, const ResultText& result) {
  QWidget* content = this->content();
  const Card card = makeCard("card", content);
  card.frame->setToolTip(result.mass.tip);
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(new LightIcon(lightOf(result.mass.source), 22, content));
  row->addWidget(termLabel(tr("Mass"), "mass", content));
  row->addStretch(1);
  QLabel* value = styledLabel(result.mass.value, "bigNumber", content);
  value->setProperty("role", "mass");
  row->addWidget(value);
  row->addWidget(styledLabel(result.mass.plusMinus, "plusMinusLarge", content));
  card.layout->addLayout(row);
  if (!result.withheld) card.layout->addWidget(new MassScaleWidget(result.massScale, result.mass.source, content));
  auto* foot = new QHBoxLayout;
  foot->addWidget(sourceTag(tagText(result.mass.source), result.mass.source, content), 0, Qt::AlignTop);
  if (result.massNote.isEmpty()) {
    foot->addStretch(1);
  } else {
    QLabel* note = wrappedLabel(QStringLiteral("| ") + result.massNote, "caption", content);
    note->setAlignment(Qt::AlignRight | Qt::AlignTop);
    foot->addWidget(note, 1);
  }
  card.layout->addLayout(foot);
  column->addWidget(card.frame);
}

void ResultPanel::addCentre(QVBoxLayout* column, const ResultText& result) {
  QWidget* content = this->content();
  const Card card = makeCard("card", content);
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(new LightIcon(jointLight(result.com), 22, content));
  row->addWidget(termLabel(tr("Centre of mass"), "centre_of_mass", content));
  row->addStretch(1);
  const Source joint = jointSource(result.com);
  const bool same =
      std::all_of(result.com.begin(), result.com.end(), [&](const NumberText& n) { return n.source == joint; });
  if (same) row->addWidget(sourceTag(shortTagText(joint), joint, content));
  card.layout->addLayout(row);

  // Side by side, or below each other where the numbers are long.
  constexpr int kSpacing = 4, kAround = 2 * 20 + 2 * 16 + 12 +
                                        2 * 16;  // margins of page and card, scroll bar, gaps between the three
  std::vector<QWidget*> parts;
  for (int i = 0; i < static_cast<int>(result.com.size()); ++i) {
    const NumberText& n = result.com[i];
    QLabel* value = styledLabel(n.value, "midNumber", content);
    value->setToolTip(n.tip);
    value->setAccessibleName(n.name + QStringLiteral(" ") + n.value + QStringLiteral(" ") + n.plusMinus);
    QLabel* spread = styledLabel(n.plusMinus, "plusMinus", content);
    spread->setToolTip(n.tip);
    for (QWidget* part : std::initializer_list<QWidget*>{new AxisDot(i, content),
                                                         styledLabel(n.name, "rowName", content), value, spread})
      parts.push_back(part);
  }
  const bool narrow = widthOf(parts, kSpacing) > (isVisible() ? width() : minimumWidth()) - kAround;
  auto* numbers = new QGridLayout;
  numbers->setHorizontalSpacing(kSpacing);
  numbers->setVerticalSpacing(2);
  constexpr int kParts = 4;
  for (int k = 0; k < static_cast<int>(parts.size()); ++k) {
    const int axis = k / kParts, part = k % kParts;
    numbers->addWidget(parts[k], narrow ? axis : 0, narrow ? part : (kParts + 1) * axis + part,
                       narrow && part == 2 ? Qt::AlignRight | Qt::AlignVCenter : Qt::AlignVCenter);
  }
  for (const int gap : {kParts, 2 * kParts + 1}) numbers->setColumnStretch(gap, 1);
  card.layout->addLayout(numbers);
  if (!same) {
    auto* tags = new QHBoxLayout;
    for (const NumberText& n : result.com) {
      tags->addWidget(sourceTag(n.name + QStringLiteral(": ") + shortTagText(n.source), n.source, content));
    }
    tags->addStretch(1);
    card.layout->addLayout(tags);
  }
  card.layout->addWidget(wrappedLabel(
      result.comNote.isEmpty() ? tr("From the sensor’s origin, along its axes.") : result.comNote, "caption", content));
  column->addWidget(card.frame);
}

void ResultPanel::addInertia(QVBoxLayout* column, const ResultText& result) {
  QWidget* content = this->content();
  const Card card = makeCard("card", content);
  card.layout->setSpacing(0);
  auto* row = new QHBoxLayout;
  row->setSpacing(10);
  row->addWidget(new LightIcon(jointLight(result.inertia), 22, content));
  row->addWidget(termLabel(tr("Inertia"), "inertia", content));
  QLabel* unit = wrappedLabel(tr("about the centre, %1").arg(result.inertiaUnit), "caption", content);
  unit->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  row->addWidget(unit, 1);
  card.layout->addLayout(row);
  card.layout->addSpacing(8);

  for (const NumberText& n : result.inertia) {
    card.layout->addWidget(makeDivider(content));
    auto* line = new QWidget(content);
    line->setFixedHeight(30);
    line->setToolTip(n.tip);
    auto* lineRow = new QHBoxLayout(line);
    lineRow->setContentsMargins(0, 0, 0, 0);
    lineRow->setSpacing(8);
    lineRow->addWidget(new LightIcon(lightOf(n.source), 18, line));
    QLabel* name = styledLabel(n.name, "rowName", line);
    name->setMinimumWidth(40);
    lineRow->addWidget(name);
    lineRow->addWidget(sourceTag(shortTagText(n.source), n.source, line));
    lineRow->addStretch(1);
    QLabel* value = styledLabel(n.value, "smallNumber", line);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    lineRow->addWidget(value);
    QLabel* spread = styledLabel(n.plusMinus, "plusMinus", line);
    // One width for all rows keeps the values in a column.
    spread->setMinimumWidth(58);
    lineRow->addWidget(spread);
    card.layout->addWidget(line);
  }
  if (!result.inertiaNote.isEmpty()) {
    card.layout->addWidget(makeDivider(content));
    card.layout->addSpacing(8);
    card.layout->addWidget(wrappedLabel(result.inertiaNote, "caption", content));
  }
  column->addWidget(card.frame);
}

void ResultPanel::addFindings(QVBoxLayout* column, const std::vector<FindingText>& findings) {
  QWidget* content = this->content();
  const bool grave = findings.front().severity == Severity::error;
  const Card card = makeCard(grave                                            ? "cardBad"
                             : findings.front().severity == Severity::warning ? "cardLook"
                                                                              : "card",
                             content);
  card.frame->setProperty("role", "findings");
  for (const FindingText& finding : findings) {
    auto* row = new QHBoxLayout;
    row->setSpacing(10);
    row->addWidget(new LightIcon(lightOf(finding.severity), 18, content), 0, Qt::AlignTop);
    auto* text = new QVBoxLayout;
    text->setSpacing(2);
    text->addWidget(wrappedLabel(finding.text, "findingText", content));
    if (!finding.remedy.isEmpty()) text->addWidget(wrappedLabel(finding.remedy, "caption", content));
    row->addLayout(text, 1);
    card.layout->addLayout(row);
  }
  using Leads = FindingText::Leads;
  const auto leadTo = [&](Leads where) {
    return std::any_of(findings.begin(), findings.end(), [&](const FindingText& finding) {
      return finding.leads == where && (finding.doubt || where == Leads::shape || where == Leads::object);
    });
  };
  const auto addButton = [&](const QString& text, const char* role, void (ResultPanel::*wanted)()) {
    auto* look = new QPushButton(text, content);
    look->setObjectName("smallButton");
    look->setProperty("role", role);
    connect(look, &QPushButton::clicked, this, wanted);
    card.layout->addWidget(look, 0, Qt::AlignRight);
  };
  if (leadTo(Leads::shape)) addButton(tr("Check the shape"), "shape", &ResultPanel::shapeWanted);
  if (leadTo(Leads::object)) addButton(tr("Weigh what was picked up"), "weighObject", &ResultPanel::objectWanted);
  if (leadTo(Leads::realityCheck)) {
    addButton(tr("Show the cause"), "cause", &ResultPanel::causeWanted);
  } else if (leadTo(Leads::cause)) {
    addButton(tr("Find the cause"), "cause", &ResultPanel::causeWanted);
  }
  column->addWidget(card.frame);
}

void ResultPanel::addAdvice(QVBoxLayout* column, const QString& advice) {
  QWidget* content = this->content();
  const Card card = makeCard("cardSuggested", content);
  auto* row = new QHBoxLayout;
  row->setSpacing(12);
  row->addWidget(new IconLabel("bulb", 20, content), 0, Qt::AlignTop);
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  words->addWidget(styledLabel(tr("How to improve it"), "sectionTitle", content));
  words->addWidget(wrappedLabel(advice, "advice", content));
  auto* record = new QPushButton(tr("Record this motion"), content);
  record->setObjectName("smallButton");
  connect(record, &QPushButton::clicked, this, &ResultPanel::recordWanted);
  words->addSpacing(4);
  words->addWidget(record, 0, Qt::AlignLeft);
  row->addLayout(words, 1);
  card.layout->addLayout(row);
  column->addWidget(card.frame);
}

void ResultPanel::addShares(QVBoxLayout* column, const std::vector<ShareText>& shares) {
  QWidget* content = this->content();
  column->addSpacing(4);
  column->addWidget(styledLabel(tr("Where the numbers come from"), "sectionTitle", content));
  auto* grid = new QGridLayout;
  grid->setHorizontalSpacing(12);
  grid->setVerticalSpacing(6);
  grid->setColumnStretch(1, 1);
  int r = 0;
  for (const ShareText& share : shares) {
    QLabel* name = styledLabel(share.name, "rowName", content);
    QLabel* words = styledLabel(share.words, "rowName", content);
    auto* bar = new DataShareBar(share.data, content);
    if (share.pulled) words->setProperty("role", "pulled");
    bar->setAccessibleName(share.name + QStringLiteral(": ") + share.words);
    for (QWidget* part : std::initializer_list<QWidget*>{name, words, bar}) part->setToolTip(share.tip);
    grid->addWidget(name, r, 0);
    grid->addWidget(bar, r, 1);
    grid->addWidget(words, r, 2);
    ++r;
  }
  column->addLayout(grid);
}

void ResultPanel::addKnown(QVBoxLayout* column, const std::vector<DetailText>& known) {
  QWidget* content = this->content();
  if (!known.empty()) {
    column->addSpacing(4);
    column->addWidget(styledLabel(tr("Compared with your reference values"), "sectionTitle", content));
    addDetailRows(column, known, content);
  }
  auto* enter =
      new QPushButton(known.empty() ? tr("Compare with a scale or CAD …") : tr("Change reference values …"), content);
  enter->setObjectName("linkButton");
  enter->setProperty("role", "known");
  connect(enter, &QPushButton::clicked, this, &ResultPanel::knownWanted);
  column->addWidget(enter, 0, Qt::AlignLeft);
}

void ResultPanel::setDetailsShown(bool shown) {
  if (shown == details_) return;
  details_ = shown;
  const int position = scrollPosition();
  if (again_) {
    // A copy, since the call replaces the member.
    const auto again = again_;
    again();
  }
  setScrollPosition(position);
}

}  // namespace heft
