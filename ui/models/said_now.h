#pragma once
// What core said when something was found, in the language of the window now.
#include <QString>

#include "core/base/said_again.h"

namespace heft {

inline QString saidNow(const std::string& text) { return QString::fromStdString(sayAgain(text)); }

}  // namespace heft
