// heft simulate: a recording whose truth is known, from the project's own Panda and a model of its sensor.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <regex>

#include "app/cli/clearance_options.h"
#include "app/cli/cli.h"
#include "app/cli/default_tool.h"
#include "app/cli/twin_recording.h"
#include "core/base/json_file.h"
#include "core/base/text.h"
#include "core/recording/csv_reader.h"
#include "core/recording/meta_file.h"
#include "core/robot/robot_model.h"
#include "core/simulation/effects/effect.h"

namespace heft::cli {
namespace {

using nlohmann::json;

struct SimulateArguments {
  std::string motion, payload, output, truth, json, xyz, rpy, seed = "1";
  std::vector<std::string> effects;
  LikeArguments like;
  ClearanceArguments clearance;
  SimulateOptions simulate;
  bool force = false;
};

constexpr std::string_view kNote = "Simulated by Heft";

std::array<double, 3> list(const Vector3d& v) { return {v.x(), v.y(), v.z()}; }

json truthJson(const SimulationTruth& truth, const SimulateArguments& options) {
  json marks = json::array();
  for (const auto& mark : truth.marks)
    marks.push_back({{"from_s", mark.from}, {"to_s", mark.to}, {"label", toString(mark.label)}});
  json effects = json::array();
  for (const auto& effect : truth.effects) effects.push_back(toJson(effect));
  return {{"schema", "heft.truth/1"},
          {"motion", options.motion},
          {"seed", options.simulate.seed},
          {"payload", toJson(truth.payload)},
          {"bias", {{"force_n", list(truth.forceBias)}, {"torque_nm", list(truth.torqueBias)}}},
          {"marks", marks},
          {"effects", effects}};
}

/// The setup file as this command writes it, but for the note's motion, seed, rate and checksum; null if a person wrote
/// or changed it, or if it belongs to a real recording. Earlier versions wrote no checksum.
json asSimulated(const std::string& text) {
  static const std::regex note(std::string(kNote) + ": [a-z-]+, seed [0-9]+, [0-9.e+]+ Hz(, CSV [0-9a-f]{16})?");
  json meta = json::parse(text, nullptr, false);
  if (!meta.is_object() || !meta.contains("note") || !meta["note"].is_string() ||
      !std::regex_match(meta["note"].get_ref<const std::string&>(), note))
    return nullptr;
  meta.erase("note");
  return meta;
}

/// The end of the note: by it, a CSV that somebody changed or put there is told from the one that was simulated.
std::string csvNote(std::string_view csvText) { return ", CSV " + checksum(csvText); }

/// Throws Failed unless both files are missing or as this command made them: it can make those again, but neither a
/// recording of a real robot nor what a person wrote into the CSV or the setup file.
void requireExpendable(const std::filesystem::path& csv, const RecordingMeta& meta, bool force) {
  const auto metaFile = metaFileOf(csv);
  const json fresh = asSimulated(orFail(metaText(meta, metaFile)));
  const auto unchanged = [&](const std::string& text) { return asSimulated(text) == fresh; };
  requireWritable(metaFile, {force, unchanged});
  requireWritable(csv, {force, [&](const std::string& rows) {
                          const auto old = readTextFile(metaFile);
                          return old && unchanged(*old) &&
                                 json::parse(*old)["note"].get_ref<const std::string&>().ends_with(csvNote(rows));
                        }});
}

/// Every kind with the unit of its size, a clear size and its forms.
std::string effectList() {
  std::string text = "ID=SIZE, or ID/FORM=SIZE for another form than the first; place and time come from the seed.\n\n";
  for (const EffectKind& kind : effectKinds()) {
    text +=
        fmt::format("  {:<17} {}{}, for instance {:g}\n", kind.id, kind.either ? "+-" : "", kind.unit, kind.typical);
    text += fmt::format("  {:<17} {}\n", "", kind.meaning);
    if (kind.forms.size() > 1) text += fmt::format("  {:<17} forms: {}\n", "", fmt::join(kind.forms, ", "));
  }
  return text;
}

constexpr double kLookRate = 100.0;  ///< [Hz] At which a motion is judged; between its samples it is bounded

/// The motion without noise, at kLookRate or what there is.
JointMotion motionIn(const Simulated& simulated, double rateHz) {
  const auto stride = std::max<Eigen::Index>(1, std::lround(rateHz / kLookRate));
  const Eigen::Index rows = (simulated.q.rows() - 1) / stride + 1;
  const auto every = [&](const MatrixXd& all) {
    MatrixXd out(rows, all.cols());
    for (Eigen::Index k = 0; k < rows; ++k) out.row(k) = all.row(k * stride);
    return out;
  };
  // The recording's own clock may be one that was hidden in it.
  const double step = static_cast<double>(stride) / rateHz;
  return {VectorXd::LinSpaced(rows, 0.0, step * static_cast<double>(rows - 1)), every(simulated.q), every(simulated.dq),
          every(simulated.ddq)};
}

using Simulation = std::function<Simulated(const SimulateOptions&, const Progress&, std::string& said)>;

/// The seed of the first motion that stays clear of the room: `simulate`'s own, then that plus a multiple of
/// kNextMotion. Throws Failed where none does. `said`: a line where it is another than the first.
std::uint64_t motionClearOf(const ClearanceArguments& arguments, SimulateOptions simulate, const Simulation& make,
                            const Progress& progress, std::string& said) {
  constexpr int kMotions = 50;                                  // Looked at; each takes some 20 ms.
  constexpr std::uint64_t kNextMotion = 0x9e3779b97f4a7c15ull;  // Far from seeds that people type (golden ratio)
  const GuidedTool tool = orFail(guidedTool(RobotModel::panda(), simulate.mount));
  Findings findings;
  const Surroundings around(arguments, tool, findings);
  printFindings(findings, false);
  simulate.effects.clear();
  simulate.rateHz = std::min(simulate.rateHz, kLookRate);
  std::optional<Conflict> first;
  for (int k = 0; k < kMotions; ++k) {
    progress(static_cast<double>(k) / kMotions, "looking for a motion that stays clear of the room");
    simulate.motionSeed = simulate.seed + static_cast<std::uint64_t>(k) * kNextMotion;
    std::string causes;
    const Simulated look = make(simulate, {}, causes);
    const auto conflict = around.clearance()->firstConflict(motionIn(look, simulate.rateHz));
    if (!conflict) {
      if (k > 0)
        said += fmt::format("  motion {} of this seed: the first that stays clear of the room. In motion 1: {}\n",
                            k + 1, first->sentence());
      return *simulate.motionSeed;
    }
    if (!first) first = conflict;
  }
  throw Failed(
      fmt::format("None of {} motions of this seed stays clear of the room. In the first: {} Give the arm more "
                  "room, or choose another --motion.",
                  kMotions, first->sentence()));
}

/// Throws Failed where the joints cannot give what the motion takes.
void requireTorques(const Simulated& simulated, double rateHz) {
  const GuidedTool tool = orFail(guidedTool(RobotModel::panda(), simulated.recording.meta.mount));
  const JointMotion motion = motionIn(simulated, rateHz);
  MotionLimits limits;
  limits.gravity = simulated.recording.meta.gravity;
  limits.payload = simulated.truth.payload;
  if (const TorqueUse use = torqueUse(tool, motion, limits); use.share > 1.0)
    throw Failed(
        fmt::format("The arm cannot perform this motion with this load: {} A lighter --payload or a smaller "
                    "--speed takes less.",
                    use.sentence()));
}

const std::vector<std::string> kMotionWords{"excitation", "pick-and-place", "free"};

/// Takes what the words say into options.simulate; which of kMotionWords.
std::size_t check(SimulateArguments& options) {
  constexpr std::array kMotions{MotionKind::excitation, MotionKind::pickAndPlace, MotionKind::free};
  if (options.motion.empty() && options.like.file.empty()) throw WrongUsage("--motion is required.");
  if (options.like.file.empty() && (options.like.fixed || !options.like.without.empty()))
    throw WrongUsage("--without and --fixed go with --like.");
  if (options.clearance.room.empty() && !(options.clearance.shape + options.clearance.shapeFile).empty())
    throw WrongUsage("--shape and --shape-file say what the arm holds in a --room.");
  if (options.motion.empty()) options.motion = kMotionWords.back();
  const std::size_t motion = chooseWord("--motion", options.motion, kMotionWords);
  options.simulate.motion = kMotions[motion];
  options.simulate.seed = parseSeed(options.seed);
  for (const auto& text : options.effects) {
    auto effect = parseEffect(text);
    if (!effect) throw WrongUsage(fmt::format("--effect: {}", effect.error().message));
    options.simulate.effects.push_back(std::move(*effect));
  }
  requireRange("--duration", options.simulate.duration, 1.0, 14400.0, "s");
  requireRange("--rate", options.simulate.rateHz, 10.0, 8000.0, "Hz");
  requireRange("--speed", options.simulate.speed, 0.01, 2.0, "");
  requireRange("--force-noise", options.simulate.sensor.forceNoise, 0.0, 100.0, "N");
  requireRange("--torque-noise", options.simulate.sensor.torqueNoise, 0.0, 10.0, "N m");
  requireRange("--joint-noise", options.simulate.positionNoise, 0.0, 0.1, "rad");
  requireRange("--joint-step", options.simulate.positionStep, 0.0, 0.1, "rad");
  if (!options.xyz.empty()) options.simulate.mount.xyz = parseVector3("--xyz", options.xyz);
  if (!options.rpy.empty()) options.simulate.mount.rpy = parseVector3("--rpy", options.rpy);
  if (options.output == "-" || options.truth == "-")
    throw WrongUsage("A recording is two files and its truth a third; give names, not -.");
  if (std::filesystem::path(options.output).extension() != ".csv")
    throw WrongUsage(fmt::format("-o expects a name that ends in .csv, not '{}'.", options.output));
  return motion;
}

/// What was written, as JSON and for a person. `said`: of motion and causes.
void tell(const SimulateArguments& options, std::size_t motion, const Simulated& simulated, double mass,
          const std::string& said) {
  constexpr std::array kTitles{"superposed sines", "pick and place", "free hand guiding"};
  const std::filesystem::path csv = options.output;
  const auto meta = metaFileOf(csv);
  if (!options.json.empty()) {
    json summary{{"schema", "heft.simulate/1"},
                 {"motion", options.motion},
                 {"seed", options.simulate.seed},
                 {"recording",
                  {{"file", displayName(csv)},
                   {"meta", displayName(meta)},
                   {"samples", simulated.recording.rows()},
                   {"rate_hz", options.simulate.rateHz},
                   {"duration_s", simulated.recording.duration()}}}};
    if (!options.truth.empty()) summary["truth"] = options.truth;
    writeResult(options.json, summary, ownResult(options.force, "heft.simulate/1"));
  }
  if (options.json == "-") return;
  std::string text =
      fmt::format("{} and {}: {} samples, {:.1f} s of {} at {:g} Hz, seed {}\n", displayName(csv),
                  displayName(meta.filename()), simulated.recording.rows(), simulated.recording.duration(),
                  kTitles[motion], options.simulate.rateHz, options.simulate.seed);
  text += said;
  if (options.payload.empty() && options.like.file.empty())
    text += fmt::format("  payload: built-in {:.2f} kg tool\n", mass);
  if (!options.truth.empty()) text += fmt::format("  ground truth: {}\n", options.truth);
  print(text);
}

void run(SimulateArguments options) {
  const std::size_t motion = check(options);
  Payload payload = defaultTool();
  if (!options.payload.empty())
    payload = orFail(payloadFromJson(orFail(readJsonFile(options.payload)), options.payload));
  if (const auto consistency = checkPhysical(payload); !consistency.physical)
    throw Failed(fmt::format("{}: such a payload cannot exist: {}", options.payload, consistency.reason));

  std::string motionWords, causes;
  const std::optional<Payload> carried = options.payload.empty() ? std::nullopt : std::optional(payload);
  const auto make = [&](const SimulateOptions& simulate, const Progress& progress, std::string& said) {
    if (!options.like.file.empty()) return simulateLike(options.like, simulate, carried, progress, said);
    return orFail(heft::simulate(RobotModel::panda(), payload, simulate, progress));
  };
  Simulated simulated = [&] {
    ProgressLine line;
    if (!options.clearance.room.empty())
      options.simulate.motionSeed =
          motionClearOf(options.clearance, options.simulate, make, line.progress(), motionWords);
    return make(options.simulate, line.progress(), causes);
  }();
  requireTorques(simulated, options.simulate.rateHz);
  simulated.recording.meta.note = fmt::format("{}: {}, seed {}, {} Hz", kNote, kMotionWords[motion],
                                              options.simulate.seed, options.simulate.rateHz);
  const std::filesystem::path csv = options.output;
  const std::string rows = orFail(recordingText(simulated.recording));
  simulated.recording.meta.note += csvNote(rows);
  requireExpendable(csv, simulated.recording.meta, options.force);
  const Overwrite overwriteTruth = ownResult(options.force, "heft.truth/1");
  if (!options.truth.empty()) requireWritable(options.truth, overwriteTruth);
  if (!options.json.empty()) requireWritable(options.json, ownResult(options.force, "heft.simulate/1"));
  orFail(writeTextFile(csv, rows));
  orFail(writeMeta(simulated.recording.meta, metaFileOf(csv)));
  if (!options.truth.empty()) writeResult(options.truth, truthJson(simulated.truth, options), overwriteTruth);
  tell(options, motion, simulated, payload.mass, motionWords + causes);
}

}  // namespace

Command makeSimulateCommand(CLI::App& root) {
  auto options = std::make_shared<SimulateArguments>();
  auto& simulate = options->simulate;
  CLI::App* app = root.add_subcommand("simulate", "Simulate a recording of a Panda and its sensor");
  app->add_option("-m,--motion", options->motion,
                  "excitation: superposed sines inside all limits; pick-and-place: with contact phases;\n"
                  "free: hand guiding with tremor")
      ->type_name("NAME");
  const char* const kLikeGroup = "Like a diagnosed setup";
  app->add_option("--like", options->like.file,
                  "JSON from 'heft diagnose --json': its payload, bias and causes, on this motion (free if absent)")
      ->type_name("FOUND")
      ->group(kLikeGroup);
  app->add_option("--without", options->like.without, "Switch this cause off (repeatable)")
      ->type_name("CAUSE")
      ->expected(1)
      ->take_all()
      ->group(kLikeGroup);
  app->add_flag("--fixed", options->like.fixed, "Sizes as found; otherwise drawn from their intervals by the seed")
      ->group(kLikeGroup);
  app->add_option("-o,--output", options->output, "REC.csv to write; REC.meta.json is written beside it")
      ->type_name("FILE")
      ->required();
  app->add_option("-p,--payload", options->payload, "Payload JSON in sensor axes; otherwise a built-in tool of 0.8 kg")
      ->type_name("FILE");
  app->add_option("--seed", options->seed, "The same seed gives the same recording")
      ->type_name("N")
      ->capture_default_str();
  app->add_option("--duration", simulate.duration, "Length [s]")->type_name("S")->capture_default_str();
  app->add_option("--rate", simulate.rateHz, "Samples per second [Hz]")->type_name("HZ")->capture_default_str();
  app->add_option("--speed", simulate.speed, "How fast the arm moves: 1 brisk hand guiding, 0.3 slow")
      ->type_name("FACTOR")
      ->capture_default_str();
  app->add_option("--force-noise", simulate.sensor.forceNoise, "White noise of the forces, standard deviation [N]")
      ->type_name("N")
      ->capture_default_str();
  app->add_option("--torque-noise", simulate.sensor.torqueNoise, "White noise of the torques [N m]")
      ->type_name("NM")
      ->capture_default_str();
  app->add_option("--joint-noise", simulate.positionNoise, "Noise of the joint angles, standard deviation [rad]")
      ->type_name("RAD")
      ->capture_default_str();
  app->add_option("--joint-step", simulate.positionStep, "Step that an encoder rounds joint angles to [rad]; 0: exact")
      ->type_name("RAD")
      ->capture_default_str();
  app->add_option("--xyz", options->xyz, "Sensor origin on the flange, x,y,z [m]; otherwise 0,0,0.04")
      ->type_name("X,Y,Z");
  app->add_option("--rpy", options->rpy, "Sensor rotation on the flange, roll,pitch,yaw [rad]; otherwise 0,0,0")
      ->type_name("R,P,Y");
  addClearanceOptions(*app, options->clearance);
  app->add_option("--effect", options->effects,
                  "Inject a fault: ID=SIZE or ID/FORM=SIZE (cable_pull=3, time_offset=-8,\n"
                  "low_pass_lag/second-order=15); repeatable; see --list-effects")
      ->type_name("ID=SIZE")
      ->expected(1)
      ->take_all();
  app->add_flag_callback(
      "--list-effects",
      [] {
        print(effectList());
        throw CLI::Success();
      },
      "Show every effect, what its size means and its forms");
  app->add_option("--truth", options->truth, "Write the hidden payload, biases, marks and effects to this file")
      ->type_name("FILE");
  app->add_option("--json", options->json, "Also write the recording's description as JSON; - is stdout")
      ->type_name("FILE");
  app->add_flag("--force", options->force,
                "Overwrite a recording that was not simulated, or a setup file that was changed");
  app->footer(
      "Examples:\n"
      "  heft simulate --motion excitation --seed 1 -o rec.csv --truth truth.json\n"
      "  heft simulate --motion free --payload tool.json --speed 0.3 --duration 10 -o slow.csv\n"
      "  heft simulate --motion free --effect cable_pull/slack=6 --effect bias_drift=0.5 -o odd.csv --truth odd.json\n"
      "  heft simulate --like found.json --without cable_pull --seed 2 -o twin.csv");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
