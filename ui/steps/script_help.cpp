#include "ui/steps/script_help.h"

#include <fmt/format.h>

namespace heft {

std::string scriptHelp(const ScriptForms& forms) {
  constexpr std::size_t kColumn = 34;
  std::string out;
  for (const auto& [form, meaning] : forms) {
    if (meaning.empty())
      out += fmt::format("  {}\n", form);
    else if (form.size() < kColumn)
      out += fmt::format("  {:<{}}{}\n", form, kColumn, meaning);
    else
      out += fmt::format("  {}\n  {:<{}}{}\n", form, "", kColumn, meaning);
  }
  return out;
}

std::string formsOf(const ScriptForms& forms, std::string_view verb) {
  constexpr std::string_view kOr = " | ";
  std::string out;
  for (const auto& each : forms) {
    std::string_view rest = each.form;
    while (!rest.empty()) {
      const std::string_view form = rest.substr(0, rest.find(kOr));
      rest.remove_prefix(std::min(rest.size(), form.size() + kOr.size()));
      if (form.substr(0, form.find(' ')) != verb) continue;
      if (!out.empty()) out += kOr;
      out += form;
    }
  }
  return out;
}

}  // namespace heft
