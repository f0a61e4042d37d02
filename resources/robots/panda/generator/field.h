#pragma once
// Solids as fields: negative inside, positive outside, close to the distance in metres near the surface. Sums of such
// fields with smooth minima give the rounded transitions of a moulded shell.
#include <functional>
#include <utility>
#include <vector>

#include "resources/robots/panda/generator/vec.h"

namespace heft::panda_maker {

using Field = std::function<double(Vec)>;

/// Minimum with a transition of width k [m], twice differentiable, so that highlights run over it without a line.
inline double smoothMin(double a, double b, double k) {
  const double h = std::max(k - std::abs(a - b), 0.0) / k;
  return std::min(a, b) - h * h * h * k * (1.0 / 6.0);
}
inline double smoothMax(double a, double b, double k) { return -smoothMin(-a, -b, k); }

/// Distance-like value of a body of revolution that is a cylinder of radius r for t < 0 and ends rounded at t = end.
/// `rho` is the distance from the axis. The end is halfway between an ellipse and a superellipse of order four.
inline double roundedEnd(double rho, double t, double r, double end) {
  if (t <= 0.0) return rho - r;
  const double a = rho / r, b = t / end;
  const double f2 = length2(a, b), f4 = std::sqrt(length2(a * a, b * b));
  if (f2 <= 0.0) return -std::min(r, end);
  const double d2a = a / (f2 * r), d2b = b / (f2 * end);
  const double f43 = f4 * f4 * f4, d4a = a * a * a / (f43 * r), d4b = b * b * b / (f43 * end);
  const double slope = 0.5 * length2(d2a + d4a, d2b + d4b);
  return (0.5 * (f2 + f4) - 1.0) / slope;
}

/// Flat-ended cylinder about an axis: `rho` from the axis, `t` along it, between `from` and `to`.
inline double cylinder(double rho, double t, double r, double from, double to) {
  const double side = rho - r, end = std::max(from - t, t - to);
  if (side > 0.0 && end > 0.0) return length2(side, end);
  return std::max(side, end);
}

/// A smooth function through given points (rising abscissae), by cubic Hermite pieces; constant outside.
class Curve {
 public:
  explicit Curve(std::vector<std::pair<double, double>> points) : points_(std::move(points)) {}

  double operator()(double t) const {
    if (t <= points_.front().first) return points_.front().second;
    if (t >= points_.back().first) return points_.back().second;
    std::size_t k = 1;
    while (points_[k].first < t) ++k;
    const auto [t0, v0] = points_[k - 1];
    const auto [t1, v1] = points_[k];
    const double step = t1 - t0, s = (t - t0) / step;
    const double m0 = slope(k - 1) * step, m1 = slope(k) * step;
    return ((2 * s - 3) * s * s + 1) * v0 + ((s - 2) * s + 1) * s * m0 + (3 - 2 * s) * s * s * v1 +
           (s - 1) * s * s * m1;
  }

 private:
  double slope(std::size_t k) const {
    if (k == 0 || k + 1 == points_.size()) return 0.0;
    return (points_[k + 1].second - points_[k - 1].second) / (points_[k + 1].first - points_[k - 1].first);
  }
  std::vector<std::pair<double, double>> points_;
};

/// Body of revolution of varying radius, without ends.
inline double lathe(double rho, double t, const Curve& radius) {
  const double slope = (radius(t + 1e-4) - radius(t - 1e-4)) / 2e-4;
  return (rho - radius(t)) / std::sqrt(1.0 + slope * slope);
}

/// Value divided by its slope: turns any smooth function that is zero on the surface into a distance near it.
template <class Function>
double perSlope(const Function& f, Vec p) {
  constexpr double h = 1e-5;
  const Vec slope{f({p.x + h, p.y, p.z}) - f({p.x - h, p.y, p.z}), f({p.x, p.y + h, p.z}) - f({p.x, p.y - h, p.z}),
                  f({p.x, p.y, p.z + h}) - f({p.x, p.y, p.z - h})};
  return f(p) / std::max(length(slope) / (2 * h), 1.0);
}

/// Stadium that narrows from radius r0 around (u0, v0) to r1 around (u1, v1): the hull of two circles.
inline double taperedStadium(double u, double v, double u0, double v0, double r0, double u1, double v1, double r1) {
  const double du = u1 - u0, dv = v1 - v0, l = length2(du, dv);
  const double t = ((u - u0) * du + (v - v0) * dv) / l, n = std::abs((u - u0) * dv - (v - v0) * du) / l;
  const double sine = (r0 - r1) / l, cosine = std::sqrt(1.0 - sine * sine);
  const double along = t * cosine - n * sine;  // Where the nearest point of the straight side lies.
  if (along < 0.0) return length2(t, n) - r0;
  if (along > l * cosine) return length2(t - l, n) - r1;
  return n * cosine + t * sine - r0;
}

/// Rectangle with half-sides and rounded corners.
inline double roundedRectangle(double u, double v, double halfU, double halfV, double round) {
  const double a = std::abs(u) - halfU + round, b = std::abs(v) - halfV + round;
  return length2(std::max(a, 0.0), std::max(b, 0.0)) + std::min(std::max(a, b), 0.0) - round;
}

/// A plane outline with thickness: `outline` and `t` (between from and to), edges rounded by `round`.
inline double extrude(double outline, double t, double from, double to, double round) {
  const double a = outline + round, b = std::abs(t - 0.5 * (from + to)) - 0.5 * (to - from) + round;
  return std::min(std::max(a, b), 0.0) + length2(std::max(a, 0.0), std::max(b, 0.0)) - round;
}

}  // namespace heft::panda_maker
