#include "core/import/demonstrations.h"

#include <algorithm>

#include "core/import/field_name.h"

namespace heft {

namespace {

/// The path of a stream up to the first part in which it differs from `other` by a number alone: "/data/demo_1" of
/// several demonstrations. Empty if they differ otherwise.
std::string differsByNumber(const std::string& name, const std::string& other) {
  const auto withoutDigits = [](std::string_view text) {
    std::string out;
    for (const char c : text)
      if (c < '0' || c > '9') out += c;
    return out;
  };
  std::size_t a = 0, b = 0;
  while (a < name.size() && b < other.size()) {
    const auto endA = std::min(name.find('/', a + 1), name.size());
    const auto endB = std::min(other.find('/', b + 1), other.size());
    const auto mine = name.substr(a, endA - a), theirs = other.substr(b, endB - b);
    if (mine != theirs) return withoutDigits(mine) == withoutDigits(theirs) ? name.substr(0, endA) : std::string();
    a = endA;
    b = endB;
  }
  return {};
}

}  // namespace

std::string demonstrationOf(const Stream& mine, const Stream& other) {
  if (auto name = differsByNumber(mine.name, other.name); !name.empty()) return name;
  if (!mine.name.starts_with('/') || mine.fields != other.fields) return {};
  const auto [a, b] = std::ranges::mismatch(mine.name, other.name);
  const auto at = static_cast<std::size_t>(a - mine.name.begin());
  if (a == mine.name.end() || b == other.name.end() || at == 0) return {};
  const auto endMine = std::min(mine.name.find('/', at), mine.name.size());
  const auto endOther = std::min(other.name.find('/', at), other.name.size());
  const auto begin = mine.name.rfind('/', at - 1);
  if (begin == std::string::npos || mine.name.substr(endMine) != other.name.substr(endOther)) return {};
  for (const auto& part : {mine.name.substr(begin, endMine - begin), other.name.substr(begin, endOther - begin)})
    for (const auto& word : wordsOf(part))
      if (word == "left" || word == "right" || word == "l" || word == "r") return {};
  return mine.name.substr(0, endMine);
}

}  // namespace heft
