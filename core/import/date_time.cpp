#include "core/import/date_time.h"

#include <chrono>
#include <string>

#include "core/import/field_name.h"
#include "core/import/time_column.h"
#include "core/recording/number.h"

namespace heft {

namespace {

/// Reads a text from its front.
class DateScan {
 public:
  explicit DateScan(std::string_view text) : rest_(text) {}

  bool done() const { return rest_.empty(); }
  char next() const { return rest_.empty() ? '\0' : rest_.front(); }
  bool take(char c) {
    if (next() != c) return false;
    rest_.remove_prefix(1);
    return true;
  }
  void blanks() {
    while (next() == ' ') rest_.remove_prefix(1);
  }
  /// A number of 1 to `most` digits; -1 if there is none.
  int number(std::size_t most) {
    int value = 0;
    std::size_t digits = 0;
    while (digits < most && next() >= '0' && next() <= '9') {
      value = 10 * value + (next() - '0');
      rest_.remove_prefix(1);
      ++digits;
    }
    digits_ = digits;
    return digits == 0 ? -1 : value;
  }
  std::size_t digits() const { return digits_; }
  double fraction() {
    double value = 0.0, place = 0.1;
    while (next() >= '0' && next() <= '9') {
      value += place * (next() - '0');
      place *= 0.1;
      rest_.remove_prefix(1);
    }
    return value;
  }

 private:
  std::string_view rest_;
  std::size_t digits_ = 0;
};

/// Seconds since 1970 of a day; nothing if there is no such day.
std::optional<double> dayOf(int year, int month, int day) {
  using namespace std::chrono;
  if (year < 1900 || year > 2200 || month < 1 || day < 1) return std::nullopt;
  const year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                            std::chrono::day(static_cast<unsigned>(day))};
  if (!date.ok()) return std::nullopt;
  return static_cast<double>(duration_cast<seconds>(sys_days(date).time_since_epoch()).count());
}

std::optional<double> readDate(DateScan& scan, int first, std::size_t digits) {
  const char mark = scan.next();
  scan.take(mark);
  const int second = scan.number(2);
  if (second < 0 || !scan.take(mark)) return std::nullopt;
  const int third = scan.number(4);
  if (third < 0) return std::nullopt;
  if (digits == 4) return dayOf(first, second, third);
  const int year = scan.digits() == 2 ? 2000 + third : third;
  if (mark == '/' && second > 12) return dayOf(year, first, second);
  if (mark == '/' && first <= 12) return dayOf(year, first, second);
  return dayOf(year, second, first);
}

/// Z, +01:00, -0500 and the like [s]; 0 where there is none.
std::optional<double> readZone(DateScan& scan) {
  if (scan.take('Z') || scan.take('z') || scan.done()) return 0.0;
  const double sign = scan.next() == '-' ? -1.0 : 1.0;
  if (!scan.take('-') && !scan.take('+')) return std::nullopt;
  const int hours = scan.number(2);
  scan.take(':');
  const int minutes = scan.done() ? 0 : scan.number(2);
  if (hours < 0 || minutes < 0) return std::nullopt;
  return sign * (3600.0 * hours + 60.0 * minutes);
}

/// "0.004 sec", "12.5 ms": a number with its unit, as MATLAB's timetables write it.
std::optional<double> secondsOfDuration(std::string_view text) {
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const char* const after = csv::parseNumber(text.data(), end, value);
  if (after == text.data() || after == end || *after != ' ') return std::nullopt;
  const auto unit =
      unitSi(lowerCase(std::string_view(after + 1, static_cast<std::size_t>(end - after - 1))), Quantity::time);
  return unit ? std::optional(value * *unit) : std::nullopt;
}

}  // namespace

std::optional<double> secondsOfDate(std::string_view text) {
  while (!text.empty() && text.back() == ' ') text.remove_suffix(1);
  if (text.size() > 40) return std::nullopt;
  if (const auto duration = secondsOfDuration(text)) return duration;
  DateScan scan(text);
  scan.blanks();
  int hours = scan.number(4);
  if (hours < 0) return std::nullopt;
  double day = 0.0;
  if (scan.next() == '-' || scan.next() == '/' || scan.next() == '.') {
    const auto date = readDate(scan, hours, scan.digits());
    if (!date) return std::nullopt;
    day = *date;
    if (scan.done()) return day;
    if (!scan.take('T') && !scan.take('t') && !scan.take(' ') && !scan.take('_') && !scan.take(','))
      return std::nullopt;
    scan.blanks();
    hours = scan.number(2);
  }
  if (hours < 0 || hours > 24 || !scan.take(':')) return std::nullopt;
  const int minutes = scan.number(2);
  if (minutes < 0 || minutes > 59) return std::nullopt;
  double seconds = 0.0;
  if (scan.take(':')) {
    const int whole = scan.number(2);
    if (whole < 0 || whole > 60) return std::nullopt;
    seconds = whole;
    if (scan.take('.') || scan.take(',') || scan.take(':')) seconds += scan.fraction();
  }
  scan.blanks();
  double half = 0.0;
  const bool pm = scan.take('P') || scan.take('p');
  if (pm || scan.take('A') || scan.take('a')) {
    if (!scan.take('M') && !scan.take('m')) return std::nullopt;
    if (pm && hours < 12) half = 43200.0;
    if (!pm && hours == 12) half = -43200.0;
    scan.blanks();
  }
  const auto zone = readZone(scan);
  if (!zone || !scan.done()) return std::nullopt;
  return day + 3600.0 * hours + 60.0 * minutes + seconds + half - *zone;
}

}  // namespace heft
