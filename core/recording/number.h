#pragma once
// Decimal numbers as they stand in CSV cells: fast, exact, deaf to the locale.
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace heft::csv {

/// Appends the decimal digits at `at` to `mantissa` (modulo 2^64); returns the first other character.
inline const char* takeDigits(const char* at, const char* last, std::uint64_t& mantissa) {
  if constexpr (std::endian::native == std::endian::little) {
    while (last - at >= 8) {  // eight at once, in bytes of one word
      std::uint64_t word = 0;
      std::memcpy(&word, at, 8);
      const std::uint64_t value = word ^ 0x3030303030303030u;  // '0'..'9' become 0..9, all else exceeds 9
      if ((((value + 0x7676767676767676u) | value) & 0x8080808080808080u) != 0) break;
      std::uint64_t sum = (10 * value + (value >> 8)) & 0x00FF00FF00FF00FFu;  // pairs, in every other byte
      sum = (100 * sum + (sum >> 16)) & 0x0000FFFF0000FFFFu;                  // fours
      mantissa = 100000000 * mantissa + ((10000 * sum + (sum >> 32)) & 0xFFFFFFFFu);
      at += 8;
    }
  }
  while (at != last && static_cast<unsigned char>(*at - '0') < 10)
    mantissa = 10 * mantissa + static_cast<unsigned>(*at++ - '0');
  return at;
}

/// Reads the longest number at the start of [first, last) into `value`, correctly rounded; a leading '+' is allowed,
/// "inf" and "nan" in any case too. Numbers too large for a double become infinite, too small ones zero. Returns the
/// first character after the number, or `first` if there is none.
inline const char* parseNumber(const char* first, const char* last, double& value) {
  // Up to 2^53 and 10^22 doubles are exact, so that one division rounds correctly (Clinger 1990): most cells of sensors
  // and controllers end here, in a third of from_chars' time.
  static constexpr std::array<double, 23> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                     1e8,  1e9,  1e10, 1e11, 1e12, 1e13, 1e14, 1e15,
                                                     1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  const char* at = first;
  const bool negative = at != last && *at == '-';
  if (at != last && (*at == '-' || *at == '+')) ++at;
  const char* const start = at;
  std::uint64_t mantissa = 0;
  at = takeDigits(at, last, mantissa);
  std::ptrdiff_t digits = at - start;
  std::ptrdiff_t decimals = 0;
  if (at != last && *at == '.') {
    const char* const point = ++at;
    at = takeDigits(at, last, mantissa);
    decimals = at - point;
    digits += decimals;
  }
  const bool exponent = at != last && (*at | 0x20) == 'e';
  if (digits > 0 && digits <= 19 && mantissa <= (std::uint64_t{1} << 53) && !exponent) {
    const double magnitude = static_cast<double>(mantissa) / kPowers[static_cast<std::size_t>(decimals)];
    value = negative ? -magnitude : magnitude;
    return at;
  }

  if (start != last && (*start == '-' || *start == '+')) return first;  // "+-1"
  const char* const from = negative ? first : start;
  const auto [end, failure] = std::from_chars(from, last, value);
  if (failure == std::errc::result_out_of_range) {
    const std::string_view text(from, static_cast<std::size_t>(end - from));
    const auto e = text.find_first_of("eE");
    const bool tiny =
        e != std::string_view::npos ? text.substr(e + 1, 1) == "-" : text.find_first_of("123456789") > text.find('.');
    const double magnitude = tiny ? 0.0 : std::numeric_limits<double>::infinity();
    value = negative ? -magnitude : magnitude;
    return end;
  }
  return failure == std::errc() ? end : first;
}

}  // namespace heft::csv
