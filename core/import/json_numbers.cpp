#include "core/import/json_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/base/text.h"
#include "core/import/date_time.h"
#include "core/recording/number.h"

namespace heft {

namespace {

constexpr std::size_t kMostNumbers = 4096;
constexpr std::size_t kDeepestArray = 32;

using nlohmann::json;

/// Of a number or a date [s] that was written as text.
std::optional<double> numberIn(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  if (!text.empty() && csv::parseNumber(text.data(), end, value) == end) return value;
  return secondsOfDate(text);
}

bool flatten(const json& node, const std::string& path, std::size_t depth, NamedNumbers& out) {
  const auto add = [&](double value) {
    out.names.push_back(path);
    out.values.push_back(value);
  };
  if (out.names.size() > kMostNumbers || depth > kDeepestArray) return false;
  if (node.is_number()) {
    add(node.get<double>());
  } else if (node.is_boolean()) {
    add(node.get<bool>() ? 1.0 : 0.0);
  } else if (node.is_string()) {
    if (const auto value = numberIn(node.get_ref<const std::string&>())) add(*value);
  } else if (node.is_null()) {
    add(std::numeric_limits<double>::quiet_NaN());
  } else if (node.is_array()) {
    for (std::size_t i = 0; i < node.size(); ++i) {
      // Transforms come in any order; each is called after its child frame.
      std::string label = std::to_string(i);
      if (node[i].is_object())
        if (const auto child = node[i].find("child_frame_id"); child != node[i].end() && child->is_string())
          if (auto frame = printable(child->get<std::string>(), 100); !frame.empty()) label = std::move(frame);
      if (!flatten(node[i], fmt::format("{}[{}]", path, label), depth + 1, out)) return false;
    }
  } else if (node.is_object()) {
    const auto labels = node.find("name");
    const bool labelled = labels != node.end() && labels->is_array();
    for (const auto& [key, value] : node.items()) {
      if (labelled && key == "name") continue;
      const std::string inner = path.empty() ? printable(key, 100) : path + "." + printable(key, 100);
      if (labelled && value.is_array() && value.size() == labels->size()) {
        for (std::size_t i = 0; i < value.size(); ++i) {
          const json& label = (*labels)[i];
          const std::string name = label.is_string() ? printable(label.get<std::string>(), 100) : std::to_string(i);
          if (!flatten(value[i], fmt::format("{}[{}]", inner, name), depth + 1, out)) return false;
        }
      } else if (!flatten(value, inner, depth + 1, out)) {
        return false;
      }
    }
  }
  return true;
}

/// The topic and the message's key of {"topic": "/ft", "msg": {...}}, as rosbridge and recorders of many topics write
/// each message; empty texts for other objects.
std::pair<std::string, std::string> envelopeOf(const json& object) {
  const auto topic = object.find("topic");
  if (topic == object.end() || !topic->is_string() || topic->get_ref<const std::string&>().empty()) return {};
  for (const char* const key : {"msg", "message", "data", "payload"})
    if (const auto inner = object.find(key); inner != object.end() && inner->is_object())
      return {printable(topic->get<std::string>(), 100), key};
  return {};
}

/// What stands in an envelope is called after its topic, so that two topics of one type stay apart; the stamps remain
/// where they are, one clock for all.
void nameAfterTopic(const std::string& topic, const std::string& key, NamedNumbers& numbers) {
  const std::string inside = key + ".", header = inside + "header.";
  for (auto& name : numbers.names)
    if (name.starts_with(inside) && !name.starts_with(header))
      name = fmt::format("{}/{}", topic, name.substr(inside.size()));
}

/// Calls work(i) for the characters outside of strings; it returns how many of them it has dealt with.
template <class Work>
void outsideStrings(std::string_view text, const Work& work) {
  bool quoted = false;
  for (std::size_t i = 0; i < text.size();) {
    if (text[i] == '"') {
      quoted = !quoted;
      ++i;
    } else if (quoted) {
      i += text[i] == '\\' ? 2 : 1;
    } else {
      i += work(i);
    }
  }
}

/// Deep nesting would exhaust the parser's own stack of brackets before flatten() sees it.
bool isTooDeep(std::string_view text) {
  std::size_t depth = 0, deepest = 0;
  outsideStrings(text, [&](std::size_t i) -> std::size_t {
    if (text[i] == '{' || text[i] == '[')
      deepest = std::max(deepest, ++depth);
    else if ((text[i] == '}' || text[i] == ']') && depth > 0)
      --depth;
    return 1;
  });
  return deepest > kDeepestArray;
}

bool flattenJson(std::string_view text, NamedNumbers& out) {
  out.names.clear();
  out.values.clear();
  if (isTooDeep(text)) return false;
  const json object = json::parse(withoutBareNaN(text), nullptr, false);
  if (!object.is_object() || !flatten(object, {}, 0, out)) return false;
  if (const auto [topic, key] = envelopeOf(object); !topic.empty()) nameAfterTopic(topic, key, out);
  return true;
}

/// Reads a number by JSON's grammar (RFC 8259, section 6). Returns the first character after it; `first` if there is
/// none, or none that a double can hold.
const char* jsonNumber(const char* first, const char* last, double& value) {
  const auto digits = [last](const char* at) {
    while (at != last && *at >= '0' && *at <= '9') ++at;
    return at;
  };
  const char* at = first;
  if (at != last && *at == '-') ++at;
  const char* end = digits(at);
  if (end == at || (*at == '0' && end - at > 1)) return first;
  if (end != last && *end == '.') {
    at = end + 1;
    end = digits(at);
    if (end == at) return first;
  }
  if (end != last && (*end == 'e' || *end == 'E')) {
    at = end + 1;
    if (at != last && (*at == '+' || *at == '-')) ++at;
    end = digits(at);
    if (end == at) return first;
  }
  return csv::parseNumber(first, end, value) == end && std::isfinite(value) ? end : first;
}

/// Where JSON's numbers stand in a text.
std::vector<std::string_view> numbersIn(std::string_view text) {
  std::vector<std::string_view> out;
  outsideStrings(text, [&](std::size_t i) -> std::size_t {
    const char* const first = text.data() + i;
    double value = 0.0;
    const auto length = static_cast<std::size_t>(jsonNumber(first, text.data() + text.size(), value) - first);
    if (length > 0) out.push_back(text.substr(i, length));
    return std::max<std::size_t>(length, 1);
  });
  return out;
}

/// Arrays of an object, also of objects in it, by their paths.
void collectArrays(const json& object, const std::string& path, std::map<std::string, const json*>& out) {
  for (const auto& [key, value] : object.items()) {
    std::string inner = path;
    if (!inner.empty()) inner += '.';
    inner += key;
    if (value.is_array()) out[inner] = &value;
    if (value.is_object()) collectArrays(value, inner, out);
  }
}

}  // namespace

std::string withoutBareNaN(std::string_view text) {
  if (text.find("NaN") == std::string_view::npos && text.find("Infinity") == std::string_view::npos)
    return std::string(text);
  std::string out;
  std::size_t copied = 0;
  outsideStrings(text, [&](std::size_t i) -> std::size_t {
    for (const std::string_view word : {"NaN", "-NaN", "Infinity", "-Infinity"}) {
      if (!text.substr(i).starts_with(word)) continue;
      out.append(text.substr(copied, i - copied)).append("null");
      copied = i + word.size();
      return word.size();
    }
    return 1;
  });
  return out.append(text.substr(copied));
}

bool JsonNumbers::Layout::read(std::string_view text) {
  const char* at = text.data();
  const char* const last = at + text.size();
  const auto passes = [&](const std::string& expected) {
    if (!std::string_view(at, static_cast<std::size_t>(last - at)).starts_with(expected)) return false;
    at += expected.size();
    return true;
  };
  for (std::size_t i = 0; i < inText.size(); ++i) {
    if (!passes(between[i])) return false;
    const char* const end = jsonNumber(at, last, inText[i]);
    if (end == at) return false;
    at = end;
  }
  if (!passes(between.back()) || at != last) return false;
  for (std::size_t k = 0; k < source.size(); ++k)
    if (source[k]) numbers.values[k] = inText[*source[k]];
  return true;
}

/// Which number becomes which is read from the same text with numbers that say where they stand.
std::optional<JsonNumbers::Layout> JsonNumbers::layoutOf(std::string_view text, const NamedNumbers& numbers) {
  constexpr std::size_t kShift = 1'000'000;
  Layout out;
  out.numbers = numbers;
  const auto places = numbersIn(text);
  out.inText.resize(places.size());
  std::string counted, shifted;
  const char* at = text.data();
  for (std::size_t i = 0; i < places.size(); ++i) {
    out.between.emplace_back(at, places[i].data());
    at = places[i].data() + places[i].size();
    counted += out.between.back() + std::to_string(i);
    shifted += out.between.back() + std::to_string(i + kShift);
  }
  out.between.emplace_back(at, text.data() + text.size());
  counted += out.between.back();
  shifted += out.between.back();
  NamedNumbers once, twice;
  if (!flattenJson(counted, once) || !flattenJson(shifted, twice)) return std::nullopt;
  if (once.names != numbers.names || twice.names != numbers.names) return std::nullopt;
  for (std::size_t k = 0; k < once.values.size(); ++k) {
    const bool stated = twice.values[k] - once.values[k] == static_cast<double>(kShift);
    out.source.push_back(stated ? std::optional(static_cast<std::size_t>(once.values[k])) : std::nullopt);
  }
  return out;
}

const NamedNumbers* JsonNumbers::read(std::string_view text) {
  constexpr std::size_t kMostLayouts = 16;         ///< Senders to one port, topics of one connection
  constexpr std::size_t kLongestLayout = 1 << 16;  ///< Characters; more than 4096 numbers take
  for (std::size_t i = 0; i < layouts_.size(); ++i) {
    if (!layouts_[i].read(text)) continue;
    ++useful_;
    if (i > 0) std::swap(layouts_[i], layouts_[0]);
    return &layouts_.front().numbers;
  }
  if (!flattenJson(text, other_)) return nullptr;
  // Of a sender whose texts change each time nothing is learned.
  if (text.size() <= kLongestLayout && (learned_ < kMostLayouts || learned_ < useful_))
    if (auto layout = layoutOf(text, other_)) {
      ++learned_;
      if (layouts_.size() == kMostLayouts) layouts_.pop_back();
      layouts_.push_front(std::move(*layout));
    }
  return &other_;
}

std::vector<std::string> rowsOfJsonTable(std::string_view text) {
  constexpr std::size_t kFewestRows = 10;
  const auto shown = [](const json& value) { return value.dump(-1, ' ', false, json::error_handler_t::replace); };
  std::vector<std::string> rows;
  if (isTooDeep(text)) return rows;
  const json whole = json::parse(withoutBareNaN(text), nullptr, false);
  if (whole.is_array()) {
    for (const json& each : whole)
      if (each.is_object()) rows.push_back(shown(each));
  } else if (whole.is_object()) {
    std::map<std::string, const json*> arrays;
    collectArrays(whole, {}, arrays);
    // The length that most of them share; of lengths that as many share, the greater.
    std::map<std::size_t, std::size_t> lengths;
    for (const auto& [path, values] : arrays) ++lengths[values->size()];
    std::size_t count = 0, most = 0;
    for (const auto& [length, times] : lengths)
      if (length >= kFewestRows && times >= most) {
        count = length;
        most = times;
      }
    for (std::size_t k = 0; k < count; ++k) {
      json row = json::object();
      for (const auto& [path, values] : arrays)
        if (values->size() == count) row[path] = (*values)[k];
      rows.push_back(shown(row));
    }
  }
  if (rows.size() < kFewestRows) rows.clear();
  return rows;
}

}  // namespace heft
