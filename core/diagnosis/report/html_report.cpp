#include "core/diagnosis/report/html_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/base/markup.h"
#include "core/diagnosis/correction/check_on_other.h"
#include "core/diagnosis/report/html_plot.h"
#include "core/diagnosis/report/report.h"
#include "core/diagnosis/wording/words.h"

namespace heft {

namespace {

constexpr const char *kMeasured = "#1f6fb2", *kBefore = "#d1812a", *kAfter = "#2a8a4a";
constexpr std::array<const char*, 6> kChannels{"Force x", "Force y", "Force z", "Torque x", "Torque y", "Torque z"};

const char* unitOf(Eigen::Index channel) { return channel < 3 ? "N" : "N m"; }

/// What the plain and the extended model leave; NaN where it is not judged.
struct Left {
  diagnosis::Wrenches before, after;
};

Left leftOf(const DiagnosisSeries& s) {
  Left out{s.measured - s.before, s.measured - s.after};
  for (Eigen::Index n = 0; n < s.time.size(); ++n)
    if (!s.judged[static_cast<std::size_t>(n)])
      for (auto* of : {&out.before, &out.after}) of->col(n).setConstant(std::numeric_limits<double>::quiet_NaN());
  return out;
}

/// Each channel over time, the size of the difference, and its spectrum.
std::string differences(const DiagnosisSeries& s, const Left& left) {
  using html::plot;
  std::string out = "<section><h2>Measured, simulated, residual</h2>\n";
  for (Eigen::Index c = 0; c < 6; ++c) {
    const VectorXd measured = s.measured.row(c).transpose();
    out += plot({kChannels[static_cast<std::size_t>(c)], unitOf(c)}, {"time", "s"}, s.time,
                {{kMeasured, "measured", measured, 1.0},
                 {kBefore, "plain model", measured - left.before.row(c).transpose(), 1.2},
                 {kAfter, "extended model", measured - left.after.row(c).transpose(), 1.2}});
  }
  for (const bool torque : {false, true}) {
    const Eigen::Index first = torque ? 3 : 0;
    out += plot({torque ? "Torque residual, norm, on held-out segments" : "Force residual, norm, on held-out segments",
                 unitOf(first)},
                {"time", "s"}, s.time,
                {{kBefore, "plain model", left.before.middleRows<3>(first).colwise().norm().transpose(), 1.0},
                 {kAfter, "extended model", left.after.middleRows<3>(first).colwise().norm().transpose(), 1.0}});
  }
  for (const bool torque : {false, true}) {
    const auto spectrum = diagnosis::spectrumOf(s, torque);
    if (spectrum.frequency.size() == 0) continue;
    out += plot({torque ? "Torque residual spectrum" : "Force residual spectrum", torque ? "N m/√Hz" : "N/√Hz", true},
                {"frequency", "Hz", true}, spectrum.frequency,
                {{kBefore, "plain model", spectrum.before, 1.2}, {kAfter, "extended model", spectrum.after, 1.2}});
  }
  return out + "</section>\n";
}

/// In which tenth of the recording how much of the difference lies, every channel in units of what is left in the end.
std::string places(const DiagnosisSeries& s, const Left& left) {
  constexpr Eigen::Index kParts = 10;
  Vector6d usual = Vector6d::Constant(1e-24);
  for (Eigen::Index n = 0; n < s.time.size(); ++n)
    if (s.judged[static_cast<std::size_t>(n)]) usual += left.after.col(n).cwiseAbs2();
  Eigen::Matrix<double, 2, kParts> energy = Eigen::Matrix<double, 2, kParts>::Zero();
  const Eigen::Index blocks = s.time.size();
  for (Eigen::Index n = 0; n < blocks; ++n) {
    if (!s.judged[static_cast<std::size_t>(n)]) continue;
    energy(0, n * kParts / blocks) += left.before.col(n).cwiseAbs2().cwiseQuotient(usual).sum();
    energy(1, n * kParts / blocks) += left.after.col(n).cwiseAbs2().cwiseQuotient(usual).sum();
  }
  const double all = std::max(1e-300, energy.row(0).sum());
  std::string out =
      "<section><h2>Where the residual is</h2><p>Shares of the plain model's residual energy; every channel is in "
      "units "
      "of its noise.</p>\n<table><tr><th>from [s]</th>";
  for (Eigen::Index part = 0; part < kParts; ++part)
    out += fmt::format("<th>{:.1f}</th>", s.time((part * blocks + kParts - 1) / kParts));
  for (const auto& [row, name] : {std::pair{0, "plain model"}, {1, "extended model"}}) {
    out += fmt::format("</tr>\n<tr><th>{}</th>", name);
    for (Eigen::Index part = 0; part < kParts; ++part)
      out += fmt::format("<td style=\"background:rgba(209,129,42,{:.2f})\">{:.1f} %</td>",
                         std::min(1.0, energy(row, part) / energy.maxCoeff()), 100.0 * energy(row, part) / all);
  }
  return out + "</tr></table></section>\n";
}

/// To two digits, without a minus before 0.
double rounded(double value) { return std::round(100.0 * value) / 100.0 + 0.0; }

/// How far the difference goes with what the robot did: correlations, and the closest of them as points.
std::string companions(const DiagnosisSeries& s, const Left& left, std::span<const diagnosis::Witness> witnesses) {
  std::string out =
      "<section><h2>What the residual correlates with</h2><p>Correlation with each channel, plain model &rarr; "
      "extended "
      "model; 1 or -1: fully, 0: not at all.</p>\n<table><tr><th></th>";
  for (const char* channel : kChannels) out += fmt::format("<th>{}</th>", channel);
  out += "</tr>\n";
  const diagnosis::Witness* closest = nullptr;
  Eigen::Index where = 0;
  double most = 0.0;
  for (const auto& witness : witnesses) {
    out += fmt::format("<tr><th>{}</th>", escapedMarkup(diagnosis::witnessWords(witness.id)));
    for (Eigen::Index c = 0; c < 6; ++c) {
      const double was = diagnosis::correlation(s, witness.value, left.before.row(c).transpose()),
                   is = diagnosis::correlation(s, witness.value, left.after.row(c).transpose());
      out += fmt::format("<td style=\"background:rgba(209,129,42,{:.2f})\">{:.2f} &rarr; {:.2f}</td>",
                         0.8 * std::abs(was), rounded(was), rounded(is));
      if (std::abs(was) <= most) continue;
      most = std::abs(was);
      closest = &witness;
      where = c;
    }
    out += "</tr>\n";
  }
  out += "</table>\n";
  if (closest != nullptr && closest->value.size() == s.time.size())
    out += html::scatter({fmt::format("Residual, {}", kChannels[static_cast<std::size_t>(where)]), unitOf(where)},
                         {diagnosis::witnessWords(closest->id), closest->unit}, closest->value,
                         {{kBefore, "plain model", left.before.row(where).transpose(), 4.0},
                          {kAfter, "extended model", left.after.row(where).transpose(), 4.0}});
  return out + "</section>\n";
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

/// What is left unknown, what else was noticed, and what the causes do for another recording.
std::string remarks(const DiagnosisReport& report) {
  std::string out;
  if (const std::string unknown = unknownText(report); !unknown.empty())
    out += fmt::format("<p><strong>Unknown:</strong> {}</p>\n", escapedMarkup(unknown));
  for (const Finding& finding : report.findings)
    out += fmt::format("<p><strong>Noticed:</strong> {} {}</p>\n", escapedMarkup(finding.text),
                       escapedMarkup(finding.remedy));
  if (report.check)
    out += fmt::format(
        "<p><strong>Checked on another recording</strong>, {}: {:.3f} &rarr; {:.3f} N, {:.4f} &rarr; {:.4f} N m. "
        "{}</p>\n",
        escapedMarkup(report.check->file), report.check->before.force, report.check->after.force,
        report.check->before.torque, report.check->after.torque, escapedMarkup(checkText(*report.check)));
  return out;
}

std::vector<std::string> titlesOf(const std::vector<std::string>& causes) {
  std::vector<std::string> out;
  for (const std::string& cause : causes) out.push_back(causeTitle(cause));
  return out;
}

std::string payloadRow(const char* name, const EstimateReport& report) {
  const auto& p = report.payload;
  const auto& s = report.std;
  std::string out = fmt::format("<tr><th>{}</th><td>{:.4f} ± {:.4f}</td>", name, p.mass, 1.96 * s.mass);
  for (int i = 0; i < 3; ++i) out += fmt::format("<td>{:.2f} ± {:.2f}</td>", p.com(i) * 1e3, 1960.0 * s.com(i));
  for (int i = 0; i < 3; ++i)
    out += fmt::format("<td>{:.3g} ± {:.1g}</td>", 1e4 * p.inertiaCom(i, i), 1.96e4 * s.inertiaCom(i, i));
  return out + "</tr>\n";
}

}  // namespace

std::string toHtml(const DiagnosisReport& report, std::span<const diagnosis::Witness> witnesses) {
  std::string out = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>Reality check: {0}</title>\n<style>"
      "body{{font:15px/1.45 system-ui,sans-serif;max-width:920px;margin:2em auto;padding:0 "
      "1em;color:#1b2430;background:#fff}}"
      "h1{{font-size:1.5em}}section{{border:1px solid #d5dbe3;border-radius:10px;padding:.4em 1.2em 1em;margin:1.2em "
      "0}}"
      "table{{border-collapse:collapse}}td,th{{padding:.2em .8em .2em 0;text-align:left;font-weight:normal}}"
      "td{{white-space:nowrap}}th{{color:#5a6675}}figure{{margin:1em "
      "0}}figcaption{{color:#5a6675}}svg{{width:100%;font-size:11px;fill:#5a6675}}"
      ".g{{stroke:#e3e8ee}}.verdict{{font-size:1.2em}}</style></head><body>\n<h1>Reality check: {0}</h1>\n"
      "<p class=\"verdict\"><strong>{1}</strong><br>{2}</p>\n",
      escapedMarkup(report.file), headingOf(report.verdict), escapedMarkup(report.sentence));
  out +=
      fmt::format("<p>Misfit of the plain model: {:.3f} N and {:.4f} N m. Noise floor: {:.3f} N and {:.4f} N m.</p>\n",
                  report.baseline.force, report.baseline.torque, report.noise.force, report.noise.torque);
  out += remarks(report);
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
          "<p>On held-out segments: {:.3f} &rarr; {:.3f} N, {:.4f} &rarr; {:.4f} N m; better in {} "
          "of {}.</p>\n",
          cause.gain.forceBefore, cause.gain.forceAfter, cause.gain.torqueBefore, cause.gain.torqueAfter,
          cause.gain.blocksBetter, cause.gain.blocks);
    if (!cause.alternatives.empty())
      out += fmt::format("<p><strong>Equally possible:</strong> {}. {}</p>\n",
                         escapedMarkup(fmt::format("{}", fmt::join(titlesOf(cause.alternatives), ", "))),
                         escapedMarkup(cause.tellApart));
    out += fmt::format("<p><strong>What to check:</strong> {}</p></section>\n", escapedMarkup(cause.check));
  }
  if (report.series.time.size() > 10) {
    const Left left = leftOf(report.series);
    out += differences(report.series, left) + places(report.series, left);
    if (!witnesses.empty()) out += companions(report.series, left, witnesses);
  }
  out +=
      "<section><h2>Payload</h2><table><tr><th></th><th>mass [kg]</th><th>x [mm]</th><th>y [mm]</th><th>z [mm]</th>"
      "<th>Ixx [kg cm²]</th><th>Iyy [kg cm²]</th><th>Izz [kg cm²]</th></tr>\n";
  out += payloadRow("before", report.before) + payloadRow("after", report.after) + "</table>";
  if (const auto moved = payloadShift(report); moved.maxCoeff() > 0.0)
    out += fmt::format(
        "<p>Change in standard deviations of the earlier estimate: mass {:.1f}, centre of mass {:.1f}, {:.1f}, {:.1f}, "
        "inertia up to "
        "{:.1f}.</p>",
        moved(0), moved(1), moved(2), moved(3), moved.tail<6>().maxCoeff());
  out += "</section>\n";
  if (!report.smallest.empty()) {
    out += "<section><h2>Not detectable with this motion</h2><table>";
    for (const auto& small : report.smallest)
      out +=
          std::isfinite(small.value)
              ? fmt::format("<tr><th>{}</th><td>below {:.2g} {} ({})</td></tr>", escapedMarkup(causeTitle(small.cause)),
                            small.value, escapedMarkup(small.unit), escapedMarkup(parameterName(small.parameter)))
              : fmt::format("<tr><th>{}</th><td>at any size</td></tr>", escapedMarkup(causeTitle(small.cause)));
    out += "</table></section>\n";
  }
  return out + "</body></html>\n";
}

}  // namespace heft
