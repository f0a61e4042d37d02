// heft estimate: from a recording to a payload with intervals.
#include "core/estimation/estimate.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/cli.h"
#include "app/cli/each_recording.h"
#include "app/cli/object_estimate.h"
#include "app/cli/reading.h"
#include "app/cli/recording_options.h"
#include "core/base/json_file.h"
#include "core/estimation/comparison.h"
#include "core/estimation/joint.h"
#include "core/estimation/judgement.h"
#include "core/exporters/flange.h"

namespace heft::cli {
namespace {

using Clock = std::chrono::steady_clock;

struct EstimateArguments {
  std::vector<std::string> recordings;
  std::string robot, known, mass, cad, certainty, shape, shapeFile, json, output, format = "json";
  std::string method, parameters, segments, smoothing, conventions = "as-stated";
  std::string jsonLines, minus;
  bool pickedUp = false;
  int jobs = 0;
  bool noBias = false, force = false, compare = false, each = false;
  ImportOptions import;
  EstimateOptions estimate;
};

// Every word that the core knows, so that help and did-you-mean cannot fall behind it.
template <class Enum, std::size_t N>
std::vector<std::string> words(const std::array<Enum, N>& values) {
  std::vector<std::string> list;
  for (const Enum value : values) list.emplace_back(toString(value));
  return list;
}

constexpr std::array kParameterSets{ParameterSet::mass, ParameterSet::massCom, ParameterSet::full};

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

EstimateOptions estimateOptions(const EstimateArguments& options) {
  EstimateOptions out = options.estimate;
  out.method = kAllMethods[chooseWord("--method", options.method, words(kAllMethods))];
  out.parameters = kParameterSets[chooseWord("--parameters", options.parameters, words(kParameterSets))];
  out.segments = segmentChoice(options.segments);
  out.conventions = conventionChoice(options.conventions);
  const std::size_t smoothing = chooseWord("--smoothing", options.smoothing, {"low-pass", "savitzky-golay"});
  out.motion.smoothing = smoothing == 0 ? SmoothingKind::lowPass : SmoothingKind::savitzkyGolay;
  out.bias = !options.noBias;
  requireRange("--trim", out.trim, 0.0, 0.45, "");
  if (out.motion.cutoffHz != 0.0) requireRange("--cutoff", out.motion.cutoffHz, 0.0, 1000.0, "Hz");
  requireRange("--sg-order", out.motion.order, 2, 9, "");
  requireRange("--sg-window", out.motion.window, 5, 1001, "samples");
  if (out.motion.order >= out.motion.window)
    throw WrongUsage(fmt::format("--sg-order {} needs a --sg-window of more than {} samples, not {}.", out.motion.order,
                                 out.motion.order, out.motion.window));
  out.shape = shapeChoice(options.shape, options.shapeFile);
  std::optional<Certainty> certainty;
  if (!options.certainty.empty()) {
    constexpr std::array kCertainties{Certainty::rough, Certainty::good, Certainty::exact};
    certainty = kCertainties[chooseWord("--certainty", options.certainty, words(kCertainties))];
    if (!out.shape && options.cad.empty())
      throw WrongUsage("--certainty says how sure --shape, --shape-file or --cad is, and none of them is there.");
    if (out.shape) out.shape->certainty = *certainty;
  }
  if (!options.mass.empty()) {
    auto scale = parseScaleMass(options.mass);
    if (!scale) throw WrongUsage("--mass: " + scale.error().message);
    out.stated.push_back(std::move(scale).value());
  }
  if (!options.cad.empty()) {
    nlohmann::json cad = orFail(readJsonFile(options.cad));
    if (certainty && cad.is_object()) cad["certainty"] = toString(*certainty);
    out.stated.push_back(orFail(statedPayloadFromJson(cad, options.cad)));
  }
  if (out.insideShape &&
      (!out.shape || out.method != Method::map || out.parameters != ParameterSet::full || options.compare))
    throw WrongUsage(
        "--inside-shape needs --shape or --shape-file, the method map and the parameters full, one at a time.");
  if (!options.known.empty()) {
    out.known = orFail(partialPayloadFromJson(orFail(readJsonFile(options.known)), options.known));
    if (out.known.empty())
      throw Failed(fmt::format(
          "{} states neither mass_kg, com_m nor inertia_com_kgm2; a payload file needs one at least.", options.known));
  }
  return out;
}

struct Estimated {
  EstimateReport report;
  std::vector<ComparedMethod> comparison;  ///< Empty unless asked for; the report is then one of them.
  std::optional<JointReport> joint;        ///< Of several recordings; the report is then that of the first used one.
};

Estimated estimateFiles(const EstimateArguments& options, const EstimateOptions& settings, const Progress& progress,
                        Clock::time_point start) {
  std::vector<Input> inputs;
  for (const auto& file : options.recordings)
    inputs.push_back(readInput(file, options.import, options.robot, progress));
  const double readSeconds = secondsSince(start);
  const Input& first = inputs.front();
  Estimated out;
  Findings read = first.findings;
  if (inputs.size() > 1) {
    std::vector<JointInput> joined;
    for (const Input& input : inputs) joined.push_back({&input.recording, input.model()});
    out.joint = orFail(estimateJointly(joined, settings, progress));
    read.clear();
    for (const Input& input : inputs) read.insert(read.end(), input.findings.begin(), input.findings.end());
    EstimateReport& report = out.joint->pieces[out.joint->first].report;
    addReadingFindings(read, report);
    report.timing.read = readSeconds;
    report.timing.total = secondsSince(start);
    out.report = report;
    return out;
  }
  if (options.compare) {
    out.comparison = orFail(compareMethods(first.recording, first.model(), settings, progress));
    const auto chosen = std::ranges::find(out.comparison, settings.method, &ComparedMethod::method);
    if (!chosen->report) throw Failed(chosen->failure);
    out.report = *chosen->report;
    out.report.timing.total += readSeconds;
  } else {
    out.report = orFail(estimate(first.recording, first.model(), settings, progress));
    out.report.timing.total = secondsSince(start);
  }
  addReadingFindings(read, out.report);
  out.report.timing.read = readSeconds;
  return out;
}

void runEach(const EstimateArguments& options, const EstimateOptions& settings) {
  if (options.jsonLines.empty()) throw WrongUsage("--each writes one line a recording: give --json-lines FILE.");
  if (options.compare || !options.json.empty() || !options.output.empty())
    throw WrongUsage("--each goes with --json-lines, not with --json, -o or --compare.");
  requireRange("--jobs", options.jobs, 0, 1024, "");
  forEachRecording({options.recordings, options.jobs, options.jsonLines, options.force}, [&](const std::string& file) {
    EstimateArguments one = options;
    one.recordings = {file};
    return toJson(estimateFiles(one, settings, {}, Clock::now()).report);
  });
}

void run(const EstimateArguments& options) {
  const auto start = Clock::now();
  const EstimateOptions settings = estimateOptions(options);
  if (!options.minus.empty() || options.pickedUp) {
    if (!options.minus.empty() && options.pickedUp)
      throw WrongUsage("--minus takes a second recording, --picked-up finds both parts in one: give one of them.");
    if (options.recordings.size() > 1 || options.each || options.compare || !options.output.empty())
      throw WrongUsage("--minus and --picked-up take one recording with the object; no --each, --compare or -o.");
    return estimateObject({options.recordings.front(), options.minus, options.robot, options.json, options.force},
                          options.import, settings);
  }
  if (options.each) return runEach(options, settings);
  if (!options.jsonLines.empty() || options.jobs != 0) throw WrongUsage("--json-lines and --jobs go with --each.");
  if (options.recordings.size() > 1 && options.compare) throw WrongUsage("--compare shows one recording; give one.");
  if (options.recordings.size() > 1 && (!options.import.metaFile.empty() || !options.import.join.empty()))
    throw WrongUsage(
        "--meta and --join go with one recording; several have their own .meta.json beside them. Each file to join has "
        "its own --join.");
  const ExportFormat* format = nullptr;
  if (!options.output.empty()) {
    if (options.output == "-") throw WrongUsage("-o expects a file name; 'heft export' writes to stdout.");
    std::vector<std::string> ids;
    for (const auto& known : exportFormats()) ids.emplace_back(known.id);
    format = &exportFormats()[chooseWord("--format", options.format, ids)];
    requireWritable(options.output, {options.force, {}});
  }
  const Overwrite overwriteResult = ownResult(options.force, "heft.estimate/1");
  if (!options.json.empty()) requireWritable(options.json, overwriteResult);

  ProgressLine line;
  const auto [report, comparison, joint] = estimateFiles(options, settings, line.progress(), start);
  line.clear();
  nlohmann::json result = joint ? toJson(*joint) : toJson(report);
  if (options.compare) result["comparison"] = toJson(comparison);
  if (!options.json.empty()) writeResult(options.json, result, overwriteResult);
  if (options.json != "-") print(joint ? toText(*joint) : options.compare ? toText(comparison) : toText(report));
  if (options.compare) printFindings(report.findings, false);  // the table has no room for them
  if (format) {
    FlangeOptions flange;
    flange.program = programVersion();
    flange.force = options.force;
    FlangePayload payload = orFail(toFlange(result, report.file, flange));
    const std::string text = orFail(exportPayload(*format, payload.input, payload.findings));
    writeOutput(options.output, text, {options.force, {}});
    printFindings(payload.findings, false);
    if (options.json != "-") print(fmt::format("{}: {}\n", options.output, format->title));
  }
}

void addManyOptions(CLI::App& app, EstimateArguments& options) {
  const char* const kManyGroup = "Many recordings, each by itself";
  app.add_flag("--each", options.each,
               "Estimate each recording separately; recordings that already have a line are skipped")
      ->group(kManyGroup);
  app.add_option("--json-lines", options.jsonLines,
                 "One line of JSON per recording: its result, or \"file\" and \"error\"; - is stdout")
      ->type_name("FILE")
      ->group(kManyGroup);
  app.add_option("--jobs", options.jobs, "How many at a time; one per core if omitted")
      ->type_name("N")
      ->group(kManyGroup);
}

void addMethodOptions(CLI::App& app, EstimateArguments& options) {
  const char* const kMethodGroup = "Method";
  app.add_option("--method", options.method, fmt::format("{}", fmt::join(words(kAllMethods), ", ")))
      ->type_name("NAME")
      ->capture_default_str()
      ->group(kMethodGroup);
  app.add_option("--parameters", options.parameters, "What to estimate: mass, mass-com or full")
      ->type_name("NAME")
      ->capture_default_str()
      ->group(kMethodGroup);
  app.add_flag("--compare", options.compare, "Show all methods side by side; --json and -o contain the chosen one")
      ->group(kMethodGroup);
  app.add_option("--known", options.known,
                 "Reference payload (JSON): fixes what is not estimated; errors are reported against it")
      ->type_name("FILE")
      ->group(kMethodGroup);
  app.add_flag("--no-bias", options.noBias, "Do not estimate the six sensor biases")->group(kMethodGroup);
  app.add_flag("--uncompressed", options.estimate.uncompressed, "Solve on all rows instead of the QR-reduced system")
      ->group(kMethodGroup);
}

void addDataOptions(CLI::App& app, EstimateArguments& options) {
  const char* const kDataGroup = "Data selection";
  app.add_option("--trim", options.estimate.trim, "Fraction of the duration excluded at each end")
      ->type_name("FRACTION")
      ->capture_default_str()
      ->group(kDataGroup);
  app.add_option("--segments", options.segments,
                 "auto: detect contact; marks: only what is marked free; all: everything.\n"
                 "Default: marks if the recording has any, otherwise auto")
      ->type_name("NAME")
      ->group(kDataGroup);
}

void addToolOptions(CLI::App& app, EstimateArguments& options) {
  const char* const kShapeGroup = "Shape of the tool, where the motion does not determine its inertia";
  app.add_option("--shape", options.shape,
                 "KIND:DIMS[@POSE] in metres: box:x,y,z cylinder:radius,height tube:outer,inner,height\n"
                 "sphere:radius cone:radius,height capsule:radius,length plate:x,y,thickness;\n"
                 "POSE is x,y,z[,roll,pitch,yaw] in sensor axes")
      ->type_name("SHAPE")
      ->group(kShapeGroup);
  app.add_option("--shape-file", options.shapeFile, "Shape as JSON: several bodies, meshes")
      ->type_name("FILE")
      ->group(kShapeGroup);
  app.add_flag("--inside-shape", options.estimate.insideShape, "Keep all mass inside the shape (map)")
      ->group(kShapeGroup);
  const char* const kBeliefGroup = "Other knowledge of the tool, weighed against the motion (method map)";
  app.add_option("--mass", options.mass, "Mass from a scale [kg]: 0.812, 0.812+-0.004 or 0.812+-1%; default +-0.5%")
      ->type_name("KG")
      ->group(kBeliefGroup);
  app.add_option("--cad", options.cad,
                 "Payload JSON from CAD; may contain \"certainty\" and \"weights\": {\"mass\", \"centre\", \"shape\"}")
      ->type_name("FILE")
      ->group(kBeliefGroup);
  app.add_option("--certainty", options.certainty, "Confidence in the shape or CAD file: rough, good or exact")
      ->type_name("NAME")
      ->group(kBeliefGroup);
}

void addSmoothingOptions(CLI::App& app, EstimateArguments& options) {
  const char* const kSmoothGroup = "Smoothing of motion and wrench";
  app.add_option("--smoothing", options.smoothing, "low-pass or savitzky-golay")
      ->type_name("NAME")
      ->capture_default_str()
      ->group(kSmoothGroup);
  app.add_option("--cutoff", options.estimate.motion.cutoffHz, "Cutoff of the low-pass [Hz]; automatic if omitted")
      ->type_name("HZ")
      ->capture_default_str()
      ->group(kSmoothGroup);
  app.add_option("--sg-order", options.estimate.motion.order, "Polynomial order of Savitzky-Golay")
      ->type_name("N")
      ->capture_default_str()
      ->group(kSmoothGroup);
  app.add_option("--sg-window", options.estimate.motion.window, "Window of Savitzky-Golay [samples]")
      ->type_name("N")
      ->capture_default_str()
      ->group(kSmoothGroup);
}

}  // namespace

Command makeEstimateCommand(CLI::App& root) {
  auto options = std::make_shared<EstimateArguments>();
  options->method = toString(options->estimate.method);
  options->parameters = toString(options->estimate.parameters);
  options->smoothing = "low-pass";
  CLI::App* app = root.add_subcommand("estimate", "Estimate mass, centre of mass and inertia from a recording");
  app->add_option("RECORDING", options->recordings,
                  "CSV with time, motion and wrench columns, SI units; or ROS bag, MCAP, HDF5, ...\n"
                  "Several recordings of one tool are combined")
      ->type_name("")
      ->required();
  app->add_option("--json", options->json, "Write the result as JSON; - is stdout, instead of the text")
      ->type_name("FILE");
  app->add_option("--robot", options->robot, "panda or a URDF, instead of the setup file's")->type_name("ROBOT");
  app->add_option("-o,--output", options->output,
                  "Also write the payload file, in flange axes, ready for the controller")
      ->type_name("FILE");
  app->add_option("-f,--format", options->format, "Output format, see 'heft export --help'")
      ->type_name("NAME")
      ->capture_default_str();
  app->add_flag("--force", options->force, "Overwrite existing files, and write a payload that is not reliable");
  addManyOptions(*app, *options);
  app->add_option("--minus", options->minus,
                  "The same tool without what it carries: the object's own mass, centre and inertia")
      ->type_name("WITHOUT");
  app->add_flag("--picked-up", options->pickedUp,
                "Something is picked up or put down in the recording: the object's own mass, centre and inertia");
  addRecordingOptions(*app, options->import);
  addRateOption(*app, options->import);
  addConventionChoice(*app, options->conventions);
  addMethodOptions(*app, *options);
  addDataOptions(*app, *options);
  addToolOptions(*app, *options);
  addSmoothingOptions(*app, *options);
  app->footer(
      "Examples:\n"
      "  heft estimate rec.csv\n"
      "  heft estimate rec.csv --json result.json -o tool.json --format franka-desk\n"
      "  heft estimate rec.csv --parameters mass-com --known cad.json\n"
      "  heft estimate rec.csv --compare\n"
      "  heft estimate first.csv second.csv third.csv\n"
      "  heft estimate with.csv --minus without.csv\n"
      "  heft estimate grasp.csv --picked-up\n"
      "  heft estimate --each *.bag --jobs 4 --json-lines results.jsonl\n"
      "  heft estimate rec.csv --shape cylinder:0.03,0.15@0,0,0.08 --mass 0.812\n\n"
      "A poor fit, or a number that the motion does not determine, is reported as such (exit code 0).");
  return {app, [app, options] {
            options->estimate.keepTrim = app->count("--trim") > 0;
            run(*options);
          }};
}

}  // namespace heft::cli
