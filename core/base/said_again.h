#pragma once
// What was said stays sayable: a sentence that is kept as text, shown after another language was chosen.
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace heft {

/// From now on the last `most` different texts of say() are kept together with the templates and values that they were
/// made of; 0, as at first: none. For programs whose language may change while they run.
void rememberSentences(std::size_t most);

/// `text`, in the language of now, as far as it consists of texts that are remembered: one, several one after the
/// other, or with other words between. What is not remembered stays as it is.
std::string sayAgain(const std::string& text);

/// Of what a text was made, for a file that is read in another language: {"template", "values"}, or a list of such
/// parts and of strings; null where nothing of it is remembered.
nlohmann::json makingOf(const std::string& text);
/// The reverse; `otherwise` where `making` is null or damaged.
std::string sayFrom(const nlohmann::json& making, const std::string& otherwise);

}  // namespace heft
