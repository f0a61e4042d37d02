#pragma once
// A plain 3-vector. The generator uses only + - * / and sqrt, which IEEE 754 rounds in one way: every machine and
// compiler writes the same bytes (built with -ffp-contract=off), and the test of the committed files relies on it.
#include <algorithm>
#include <cmath>

namespace heft::panda_maker {

struct Vec {
  double x = 0.0, y = 0.0, z = 0.0;
};

inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(Vec a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline Vec operator*(double s, Vec a) { return a * s; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(Vec a, Vec b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline double length2(double a, double b) { return std::sqrt(a * a + b * b); }
inline double length3(double a, double b, double c) { return std::sqrt(a * a + b * b + c * c); }
/// Unit vector along `a`, or zero.
inline Vec unit(Vec a) {
  const double l = length(a);
  return l > 0.0 ? a * (1.0 / l) : Vec{};
}

}  // namespace heft::panda_maker
