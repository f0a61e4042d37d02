#include "core/base/say.h"

#include <locale>
#include <memory>
#include <mutex>

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
std::shared_ptr<const Language> chosen;

std::shared_ptr<const Language> language() {
  const std::lock_guard lock(mutex);
  return chosen;
}

/// Places that format a real number take the language's decimal point: "{:.1f}" becomes "{:.1Lf}".
std::string withLocalNumbers(const std::string& pattern) {
  std::string out;
  bool inside = false;
  for (std::size_t i = 0; i < pattern.size(); ++i) {
    const char c = pattern[i];
    if (c == '{') inside = i + 1 < pattern.size() && pattern[i + 1] != '{' && !(i > 0 && pattern[i - 1] == '{');
    const bool last = inside && i + 1 < pattern.size() && pattern[i + 1] == '}';
    if (last && (c == 'f' || c == 'g' || c == 'e')) out += 'L';
    if (c == '}') inside = false;
    out += c;
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

std::string detail::said(fmt::string_view pattern, fmt::format_args arguments) {
  if (const auto now = language()) {
    const std::string translated = now->translate(std::string(pattern.data(), pattern.size()).c_str());
    try {
      if (!translated.empty())
        return fmt::vformat(now->numbers, fmt::string_view(withLocalNumbers(translated)), arguments);
    } catch (const fmt::format_error&) {
      // A translation whose places do not fit tells nothing wrong: English does.
    }
  }
  return fmt::vformat(pattern, arguments);
}

std::string joined(const std::vector<std::string>& parts) { return fmt::format("{}", fmt::join(parts, ", ")); }

}  // namespace heft
