#include "core/diagnosis/model/correlate.h"

#include <fmt/format.h>

#include <ostream>

#include "core/base/say.h"

namespace heft::diagnosis {

Correlate Correlate::rhythm(double frequencyHz) {
  return {frequencyHz < 10.0 ? heft::toSay("a rhythm of {:.2g} Hz") : heft::toSay("a rhythm of {:.0f} Hz"),
          frequencyHz};
}

std::string Correlate::english() const { return fmt::format(fmt::runtime(pattern_), first_, second_); }

std::string Correlate::words() const {
  return empty() ? std::string() : heft::say(fmt::runtime(pattern_), first_, second_);
}

std::ostream& operator<<(std::ostream& out, const Correlate& correlate) { return out << correlate.english(); }

}  // namespace heft::diagnosis
