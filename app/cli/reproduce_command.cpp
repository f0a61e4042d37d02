// heft reproduce: the seed paper's tables beside ours.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "core/reproduction/reproduction.h"

namespace heft::cli {
namespace {

struct ReproduceArguments {
  std::string seed = "1", format = "text", output = "-", plots, json;
  bool force = false;
  ReproductionOptions reproduce;
};

void run(ReproduceArguments options) {
  const std::size_t format = chooseWord("--format", options.format, {"text", "csv", "markdown"});
  options.reproduce.seed = parseSeed(options.seed);
  requireRange("--recordings", options.reproduce.repeats, 1, 1000, "");
  const bool jsonOnly = options.json == "-";
  if (jsonOnly && options.output == "-") options.output.clear();
  const Overwrite overwriteJson = ownResult(options.force, "heft.reproduce/1");
  // Whether somebody wrote into a text or a chart cannot be seen.
  const Overwrite overwrite{options.force, {}};
  const std::filesystem::path folder = options.plots;
  if (!options.output.empty()) requireWritable(options.output, overwrite);
  if (!options.json.empty()) requireWritable(options.json, overwriteJson);
  if (!options.plots.empty()) {
    // Before the work, not after it.
    std::error_code ec;
    std::filesystem::create_directories(folder, ec);
    if (ec || !std::filesystem::is_directory(folder))
      throw Failed(fmt::format("The folder {} for the plots cannot be created{}; name another one.", options.plots,
                               ec ? ": " + ec.message() : std::string(": a file has that name")));
    for (const auto file : chartFiles()) requireWritable(folder / file, overwrite);
  }

  ProgressLine line;
  const Reproduction all = orFail(reproducePaper(options.reproduce, line.progress()));
  line.clear();
  if (!options.json.empty()) writeResult(options.json, toJson(all), overwriteJson);
  if (!options.output.empty())
    writeOutput(options.output, format == 0 ? toText(all) : format == 1 ? toCsv(all) : toMarkdown(all), overwrite);
  if (!options.plots.empty())
    for (const auto& [file, chart] : chartsOf(all)) writeOutput(folder / file, toSvg(chart), overwrite);
}

}  // namespace

Command makeReproduceCommand(CLI::App& root) {
  auto options = std::make_shared<ReproduceArguments>();
  CLI::App* app = root.add_subcommand("reproduce", "Reproduce the paper's tables and explain the differences");
  app->add_option("--seed", options->seed, "The same seed gives the same errors; runtimes always vary")
      ->type_name("N")
      ->capture_default_str();
  app->add_option("--recordings", options->reproduce.repeats,
                  "How often the paper's five recordings are simulated, with different seeds")
      ->type_name("K")
      ->capture_default_str();
  app->add_flag("--uncompressed", options->reproduce.uncompressed,
                "Also time every method on all rows instead of the QR-reduced system");
  app->add_option("-f,--format", options->format, "text, csv or markdown")->type_name("NAME")->capture_default_str();
  app->add_option("-o,--output", options->output, "Output file; - is stdout")->type_name("FILE")->capture_default_str();
  app->add_option("--plots", options->plots, "Also write bar charts as SVG into this folder")->type_name("FOLDER");
  app->add_option("--json", options->json, "Also write all numbers as JSON; - is stdout, instead of the text")
      ->type_name("FILE");
  app->add_flag("--force", options->force, "Replace files that this command did not write");
  app->footer(
      "Hartwig, Lienhardt and Henrich (2025) estimated payloads with a bare Newton-Euler equation. This command makes\n"
      "recordings like theirs with a sensor that has bias, delay and tilt, estimates as they did and as Heft does by\n"
      "default, and shows which of the causes makes which error.\n\n"
      "Examples:\n"
      "  heft reproduce --recordings 1\n"
      "  heft reproduce --seed 2 --recordings 5 --format markdown -o tables.md --plots charts");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
