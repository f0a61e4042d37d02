#pragma once
// The Tab key's way through a window: as the eye goes, whatever was built first.
#include <QVector>

class QWidget;

namespace heft {

/// What the Tab key leads to in `window`, in order: part by part of `parts`, then whatever is in none of them; in each
/// row by row, from the left. Of buttons that exclude each other only the chosen one: arrow keys lead to the others.
QVector<QWidget*> tabWay(const QWidget& window, const QVector<QWidget*>& parts);

/// Gives the focus to the next or the previous on that way; false where there is nothing.
bool focusNext(const QWidget& window, const QVector<QWidget*>& parts, bool next);
/// To the next of the parts (`by`: 1 or -1) that takes the keyboard, as in other programs.
void focusNextPart(const QWidget& window, const QVector<QWidget*>& parts, int by);

}  // namespace heft
