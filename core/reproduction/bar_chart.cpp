#include "core/reproduction/bar_chart.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include "core/base/markup.h"

namespace heft {

namespace {

// Told apart in grey and by colour-blind readers too.
constexpr std::array<std::string_view, 6> kColours{"#b0b0b0", "#6e6e6e", "#e69f00", "#d55e00", "#0072b2", "#009e73"};

std::string decadeLabel(int exponent) {
  if (exponent >= -3 && exponent <= 4) return fmt::format("{:g}", std::pow(10.0, exponent));
  return fmt::format("1e{}", exponent);
}

}  // namespace

std::string toSvg(const BarChart& chart) {
  constexpr double kLeft = 78, kTop = 72, kHeight = 300, kBar = 14, kGap = 22, kBottom = 128;
  const double groupWidth = kBar * static_cast<double>(chart.series.size()) + kGap;
  const double plotWidth = std::max(420.0, groupWidth * static_cast<double>(chart.groups.size()));
  const double step = plotWidth / static_cast<double>(std::max<std::size_t>(1, chart.groups.size()));
  const double width = kLeft + plotWidth + 24, height = kTop + kHeight + kBottom;

  double least = std::numeric_limits<double>::infinity(), most = 0.0;
  for (const auto& series : chart.series)
    for (const double value : series.values)
      if (std::isfinite(value) && value > 0.0) {
        least = std::min(least, value);
        most = std::max(most, value);
      }
  if (most <= 0.0) least = most = 1.0;
  const int top =
      std::max(static_cast<int>(std::ceil(std::log10(most))), static_cast<int>(std::floor(std::log10(least))) + 1);
  const int bottom = std::max(static_cast<int>(std::floor(std::log10(least) - 1e-9)), top - 10);
  const auto yOf = [&](double value) {
    const double part = (std::log10(value) - bottom) / static_cast<double>(top - bottom);
    return kTop + kHeight * (1.0 - std::clamp(part, 0.005, 1.0));
  };

  std::string svg = fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!-- heft reproduce -->\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"12\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
      "<text x=\"{2:.1f}\" y=\"22\" font-size=\"15\" font-weight=\"bold\">{3}</text>\n",
      width, height, kLeft, escapedMarkup(chart.title));

  double legend = kLeft;
  for (std::size_t s = 0; s < chart.series.size(); ++s) {
    svg += fmt::format("<rect x=\"{:.1f}\" y=\"38\" width=\"11\" height=\"11\" fill=\"{}\"/>\n", legend,
                       kColours[s % kColours.size()]);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"48\">{}</text>\n", legend + 15, escapedMarkup(chart.series[s].name));
    legend += 30 + 6.4 * static_cast<double>(chart.series[s].name.size());
  }
  for (int exponent = bottom; exponent <= top; ++exponent) {
    const double y = kTop + kHeight * static_cast<double>(top - exponent) / static_cast<double>(top - bottom);
    svg += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" stroke=\"#dddddd\"/>\n", kLeft, y,
                       kLeft + plotWidth, y);
    svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", kLeft - 6, y + 4,
                       decadeLabel(exponent));
  }
  for (std::size_t g = 0; g < chart.groups.size(); ++g) {
    const double centre = kLeft + step * (static_cast<double>(g) + 0.5);
    double x = centre - 0.5 * kBar * static_cast<double>(chart.series.size());
    for (std::size_t s = 0; s < chart.series.size(); ++s, x += kBar) {
      const double value = g < chart.series[s].values.size() ? chart.series[s].values[g] : std::nan("");
      if (!(value > 0.0)) continue;
      const double y = yOf(value);
      svg += fmt::format(
          "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"{}\"><title>{}, {}: "
          "{:.3g}</title></rect>\n",
          x, y, kBar - 1.0, kTop + kHeight - y, kColours[s % kColours.size()], escapedMarkup(chart.groups[g]),
          escapedMarkup(chart.series[s].name), value);
    }
    svg += fmt::format(
        "<text x=\"{0:.1f}\" y=\"{1:.1f}\" text-anchor=\"end\" font-size=\"11\" transform=\"rotate(-28 {0:.1f} "
        "{1:.1f})\">{2}</text>\n",
        centre + 8, kTop + kHeight + 16, escapedMarkup(chart.groups[g]));
  }
  svg += fmt::format("<path d=\"M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}\" fill=\"none\" stroke=\"#333333\"/>\n", kLeft, kTop,
                     kTop + kHeight, kLeft + plotWidth);
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", kLeft + 0.5 * plotWidth,
                     height - 10, escapedMarkup(chart.xTitle));
  svg += fmt::format(
      "<text x=\"18\" y=\"{0:.1f}\" text-anchor=\"middle\" transform=\"rotate(-90 18 {0:.1f})\">{1}</text>\n</svg>\n",
      kTop + 0.5 * kHeight, escapedMarkup(chart.yTitle));
  return svg;
}

}  // namespace heft
