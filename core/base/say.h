#pragma once
// How core says something to a person: in English, or in the language that the program around it has chosen.
//
// A template stands literally in the call, and the call is written heft::say(...): so packaging/update-texts.sh
// collects it for the translators, all under one heading.
#include <fmt/format.h>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace heft {

/// Returns a template ("{:.1f} s looked like contact.") in another language, with the same places, if need be in
/// another order ("{1} ... {0:.1f}"); empty where it knows none. Called from any thread.
using Translator = std::function<std::string(const char* pattern)>;

/// From now on say() speaks so, with this decimal point. An empty function: English.
void setTranslator(Translator translator, char decimalPoint = '.');

namespace detail {
std::string said(fmt::string_view pattern, fmt::format_args arguments);
}

/// heft::say("{:.1f} s of {} look touched.", seconds, name), as fmt::format.
template <class... Arguments>
std::string say(fmt::format_string<Arguments...> pattern, Arguments&&... arguments) {
  return detail::said(pattern, fmt::make_format_args(arguments...));
}

/// Marks a template that stands in a table and is said later: heft::say(fmt::runtime(template)).
constexpr const char* toSay(const char* pattern) { return pattern; }

/// All of them with ", " between each two.
std::string joined(const std::vector<std::string>& parts);

}  // namespace heft
