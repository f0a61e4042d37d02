#pragma once
// What the cards of the reality check are put together from.
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QString>
#include <QWidget>

#include "ui/reality_cards/cause_numbers.h"
#include "ui/widgets/basics.h"

namespace heft {

/// Verdict tag: icon and word.
QWidget* makeVerdictTag(const QString& text, Light light, bool accent, QWidget* parent);

/// The tag at the left, a word with its tip at the right.
QHBoxLayout* tagRow(QWidget* tag, const QString& right, const QString& tip, QWidget* parent);
QPushButton* makeButton(const QString& text, const char* name, QWidget* parent);
/// "Check on the robot: ...": bold beginning, plain rest.
QLabel* boldFirst(const QString& bold, const QString& rest, QWidget* parent);
/// Two bars and the noise floor as a dashed line.
QWidget* makeGainBars(const UnseenError& unseen, QWidget* parent);

}  // namespace heft
