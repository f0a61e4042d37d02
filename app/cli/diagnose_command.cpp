// heft diagnose: what the simulation gets wrong, by name.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "app/cli/recording_options.h"
#include "app/cli/stage_times.h"
#include "core/base/heap.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/correction/check_on_other.h"
#include "core/diagnosis/diagnose.h"
#include "core/diagnosis/report/html_report.h"
#include "core/diagnosis/report/report.h"
#include "core/diagnosis/wording/words.h"
#include "core/recording/meta_file.h"

namespace heft::cli {
namespace {

struct DiagnoseArguments {
  std::string recording, robot, check, json, report, result, correctedMeta, segments;
  ImportOptions import;
  std::vector<std::string> hidden;
  int surrogates = DiagnoseOptions{}.surrogates;
  unsigned seed = DiagnoseOptions{}.seed;
  bool force = false, causes = false, timing = false;
};

void list() {
  // What has no title of its own only takes part in the search.
  for (const auto& cause : diagnosis::catalogue())
    if (causeTitle(cause->id()) != cause->id())
      print(fmt::format("  {:<18} {}\n", cause->id(), causeTitle(cause->id())));
  print("  Strong contact, saturation, spikes, dropouts and frame_error are seen directly.\n");
}

void run(const DiagnoseArguments& options) {
  if (options.causes) {
    list();
    return;
  }
  if (options.recording.empty()) throw WrongUsage("RECORDING is required.");
  DiagnoseOptions settings;
  settings.surrogates = options.surrogates;
  settings.seed = options.seed;
  requireRange("--surrogates", options.surrogates, 0, 5000, "");
  for (const auto& id : options.hidden) {
    std::vector<std::string> known;
    for (const auto* list : {&diagnosis::seenDirectly(), &diagnosis::catalogue()})
      for (const auto& cause : *list)
        if (cause->info().family != diagnosis::Family::convention) known.emplace_back(cause->id());
    settings.hidden.push_back(known[chooseWord("--without", id, known)]);
  }
  settings.segments = segmentChoice(options.segments);
  const Overwrite overwriteResult = ownResult(options.force, "heft.diagnose/1");
  if (!options.json.empty()) requireWritable(options.json, overwriteResult);
  const Overwrite overwriteEstimate = ownResult(options.force, "heft.estimate/1");
  if (!options.result.empty()) requireWritable(options.result, overwriteEstimate);
  for (const auto& file : {options.report, options.correctedMeta})
    if (!file.empty()) requireWritable(file, {options.force, {}});

  useTwoHeaps();
  ProgressLine line;
  StageTimes times;
  const Progress progress = options.timing ? times.watching(line.progress()) : line.progress();
  const Input input = readInput(options.recording, options.import, options.robot, progress);
  DiagnosisReport report = orFail(diagnose(input.recording, input.model(), settings, progress));
  report.findings.insert(report.findings.begin(), input.findings.begin(), input.findings.end());
  if (!options.check.empty()) {
    const Input other = readInput(options.check, {}, options.robot, progress);
    report.check = orFail(checkOn(report, other.recording, other.model()));
  }
  times.finish();
  line.clear();
  if (!options.json.empty()) {
    nlohmann::json result = toJson(report);
    if (options.timing) result["timing_s"]["stages"] = times.toJson();
    writeResult(options.json, result, overwriteResult);
  }
  if (!options.report.empty()) {
    const auto witnesses = diagnosis::witnesses(input.recording, input.model());
    writeOutput(options.report, toHtml(report, witnesses ? *witnesses : std::vector<diagnosis::Witness>{}),
                {options.force, {}});
  }
  if (!options.result.empty()) writeResult(options.result, toJson(report.after), overwriteEstimate);
  // All files before the text: whoever reads only its first lines still gets them.
  const nlohmann::json changes = report.metaChanges();
  if (!options.correctedMeta.empty() && !changes.empty()) {
    const auto old = options.import.metaFile.empty() ? metaFileOf(options.recording) : options.import.metaFile;
    writeOutput(options.correctedMeta, fileText(orFail(mergedMeta(old, changes))), {options.force, {}});
  }
  if (options.json != "-") {
    print(toText(report));
    if (options.timing) print("\n" + times.table());
    printFindings(report.findings, true);
  }
  if (options.correctedMeta.empty() || !changes.empty()) return;
  throw Failed(
      report.mistake && report.mistake->tied
          ? "Several readings of the numbers fit, each with another setup file; none was written. Decide for "
            "one, and write the keys that 'heft diagnose --json' has for it under frame_mistake into the setup "
            "file."
          : "The diagnosis proposes no change of the setup file; none was written.");
}

}  // namespace

Command makeDiagnoseCommand(CLI::App& root) {
  auto options = std::make_shared<DiagnoseArguments>();
  CLI::App* app = root.add_subcommand("diagnose", "Diagnose model errors: find the cause and quantify the improvement");
  app->add_option("RECORDING", options->recording, "CSV with time, motion and wrench columns, SI units")->type_name("");
  app->add_option("--json", options->json, "Write the result as JSON; - is stdout, instead of the text")
      ->type_name("FILE");
  app->add_option("--report", options->report, "Write a page with plots (HTML)")->type_name("FILE");
  app->add_option("--result", options->result,
                  "Write the payload estimated with the causes corrected, for 'heft export'")
      ->type_name("FILE");
  app->add_option("--check", options->check, "Another recording of the same setup, to check the causes on")
      ->type_name("FILE");
  app->add_option("--corrected-meta", options->correctedMeta,
                  "Write the corrected setup file, where a cause shows that it is wrong")
      ->type_name("FILE");
  addRecordingOptions(*app, options->import);
  addRateOption(*app, options->import);
  app->add_option("--robot", options->robot, "panda or a URDF, instead of the setup file's")->type_name("ROBOT");
  app->add_option("--segments", options->segments, "auto, marks or all, as for 'heft estimate'")->type_name("NAME");
  app->add_option("--without", options->hidden, "Exclude a cause (repeatable)")->type_name("CAUSE");
  app->add_option("--surrogates", options->surrogates,
                  "Simulated clean recordings that set the threshold; 0: fixed threshold")
      ->type_name("N")
      ->capture_default_str();
  app->add_option("--seed", options->seed, "Random seed for the simulations")->type_name("N")->capture_default_str();
  app->add_flag("--timing", options->timing, "Show time and memory of each stage, in the JSON, too");
  app->add_flag("--list-causes", options->causes, "Show the catalogue");
  app->add_flag("--force", options->force, "Overwrite existing files");
  app->footer(
      "Examples:\n"
      "  heft diagnose rec.csv\n"
      "  heft diagnose rec.csv --json found.json --report found.html\n"
      "  heft diagnose monday.csv --check tuesday.csv\n");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
