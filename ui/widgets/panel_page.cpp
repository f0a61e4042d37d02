#include "ui/widgets/panel_page.h"

#include <QApplication>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QTimer>
#include <QVBoxLayout>
#include <QVariant>
#include <algorithm>

#include "ui/theme/icons.h"
#include "ui/theme/theme.h"
#include "ui/widgets/basics.h"

namespace heft {
namespace {

constexpr int kLeastWidth = 384;  ///< [px] What the widest rows need in German; test_gl asks for it.

/// What scrolls: as high as its text needs at the present width, which a layout alone does not ask for. Parts that were
/// just added are shown and styled before they are measured; Qt would do so only after a first, wrong picture.
class PanelContent : public QWidget {
 public:
  PanelContent() {
    setObjectName("panelContent");
    later_.setSingleShot(true);
    later_.setInterval(0);
    connect(&later_, &QTimer::timeout, this, [this] {
      showParts();
      fitHeight();
    });
    later_.start();
  }
  void reserve(QLabel* label, const QStringList& texts) {
    reserved_ = label;
    texts_ = texts;
    label->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    fitHeight();
  }

 protected:
  void resizeEvent(QResizeEvent* event) override {
    QWidget::resizeEvent(event);
    fitHeight();
  }
  bool event(QEvent* event) override {
    if (event->type() == QEvent::LayoutRequest) showParts();
    const bool handled = QWidget::event(event);
    if (event->type() == QEvent::LayoutRequest) {
      fitHeight();
      // Once more: a layout within it may have learned its width only now.
      later_.start();
    }
    return handled;
  }

 private:
  void showParts() {
    if (!isVisible()) return;
    for (auto* part : findChildren<QWidget*>()) {
      part->ensurePolished();
      const QWidget* parent = part->parentWidget();
      if (part->isWindow() || !part->isHidden() || part->testAttribute(Qt::WA_WState_ExplicitShowHide) ||
          !parent->isVisible() || !parent->layout())
        continue;
      part->show();
    }
    if (layout()) layout()->activate();
  }
  void fitHeight() {
    if (!layout() || width() <= 0) return;
    if (reserved_) {
      const QMargins around = layout()->contentsMargins();
      const QRect room(0, 0, width() - around.left() - around.right(), 10000);
      int most = 0;
      for (const QString& text : texts_)
        most = std::max(most, reserved_->fontMetrics().boundingRect(room, Qt::TextWordWrap, text).height());
      constexpr int kRounding = 2;  // [px] Between the font's measure and the label's own
      if (most + kRounding != reserved_->height()) reserved_->setFixedHeight(most + kRounding);
    }
    const int needed = layout()->totalHeightForWidth(width());
    setMinimumHeight(needed > 0 ? needed : layout()->totalMinimumSize().height());
  }
  QTimer later_;
  QLabel* reserved_ = nullptr;
  QStringList texts_;
};

/// Where both buttons have no room beside each other, the second one is its icon alone or, without one, stands below.
class FootFitter : public QObject {
 public:
  FootFitter(QWidget* foot, QPushButton* main, QPushButton* second)
      : QObject(foot), foot_(foot), main_(main), second_(second) {
    foot->installEventFilter(this);
  }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    if (event->type() != QEvent::Resize && event->type() != QEvent::LayoutRequest) return false;
    if (!second_->text().isEmpty()) whole_ = second_->text();
    const int gaps = 2 * 20 + 10;
    const bool both = !second_->isHidden() && !main_->isHidden(), stacks = both && second_->icon().isNull();
    auto* row = static_cast<QBoxLayout*>(foot_->layout());
    const auto way = stacks && main_->sizeHint().width() + second_->sizeHint().width() + gaps > foot_->width()
                         ? QBoxLayout::BottomToTop
                         : QBoxLayout::LeftToRight;
    if (row->direction() != way) row->setDirection(way);
    if (!both || stacks) return false;
    const int words = QFontMetrics(second_->font()).horizontalAdvance(whole_);
    const int icon = second_->sizeHint().width() - (second_->text().isEmpty() ? 0 : words);
    const bool fits = main_->sizeHint().width() + icon + words + gaps <= foot_->width();
    if (fits == !second_->text().isEmpty()) return false;
    second_->setText(fits ? whole_ : QString());
    second_->setToolTip(fits ? QString() : whole_);
    second_->setAccessibleName(whole_);
    return false;
  }

 private:
  QWidget* foot_;
  QPushButton *main_, *second_;
  QString whole_;
};

}  // namespace

PanelPage::PanelPage(QWidget* parent) : QWidget(parent) {
  setObjectName("panel");
  setAttribute(Qt::WA_StyledBackground);
  setMinimumWidth(kLeastWidth);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(1, 0, 0, 0);
  column->setSpacing(0);
  scroll_ = new QScrollArea(this);
  scroll_->setObjectName("panelScroll");
  scroll_->setWidgetResizable(true);
  scroll_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  scroll_->setFocusPolicy(Qt::NoFocus);
  scroll_->setFrameShape(QFrame::NoFrame);
  column->addWidget(scroll_, 1);
  foot_ = new QWidget(this);
  foot_->setObjectName("panelFoot");
  foot_->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(foot_);
  row->setContentsMargins(20, 14, 20, 14);
  row->setSpacing(10);
  second_ = new QPushButton(foot_);
  second_->setObjectName("secondButton");
  row->addWidget(second_);
  main_ = new QPushButton(foot_);
  main_->setObjectName("mainButton");
  row->addWidget(main_, 1);
  column->addWidget(foot_);
  connect(main_, &QPushButton::clicked, this, [this] {
    const Clicked clicked = mainClicked_;  // The call may replace the member.
    if (clicked) clicked();
  });
  connect(second_, &QPushButton::clicked, this, [this] {
    const Clicked clicked = secondClicked_;
    if (clicked) clicked();
  });
  new FootFitter(foot_, main_, second_);
  main_->hide();
  second_->hide();
  foot_->hide();
}

QVBoxLayout* PanelPage::restart(const QString& question, const QString& answer) {
  auto* content = new PanelContent;
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(20, 18, 20, 16);
  column->setSpacing(10);
  column->addWidget(wrappedLabel(question, "question", content));
  QLabel* second = wrappedLabel(answer, "answer", content);
  second->setVisible(!answer.isEmpty());
  column->addWidget(second);
  column->addSpacing(2);
  keepFocus();
  // The page is often rebuilt by a click on one of its own buttons, which must outlive its signal.
  if (QWidget* before = scroll_->takeWidget()) before->deleteLater();
  scroll_->setWidget(content);
  return column;
}

void PanelPage::keepFocus() {
  QWidget* const focus = QApplication::focusWidget();
  QWidget* const before = content();
  const bool inside = focus && before && before->isAncestorOf(focus),
             atFoot = focus && (focus == main_ || focus == second_);
  if (!inside && !atFoot) return;
  const QString name = focus->objectName();
  const int place = inside && !name.isEmpty() ? before->findChildren<QWidget*>(name).indexOf(focus) : 0;
  // When the new content stands there.
  QTimer::singleShot(0, this, [this, name, place, atFoot] {
    const auto takes = [](const QWidget* each) {
      return each->isVisible() && each->isEnabled() && (each->focusPolicy() & Qt::TabFocus);
    };
    QWidget* to = nullptr;
    if (!atFoot && !name.isEmpty()) {
      const auto same = content()->findChildren<QWidget*>(name);
      if (!same.isEmpty()) to = same[std::min(place, static_cast<int>(same.size()) - 1)];
    }
    if (!to || !takes(to)) to = main_;
    if (!takes(to)) {
      const auto all = content()->findChildren<QWidget*>();
      const auto first = std::find_if(all.begin(), all.end(), takes);
      to = first == all.end() ? nullptr : *first;
    }
    if (to) to->setFocus(Qt::OtherFocusReason);
  });
}

void PanelPage::reserveAnswers(const QStringList& answers) {
  auto* page = static_cast<PanelContent*>(content());
  if (auto* label = page ? page->findChild<QLabel*>("answer", Qt::FindDirectChildrenOnly) : nullptr)
    page->reserve(label, answers);
}

void PanelPage::setQuestion(const QString& question, const QString& answer) {
  if (!content()) return;
  if (auto* label = content()->findChild<QLabel*>("question")) label->setText(question);
  if (auto* label = content()->findChild<QLabel*>("answer")) {
    label->setText(answer);
    label->setVisible(!answer.isEmpty());
  }
}

QWidget* PanelPage::content() const { return scroll_->widget(); }

void PanelPage::setMainButton(const QString& text, Clicked clicked, const QString& icon) {
  main_->setText(text);
  main_->setVisible(!text.isEmpty());
  main_->setEnabled(true);
  main_->setToolTip({});
  mainClicked_ = std::move(clicked);
  mainIcon_ = icon;
  showFoot();
}

void PanelPage::setMainEnabled(bool enabled, const QString& why) {
  main_->setEnabled(enabled);
  main_->setToolTip(enabled ? QString() : why);
}

void PanelPage::setSecondButton(const QString& text, Clicked clicked, const QString& icon) {
  second_->setText(text);
  second_->setVisible(!text.isEmpty());
  secondClicked_ = std::move(clicked);
  secondIcon_ = icon;
  showFoot();
}

void PanelPage::showFoot() {
  foot_->setVisible(!main_->text().isEmpty() || !second_->text().isEmpty());
  refreshIcons();
}

void PanelPage::refreshIcons() {
  const Theme& t = theme();
  QIcon onFill;
  if (!mainIcon_.isEmpty()) {
    onFill.addPixmap(iconPixmap(mainIcon_, 20, Qt::white, t.accentFill, 2.0));
    onFill.addPixmap(iconPixmap(mainIcon_, 20, t.text3, t.raised, 2.0), QIcon::Disabled);
  }
  main_->setIcon(onFill);
  second_->setIcon(secondIcon_.isEmpty() ? QIcon() : themedIcon(secondIcon_));
  main_->setIconSize(QSize(20, 20));
  second_->setIconSize(QSize(20, 20));
}

int PanelPage::scrollPosition() const { return scroll_->verticalScrollBar()->value(); }

void PanelPage::setScrollPosition(int position) { scroll_->verticalScrollBar()->setValue(position); }

void PanelPage::reveal(const char* role) {
  // The page has no places for its parts until it is laid out.
  QTimer::singleShot(0, this, [this, role = QString(role)] {
    if (!content()) return;
    for (QWidget* part : content()->findChildren<QWidget*>()) {
      if (part->property("role").toString() != role || part->isHidden()) continue;
      content()->layout()->activate();
      return setScrollPosition(std::max(0, part->mapTo(content(), QPoint()).y() - 12));
    }
  });
}

void PanelPage::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) refreshIcons();
}

}  // namespace heft
