#include "ui/main_window/tab_way.h"

#include <QAbstractButton>
#include <QApplication>
#include <QButtonGroup>
#include <QScrollArea>
#include <QWidget>
#include <algorithm>
#include <tuple>

namespace heft {
namespace {

bool standsForItsGroup(const QWidget* widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(widget);
  if (!button || !button->isCheckable() || button->isChecked()) return true;
  if (button->group()) return !button->group()->exclusive() || !button->group()->checkedButton();
  if (!button->autoExclusive() || !button->parentWidget()) return true;
  const auto others = button->parentWidget()->findChildren<QAbstractButton*>(QString(), Qt::FindDirectChildrenOnly);
  return std::none_of(others.begin(), others.end(), [](const auto* b) { return b->autoExclusive() && b->isChecked(); });
}

/// A button that is not chosen has lost its place on the way to the chosen one (Qt's focus policy of groups).
bool takesTab(const QWidget* widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(widget);
  const bool chosen = button && button->isCheckable() && button->isChecked() && button->focusPolicy() != Qt::NoFocus;
  return chosen || (widget->focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
}

}  // namespace

QVector<QWidget*> tabWay(const QWidget& window, const QVector<QWidget*>& parts) {
  struct Stop {
    QWidget* widget;
    int part;
    int block;  ///< [px] Top of what it scrolls in; what is scrolled out of sight below comes before what stands there
    QRect place;
    bool scrolls;  ///< It stands in something that scrolls.
  };
  QVector<Stop> stops;
  for (auto* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || !widget->isEnabled() || widget->window() != &window || widget->focusProxy()) continue;
    if (!takesTab(widget) || !standsForItsGroup(widget)) continue;
    const auto part = std::find_if(parts.begin(), parts.end(),
                                   [&](const QWidget* p) { return p == widget || p->isAncestorOf(widget); });
    const QRect place(widget->mapTo(&window, QPoint()), widget->size());
    int block = place.top();
    bool scrolls = false;
    for (const QWidget* p = widget->parentWidget(); p && p != &window; p = p->parentWidget())
      if (qobject_cast<const QScrollArea*>(p)) {
        block = p->mapTo(&window, QPoint()).y();
        scrolls = true;
      }
    stops.push_back({widget, static_cast<int>(part - parts.begin()), block, place, scrolls});
  }
  std::stable_sort(stops.begin(), stops.end(), [](const Stop& a, const Stop& b) {
    return std::tuple(a.part, a.block, a.place.top()) < std::tuple(b.part, b.block, b.place.top());
  });
  QVector<QWidget*> way;
  for (auto row = stops.begin(); row != stops.end();) {
    // What begins above the middle of the row's first stands beside it; what is scrolled out of sight stands beside
    // nothing below.
    auto end = row + 1;
    while (end != stops.end() && end->part == row->part && end->scrolls == row->scrolls &&
           end->place.top() < row->place.center().y())
      ++end;
    std::stable_sort(row, end, [](const Stop& a, const Stop& b) { return a.place.left() < b.place.left(); });
    for (; row != end; ++row) way.push_back(row->widget);
  }
  return way;
}

bool focusNext(const QWidget& window, const QVector<QWidget*>& parts, bool next) {
  const QVector<QWidget*> way = tabWay(window, parts);
  if (way.isEmpty()) return false;
  const int at = way.indexOf(QApplication::focusWidget()), count = way.size();
  const int to = at < 0 ? (next ? 0 : count - 1) : (at + (next ? 1 : count - 1)) % count;
  way[to]->setFocus(next ? Qt::TabFocusReason : Qt::BacktabFocusReason);
  for (QWidget* p = way[to]->parentWidget(); p; p = p->parentWidget())
    if (auto* area = qobject_cast<QScrollArea*>(p)) area->ensureWidgetVisible(way[to]);
  return true;
}

void focusNextPart(const QWidget& window, const QVector<QWidget*>& parts, int by) {
  const int count = static_cast<int>(parts.size());
  int at = 0;
  for (int k = 0; k < count; ++k)
    if (parts[k]->isAncestorOf(QApplication::focusWidget())) at = k;
  for (int k = 1; k <= count; ++k) {
    QWidget* part = parts[((at + by * k) % count + count) % count];
    if (!part->isVisible()) continue;
    for (QWidget* each : tabWay(window, {part}))
      if (part->isAncestorOf(each)) return each->setFocus(Qt::TabFocusReason);
  }
}

}  // namespace heft
