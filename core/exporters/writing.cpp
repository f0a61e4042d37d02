#include "core/exporters/writing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/base/text.h"

namespace heft {

std::string number(double value) {
  if (value == 0.0) return "0";  // also for -0
  std::array<char, 400> buffer;  // the longest double without exponent has some 330 characters
  const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::fixed).ptr;
  return std::string(buffer.data(), end);
}

double roundedTo(double value, int decimals) {
  const double factor = std::pow(10.0, decimals);
  const double scaled = std::nearbyint(value * factor);
  // Beyond 2^53 a double has fewer places than were asked for: it is what it is.
  if (!std::isfinite(scaled) || std::abs(scaled) > 9007199254740992.0) return value;
  return scaled / factor;
}

int decimalsFor(double largest) {
  if (!(largest > 0.0)) return 6;
  return std::clamp(5 - static_cast<int>(std::floor(std::log10(largest))), 4, 18);
}

std::string list(std::initializer_list<double> values, std::string_view separator) {
  return list(std::span<const double>(values.begin(), values.size()), separator);
}

std::string list(std::span<const double> values, std::string_view separator) {
  std::string text;
  for (std::size_t i = 0; i < values.size(); ++i) text += (i ? std::string(separator) : "") + number(values[i]);
  return text;
}

std::string list(const Vector3d& v, std::string_view separator) { return list({v.x(), v.y(), v.z()}, separator); }

std::string columnMajor(const Matrix3d& m) { return list(std::span<const double>(m.data(), 9)); }

std::string identifier(std::string_view name) {
  std::string text;
  for (const char c : name.substr(0, 24)) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    text += plain ? c : '_';
  }
  if (text.find_first_not_of('_') == std::string::npos) return "tool";
  if (text.front() == '_' || (text.front() >= '0' && text.front() <= '9')) text = "t" + text;
  return text;
}

std::string comment(const std::vector<std::string>& remarks, std::string_view prefix) {
  std::string text;
  for (const std::string& remark : remarks) {
    // Controllers' editors know ASCII only.
    std::string line = printable(remark, 1000);
    constexpr std::string_view kPlusMinus = "\u00b1";
    for (auto at = line.find(kPlusMinus); at != std::string::npos; at = line.find(kPlusMinus))
      line.replace(at, kPlusMinus.size(), "+-");
    std::string ascii;
    for (const char c : line) {
      const auto byte = static_cast<unsigned char>(c);
      if (byte < 0x80) {
        ascii += c;
      } else if ((byte & 0xC0) == 0xC0) {
        ascii += '?';  // one for a character of several bytes
      }
    }
    if (!ascii.empty() && ascii.back() == '\\') ascii += '.';  // a C++ comment would go on in the next line
    text += fmt::format("{} {}\n", prefix, ascii);
  }
  return text;
}

std::string xmlComment(const std::vector<std::string>& remarks) {
  std::string text = "<!--\n";
  for (const std::string& remark : remarks) {
    std::string line = printable(remark, 1000);
    for (auto at = line.find("--"); at != std::string::npos; at = line.find("--", at)) line.replace(at, 2, "- -");
    text += "  " + line + "\n";
  }
  return text + "-->\n";
}

std::string xmlEscaped(std::string_view text) {
  std::string out;
  for (const char c : printable(text, 200)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string frameName(const std::string& frame) {
  std::string out;
  for (const char c : frame) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
    out += plain || c == '_' || c == '/' || c == '-' ? c : '_';
  }
  return out;
}

std::string jsonString(std::string_view text) { return nlohmann::json(printable(text, 1000)).dump(); }

std::vector<std::string> remarksOf(const ExportInput& input, const std::vector<std::string>& more) {
  std::vector<std::string> remarks;
  for (const std::string& caution : input.cautions) remarks.push_back("CAUTION: " + caution);
  if (!input.provenance.empty()) remarks.push_back(input.provenance);
  if (!input.uncertainty.empty()) remarks.push_back(input.uncertainty);
  remarks.insert(remarks.end(), more.begin(), more.end());
  return remarks;
}

PrincipalAxes principalAxes(const Matrix3d& inertia) {
  PrincipalAxes axes;
  const bool diagonal = inertia(0, 1) == 0.0 && inertia(0, 2) == 0.0 && inertia(1, 2) == 0.0;
  if (diagonal) {
    axes.moments = inertia.diagonal();
  } else {
    const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(inertia);
    const Matrix3d V = solver.eigenvectors();
    std::array<int, 3> order{0, 1, 2}, best = order;
    double nearest = -1.0;
    do {
      const double trace = std::abs(V(0, order[0])) + std::abs(V(1, order[1])) + std::abs(V(2, order[2]));
      if (trace > nearest) {
        nearest = trace;
        best = order;
      }
    } while (std::next_permutation(order.begin(), order.end()));
    for (int i = 0; i < 3; ++i) {
      axes.R_FA.col(i) = V.col(best[i]) * (V(i, best[i]) < 0.0 ? -1.0 : 1.0);
      axes.moments(i) = solver.eigenvalues()(best[i]);
    }
    if (axes.R_FA.determinant() < 0.0) {
      int weakest = 0;
      axes.R_FA.diagonal().cwiseAbs().minCoeff(&weakest);
      axes.R_FA.col(weakest) *= -1.0;
    }
  }
  const int decimals = decimalsFor(axes.moments.maxCoeff()) + 3;
  const double step = std::pow(10.0, -decimals);
  const Vector3d exact = axes.moments;
  // Rounding moves a sum of two by one step at most, so that a few steps more on each make the body possible again.
  for (int k = 0; k < 4; ++k) {
    axes.moments = exact.unaryExpr([&](double m) { return roundedTo(m + k * step, decimals); });
    const double largest = axes.moments.maxCoeff();
    if (axes.moments.minCoeff() > 0.0 && axes.moments.sum() - largest >= largest * (1.0 - 1e-15)) break;
  }
  return axes;
}

}  // namespace heft
