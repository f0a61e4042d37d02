#include "core/base/said_again.h"

#include <fmt/args.h>
#include <pthread.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <deque>
#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <variant>
#include <vector>

#include "core/base/say.h"
#include "core/base/sentence_memory.h"

namespace heft {
namespace {

using nlohmann::json;

using Value = std::variant<std::monostate, bool, std::int64_t, std::uint64_t, double, std::string>;

struct Making {
  std::string pattern;
  std::vector<Value> values;
};

constexpr int kDeepest = 4;             // Sentences within sentences
constexpr std::size_t kLongest = 4000;  // [bytes] Of a text that is taken apart

std::mutex memoryMutex;
// A copy of the process that reads a file has its own, not held by a thread that it does not have.
[[maybe_unused]] const int memoryInCopies =
    ::pthread_atfork([] { memoryMutex.lock(); }, [] { memoryMutex.unlock(); }, [] { memoryMutex.unlock(); });
std::size_t capacity = 0;
std::map<std::string, Making> known;
std::deque<std::string> order;  // Oldest first

std::optional<Making> recall(const std::string& text) {
  const std::lock_guard lock(memoryMutex);
  const auto found = known.find(text);
  return found == known.end() ? std::nullopt : std::optional(found->second);
}

struct Copied {
  Value operator()(bool v) const { return v; }
  Value operator()(const char* v) const { return std::string(v); }
  Value operator()(fmt::string_view v) const { return std::string(v.data(), v.size()); }
  template <class T>
  Value operator()(const T& v) const {
    if constexpr (std::is_same_v<T, char>)
      return std::string(1, v);
    else if constexpr (std::is_floating_point_v<T>)
      return static_cast<double>(v);
    else if constexpr (std::is_integral_v<T> && sizeof(T) <= 8 && std::is_signed_v<T>)
      return std::int64_t{v};
    else if constexpr (std::is_integral_v<T> && sizeof(T) <= 8)
      return std::uint64_t{v};
    else
      return std::monostate{};
  }
};

std::string again(const std::string& text, int depth);

std::string saidOf(const Making& making, int depth) {
  fmt::dynamic_format_arg_store<fmt::format_context> values;
  for (const Value& value : making.values)
    std::visit(
        [&](const auto& v) {
          using T = std::decay_t<decltype(v)>;
          if constexpr (std::is_same_v<T, std::string>)
            values.push_back(again(v, depth + 1));
          else if constexpr (!std::is_same_v<T, std::monostate>)
            values.push_back(v);
        },
        value);
  return detail::said(making.pattern, values);
}

/// A part is taken for one that was said if it is a number or three words at least: single words are in any text.
bool worthSaying(const std::string& part) {
  const auto spaces = std::count(part.begin(), part.end(), ' ');
  return spaces >= 2 || std::any_of(part.begin(), part.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

/// The longest part from `from` on that is remembered and ends before a space, a comma or the end, and how many bytes
/// it takes.
std::optional<std::pair<Making, std::size_t>> longestPart(const std::string& text, std::size_t from) {
  for (std::size_t end = text.size(); end > from;) {
    for (const std::size_t to : {end, text[end - 1] == ',' ? end - 1 : end}) {
      const std::string part = text.substr(from, to - from);
      if (!worthSaying(part)) return std::nullopt;
      if (auto making = recall(part)) return std::pair{std::move(*making), part.size()};
    }
    const auto space = text.rfind(' ', end - 1);
    if (space == std::string::npos || space <= from) break;
    end = space;
  }
  return std::nullopt;
}

using Part = std::variant<std::string, Making>;  // As it stands, or what it was made of

std::vector<Part> partsOf(const std::string& text) {
  if (auto making = recall(text)) return {std::move(*making)};
  std::vector<Part> out{std::string()};
  if (text.size() > kLongest) return {text};
  for (std::size_t at = 0; at < text.size();) {
    if (auto part = longestPart(text, at)) {
      at += part->second;
      out.emplace_back(std::move(part->first));
      out.emplace_back(std::string());
    }
    const auto next = text.find(' ', at);
    const std::size_t to = next == std::string::npos ? text.size() : next + 1;
    std::get<std::string>(out.back()) += text.substr(at, to - at);
    at = to;
  }
  return out;
}

std::string again(const std::string& text, int depth) {
  if (depth > kDeepest) return text;
  std::string out;
  for (const Part& part : partsOf(text)) {
    const auto* making = std::get_if<Making>(&part);
    out += making != nullptr ? saidOf(*making, depth) : std::get<std::string>(part);
  }
  return out;
}

/// Files are anybody's: a width or precision of three digits would ask for memory without end.
bool harmless(const std::string& pattern) {
  int digits = 0, inside = 0;
  for (const unsigned char c : pattern) {
    inside += c == '{' ? 1 : c == '}' ? -1 : 0;
    digits = inside > 0 && std::isdigit(c) != 0 ? digits + 1 : 0;
    if (digits > 2) return false;
  }
  return pattern.size() <= kLongest;
}

}  // namespace

void remember(const std::string& text, fmt::string_view pattern, const fmt::format_args& arguments) {
  {
    const std::lock_guard lock(memoryMutex);
    if (capacity == 0) return;
  }
  Making making{std::string(pattern.data(), pattern.size()), {}};
  for (int i = 0;; ++i) {
    const auto argument = arguments.get(i);
    if (!argument) break;
    making.values.push_back(fmt::visit_format_arg(Copied{}, argument));
    if (std::holds_alternative<std::monostate>(making.values.back())) return;  // Nothing that can be kept
  }
  const std::lock_guard lock(memoryMutex);
  if (!known.insert_or_assign(text, std::move(making)).second) return;
  order.push_back(text);
  while (order.size() > capacity) {
    known.erase(order.front());
    order.pop_front();
  }
}

void rememberSentences(std::size_t most) {
  const std::lock_guard lock(memoryMutex);
  capacity = most;
  if (most > 0) return;
  known.clear();
  order.clear();
}

std::string sayAgain(const std::string& text) { return again(text, 0); }

namespace {

json jsonOf(const std::string& text, int depth);

json jsonOf(const Making& making, int depth) {
  json values = json::array();
  for (const Value& value : making.values)
    std::visit(
        [&](const auto& v) {
          using T = std::decay_t<decltype(v)>;
          if constexpr (std::is_same_v<T, std::string>)
            values.push_back(jsonOf(v, depth + 1));
          else if constexpr (!std::is_same_v<T, std::monostate>)
            values.push_back(v);
        },
        value);
  return {{"template", making.pattern}, {"values", std::move(values)}};
}

/// A string as it stands, or what it was made of: one making, or a list.
json jsonOf(const std::string& text, int depth) {
  if (depth > kDeepest) return text;
  json parts = json::array();
  bool made = false;
  for (const Part& part : partsOf(text)) {
    const auto* making = std::get_if<Making>(&part);
    made = made || making != nullptr;
    if (making != nullptr)
      parts.push_back(jsonOf(*making, depth));
    else if (const auto& literal = std::get<std::string>(part); !literal.empty())
      parts.push_back(literal);
  }
  return !made ? json(text) : parts.size() == 1 ? parts[0] : parts;
}

/// Throws fmt::format_error and json::exception where it is damaged.
std::string textFrom(const json& making, int depth) {
  if (making.is_string()) return making.get<std::string>();
  if (depth > kDeepest) throw fmt::format_error("too deep");
  std::string out;
  if (making.is_array()) {
    for (const json& part : making) out += textFrom(part, depth + 1);
    return out;
  }
  Making made{making.at("template").get<std::string>(), {}};
  if (!harmless(made.pattern)) throw fmt::format_error("too wide");
  for (const json& value : making.at("values")) {
    if (value.is_boolean())
      made.values.emplace_back(value.get<bool>());
    else if (value.is_number_unsigned())
      made.values.emplace_back(value.get<std::uint64_t>());
    else if (value.is_number_integer())
      made.values.emplace_back(value.get<std::int64_t>());
    else if (value.is_number())
      made.values.emplace_back(value.get<double>());
    else
      made.values.emplace_back(textFrom(value, depth + 1));
  }
  return saidOf(made, kDeepest - 1);
}

}  // namespace

json makingOf(const std::string& text) {
  json out = jsonOf(text, 0);
  return out.is_string() ? json() : out;
}

std::string sayFrom(const json& making, const std::string& otherwise) {
  if (!making.is_object() && !making.is_array()) return otherwise;
  try {
    return textFrom(making, 0);
  } catch (const fmt::format_error&) {
    return otherwise;
  } catch (const json::exception&) {
    return otherwise;
  }
}

}  // namespace heft
