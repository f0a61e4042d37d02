#include "core/diagnosis/report/html_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/base/markup.h"

namespace heft::html {

namespace {

constexpr double kWidth = 860, kHeight = 190, kLeft = 62, kBottom = 30, kTop = 12, kRight = 12;

/// Round steps for an axis.
double stepFor(double span) {
  const double raw = span / 4.0, power = std::pow(10.0, std::floor(std::log10(std::max(1e-12, raw))));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10.0 * power;
}

/// An axis and the values that it must show: in units of its logarithm where it has one.
class Scale {
 public:
  explicit Scale(bool logarithmic) : logarithmic_(logarithmic) {}

  double valueOf(double y) const { return logarithmic_ ? std::log10(std::max(1e-12, y)) : y; }
  void mustShow(const VectorXd& values) {
    for (const double y : values)
      if (std::isfinite(y)) {
        low_ = std::min(low_, valueOf(y));
        high_ = std::max(high_, valueOf(y));
      }
  }
  /// Some room at either end; call once everything is shown.
  void widen(double share) {
    if (!(high_ > low_)) {
      if (low_ > high_) low_ = 0.0;
      high_ = low_ + 1.0;
    }
    const double pad = share * (high_ - low_);
    low_ -= pad;
    high_ += pad;
  }
  /// Where a value lies, 0 .. 1.
  double at(double y) const { return (valueOf(y) - low_) / (high_ - low_); }
  /// What is written where, 0 .. 1.
  std::vector<std::pair<double, double>> ticks() const {
    std::vector<std::pair<double, double>> out;
    const double step = logarithmic_ ? std::max(1.0, stepFor(high_ - low_)) : stepFor(high_ - low_);
    for (double v = std::ceil(low_ / step) * step; v <= high_; v += step)
      out.emplace_back(logarithmic_                ? std::pow(10.0, v)
                       : std::abs(v) < 1e-9 * step ? 0.0
                                                   : v,
                       (v - low_) / (high_ - low_));
    return out;
  }

 private:
  bool logarithmic_;
  double low_ = 1e300, high_ = -1e300;
};

std::string withUnit(const Axis& axis) {
  return escapedMarkup(axis.unit.empty() ? axis.title : fmt::format("{} [{}]", axis.title, axis.unit));
}

/// Caption, grid and ticks; the picture is left open.
class Frame {
 public:
  /// `room`: at either end of x, a share.
  Frame(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Series>& drawn, double room)
      : x_(x.logarithmic), y_(y.logarithmic) {
    x_.mustShow(at);
    x_.widen(room);
    for (const auto& one : drawn) y_.mustShow(one.y);
    y_.widen(0.05);
    svg = fmt::format("<figure><figcaption>{}", withUnit(y));
    for (const auto& one : drawn)
      svg += fmt::format(" <span style=\"color:{}\">&#9644; {}</span>", one.colour, escapedMarkup(one.name));
    svg += fmt::format("</figcaption><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", kWidth, kHeight,
                       escapedMarkup(y.title));
    for (const auto& [value, share] : y_.ticks())
      svg += fmt::format(
          "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" class=\"g\"/><text x=\"{3}\" y=\"{4:.1f}\" "
          "text-anchor=\"end\">{5:.4g}</text>",
          kLeft, kWidth - kRight, up(share), kLeft - 6, up(share) + 4, value);
    for (const auto& [value, share] : x_.ticks())
      svg += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:.4g}</text>", across(share),
                         kHeight - 15, value);
    svg +=
        fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", kWidth - kRight, kHeight - 3, withUnit(x));
  }
  double xOf(double value) const { return across(x_.at(value)); }
  double yOf(double value) const { return up(y_.at(value)); }
  std::string closed() && { return std::move(svg) + "</svg></figure>\n"; }

  std::string svg;

 private:
  static double across(double share) { return kLeft + share * (kWidth - kLeft - kRight); }
  static double up(double share) { return kHeight - kBottom - share * (kHeight - kBottom - kTop); }

  Scale x_, y_;
};

}  // namespace

std::string plot(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Series>& lines) {
  Frame frame(y, x, at, lines, 0.0);
  for (const auto& line : lines) {
    // Two points a pixel are enough: the smallest and the largest of what falls into it.
    const auto columns = static_cast<Eigen::Index>(kWidth);
    const Eigen::Index stride = std::max<Eigen::Index>(1, line.y.size() / columns);
    std::string path;
    for (Eigen::Index i = 0; i < line.y.size(); i += stride) {
      const Eigen::Index n = std::min(stride, line.y.size() - i);
      const auto part = line.y.segment(i, n);
      if (!part.allFinite()) {
        path += path.empty() || path.back() == 'M' ? "" : " M";
        continue;
      }
      for (const double value : n > 1 ? std::array{part.minCoeff(), part.maxCoeff()} : std::array{part(0), part(0)})
        path += fmt::format("{}{:.1f},{:.1f}",
                            path.empty()         ? "M"
                            : path.back() == 'M' ? ""
                                                 : " ",
                            frame.xOf(at(i)), frame.yOf(value));
    }
    if (!path.empty() && path.back() == 'M') path.pop_back();
    frame.svg +=
        fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>", path, line.colour, line.width);
  }
  return std::move(frame).closed();
}

std::string scatter(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Series>& clouds) {
  constexpr Eigen::Index kMostPoints = 500;
  Frame frame(y, x, at, clouds, 0.02);
  const Eigen::Index stride = std::max<Eigen::Index>(1, at.size() / kMostPoints);
  for (const auto& cloud : clouds) {
    frame.svg += fmt::format("<g fill=\"{}\" fill-opacity=\"0.6\">", cloud.colour);
    for (Eigen::Index i = 0; i < at.size(); i += stride)
      if (std::isfinite(at(i)) && std::isfinite(cloud.y(i)))
        frame.svg += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\"/>", frame.xOf(at(i)),
                                 frame.yOf(cloud.y(i)), 0.5 * cloud.width);
    frame.svg += "</g>";
  }
  return std::move(frame).closed();
}

}  // namespace heft::html
