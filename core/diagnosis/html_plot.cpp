#include "core/diagnosis/html_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

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

double xOf(const Scale& x, double value) { return kLeft + x.at(value) * (kWidth - kLeft - kRight); }
double yOf(const Scale& y, double value) { return kHeight - kBottom - y.at(value) * (kHeight - kBottom - kTop); }

std::string withUnit(const Axis& axis) {
  return escapedMarkup(axis.unit.empty() ? axis.title : fmt::format("{} [{}]", axis.title, axis.unit));
}

/// Caption, grid and ticks; the picture is left open.
template <class Drawn>
std::string frame(const Axis& y, const Axis& x, const Scale& ys, const Scale& xs, const std::vector<Drawn>& drawn) {
  std::string out = fmt::format("<figure><figcaption>{}", withUnit(y));
  for (const auto& one : drawn)
    out += fmt::format(" <span style=\"color:{}\">&#9644; {}</span>", one.colour, escapedMarkup(one.name));
  out += fmt::format("</figcaption><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", kWidth, kHeight,
                     escapedMarkup(y.title));
  for (const auto& [value, at] : ys.ticks()) {
    const double py = kHeight - kBottom - at * (kHeight - kBottom - kTop);
    out += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" class=\"g\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5:.4g}</text>",
        kLeft, kWidth - kRight, py, kLeft - 6, py + 4, value);
  }
  for (const auto& [value, at] : xs.ticks())
    out += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:.4g}</text>",
                       kLeft + at * (kWidth - kLeft - kRight), kHeight - 12, value);
  return out + fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", kWidth - kRight, kHeight - 1,
                           withUnit(x));
}

}  // namespace

std::string plot(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Curve>& curves) {
  Scale ys(y.logarithmic), xs(x.logarithmic);
  xs.mustShow(at);
  xs.widen(0.0);
  for (const auto& curve : curves) ys.mustShow(curve.y);
  ys.widen(0.05);
  std::string out = frame(y, x, ys, xs, curves);
  for (const auto& curve : curves) {
    // Two points a pixel are enough: the smallest and the largest of what falls into it.
    const auto columns = static_cast<Eigen::Index>(kWidth);
    const Eigen::Index stride = std::max<Eigen::Index>(1, curve.y.size() / columns);
    std::string path;
    for (Eigen::Index i = 0; i < curve.y.size(); i += stride) {
      const Eigen::Index n = std::min(stride, curve.y.size() - i);
      const auto part = curve.y.segment(i, n);
      if (!part.allFinite()) {
        path += path.empty() || path.back() == 'M' ? "" : " M";
        continue;
      }
      for (const double value : n > 1 ? std::array{part.minCoeff(), part.maxCoeff()} : std::array{part(0), part(0)})
        path += fmt::format("{}{:.1f},{:.1f}",
                            path.empty()         ? "M"
                            : path.back() == 'M' ? ""
                                                 : " ",
                            xOf(xs, at(i)), yOf(ys, value));
    }
    if (!path.empty() && path.back() == 'M') path.pop_back();
    out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>", path, curve.colour,
                       curve.width);
  }
  return out + "</svg></figure>\n";
}

std::string scatter(const Axis& y, const Axis& x, const VectorXd& at, const std::vector<Cloud>& clouds) {
  constexpr Eigen::Index kMost = 500;
  Scale ys(y.logarithmic), xs(x.logarithmic);
  xs.mustShow(at);
  xs.widen(0.02);
  for (const auto& cloud : clouds) ys.mustShow(cloud.y);
  ys.widen(0.05);
  std::string out = frame(y, x, ys, xs, clouds);
  const Eigen::Index stride = std::max<Eigen::Index>(1, at.size() / kMost);
  for (const auto& cloud : clouds) {
    out += fmt::format("<g fill=\"{}\" fill-opacity=\"0.6\">", cloud.colour);
    for (Eigen::Index i = 0; i < std::min(at.size(), cloud.y.size()); i += stride)
      if (std::isfinite(at(i)) && std::isfinite(cloud.y(i)))
        out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2\"/>", xOf(xs, at(i)), yOf(ys, cloud.y(i)));
    out += "</g>";
  }
  return out + "</svg></figure>\n";
}

}  // namespace heft::html
