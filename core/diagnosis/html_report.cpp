// The diagnosis as a page on its own: inline SVG, no scripts, nothing fetched.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/markup.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/signals.h"
#include "core/diagnosis/words.h"

namespace heft {

namespace {

struct Curve {
  const char* colour;
  const char* name;
  VectorXd y;
  double width;
};

constexpr double kWidth = 860, kHeight = 190, kLeft = 62, kBottom = 30, kTop = 12, kRight = 12;

/// Round steps for an axis.
double stepFor(double span) {
  const double raw = span / 4.0, power = std::pow(10.0, std::floor(std::log10(std::max(1e-12, raw))));
  for (const double factor : {1.0, 2.0, 5.0})
    if (factor * power >= raw) return factor * power;
  return 10.0 * power;
}

std::string plot(const std::string& title, const std::string& unit, const VectorXd& x, const std::string& xTitle,
                 const std::vector<Curve>& curves, bool logarithmic) {
  double low = 1e300, high = -1e300;
  const auto value = [&](double y) { return logarithmic ? std::log10(std::max(1e-12, y)) : y; };
  for (const auto& curve : curves)
    for (Eigen::Index i = 0; i < curve.y.size(); ++i)
      if (std::isfinite(curve.y(i))) {
        low = std::min(low, value(curve.y(i)));
        high = std::max(high, value(curve.y(i)));
      }
  if (!(high > low)) high = low + 1.0;
  const double pad = 0.05 * (high - low), x0 = x(0), x1 = x(x.size() - 1);
  low -= pad;
  high += pad;
  const auto px = [&](double at) { return kLeft + (at - x0) / std::max(1e-12, x1 - x0) * (kWidth - kLeft - kRight); };
  const auto py = [&](double at) { return kHeight - kBottom - (at - low) / (high - low) * (kHeight - kBottom - kTop); };
  std::string out = fmt::format("<figure><figcaption>{} [{}]", escapedMarkup(title), escapedMarkup(unit));
  for (const auto& curve : curves)
    out += fmt::format(" <span style=\"color:{}\">&#9644; {}</span>", curve.colour, escapedMarkup(curve.name));
  out += fmt::format("</figcaption><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">", kWidth, kHeight,
                     escapedMarkup(title));
  const double yStep = logarithmic ? 1.0 : stepFor(high - low), xStep = stepFor(x1 - x0);
  for (double y = std::ceil(low / yStep) * yStep; y <= high; y += yStep)
    out += fmt::format(
        "<line x1=\"{0}\" x2=\"{1}\" y1=\"{2:.1f}\" y2=\"{2:.1f}\" class=\"g\"/><text x=\"{3}\" y=\"{4:.1f}\" "
        "text-anchor=\"end\">{5:.4g}</text>",
        kLeft, kWidth - kRight, py(y), kLeft - 6, py(y) + 4,
        logarithmic ? std::pow(10.0, y) : (std::abs(y) < 1e-9 ? 0.0 : y));
  for (double at = std::ceil(x0 / xStep) * xStep; at <= x1; at += xStep)
    out += fmt::format("<text x=\"{:.1f}\" y=\"{}\" text-anchor=\"middle\">{:.4g}</text>", px(at), kHeight - 12, at);
  out += fmt::format("<text x=\"{}\" y=\"{}\" text-anchor=\"end\">{}</text>", kWidth - kRight, kHeight - 1,
                     escapedMarkup(xTitle));
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
      for (const double y : n > 1 ? std::array{part.minCoeff(), part.maxCoeff()} : std::array{part(0), part(0)})
        path += fmt::format("{}{:.1f},{:.1f}",
                            path.empty()         ? "M"
                            : path.back() == 'M' ? ""
                                                 : " ",
                            px(x(i)), py(value(y)));
    }
    if (!path.empty() && path.back() == 'M') path.pop_back();
    out += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\"/>", path, curve.colour,
                       curve.width);
  }
  return out + "</svg></figure>\n";
}

VectorXd normOf(const diagnosis::Wrenches& w, bool torque, const std::vector<bool>& judged) {
  VectorXd out(w.cols());
  for (Eigen::Index n = 0; n < w.cols(); ++n)
    out(n) = judged[static_cast<std::size_t>(n)] ? (torque ? w.col(n).tail<3>() : w.col(n).head<3>()).norm()
                                                 : std::numeric_limits<double>::quiet_NaN();
  return out;
}

/// Amplitude of the difference by frequency, root of the mean over channels, smoothed over a twentieth of a decade.
void spectrumOf(const diagnosis::Wrenches& w, const std::vector<bool>& judged, double rate, VectorXd& frequency,
                VectorXd& amplitude) {
  std::vector<double> f, a;
  double count = 0.0;
  for (const bool j : judged) count += j ? 1.0 : 0.0;
  for (double at = 0.1; at < 0.5 * rate; at *= 1.035) {
    double sum = 0.0;
    for (Eigen::Index c = 0; c < 3; ++c) {
      double re = 0.0, im = 0.0;
      for (Eigen::Index n = 0; n < w.cols(); ++n) {
        if (!judged[static_cast<std::size_t>(n)]) continue;
        const double phase = 2.0 * 3.14159265358979323846 * at * static_cast<double>(n) / rate;
        re += w(c, n) * std::cos(phase);
        im += w(c, n) * std::sin(phase);
      }
      sum += re * re + im * im;
    }
    f.push_back(std::log10(at));
    a.push_back(2.0 * std::sqrt(sum / 3.0) / std::max(1.0, count));
  }
  frequency = Eigen::Map<VectorXd>(f.data(), static_cast<Eigen::Index>(f.size()));
  amplitude = Eigen::Map<VectorXd>(a.data(), static_cast<Eigen::Index>(a.size()));
}

const char* headingOf(Verdict verdict) {
  switch (verdict) {
    case Verdict::clean:
      return "&#10003; Model fits";
    case Verdict::explained:
      return "&#9679; Cause found";
    case Verdict::ambiguous:
      return "&#9670; Two causes possible";
    case Verdict::unexplained:
      return "? Something unknown";
  }
  return "";
}

std::string payloadRow(const char* name, const EstimateReport& report) {
  const auto& p = report.payload;
  const auto& s = report.std;
  std::string out = fmt::format("<tr><th>{}</th><td>{:.4f} ± {:.4f}</td>", name, p.mass, 1.96 * s.mass);
  for (int i = 0; i < 3; ++i) out += fmt::format("<td>{:.2f} ± {:.2f}</td>", p.com(i) * 1e3, 1960.0 * s.com(i));
  for (int i = 0; i < 3; ++i)
    out += fmt::format("<td>{:.3g} ± {:.1g}</td>", p.inertiaCom(i, i), 1.96 * s.inertiaCom(i, i));
  return out + "</tr>\n";
}

}  // namespace

std::string toHtml(const DiagnosisReport& report) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Reality check: {0}</title>\n<style>"
      "body{{font:15px/1.45 system-ui,sans-serif;max-width:920px;margin:2em auto;padding:0 "
      "1em;color:#1b2430;background:#fff}}"
      "h1{{font-size:1.5em}}section{{border:1px solid #d5dbe3;border-radius:10px;padding:.4em 1.2em 1em;margin:1.2em "
      "0}}"
      "table{{border-collapse:collapse}}td,th{{padding:.2em .8em .2em 0;text-align:left;font-weight:normal}}"
      "th{{color:#5a6675}}figure{{margin:1em "
      "0}}figcaption{{color:#5a6675}}svg{{width:100%;font-size:11px;fill:#5a6675}}"
      ".g{{stroke:#e3e8ee}}.verdict{{font-size:1.2em}}</style></head><body>\n<h1>Reality check: {0}</h1>\n"
      "<p class=\"verdict\"><strong>{1}</strong><br>{2}</p>\n",
      escapedMarkup(report.file), headingOf(report.verdict), escapedMarkup(report.sentence));
  out +=
      fmt::format("<p>Misfit of the plain model: {:.3f} N and {:.4f} N m. Noise floor: {:.3f} N and {:.4f} N m.</p>\n",
                  report.baseline.force, report.baseline.torque, report.noise.force, report.noise.torque);
  for (const auto& cause : report.causes) {
    out += fmt::format("<section><h2>{}</h2><p>{}</p>\n<table>", escapedMarkup(cause.title),
                       escapedMarkup(cause.sentence));
    for (const auto& p : cause.parameters)
      out += fmt::format("<tr><th>{}</th><td>{}</td></tr>", escapedMarkup(parameterName(p.name)),
                         escapedMarkup(parameterWords(p)));
    for (const auto& [from, to] : cause.when)
      out += fmt::format("<tr><th>when</th><td>{:.2f} to {:.2f} s</td></tr>", from, to);
    out += "</table>\n";
    if (cause.gain.blocks > 0)
      out += fmt::format(
          "<p>On stretches that it was not fitted to: {:.3f} &rarr; {:.3f} N, {:.4f} &rarr; {:.4f} N m; better in {} "
          "of {}.</p>\n",
          cause.gain.forceBefore, cause.gain.forceAfter, cause.gain.torqueBefore, cause.gain.torqueAfter,
          cause.gain.blocksBetter, cause.gain.blocks);
    if (!cause.alternatives.empty())
      out += fmt::format("<p><strong>Equally possible:</strong> {}. {}</p>\n",
                         escapedMarkup(fmt::format("{}", fmt::join(cause.alternatives, ", "))),
                         escapedMarkup(cause.tellApart));
    out += fmt::format("<p><strong>What to check:</strong> {}</p></section>\n", escapedMarkup(cause.check));
  }
  const auto& s = report.series;
  if (s.time.size() > 10) {
    const auto nan = std::numeric_limits<double>::quiet_NaN();
    constexpr std::array<const char*, 6> kNames{"Force x", "Force y", "Force z", "Torque x", "Torque y", "Torque z"};
    out += "<section><h2>Measured, simulated, difference</h2>\n";
    for (Eigen::Index c = 0; c < 6; ++c) {
      VectorXd before = s.before.row(c).transpose(), after = s.after.row(c).transpose();
      for (Eigen::Index n = 0; n < before.size(); ++n)
        if (!s.judged[static_cast<std::size_t>(n)]) before(n) = after(n) = nan;
      out += plot(kNames[static_cast<std::size_t>(c)], c < 3 ? "N" : "N m", s.time, "time [s]",
                  {{"#1f6fb2", "measured", s.measured.row(c).transpose(), 1.0},
                   {"#d1812a", "plain model", before, 1.2},
                   {"#2a8a4a", "extended model", after, 1.2}},
                  false);
    }
    const diagnosis::Wrenches was = s.measured - s.before, is = s.measured - s.after;
    out += plot("Size of the force difference, unseen", "N", s.time, "time [s]",
                {{"#d1812a", "plain model", normOf(was, false, s.judged), 1.0},
                 {"#2a8a4a", "extended model", normOf(is, false, s.judged), 1.0}},
                false);
    out += plot("Size of the torque difference, unseen", "N m", s.time, "time [s]",
                {{"#d1812a", "plain model", normOf(was, true, s.judged), 1.0},
                 {"#2a8a4a", "extended model", normOf(is, true, s.judged), 1.0}},
                false);
    VectorXd f, a, b;
    const double rate = 1.0 / (s.time(1) - s.time(0));
    spectrumOf(was, s.judged, rate, f, a);
    spectrumOf(is, s.judged, rate, f, b);
    out += plot("Force difference by frequency", "N", f, "log10 of the frequency in Hz",
                {{"#d1812a", "plain model", a, 1.2}, {"#2a8a4a", "extended model", b, 1.2}}, true);
    out += "</section>\n";
  }
  out +=
      "<section><h2>Payload</h2><table><tr><th></th><th>mass [kg]</th><th>x [mm]</th><th>y [mm]</th><th>z [mm]</th>"
      "<th>Ixx [kg m²]</th><th>Iyy</th><th>Izz</th></tr>\n";
  out += payloadRow("before", report.before) + payloadRow("after", report.after) + "</table></section>\n";
  if (!report.smallest.empty()) {
    out += "<section><h2>Could not have been seen with this motion</h2><table>";
    for (const auto& small : report.smallest)
      out += std::isfinite(small.value)
                 ? fmt::format("<tr><th>{}</th><td>below {:.2g} {} ({})</td></tr>", escapedMarkup(small.cause),
                               small.value, escapedMarkup(small.unit), escapedMarkup(small.parameter))
                 : fmt::format("<tr><th>{}</th><td>at any size</td></tr>", escapedMarkup(small.cause));
    out += "</table></section>\n";
  }
  return out + "</body></html>\n";
}

}  // namespace heft
