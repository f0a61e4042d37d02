#include "ui/studio/script.h"

#include <fmt/format.h>

namespace heft {

Result<std::vector<ScriptLine>> parseScript(std::string_view text, const std::string& name) {
  std::vector<ScriptLine> lines;
  const QStringList rows = QString::fromUtf8(text.data(), static_cast<int>(text.size())).split('\n');
  for (int row = 0; row < rows.size(); ++row) {
    ScriptLine line{row + 1, {}};
    QString word;
    bool quoted = false, begun = false;
    for (const QChar c : rows[row]) {
      if (c == '"') {
        quoted = !quoted;
        begun = true;
      } else if (!quoted && c.isSpace()) {
        if (begun) line.words << word;
        word.clear();
        begun = false;
      } else if (!quoted && !begun && c == '#') {
        break;
      } else {
        word += c;
        begun = true;
      }
    }
    if (quoted) return Error{fmt::format("{}:{}: the quotation mark has no partner.", name, row + 1)};
    if (begun) line.words << word;
    if (!line.words.isEmpty()) lines.push_back(line);
  }
  return lines;
}

std::optional<QSize> parseSize(const QString& text) {
  const QStringList parts = text.split('x');
  if (parts.size() != 2) return std::nullopt;
  bool first = false, second = false;
  const QSize size(parts[0].toInt(&first), parts[1].toInt(&second));
  if (!first || !second || size.width() < 640 || size.height() < 400 || size.width() > 7680 || size.height() > 4320)
    return std::nullopt;
  return size;
}

QSize screenFor(const std::vector<ScriptLine>& lines, QSize least) {
  for (const ScriptLine& line : lines) {
    if (line.words.size() != 2 || line.words[0] != "size") continue;
    if (const auto size = parseSize(line.words[1])) least = least.expandedTo(*size);
  }
  return least;
}

}  // namespace heft
