#include "core/base/say.h"

#include <pthread.h>

#include <cstdlib>
#include <locale>
#include <memory>
#include <mutex>
#include <type_traits>

#include "core/base/sentence_memory.h"

namespace heft {
namespace {

struct Language {
  Translator translate;
  std::locale numbers;
};

class DecimalPoint : public std::numpunct<char> {
 public:
  explicit DecimalPoint(char point) : point_(point) {}

 protected:
  char do_decimal_point() const override { return point_; }

 private:
  char point_;
};

std::mutex mutex;
// A copy of the process that reads a file has its own, not held by a thread that it does not have.
[[maybe_unused]] const int languageInCopies =
    ::pthread_atfork([] { mutex.lock(); }, [] { mutex.unlock(); }, [] { mutex.unlock(); });
std::shared_ptr<const Language> chosen;

std::shared_ptr<const Language> language() {
  const std::lock_guard lock(mutex);
  return chosen;
}

bool isReal(const fmt::format_args& arguments, int place) {
  const auto argument = arguments.get(place);
  return argument &&
         fmt::visit_format_arg(
             [](const auto& value) { return std::is_floating_point_v<std::decay_t<decltype(value)>>; }, argument);
}

/// Places that hold a real number take the language's decimal point: "{:.1f}" becomes "{:.1Lf}", "{}" "{:L}".
std::string withLocalNumbers(const std::string& pattern, const fmt::format_args& arguments) {
  std::string out;
  int next = 0;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char c = pattern[i];
    const auto end = pattern.find('}', i);
    out += c;
    if ((c != '{' && c != '}') || end == std::string::npos) continue;
    if (c == '}' || pattern[i + 1] == '{') {  // A brace that is written twice stands for itself.
      out += pattern[++i];
      continue;
    }
    std::string place = pattern.substr(i + 1, end - i - 1);
    const auto colon = place.find(':');
    const std::string number = place.substr(0, colon);
    if (isReal(arguments, number.empty() ? next++ : std::atoi(number.c_str()))) {
      if (colon == std::string::npos) place += ':';
      const bool typed = std::string_view("eEfFgG").find(place.back()) != std::string_view::npos;
      place.insert(place.size() - (typed ? 1 : 0), "L");
    }
    out += place + "}";
    i = end;
  }
  return out;
}

}  // namespace

void setTranslator(Translator translator, char decimalPoint) {
  std::shared_ptr<const Language> next;
  if (translator)
    next = std::make_shared<const Language>(
        Language{std::move(translator), std::locale(std::locale::classic(), new DecimalPoint(decimalPoint))});
  const std::lock_guard lock(mutex);
  chosen = std::move(next);
}

namespace {

std::string inLanguageOfNow(fmt::string_view pattern, const fmt::format_args& arguments) {
  if (const auto now = language()) {
    const std::string translated = now->translate(std::string(pattern.data(), pattern.size()).c_str());
    try {
      if (!translated.empty())
        return fmt::vformat(now->numbers, fmt::string_view(withLocalNumbers(translated, arguments)), arguments);
    } catch (const fmt::format_error&) {
      // A translation whose places do not fit tells nothing wrong: English does.
    }
  }
  return fmt::vformat(pattern, arguments);
}

}  // namespace

std::string detail::said(fmt::string_view pattern, fmt::format_args arguments) {
  std::string out = inLanguageOfNow(pattern, arguments);
  remember(out, pattern, arguments);
  return out;
}

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, ", ")); }

}  // namespace heft
