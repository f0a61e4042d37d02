#pragma once
#include <QString>

namespace heft {

/// FOLDER/NAME.SUFFIX, or NAME-2, NAME-3 ... if that exists.
QString freeFile(const QString& folder, const QString& name, const QString& suffix);

}  // namespace heft
