#pragma once
// A box to choose from, as both dialogs have them.
class QComboBox;
class QString;
class QWidget;

namespace heft {

/// Named for scripts and screen readers; `characters` wide, since a long topic must not make the dialog wider than the
/// screen.
QComboBox* makeChoice(const QString& name, const QString& accessible, const QString& tip, int characters,
                      QWidget* parent);

}  // namespace heft
