#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QStyleOptionButton>
#include <QStylePainter>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>
#include <functional>
#include <utility>

#include "ui/controller/workspace.h"
#include "ui/mark_panel/mark_panel.h"
#include "ui/mark_panel/share_bar.h"
#include "ui/models/glossary.h"
#include "ui/models/numbers.h"
#include "ui/theme/theme.h"
#include "ui/timeline/marks_bar.h"
#include "ui/widgets/basics.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/stepper.h"

namespace heft {
namespace {

/// A small square in the colour of a mark.
QIcon markSwatch(MarkLabel label) {
  QPixmap pixmap(28, 28);
  pixmap.setDevicePixelRatio(2.0);
  pixmap.fill(markColour(label));
  return QIcon(pixmap);
}

/// A link "13.0 – 15.3 s" whose numbers stand below those of its neighbours.
class SpanButton : public QPushButton {
 public:
  SpanButton(const Segment& segment, int numberWidth, QWidget* parent)
      : QPushButton(parent),
        from_(numberText(segment.from, 1)),
        to_(MarkPanel::tr("%1 s").arg(numberText(segment.to, 1))),
        width_(numberWidth) {
    setObjectName("linkButton");
  }
  QSize sizeHint() const override {
    return {2 * kEdge + 2 * width_ + kDash + fontMetrics().horizontalAdvance(MarkPanel::tr("%1 s").arg(QString())),
            QPushButton::sizeHint().height()};
  }

 protected:
  void paintEvent(QPaintEvent*) override {
    QStylePainter painter(this);
    QStyleOptionButton option;
    initStyleOption(&option);
    painter.drawControl(QStyle::CE_PushButton, option);
    painter.setPen(theme().text);
    painter.drawText(QRect(kEdge, 0, width_, height()), Qt::AlignRight | Qt::AlignVCenter, from_);
    painter.drawText(QRect(kEdge + width_, 0, kDash, height()), Qt::AlignCenter, QStringLiteral("–"));
    painter.drawText(rect().adjusted(0, 0, -kEdge, 0), Qt::AlignRight | Qt::AlignVCenter, to_);
  }

 private:
  static constexpr int kEdge = 8, kDash = 18;  ///< [px] The first is the style sheet's padding.
  QString from_, to_;
  int width_;
};

QString capitalised(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

/// Calls once the card, or a text on it, was clicked; its buttons answer for themselves.
class CardClick : public QObject {
 public:
  CardClick(QWidget* card, std::function<void()> clicked) : QObject(card), clicked_(std::move(clicked)) {
    card->setCursor(Qt::PointingHandCursor);
    card->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::MouseButtonRelease) return false;
    clicked_();
    return true;
  }

 private:
  std::function<void()> clicked_;
};

}  // namespace

void MarkPanel::addSuggestion(QVBoxLayout* column, const Segment& segment, bool first) {
  QWidget* content = page()->content();
  const Card card = makeCard(first ? "cardChosen" : "card", content);
  card.frame->setProperty("role", "suggestion");
  auto* head = new QHBoxLayout;
  head->setSpacing(10);
  head->addWidget(new IconLabel(segment.label == MarkLabel::contact ? "contact" : "hand", 22, content));
  head->addWidget(styledLabel(capitalised(segment.label == MarkLabel::contact ? tr("contact") : tr("ignore")),
                              "cardTitle", content));
  head->addStretch(1);
  auto* when = new QPushButton(stretchText(segment.from, segment.to), content);
  when->setObjectName("linkButton");
  when->setToolTip(tr("Show this segment"));
  connect(when, &QPushButton::clicked, this, [this, segment] { select(segment.from, segment.to); });
  head->addWidget(when);
  card.layout->addLayout(head);
  card.layout->addWidget(wrappedLabel(QString::fromStdString(segment.reason), "answer", content));
  auto* sure = new QHBoxLayout;
  sure->setSpacing(8);
  sure->addWidget(styledLabel(tr("Confidence"), "caption", content));
  sure->addWidget(styledLabel(confidenceWord(segment.confidence), "captionBold", content));
  sure->addWidget(new ConfidenceBar(segment.confidence, content));
  // Never stated as certain: nobody has checked it.
  sure->addWidget(
      styledLabel(tr("%1 %").arg(numberText(std::min(99.0, 100 * segment.confidence), 0)), "caption", content));
  sure->addStretch(1);
  card.layout->addLayout(sure);
  auto* answers = new QHBoxLayout;
  answers->setSpacing(8);
  auto* yes = new QPushButton(segment.label == MarkLabel::contact ? tr("Yes, contact") : tr("Yes, ignore"), content);
  yes->setObjectName("acceptButton");
  connect(yes, &QPushButton::clicked, this, [this, segment] { decide(segment, segment.label); });
  auto* no = new QPushButton(tr("No, free motion"), content);
  no->setObjectName("plainButton");
  connect(no, &QPushButton::clicked, this, [this, segment] { decide(segment, MarkLabel::free); });
  answers->addWidget(yes, 1);
  answers->addWidget(no, 1);
  card.layout->addLayout(answers);
  column->addWidget(card.frame);
  // The whole card leads there; by keys its time does.
  new CardClick(card.frame, [this, segment] { select(segment.from, segment.to); });
}

void MarkPanel::addSegments(QVBoxLayout* column, const std::vector<Segment>& segments,
                            const std::vector<bool>& suggested) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  QLabel* title = styledLabel(tr("All segments"), "sectionTitle", content);
  title->setProperty("role", "segments");
  column->addWidget(title);
  if (const auto report = workspace().report(); details_ && report)
    column->addWidget(wrappedLabel(noiseText(report->noiseStd), "caption", content));
  auto* rows = new QGridLayout;
  rows->setVerticalSpacing(0);
  rows->setHorizontalSpacing(10);
  rows->setColumnStretch(4, 1);
  column->addLayout(rows);
  int widest = 0;
  for (const Segment& segment : segments)
    widest = std::max(widest, QFontMetrics(uiFont(type::kBody)).horizontalAdvance(numberText(segment.to, 1)));
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    const int line = static_cast<int>(2 * i);
    auto* swatch = new QLabel(content);
    swatch->setPixmap(markSwatch(segment.label).pixmap(16, 16));
    rows->addWidget(swatch, line, 0);
    // The times stand in columns, end below end.
    auto* when = new SpanButton(segment, widest, content);
    when->setToolTip(QString::fromStdString(segment.reason));
    when->setAccessibleName(MarksBar::describe(segment));
    connect(when, &QPushButton::clicked, this, [this, segment] { select(segment.from, segment.to); });
    rows->addWidget(when, line, 1);
    QLabel* length = styledLabel(tr("%1 s").arg(numberText(segment.to - segment.from, 1)), "rowName", content);
    length->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    length->setToolTip(tr("Duration"));
    rows->addWidget(length, line, 2);
    rows->addWidget(styledLabel(suggested[i] ? tr("%1?").arg(markWord(segment.label)) : markWord(segment.label),
                                "rowName", content),
                    line, 3);
    if (details_) addEvidence(rows, line + 1, segment);
  }
}

void MarkPanel::addEvidence(QGridLayout* rows, int line, const Segment& segment) {
  QStringList numbers, parts;
  if (!segment.reason.empty()) parts << QString::fromStdString(segment.reason);
  if (const auto report = workspace().report()) numbers << residualText(segment, report->series);
  if (segment.confidence < 1.0)
    numbers << tr("confidence %1 %").arg(numberText(std::min(99.0, 100 * segment.confidence), 0));
  numbers.removeAll(QString());
  if (!numbers.isEmpty()) parts << numbers.join(QStringLiteral(" · "));
  if (parts.isEmpty()) return;
  QLabel* label = wrappedLabel(parts.join('\n'), "caption", page()->content());
  label->setProperty("role", "evidence");
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  rows->addWidget(label, line, 1, 1, 4);
}

void MarkPanel::addPainting(QVBoxLayout* column) {
  QWidget* content = page()->content();
  auto* head = new QHBoxLayout;
  head->addWidget(styledLabel(tr("Paint it yourself"), "sectionTitle", content));
  head->addStretch(1);
  head->addWidget(styledLabel(tr("drag along the bar"), "caption", content));
  column->addLayout(head);
  const QString names[] = {tr("Free"), tr("Contact"), tr("Ignore")};
  QStringList texts;
  for (std::size_t k = 0; k < kBrushes.size(); ++k)
    texts.push_back(QStringLiteral("  %1  %2").arg(names[k]).arg(k + 1));
  brushes_ = new Segments(texts, {"brush1", "brush2", "brush3"}, content);
  for (std::size_t k = 0; k < kBrushes.size(); ++k) {
    auto* button = brushes_->button(static_cast<int>(k));
    button->setIcon(markSwatch(kBrushes[k]));
    if (kBrushes[k] == brush_) brushes_->setChosen(static_cast<int>(k));
    const char* const terms[] = {"free", "contact", ""};
    const QString meaning = glossaryTip(terms[k]);
    button->setToolTip(tr("Paint with %1 (key %2). By keys: go to the marks bar, Enter begins, arrow keys move, Enter "
                          "ends.")
                           .arg(names[k])
                           .arg(k + 1) +
                       (meaning.isEmpty() ? QString() : QStringLiteral("\n") + meaning));
    button->setAccessibleName(tr("Paint as %1").arg(names[k]));
  }
  connect(brushes_, &Segments::picked, this, [this](int i) { chooseBrush(kBrushes[static_cast<std::size_t>(i)]); });
  column->addWidget(brushes_);
  auto* plots = new QCheckBox(tr("Paint in the plots, too"), content);
  plots->setObjectName("paintPlots");
  plots->setToolTip(tr("Drag in the plots to label a range instead of zooming"));
  plots->setChecked(inPlots_);
  connect(plots, &QCheckBox::toggled, this, [this](bool on) {
    inPlots_ = on;
    showBrush();
  });
  column->addWidget(plots);
}

/// Why less is used than is free, and how to change it: of a short recording the ends are most.
void MarkPanel::addTrim(QVBoxLayout* column) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(
      wrappedLabel(tr("Also excluded at each end, where the arm is gripped and released"), "caption", content), 1);
  auto* trim = new Stepper(tr("Excluded at each end"), QStringLiteral("%"), {0.0, 45.0, 1.0, 0}, content);
  trim->setObjectName("trim");
  trim->setFixedWidth(130);
  trim->setValue(100.0 * workspace().session().settings.trim);
  connect(trim, &Stepper::begun, this, [this] { trimKey_ = workspace().newMergeKey(); });
  connect(trim, &Stepper::changed, this, [this](double percent) {
    EstimateSettings settings = workspace().session().settings;
    settings.trim = 0.01 * percent;
    workspace().setSettings(settings, tr("excluded at each end"), trimKey_);
  });
  row->addWidget(trim);
  column->addLayout(row);
}

void MarkPanel::addSummary(QVBoxLayout* column, const MarkSummary& summary) {
  QWidget* content = page()->content();
  column->addSpacing(4);
  column->addWidget(styledLabel(tr("Usable data"), "sectionTitle", content));
  auto* bar = new ShareBar(content);
  bar->setSeconds(summary.seconds);
  column->addWidget(bar);
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  row->addWidget(new LightIcon(summary.enough ? Light::measured : Light::look, 20, content), 0, Qt::AlignTop);
  row->addWidget(wrappedLabel(tr("%1 s of %2 s are free. %3")
                                  .arg(numberText(summary.seconds[0], 1), numberText(summary.total, 1),
                                       summary.enough ? tr("Enough for mass and centre.")
                                                      : tr("Too little: record more, without touching anything.")),
                              "body", content),
                 1);
  column->addLayout(row);
}

}  // namespace heft
