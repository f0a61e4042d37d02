#pragma once
// What a misfit that no cause accounts for goes with.
#include <iosfwd>
#include <string>
#include <string_view>

namespace heft::diagnosis {

/// "where the tool is", "a rhythm of 1.3 Hz": data, said in English for files and in the program's language for people.
class Correlate {
 public:
  Correlate() = default;
  /// `pattern`: heft::toSay(), with as many places as values [Hz, or a joint's number].
  Correlate(const char* pattern, double first = 0.0, double second = 0.0)
      : pattern_(pattern), first_(first), second_(second) {}
  static Correlate rhythm(double frequencyHz);

  bool empty() const { return pattern_.empty(); }
  std::string english() const;
  /// In the language of the program, now.
  std::string words() const;

  bool operator==(const Correlate&) const = default;
  friend bool operator==(const Correlate& correlate, std::string_view english) {
    return correlate.english() == english;
  }
  friend bool operator==(const Correlate& correlate, const char* english) { return correlate.english() == english; }

 private:
  std::string_view pattern_;
  double first_ = 0.0, second_ = 0.0;
};

std::ostream& operator<<(std::ostream& out, const Correlate& correlate);

}  // namespace heft::diagnosis
