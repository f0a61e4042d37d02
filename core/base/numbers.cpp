#include "core/base/numbers.h"

#include <algorithm>
#include <cmath>

#include "core/base/say.h"

namespace heft {

std::string sayNumber(double value, int decimals) {
  if (!std::isfinite(value)) return "—";
  decimals = std::clamp(decimals, 0, 12);
  if (std::abs(value) < 0.5 * std::pow(10.0, -decimals)) value = 0.0;
  const std::string pattern = fmt::format("{{:.{}f}}", decimals);
  const std::string digits = heft::say(fmt::runtime(pattern), std::abs(value));
  return value < 0.0 ? "−" + digits : digits;
}

int decimalsFor(double uncertainty, int most) {
  if (!std::isfinite(uncertainty) || uncertainty <= 0) return most;
  const double exponent = std::floor(std::log10(uncertainty));
  const double lead = uncertainty / std::pow(10.0, exponent);
  const int decimals = static_cast<int>(-exponent) + (lead < 1.95 ? 1 : 0);
  return std::clamp(decimals, 0, most);
}

}  // namespace heft
