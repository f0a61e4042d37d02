// The reproduction as text, Markdown, CSV, JSON and charts.
#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/reproduction/reproduction.h"
#include "core/reproduction/scenario.h"

namespace heft {

using nlohmann::json;

namespace {

struct Table {
  std::string title, note;
  std::vector<std::string> header;
  std::vector<std::vector<std::string>> rows;
};

std::string number(double value) { return fmt::format("{:.3g}", value); }
std::string number(std::optional<double> value) { return value ? number(*value) : "-"; }

std::string duration(double seconds) {
  if (seconds >= 3600.0) return fmt::format("{:.3g} h", seconds / 3600.0);
  if (seconds >= 60.0) return fmt::format("{:.3g} min", seconds / 60.0);
  if (seconds >= 1.0) return fmt::format("{:.3g} s", seconds);
  if (seconds >= 1e-3) return fmt::format("{:.3g} ms", 1e3 * seconds);
  return fmt::format("{:.3g} us", 1e6 * seconds);
}

std::string duration(const std::optional<PaperTime>& time) {
  return time ? (time->below ? "< " : "") + duration(time->seconds) : "-";
}

std::string words(ParameterSet set) {
  return set == ParameterSet::mass ? "mass" : set == ParameterSet::massCom ? "mass, com" : "all ten";
}

Table errorTable(const ErrorTable& errors) {
  Table table;
  table.title = fmt::format(
      "Relative errors, {} ({} recordings)",
      errors.handGuided ? "gripper guided by hand, 10 s" : "predefined motion, 20 s, 0.2 to 0.5 kg", errors.recordings);
  const bool paper = !errors.handGuided;
  table.header = {"error of", "estimated", "data"};
  if (paper) table.header.insert(table.header.end(), {"paper: Ceres", "paper: Eigen LM"});
  table.header.insert(table.header.end(), {"as the paper: ceres", "as the paper: eigen-lm", "Heft's default"});
  for (const auto& row : errors.rows) {
    std::vector<std::string> cells{std::string(toString(row.quantity)), words(row.estimated),
                                   std::string(toString(row.data))};
    if (paper) cells.insert(cells.end(), {number(row.paperCeres), number(row.paperEigenLm)});
    cells.insert(cells.end(), {number(row.ceres), number(row.eigenLm), number(row.heft)});
    table.rows.push_back(std::move(cells));
  }
  table.note = paper ? "Means of |p - truth| / |truth|; 1 is 100 %. Inertia about the sensor's origin."
                     : "The paper shows these errors in a figure only, without numbers.";
  return table;
}

Table runtimeTable(const Reproduction& all) {
  Table table;
  table.title = fmt::format("Runtimes on one recording of the predefined motion ({} rows)", all.rows);
  table.header = {"method",     "paper: mass", "mass, com", "all ten",
                  "ours: mass", "mass, com",   "all ten",   "whole, all ten"};
  if (all.options.uncompressed) table.header.emplace_back("all ten, every row");
  for (const auto& row : all.runtimes) {
    std::vector<std::string> cells{std::string(toString(row.method))};
    for (const auto& time : row.paper) cells.push_back(duration(time));
    for (const double time : row.solve) cells.push_back(duration(time));
    cells.push_back(duration(row.total[2]));
    if (all.options.uncompressed) cells.push_back(row.uncompressed[2] ? duration(*row.uncompressed[2]) : "-");
    table.rows.push_back(std::move(cells));
  }
  table.note =
      "Ours: from the prepared motion to the numbers (map finds the rows reduced already, so compare it by the whole); "
      "whole: with motion, smoothing, checks and held-out fits. The paper's total least squares saw every tenth "
      "sample.";
  return table;
}

Table causeTable(const Reproduction& all) {
  Table table;
  table.title = "Why: the measured errors cause by cause, predefined motion, all ten parameters estimated";
  table.header = {"sensor with", "as the paper: mass", "com", "inertia", "Heft's default: mass", "com", "inertia"};
  for (const auto& row : all.causes)
    table.rows.push_back({row.cause, number(row.paper.mass), number(row.paper.com), number(row.paper.inertia),
                          number(row.heft.mass), number(row.heft.com), number(row.heft.inertia)});
  table.note = fmt::format(
      "Every line has the sensor's noise. Bias: forces of some newtons that nobody tared; delay: the wrench {:g} ms "
      "late; tilt: the sensor turned by {:g} degrees on the flange.",
      1e3 * kWrenchDelay, std::round(kMountTilt * 180.0 / 3.14159265358979 * 1e6) / 1e6);
  return table;
}

std::vector<Table> tablesOf(const Reproduction& all) {
  std::vector<Table> tables;
  for (const auto& errors : all.errors) tables.push_back(errorTable(errors));
  tables.push_back(runtimeTable(all));
  tables.push_back(causeTable(all));
  return tables;
}

/// Two header lines where a title has a group before a colon, so that columns stay narrow.
std::pair<std::string, std::string> splitHeader(const std::string& title) {
  const auto colon = title.find(": ");
  if (colon == std::string::npos) return {"", title};
  return {title.substr(0, colon), title.substr(colon + 2)};
}

std::string wrapped(const std::string& text, std::size_t width, const std::string& indent) {
  std::string out = indent;
  std::size_t column = indent.size();
  for (std::size_t from = 0; from < text.size();) {
    const std::size_t space = std::min(text.find(' ', from), text.size());
    const std::string word = text.substr(from, space - from);
    if (column > indent.size() && column + 1 + word.size() > width) {
      out += "\n" + indent;
      column = indent.size();
    } else if (column > indent.size()) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    from = space + 1;
  }
  return out + "\n";
}

std::string textOf(const Table& table) {
  std::string text = table.title + "\n";
  std::vector<std::size_t> widths;
  for (std::size_t c = 0; c < table.header.size(); ++c) {
    const auto [group, name] = splitHeader(table.header[c]);
    std::size_t width = std::max(group.size(), name.size());
    for (const auto& row : table.rows) width = std::max(width, row[c].size());
    widths.push_back(width);
  }
  const auto line = [&](const auto& cell) {
    std::string out;
    for (std::size_t c = 0; c < widths.size(); ++c)
      out += c == 0 ? fmt::format("  {:<{}}", cell(c), widths[c]) : fmt::format("  {:>{}}", cell(c), widths[c]);
    return out.substr(0, out.find_last_not_of(' ') + 1) + "\n";
  };
  text += line([&](std::size_t c) { return splitHeader(table.header[c]).first; });
  text += line([&](std::size_t c) { return splitHeader(table.header[c]).second; });
  for (const auto& row : table.rows) text += line([&](std::size_t c) { return row[c]; });
  return text + wrapped(table.note, 110, "  ");
}

std::string markdownOf(const Table& table) {
  const auto line = [](const std::vector<std::string>& cells) {
    return fmt::format("| {} |\n", fmt::join(cells, " | "));
  };
  std::string text = "## " + table.title + "\n\n" + line(table.header) + "|---";
  for (std::size_t c = 1; c < table.header.size(); ++c) text += "|---:";
  text += "|\n";
  for (const auto& row : table.rows) text += line(row);
  return text + "\n" + table.note + "\n";
}

std::string headline(const Reproduction& all) {
  return fmt::format("heft reproduce: Hartwig, Lienhardt, Henrich (2025) beside Heft, simulated recordings, seed {}",
                     all.options.seed);
}

json optional(const std::optional<double>& value) { return value ? json(*value) : json(nullptr); }
json jsonOf(const Errors& e) { return {{"mass", e.mass}, {"com", e.com}, {"inertia", e.inertia}}; }

/// Charts have no place for zero and none for what is missing.
double bar(std::optional<double> value) { return value && *value > 0.0 ? *value : std::nan(""); }

}  // namespace

std::string toText(const Reproduction& all) {
  std::string text = headline(all) + "\n\n";
  for (const auto& table : tablesOf(all)) text += textOf(table) + "\n";
  text += "What follows from it\n";
  for (const auto& sentence : explain(all)) text += wrapped(sentence, 110, "  ");
  return text;
}

std::string toMarkdown(const Reproduction& all) {
  std::string text = "# " + headline(all) + "\n\n";
  for (const auto& table : tablesOf(all)) text += markdownOf(table) + "\n";
  text += "## What follows from it\n\n";
  for (const auto& sentence : explain(all)) text += "- " + sentence + "\n";
  return text;
}

std::string toCsv(const Reproduction& all) {
  std::string text = "table,estimated,quantity,data,cause,source,method,value,unit\n";
  const auto add = [&](std::string_view table, std::string_view estimated, std::string_view quantity,
                       std::string_view data, std::string_view cause, std::string_view source, std::string_view method,
                       std::optional<double> value, std::string_view unit) {
    if (value)
      text += fmt::format("{},{},{},{},{},{},{},{},{}\n", table, estimated, quantity, data, cause, source, method,
                          *value, unit);
  };
  for (const auto& table : all.errors)
    for (const auto& row : table.rows) {
      const auto one = [&](std::string_view source, std::string_view method, std::optional<double> value) {
        add(table.handGuided ? "errors-guided" : "errors-predefined", toString(row.estimated), toString(row.quantity),
            toString(row.data), "", source, method, value, "1");
      };
      one("paper", "ceres", row.paperCeres);
      one("paper", "eigen-lm", row.paperEigenLm);
      one("as-paper", "ceres", row.ceres);
      one("as-paper", "eigen-lm", row.eigenLm);
      one("heft", "map", row.heft);
    }
  for (const auto& row : all.runtimes)
    for (std::size_t p = 0; p < kParameterSets.size(); ++p) {
      const auto one = [&](std::string_view quantity, std::string_view source, std::optional<double> value) {
        add("runtimes", toString(kParameterSets[p]), quantity, "measured", "", source, toString(row.method), value,
            "s");
      };
      if (row.paper[p]) one(row.paper[p]->below ? "solve-at-most" : "solve", "paper", row.paper[p]->seconds);
      one("solve", "heft", row.solve[p]);
      one("total", "heft", row.total[p]);
      one("solve-every-row", "heft", row.uncompressed[p]);
    }
  for (const auto& row : all.causes)
    for (const Quantity quantity : {Quantity::mass, Quantity::com, Quantity::inertia}) {
      add("why", "full", toString(quantity), "measured", row.cause, "as-paper", "ls", row.paper.of(quantity), "1");
      add("why", "full", toString(quantity), "measured", row.cause, "heft", "map", row.heft.of(quantity), "1");
    }
  return text;
}

json toJson(const Reproduction& all) {
  json errors = json::array(), runtimes = json::array(), causes = json::array();
  for (const auto& table : all.errors)
    for (const auto& row : table.rows)
      errors.push_back({{"motion", table.handGuided ? "guided" : "predefined"},
                        {"recordings", table.recordings},
                        {"estimated", toString(row.estimated)},
                        {"quantity", toString(row.quantity)},
                        {"data", toString(row.data)},
                        {"paper", {{"ceres", optional(row.paperCeres)}, {"eigen-lm", optional(row.paperEigenLm)}}},
                        {"as_paper", {{"ceres", row.ceres}, {"eigen-lm", row.eigenLm}}},
                        {"heft", row.heft}});
  for (const auto& row : all.runtimes)
    for (std::size_t p = 0; p < kParameterSets.size(); ++p)
      runtimes.push_back({{"method", toString(row.method)},
                          {"estimated", toString(kParameterSets[p])},
                          {"paper_s", row.paper[p] ? json(row.paper[p]->seconds) : json(nullptr)},
                          {"paper_says_less", row.paper[p] && row.paper[p]->below},
                          {"solve_s", row.solve[p]},
                          {"total_s", row.total[p]},
                          {"solve_every_row_s", optional(row.uncompressed[p])}});
  for (const auto& row : all.causes)
    causes.push_back({{"cause", row.cause}, {"as_paper", jsonOf(row.paper)}, {"heft", jsonOf(row.heft)}});
  return {{"schema", "heft.reproduce/1"},
          {"seed", all.options.seed},
          {"repeats", all.options.repeats},
          {"rows", all.rows},
          {"errors", errors},
          {"runtimes", runtimes},
          {"why", causes},
          {"inertial_torque_rms_nm", all.inertialTorque},
          {"torque_bias_nm", all.torqueBias},
          {"force_bias_n", all.forceBias},
          {"explanation", explain(all)}};
}

std::vector<std::string_view> chartFiles() {
  return {"errors-predefined.svg", "errors-guided.svg", "runtimes.svg", "why.svg"};
}

std::vector<NamedChart> chartsOf(const Reproduction& all) {
  std::vector<NamedChart> charts;
  const auto files = chartFiles();
  for (std::size_t t = 0; t < all.errors.size(); ++t) {
    const auto& table = all.errors[t];
    BarChart chart{table.handGuided ? "Relative errors, gripper guided by hand" : "Relative errors, predefined motion",
                   "error of (parameters estimated), kind of data",
                   "relative error, 1 = 100 %",
                   {},
                   {}};
    BarSeries paperCeres{"paper, Ceres", {}}, paperLm{"paper, Eigen LM", {}}, ceres{"as the paper, ceres", {}},
        lm{"as the paper, eigen-lm", {}}, ours{"Heft's default", {}};
    for (const auto& row : table.rows) {
      chart.groups.push_back(
          fmt::format("{} ({}), {}", toString(row.quantity), words(row.estimated), toString(row.data)));
      paperCeres.values.push_back(bar(row.paperCeres));
      paperLm.values.push_back(bar(row.paperEigenLm));
      ceres.values.push_back(bar(row.ceres));
      lm.values.push_back(bar(row.eigenLm));
      ours.values.push_back(bar(row.heft));
    }
    if (!table.handGuided) chart.series = {paperCeres, paperLm};
    chart.series.insert(chart.series.end(), {ceres, lm, ours});
    charts.push_back({files[t], std::move(chart)});
  }
  BarChart runtimes{"Runtimes, predefined motion", "method (parameters estimated)", "time to solve, s", {}, {}};
  BarSeries paper{"paper", {}}, ours{"ours", {}}, every{"ours, every row", {}};
  for (const auto& row : all.runtimes)
    for (std::size_t p = 0; p < kParameterSets.size(); ++p) {
      runtimes.groups.push_back(fmt::format("{} ({})", toString(row.method), words(kParameterSets[p])));
      paper.values.push_back(row.paper[p] ? row.paper[p]->seconds : std::nan(""));
      ours.values.push_back(bar(row.solve[p]));
      every.values.push_back(bar(row.uncompressed[p]));
    }
  runtimes.series = {paper, ours};
  if (all.options.uncompressed) runtimes.series.push_back(every);
  charts.push_back({files[2], std::move(runtimes)});

  BarChart why{"Measured errors cause by cause, all ten parameters estimated",
               "error of, sensor with",
               "relative error, 1 = 100 %",
               {},
               {}};
  BarSeries asPaper{"as the paper", {}}, heft{"Heft's default", {}};
  for (const Quantity quantity : {Quantity::mass, Quantity::com, Quantity::inertia})
    for (const auto& row : all.causes) {
      why.groups.push_back(fmt::format("{}, {}", toString(quantity), row.cause));
      asPaper.values.push_back(bar(row.paper.of(quantity)));
      heft.values.push_back(bar(row.heft.of(quantity)));
    }
  why.series = {asPaper, heft};
  charts.push_back({files[3], std::move(why)});
  return charts;
}

}  // namespace heft
