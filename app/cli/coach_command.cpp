// heft coach: what a recording lacks, and the motion (or the standing pose) that would help most. heft excite: the
// demonstration with small sines on top, for its replay by the robot.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "app/cli/clearance_options.h"
#include "app/cli/cli.h"
#include "app/cli/reading.h"
#include "app/cli/recording_options.h"
#include "core/base/json_file.h"
#include "core/base/text.h"
#include "core/coach/coach.h"
#include "core/coach/deciding_pose.h"
#include "core/coach/excitation.h"
#include "core/coach/pose_guide.h"
#include "core/motion/motion.h"

namespace heft::cli {
namespace {

using nlohmann::json;

constexpr double kNormal95 = 1.959963984540054;
// Half widths beyond which a number is no knowledge of a tool that a hand holds.
constexpr double kFarMass = 5.0, kFarCom = 0.25, kFarInertia = 2.0;  // [kg], [m], relative

struct CoachArguments {
  std::string recording, robot, want, output, json;
  double rateHz = 1000.0;
  CoachOptions coach;
  ExcitationOptions excitation;
  ImportOptions import;
  ClearanceArguments clearance;
  bool force = false;
};

json list(const VectorXd& values) { return std::vector<double>(values.data(), values.data() + values.size()); }

/// Half widths of the 95 % intervals.
json widths(const Uncertainty& u) {
  return {{"mass_kg", kNormal95 * u.mass}, {"com_m", kNormal95 * u.com}, {"inertia_relative", kNormal95 * u.inertia}};
}

std::string knownText(const Uncertainty& u) {
  const double mass = kNormal95 * u.mass, com = kNormal95 * u.com, inertia = kNormal95 * u.inertia;
  return fmt::format("mass {}, centre of mass {}, inertia {}",
                     mass < kFarMass ? fmt::format("± {:.1f} g", 1e3 * mass) : "not known",
                     com < kFarCom ? fmt::format("± {:.1f} mm", 1e3 * com) : "not known",
                     inertia < kFarInertia ? fmt::format("± {:.0f} %", 1e2 * inertia) : "not known");
}

std::string speedText(const LimitUse& use, double cap) {
  return fmt::format("at most {:.0f} mm/s at the tool (cap {:.0f} mm/s, for people within reach: ISO/TS 15066)",
                     1e3 * use.largestTcpSpeed, 1e3 * cap);
}

void requirePaths(const CoachArguments& options, std::string_view schema) {
  if (options.output == "-" && options.json == "-")
    throw WrongUsage("The trajectory and --json cannot both go to stdout; give -o FILE.");
  if (!options.output.empty()) requireWritable(options.output, {options.force, {}});
  if (!options.json.empty()) requireWritable(options.json, ownResult(options.force, schema));
}

void writeResults(const CoachArguments& options, std::string_view schema, const json& result, const std::string& text,
                  const JointMotion* motion) {
  if (!options.output.empty() && motion)
    writeOutput(options.output, trajectoryCsv(*motion, options.rateHz), {options.force, {}});
  if (!options.json.empty()) writeResult(options.json, result, ownResult(options.force, schema));
  if (options.json != "-" && options.output != "-") print(text);
}

GuidedTool toolOf(const Input& input) {
  if (!input.model() || !input.recording.hasJoints())
    throw Failed(
        fmt::format("{} has no joint angles of a known arm, so no motion can be suggested.", input.recording.file));
  return orFail(guidedTool(*input.model(), input.recording.meta.mount));
}

/// Where more than one reading of the numbers fits: what would decide, as text and as JSON (null where nothing is
/// open). `tool` and `from`: where a pose of the arm may do so.
std::pair<std::string, json> whatDecides(const Input& input, const std::optional<GuidedTool>& tool,
                                         const VectorXd& from, const std::optional<Surroundings>& around) {
  const Recording& recording = input.recording;
  const bool poses = recording.meta.kind == RecordingKind::poses;
  const auto motion = poses ? standingPoses(recording, input.model()) : motionOf(recording, input.model(), {});
  if (!motion) return {};
  const conventions::Report report = conventions::check(conventions::questionOf(recording, *motion));
  const auto tied = tiedReadings(report);
  if (!tied) return {};
  std::string text =
      fmt::format("Two interpretations of the numbers fit:\n  {}\n  {}\n", tied->firstSaid, tied->secondSaid);
  json out{{"readings", {tied->firstSaid, tied->secondSaid}}, {"q_rad", nullptr}, {"text", report.decides}};
  const auto pose = poses && tool ? decidingPose(recording, *tool, *tied, from, around->clearance()) : std::nullopt;
  if (pose) {
    std::string joints;
    for (const double q : pose->q) joints += fmt::format("{}{:.3f}", joints.empty() ? "" : ", ", q);
    const std::string says =
        fmt::format("In this pose they expect readings that are {:.0f} standard deviations apart.", pose->apart);
    text += fmt::format("  Decide by one more pose, joints [{}] rad. {}\n{}", joints, says, around->words());
    out["q_rad"] = list(pose->q);
    out["apart_sd"] = pose->apart;
    out["text"] = says;
  } else {
    text +=
        fmt::format("  {}{}\n", poses && tool ? "No pose within the last joints' reach decides. " : "", report.decides);
  }
  return {text, out};
}

void coachPoses(const CoachArguments& options, const Input& input) {
  const Recording& recording = input.recording;
  std::optional<GuidedTool> tool;
  std::optional<Surroundings> around;
  Findings findings = input.findings;
  if (input.model() && recording.hasJoints()) {
    tool = toolOf(input);
    around.emplace(options.clearance, *tool, findings);
  }
  PoseGuide guide(tool, recording.meta.gravity);
  for (const auto& pose : orFail(posesOf(recording, input.model()))) guide.add(pose);
  const PoseResult& result = guide.result();
  std::string text;
  json poses = json::array();
  int number = 0;
  for (const auto& pose : guide.poses()) {
    text += fmt::format("  pose {:>2}  {:<9}  {}\n", ++number, toString(pose.light), pose.words);
    poses.push_back({{"light", toString(pose.light)}, {"text", pose.words}, {"misfit_n", pose.misfit}});
  }
  json out{{"schema", "heft.coach/1"},
           {"kind", "poses"},
           {"poses", poses},
           {"used", guide.usedCount()},
           {"wanted", guide.options().wanted},
           {"spread", {{"light", toString(result.spread)}, {"text", result.spreadWords}}},
           {"known", result.known},
           {"next", nullptr},
           {"clearance", around ? around->toJson() : json()},
           {"findings", toJson(findings)}};
  text += fmt::format("{} of {} poses are used. {}\n", guide.usedCount(), guide.options().wanted, result.spreadWords);
  if (result.known) {
    text += fmt::format("mass {:.3f} ± {:.3f} kg, centre of mass ({:.1f}, {:.1f}, {:.1f}) ± {:.1f} mm\n", result.mass,
                        kNormal95 * result.massStd, 1e3 * result.com.x(), 1e3 * result.com.y(), 1e3 * result.com.z(),
                        1e3 * kNormal95 * result.comStd.maxCoeff());
    out["payload"] = {{"mass_kg", result.mass}, {"com_m", list(result.com)}};
    out["std"] = {{"mass_kg", result.massStd}, {"com_m", list(result.comStd)}};
  } else {
    text += "Mass and centre of mass are not known yet.\n";
  }
  if (tool && recording.rows() > 0) {
    if (const auto next =
            guide.next(recording.q.row(recording.rows() - 1).transpose(), around ? around->clearance() : nullptr)) {
      std::string joints;
      for (const double q : next->q) joints += fmt::format("{}{:.3f}", joints.empty() ? "" : ", ", q);
      const double mass = kNormal95 * next->massStd, com = kNormal95 * next->comStd;
      text += fmt::format(
          "Next pose: {}\n  joints [{}] rad\n  {}, {} after it\n", next->words, joints,
          mass < kFarMass ? fmt::format("mass ± {:.1f} g", 1e3 * mass) : "mass not known",
          com < kFarCom ? fmt::format("centre of mass ± {:.1f} mm", 1e3 * com) : "centre of mass not known yet");
      text += around->words();
      out["next"] = {{"q_rad", list(next->q)}, {"text", next->words}, {"after", {{"mass_kg", mass}, {"com_m", com}}}};
    }
  }
  const VectorXd last = tool ? VectorXd(recording.q.row(recording.rows() - 1).transpose()) : VectorXd();
  const auto [deciding, decidingJson] = whatDecides(input, tool, last, around);
  out["deciding"] = decidingJson;
  writeResults(options, "heft.coach/1", out, text + deciding, nullptr);
}

void runCoach(CoachArguments options) {
  if (!options.want.empty()) {
    constexpr CoachGoal kQuantities[] = {CoachGoal::mass, CoachGoal::com, CoachGoal::inertia};
    options.coach.want = kQuantities[chooseWord("--want", options.want, {"mass", "com", "inertia"})];
  }
  requireRange("--tcp-speed", options.coach.limits.tcpSpeed, 0.001, 2.0, "m/s");
  requireRange("--seconds", options.coach.duration, 1.0, 60.0, "s");
  requireRange("--rate", options.rateHz, 1.0, 8000.0, "Hz");
  requirePaths(options, "heft.coach/1");
  const Input input = readInput(options.recording, options.import, options.robot, {});
  printFindings(input.findings, false);
  if (input.recording.meta.kind == RecordingKind::poses) return coachPoses(options, input);

  const GuidedTool tool = toolOf(input);
  const OnlineInformation information = orFail(informationOf(input.recording, input.model(), {}));
  const VectorXd q = input.model()->clampToLimits(input.recording.q.row(input.recording.rows() - 1).transpose());
  Findings findings = input.findings;
  std::optional<Surroundings> around;
  around.emplace(options.clearance, tool, findings);
  options.coach.limits.clearance = around->clearance();
  const Advice advice = orFail(advise(information, tool, input.recording.meta.gravity, q, options.coach));
  json out{{"schema", "heft.coach/1"},
           {"kind", "motion"},
           {"needed", advice.needed},
           {"sentence", advice.sentence},
           {"about", toString(advice.about)},
           {"interval95_before", widths(advice.before)},
           {"interval95_after", widths(advice.after)},
           {"clearance", around->toJson()},
           {"findings", toJson(findings)}};
  std::string text = fmt::format("Current uncertainty: {}.\n{}\n", knownText(advice.before), advice.sentence);
  if (advice.needed) {
    text += fmt::format("  {}\n  {:.1f} s, {}\n", advice.gain, advice.motion.duration(),
                        speedText(advice.use, options.coach.limits.tcpSpeed));
    text += around->words();
    json samples = json::array();
    for (Eigen::Index k = 0; k < advice.motion.size(); k += 5)
      samples.push_back(list(advice.motion.q.row(k).transpose()));
    out["advice"] = {{"id", advice.id},
                     {"gain", advice.gain},
                     {"duration_s", advice.motion.duration()},
                     {"tcp_speed_m_s", advice.use.largestTcpSpeed},
                     {"target_q_rad", list(advice.target)},
                     {"path_q_rad", samples}};
  }
  const auto [deciding, decidingJson] = whatDecides(input, tool, q, around);
  out["deciding"] = decidingJson;
  writeResults(options, "heft.coach/1", out, text + deciding, advice.needed ? &advice.motion : nullptr);
}

void runExcite(CoachArguments options) {
  requireRange("--tcp-speed", options.excitation.limits.tcpSpeed, 0.001, 2.0, "m/s");
  requireRange("--amplitude", options.excitation.amplitude, 0.001, 0.5, "rad");
  requireRange("--deviation", options.excitation.deviation, 0.0005, 0.5, "m");
  requireRange("--rate", options.rateHz, 1.0, 8000.0, "Hz");
  requirePaths(options, "heft.excite/1");
  const Input input = readInput(options.recording, options.import, options.robot, {});
  printFindings(input.findings, false);
  if (input.recording.meta.kind == RecordingKind::poses)
    throw Failed(fmt::format("{} holds standing poses: there is no motion to replay.", options.recording));
  const GuidedTool tool = toolOf(input);
  std::vector<Segment> segments;
  const OnlineInformation information = orFail(informationOf(input.recording, input.model(), {}, &segments));
  Findings findings = input.findings;
  const Surroundings around(options.clearance, tool, findings);
  options.excitation.limits.clearance = around.clearance();
  const ExcitedMotion e = orFail(excite(input.recording, tool, segments, information, options.excitation));
  json free = json::array();
  for (const auto& part : e.free) free.push_back({part.from, part.to});
  const json out{{"schema", "heft.excite/1"},
                 {"file", options.output},
                 {"rate_hz", options.rateHz},
                 {"duration_s", e.excited.duration()},
                 {"slowed", e.slowed},
                 {"amplitude_rad", e.amplitude},
                 {"deviation_m", e.deviation},
                 {"tcp_speed_m_s", e.use.largestTcpSpeed},
                 {"limit_use",
                  {{"position", e.use.position},
                   {"velocity", e.use.velocity},
                   {"acceleration", e.use.acceleration},
                   {"tcp_speed", e.use.tcpSpeed},
                   {"cartesian", e.use.cartesian}}},
                 {"excited_s", free},
                 {"interval95_now", widths(e.now)},
                 {"interval95_replayed", widths(e.replayed)},
                 {"interval95_excited", widths(e.after)},
                 {"clearance", around.toJson()},
                 {"findings", toJson(findings)}};
  std::string text = fmt::format("{}: {:.1f} s at {:g} Hz", options.output, e.excited.duration(), options.rateHz);
  if (e.slowed > 1.001) text += fmt::format(", slowed down {:.2f} times to respect the limits", e.slowed);
  text +=
      fmt::format("\n  sine motions in {} free segment{}: up to {:.3f} rad per joint, {:.1f} mm from the taught path\n",
                  e.free.size(), e.free.size() == 1 ? "" : "s", e.amplitude, 1e3 * e.deviation);
  text += fmt::format("  {}\n", speedText(e.use, options.excitation.limits.tcpSpeed));
  text += fmt::format("  now:                    {}\n  after a plain replay:   {}\n  after this replay:      {}\n",
                      knownText(e.now), knownText(e.replayed), knownText(e.after));
  text += around.words();
  writeResults(options, "heft.excite/1", out, text, &e.excited);
}

CLI::App* addCommon(CLI::App& root, const char* name, const char* what, CoachArguments& options, MotionLimits& limits) {
  CLI::App* app = root.add_subcommand(name, what);
  app->add_option("RECORDING", options.recording, "CSV with time, joints and wrench, SI units")
      ->type_name("")
      ->required();
  app->add_option("--json", options.json, "Write the result as JSON; - is stdout, instead of the text")
      ->type_name("FILE");
  addRecordingOptions(*app, options.import);
  app->add_option("--robot", options.robot, "panda or a URDF, instead of what the setup file names")->type_name("NAME");
  app->add_option("--tcp-speed", limits.tcpSpeed, "Speed limit for any point of the tool [m/s]")
      ->type_name("M/S")
      ->capture_default_str();
  app->add_option("--rate", options.rateHz, "Rows per second of the trajectory [Hz]")
      ->type_name("HZ")
      ->capture_default_str();
  addClearanceOptions(*app, options.clearance);
  app->add_flag("--force", options.force, "Overwrite existing files");
  return app;
}

}  // namespace

Command makeCoachCommand(CLI::App& root) {
  auto options = std::make_shared<CoachArguments>();
  CLI::App* app = addCommon(root, "coach", "Suggest the motion or standing pose that would help most", *options,
                            options->coach.limits);
  app->add_option("--want", options->want, "mass, com or inertia; otherwise the least certain")->type_name("NAME");
  app->add_option("--seconds", options->coach.duration, "Longest motion to suggest [s]")
      ->type_name("S")
      ->capture_default_str();
  app->add_option("-o,--output", options->output,
                  "Write the suggested motion as CSV: time, joint angles and speeds, from the recording's last posture")
      ->type_name("FILE");
  app->footer(
      "Examples:\n"
      "  heft coach rec.csv\n"
      "  heft coach rec.csv --want inertia -o motion.csv");
  return {app, [options] { runCoach(*options); }};
}

Command makeExciteCommand(CLI::App& root) {
  auto options = std::make_shared<CoachArguments>();
  auto& excitation = options->excitation;
  CLI::App* app = addCommon(root, "excite", "Add small sine motions to a taught motion, for the robot to replay",
                            *options, excitation.limits);
  app->add_option("-o,--output", options->output, "CSV to write: time, joint angles and speeds")
      ->type_name("FILE")
      ->required();
  app->add_option("--amplitude", excitation.amplitude, "Largest deviation of a joint [rad]")
      ->type_name("RAD")
      ->capture_default_str();
  app->add_option("--deviation", excitation.deviation, "Largest deviation of the tool from its taught path [m]")
      ->type_name("M")
      ->capture_default_str();
  app->footer(
      "Examples:\n"
      "  heft excite rec.csv -o replay.csv\n"
      "  heft excite rec.csv -o replay.csv --deviation 0.005 --tcp-speed 0.15");
  return {app, [options] { runExcite(*options); }};
}

}  // namespace heft::cli
