#pragma once
// The lines of a studio script: one command a line, words separated by spaces, "quotes" around words with spaces, # for
// remarks.
#include <QSize>
#include <QStringList>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"

namespace heft {

struct ScriptLine {
  int number = 0;  ///< From 1.
  QStringList words;
};

/// `name` stands in messages.
Result<std::vector<ScriptLine>> parseScript(std::string_view text, const std::string& name);

/// "1440x900" between 640x400 and 7680x4320; empty if it is no such size.
std::optional<QSize> parseSize(const QString& text);

/// The largest window that the script asks for, at least `least`: the screen must be able to hold it.
QSize screenFor(const std::vector<ScriptLine>& lines, QSize least);

}  // namespace heft
