#pragma once
// The terms of resources/manual/glossary.json: one list for the manual's table and the tooltips of the window.
#include <QString>

namespace heft {

/// "residual: measured minus simulated" in the language of the window; empty for a term that the glossary does not
/// have.
QString glossaryTip(const QString& id);

/// The whole glossary as rows of a table: plain word, term of the field, meaning.
QString glossaryTable();

}  // namespace heft
