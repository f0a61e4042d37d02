#include "core/diagnosis/model/found_values.h"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "core/base/say.h"

namespace heft {

const CauseParameter* findParameter(const std::vector<CauseParameter>& parameters, std::string_view name) {
  const auto at = std::ranges::find(parameters, name, &CauseParameter::name);
  return at == parameters.end() ? nullptr : &*at;
}

std::string_view occurrenceOf(std::string_view name) {
  const auto line = name.rfind('_');
  const bool counted = line != std::string_view::npos && line + 1 < name.size() &&
                       std::isdigit(static_cast<unsigned char>(name[line + 1])) != 0;
  return counted ? name.substr(line) : std::string_view();
}

std::string channelWords(int channel) {
  const std::string axis(1, static_cast<char>('x' + channel % 3));
  return channel < 3 ? heft::say("force {}", axis) : heft::say("torque {}", axis);
}

std::string parameterWords(const CauseParameter& p) {
  // Small numbers in a large unit would be rounded away; degrees have a sign of their own.
  if (p.unit == "kg m") return diagnosis::plusMinus(1e3 * p.value, 1e3 * p.std) + " g m";
  if (p.unit == "deg") return diagnosis::plusMinus(p.value, p.std) + " \u00b0";
  return diagnosis::plusMinus(p.value, p.std) + (p.unit.empty() ? "" : " " + p.unit);
}

namespace diagnosis {

namespace {

constexpr std::array kPatterns{"{:.0f}", "{:.1f}", "{:.2f}", "{:.3f}", "{:.4f}", "{:.5f}", "{:.6f}"};
constexpr int kMostDecimals = std::ssize(kPatterns) - 1;

}  // namespace

std::string numberWords(double value, int decimals) {
  const double unit = std::pow(10.0, -decimals);
  if (std::abs(value) < 0.5 * unit) value = 0.0;  // Never -0.0
  return heft::say(fmt::runtime(kPatterns[static_cast<std::size_t>(std::clamp(decimals, 0, kMostDecimals))]), value);
}

std::string plusMinus(double value, double deviation) {
  const double std = 1.96 * deviation;
  if (!(std > 0.0) || !std::isfinite(std))
    return numberWords(value, std::abs(value) >= 100 ? 0 : std::abs(value) >= 1 ? 1 : 2);
  const double exponent = std::floor(std::log10(std));
  const bool small = std / std::pow(10.0, exponent) < 1.95;
  const int decimals = std::clamp(static_cast<int>(-exponent) + (small ? 1 : 0), 0, kMostDecimals);
  return numberWords(value, decimals) + " \u00b1 " + numberWords(std, decimals);
}

Matrix3d tensorOf(std::string_view what, const std::vector<CauseParameter>& parameters, std::string_view ending) {
  const std::string alike(what), along = alike + "_";
  const auto valueOf = [&](std::string name) {
    const CauseParameter* parameter = findParameter(parameters, name.append(ending));
    return parameter ? parameter->value : 0.0;
  };
  Matrix3d out = valueOf(alike) * Matrix3d::Identity();
  for (int i = 0; i < 3; ++i) {
    out(i, i) += valueOf(along + "xyz"[i]);
    for (int j = 0; j < i; ++j) out(i, j) = out(j, i) = valueOf(along + "xyz"[j] + "xyz"[i]);
  }
  return out;
}

int channelOf(std::string_view name) {
  constexpr std::array<std::string_view, 6> kNames{"fx", "fy", "fz", "tx", "ty", "tz"};
  for (std::size_t c = 0; c < kNames.size(); ++c)
    if (name.starts_with(kNames[c])) return static_cast<int>(c);
  return 0;
}

const CauseParameter* FoundValues::find(std::string_view name) const {
  return findParameter(parameters, std::string(name) + ending);
}

double FoundValues::value(std::string_view name) const {
  const auto* p = find(name);
  return p ? p->value : 0.0;
}

std::string FoundValues::size(std::string_view name) const {
  const auto* p = find(name);
  return p ? plusMinus(std::abs(p->value), p->std) : "0";
}

std::string FoundValues::norm(std::initializer_list<std::string_view> names) const {
  double sum = 0.0, std = 0.0;
  for (const auto name : names)
    if (const auto* p = find(name)) {
      sum += p->value * p->value;
      std = std::max(std, p->std);
    }
  return plusMinus(std::sqrt(sum), std);
}

std::string FoundValues::most(std::initializer_list<std::string_view> names) const {
  std::string_view best = *names.begin();
  for (const auto name : names)
    if (std::abs(value(name)) > std::abs(value(best))) best = name;
  return size(best);
}

double FoundValues::mostAlongAnyLine(std::string_view what) const {
  const Matrix3d tensor = tensorOf(what, parameters, ending);
  return tensor.selfadjointView<Eigen::Lower>().eigenvalues().cwiseAbs().maxCoeff();
}

const CauseParameter* FoundValues::strongest() const {
  const CauseParameter* best = nullptr;
  double most = -1.0;
  for (const auto& p : parameters) {
    if (occurrenceOf(p.name) != ending) continue;
    if (p.name.starts_with("time") || p.name.starts_with("turning_way") || p.name.starts_with("duration") ||
        p.name.starts_with("course_w") || p.name == "warm_up")
      continue;
    const double z = p.std > 0.0 ? std::abs(p.value) / p.std : 0.0;
    if (z > most) {
      most = z;
      best = &p;
    }
  }
  return best;
}

}  // namespace diagnosis
}  // namespace heft
