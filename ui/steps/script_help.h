#pragma once
// What the lines of a script may say, as `heft-studio --help` prints it. Whoever obeys a line has the list of its forms
// beside the code that obeys it; nothing else repeats them.
#include <string>
#include <string_view>
#include <vector>

namespace heft {

struct ScriptForm {
  std::string_view form;     ///< "mark FROM TO LABEL"; several with " | " between
  std::string_view meaning;  ///< May be empty
};
using ScriptForms = std::vector<ScriptForm>;

/// Two columns, indented by two; a long form has a line of its own.
std::string scriptHelp(const ScriptForms& forms);

/// The forms that begin with `verb`, as "mark FROM TO LABEL"; empty if none does.
std::string formsOf(const ScriptForms& forms, std::string_view verb);

}  // namespace heft
