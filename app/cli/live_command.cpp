// heft live: samples as they arrive, the estimate while the hand moves, and a recording that grows on disk.
#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "app/cli/cli.h"
#include "app/cli/recording_options.h"
#include "app/cli/running_estimate.h"
#include "core/base/text.h"
#include "core/estimation/estimate.h"
#include "core/estimation/judgement.h"
#include "core/import/import.h"
#include "core/live/sample_spool.h"
#include "core/live/session.h"
#include "core/motion/motion.h"
#include "core/motion/sensor_axes.h"
#include "core/recording/missing.h"
#include "core/recording/robot_name.h"
#include "core/recording/unwrap.h"
#include "core/simulation/virtual_rig.h"

namespace heft::cli {
namespace {

using nlohmann::json;

constexpr double kShowEvery = 0.07;              ///< [s] On a terminal
constexpr double kLineEvery = 1.0;               ///< [s] Elsewhere
constexpr std::chrono::milliseconds kPause{35};  ///< Between two looks at the samples: two make what a terminal shows
constexpr std::size_t kMostRows = 4'000'000;     ///< About an hour at 1 kHz is kept for the final estimate.

struct LiveArguments {
  std::vector<std::string> sources;
  std::string record, meta, robot, shape, shapeFile, json, conventions = "as-stated";
  double duration = 0.0;
  bool force = false;
};

std::atomic<bool> interrupted = false;

/// Ends the loop at Ctrl-C or with the terminal instead of the program, so that what came so far is estimated and
/// written. A terminal that closes says so several times, so it is not listened to again.
class InterruptGuard {
 public:
  InterruptGuard() {
    interrupted = false;
    struct sigaction action {
    }, before{};
    action.sa_handler = [](int) { interrupted = true; };
    ::sigaction(SIGINT, &action, &oldInterrupt_);
    ::sigaction(SIGTERM, &action, &oldTerminate_);
    // Under nohup it stays ignored.
    if (::sigaction(SIGHUP, nullptr, &before) == 0 && before.sa_handler != SIG_IGN)
      ::sigaction(SIGHUP, &action, nullptr);
  }
  ~InterruptGuard() {
    ::sigaction(SIGINT, &oldInterrupt_, nullptr);
    ::sigaction(SIGTERM, &oldTerminate_, nullptr);
  }
  InterruptGuard(const InterruptGuard&) = delete;
  InterruptGuard& operator=(const InterruptGuard&) = delete;

 private:
  struct sigaction oldInterrupt_ {
  }, oldTerminate_{};
};

/// All complete samples, for the estimate at the end.
class Kept {
 public:
  void add(const LiveSample& sample) {
    if (samples_.empty()) first_ = sample;
    if (samples_.size() < kMostRows) samples_.add(sample);
  }
  bool empty() const { return samples_.empty(); }
  bool full() const { return samples_.size() == kMostRows; }

  /// In the form that the first sample has.
  Recording toRecording(const RecordingMeta& meta, const std::string& name) const {
    Recording out;
    out.file = name;
    out.meta = meta;
    const bool joints = first_.q.has_value();
    const auto isRow = [&](const LiveSample& s) { return joints ? s.q.has_value() : s.orientation.has_value(); };
    bool velocities = joints, position = !joints, turned = true;
    Eigen::Index count = 0, lacking = 0;
    orFail(samples_.forEach([&](const LiveSample& s) {
      velocities = velocities && s.dq;
      position = position && s.position;
      if (!isRow(s)) return;
      ++count;
      if (!s.accelerometer) ++lacking;
      turned = turned && (s.gyroscope || !s.accelerometer);
    }));
    // Without gaps: this costs a few rows, and more where the acceleration comes from nothing else.
    const bool felt =
        static_cast<double>(lacking) <= mostWithoutAccelerometer(joints || position) * static_cast<double>(count);
    if (felt) count -= lacking;
    turned = turned && felt;
    out.time.resize(count);
    out.wrench.resize(count, 6);
    if (joints) out.q.resize(count, first_.joints);
    if (velocities) out.dq.resize(count, first_.joints);
    if (!joints) out.quaternion.resize(count, 4);
    if (position) out.position.resize(count, 3);
    if (felt) out.accelerometer.resize(count, 3);
    if (turned) out.gyroscope.resize(count, 3);
    Eigen::Index k = 0;
    orFail(samples_.forEach([&](const LiveSample& s) {
      if (!isRow(s) || (felt && !s.accelerometer)) return;
      out.time(k) = s.time - first_.time;
      out.wrench.row(k) = s.wrench->transpose();
      for (Eigen::Index j = 0; j < out.q.cols(); ++j) out.q(k, j) = (*s.q)[static_cast<std::size_t>(j)];
      for (Eigen::Index j = 0; j < out.dq.cols(); ++j) out.dq(k, j) = (*s.dq)[static_cast<std::size_t>(j)];
      if (!joints) out.quaternion.row(k) = s.orientation->coeffs().transpose();
      if (position) out.position.row(k) = s.position->transpose();
      if (felt) out.accelerometer.row(k) = s.accelerometer->transpose();
      if (turned) out.gyroscope.row(k) = s.gyroscope->transpose();
      ++k;
    }));
    return out;
  }

 private:
  LiveSample first_;
  SampleSpool samples_;
};

std::string troubleLine(const SessionStatus& status) {
  std::string text;
  for (const auto& source : status.sources) {
    std::string part;
    for (const auto& [count, word] :
         {std::pair{source.lost, "lost"}, std::pair{source.reordered, "late"}, std::pair{source.malformed, "malformed"},
          std::pair{source.flagged, "flagged"},
          std::pair{source.disconnects, source.disconnects == 1 ? "disconnect" : "disconnects"}})
      if (count > 0) part += fmt::format("{}{} {}", part.empty() ? "" : ", ", count, word);
    if (!part.empty()) text += fmt::format("  [{}: {}]", source.name, part);
    if (source.state != LinkState::live && source.state != LinkState::finished && !source.text.empty())
      text += fmt::format("  {}", source.text);
  }
  return text;
}

std::string waitingFor(const SessionStatus& status) {
  if (status.motions == 0 && status.wrenches == 0) return "waiting for motion and wrench";
  if (status.motions == 0) return "the wrench arrives; waiting for joint angles or a pose";
  if (status.wrenches == 0) return "the motion arrives; waiting for the wrench";
  return "waiting for motion and wrench of the same time";
}

json statusJson(const SessionStatus& status) {
  json sources = json::array();
  for (const auto& source : status.sources)
    sources.push_back({{"name", source.name},
                       {"state", toString(source.state)},
                       {"samples", source.samples},
                       {"lost", source.lost},
                       {"reordered", source.reordered},
                       {"malformed", source.malformed},
                       {"flagged", source.flagged},
                       {"disconnects", source.disconnects},
                       {"topics", source.topics},
                       {"notes", source.notes}});
  return {{"sources", std::move(sources)}, {"samples", status.samples}, {"motions", status.motions},
          {"wrenches", status.wrenches},   {"late", status.late},       {"unmatched", status.unmatched},
          {"recorded", status.recorded}};
}

/// A line that changes on a terminal, once a second elsewhere; to stderr, as stdout is for the result.
class StatusLine {
 public:
  StatusLine() : terminal_(::isatty(STDERR_FILENO) == 1) {}
  /// Whether it is time for the next.
  bool due() const { return hostNow() - last_ >= (terminal_ ? kShowEvery : kLineEvery); }
  void show(const std::string& text) {
    last_ = hostNow();
    if (terminal_)
      tell(fmt::format("\r\033[K{}", text));
    else
      tell(fmt::format("{}\n", text));
    std::fflush(stderr);
  }
  /// A line that stays.
  void say(const std::string& text) {
    tell(fmt::format("{}{}\n", terminal_ ? "\r\033[K" : "", text));
    std::fflush(stderr);
  }
  ~StatusLine() {
    if (terminal_) tell("\r\033[K");
  }
  StatusLine(const StatusLine&) = delete;
  StatusLine& operator=(const StatusLine&) = delete;

 private:
  bool terminal_;
  double last_ = -1e9;
};

/// The setup file given, or that of the only recording replayed.
RecordingMeta metaOf(const LiveArguments& options, Findings& findings) {
  std::filesystem::path file = options.meta;
  const bool replays = std::ranges::all_of(options.sources, [](const auto& s) { return s.starts_with("replay:"); });
  if (file.empty() && replays && options.sources.size() == 1) {
    auto name = options.sources[0].substr(7);
    name.resize(std::min(name.size(), name.rfind('?')));
    if (std::filesystem::exists(metaFileOf(name))) file = metaFileOf(name);
  }
  RecordingMeta meta;
  if (!file.empty()) meta = orFail(readMeta(file, findings));
  const auto isVirtual = [](const auto& s) { return s == "virtual" || s.starts_with("virtual:"); };
  if (file.empty() && std::ranges::all_of(options.sources, isVirtual)) meta = VirtualRig::metaFor(VirtualRigOptions());
  if (meta.kind == RecordingKind::poses) throw Failed("Live samples are of a motion, not of standing poses.");
  if (!options.robot.empty()) meta.robot = orFail(robotNamed(options.robot, {}, "--robot"));
  // A replayed recording was brought to the plain form when it was read.
  if (replays) meta.numbersArePlain();
  return meta;
}

class LiveRun {
 public:
  LiveRun(const LiveArguments& options, EstimateOptions settings)
      : options_(options), settings_(std::move(settings)), meta_(metaOf(options, findings_)) {
    const auto jointNames = jointNamesOf(meta_);
    for (const auto& address : options.sources) {
      auto source = makeLiveSource(address, options.meta, jointNames, meta_.conventions);
      if (!source) throw WrongUsage(source.error().message);
      session_.addSource(std::move(*source));
    }
  }

  void run() {
    session_.setConventions(meta_.conventions);
    if (!options_.record.empty()) orFail(session_.record(options_.record, meta_));
    orFail(session_.start());
    StatusLine line;
    {
      const InterruptGuard guard;
      const double start = hostNow();
      while (!interrupted && !(options_.duration > 0.0 && hostNow() - start >= options_.duration)) {
        const bool finished = allFinished();
        takeNew();
        const auto status = session_.status();
        if (recordingProblem_ != status.recordingProblem) {
          recordingProblem_ = status.recordingProblem;
          line.say(fmt::format("{} The estimate goes on.", recordingProblem_));
        }
        for (const auto& source : status.sources) {
          if (source.state != LinkState::failed) continue;
          if (kept_.empty()) throw Failed(source.text);
          sourceProblem_ = source.text;
        }
        // What there is to say costs more than to take the samples.
        if (finished || line.due()) {
          sayNews(line);
          line.show((running_ ? running_->line() : waitingFor(status)) + troubleLine(status));
        }
        if (finished || !sourceProblem_.empty()) break;
        std::this_thread::sleep_for(kPause);
      }
    }
    session_.stop();
    takeNew();
    sayNews(line);
    status_ = session_.status();
    recordingProblem_ = status_.recordingProblem;
    session_.endRecording();
  }

  /// What went wrong beside the estimate.
  std::vector<std::string> problems() const {
    std::vector<std::string> all;
    for (const auto& problem : {recordingProblem_, sourceProblem_})
      if (!problem.empty()) all.push_back(problem);
    return all;
  }

  EstimateReport report() {
    if (kept_.empty()) {
      std::string why;
      for (const auto& source : status_.sources) {
        if (!source.text.empty()) why += " " + source.text;
        for (const auto& note : source.notes) why += " " + note;
      }
      const auto missing = missingPart(status_);
      throw Failed((missing.empty() ? "No complete sample arrived: motion and wrench never came at the same time."
                                    : "No complete sample arrived. " + missing) +
                   why);
    }
    if (kept_.full())
      findings_.push_back({Severity::warning,
                           "live_too_long",
                           "More samples came than are kept; the estimate rests on the first ones.",
                           "Estimate the "
                           "recording instead.",
                           {}});
    const auto name = options_.record.empty() ? "live" : options_.record;
    auto checked = orFail(checkRecording(kept_.toRecording(meta_, name)));
    for (const auto& source : status_.sources) {
      if (source.configured) checked.recording.configured = source.configured;
      for (const auto& note : source.notes)
        findings_.push_back({Severity::info, "live_note", fmt::format("{}: {}", source.name, note), {}, {}});
    }
    std::optional<RobotModel> robot;
    if (checked.recording.hasJoints()) robot = orFail(robotFor(checked.recording.meta, findings_));
    orFail(toSensorAxes(checked.recording, robot ? &*robot : nullptr));
    if (!status_.wrapped.empty())
      findings_.push_back({Severity::info, "angles_unwrapped", unwrapped(status_.wrapped), {}, {}});
    auto report = orFail(estimate(checked.recording, robot ? &*robot : nullptr, settings_));
    addReadingFindings(checked.findings, report);
    addReadingFindings(findings_, report);
    return report;
  }

  const SessionStatus& status() const { return status_; }

 private:
  bool allFinished() const {
    const auto status = session_.status();
    return std::ranges::all_of(status.sources, [](const auto& s) { return s.state == LinkState::finished; });
  }

  void takeNew() {
    session_.takeNew(fresh_);
    for (const auto& sample : fresh_) {
      if (kept_.empty()) begin(sample);
      kept_.add(sample);
      running_->add(sample);
    }
  }

  void sayNews(StatusLine& line) {
    if (!running_) return;
    for (const auto& news : running_->news()) line.say(news);
  }

  /// The first sample shows whether there are joint angles, and so which arm is needed.
  void begin(const LiveSample& first) {
    if (first.q && !meta_.robot) {
      if (first.joints != 7)
        throw Failed(fmt::format("There are {} joints but no robot is named: give --robot or --meta.", first.joints));
      meta_.robot = "panda";
      findings_.push_back({Severity::warning,
                           "robot_assumed",
                           "No robot is named; with seven joints it is taken to be a Franka Panda, with the sensor at "
                           "its flange.",
                           "Name it with --robot, or in a setup file: --meta FILE.",
                           {}});
    }
    std::optional<RobotModel> robot;
    if (first.q) robot = orFail(robotFor(meta_, findings_));
    running_.emplace(meta_, robot ? &*robot : nullptr, settings_.shape, settings_.conventions);
  }

  const LiveArguments& options_;
  EstimateOptions settings_;
  Findings findings_;
  RecordingMeta meta_;
  LiveSession session_;
  std::optional<RunningEstimate> running_;
  Kept kept_;
  std::vector<LiveSample> fresh_;
  SessionStatus status_;
  std::string recordingProblem_, sourceProblem_;
};

void run(const LiveArguments& options) {
  EstimateOptions settings;
  if (options.duration != 0.0) requireRange("--duration", options.duration, 0.1, 86400.0, "s");
  settings.shape = shapeChoice(options.shape, options.shapeFile);
  settings.conventions = conventionChoice(options.conventions);
  if (!options.record.empty() && std::filesystem::path(options.record).extension() != ".csv")
    throw WrongUsage(fmt::format("--record expects a name that ends in .csv, not '{}'.", printable(options.record)));
  const Overwrite overwrite = ownResult(options.force, "heft.estimate/1");
  if (!options.json.empty()) requireWritable(options.json, overwrite);

  LiveRun live(options, settings);
  live.run();
  const auto& status = live.status();
  // What cannot be written may still be printed, and the other way round: the terminal may be gone, the disk full.
  std::vector<std::string> problems = live.problems();
  const auto attempt = [&problems](const auto& output) {
    try {
      output();
    } catch (const Failed& failure) {
      if (std::ranges::find(problems, failure.what()) == problems.end()) problems.emplace_back(failure.what());
    }
  };
  if (!options.record.empty() && options.json != "-" && status.recordingProblem.empty() && status.recorded > 0)
    attempt([&] { print(fmt::format("{}: {} samples\n", options.record, status.recorded)); });
  std::optional<EstimateReport> report;
  attempt([&] { report = live.report(); });
  if (report) {
    json result = heft::toJson(*report);
    result["live"] = statusJson(status);
    if (!options.json.empty()) attempt([&] { writeResult(options.json, result, overwrite); });
    if (options.json != "-") attempt([&] { print(toText(*report)); });
    if (const auto trouble = troubleLine(status); !trouble.empty()) tell(fmt::format("heft:{}\n", trouble));
  }
  if (problems.empty()) return;
  for (std::size_t k = 0; k + 1 < problems.size(); ++k) tell(fmt::format("heft: {}\n", problems[k]));
  throw Failed(problems.back());
}

}  // namespace

Command makeLiveCommand(CLI::App& root) {
  auto options = std::make_shared<LiveArguments>();
  CLI::App* app = root.add_subcommand("live", "Estimate and record while the arm is guided by hand");
  app->add_option("SOURCE", options->sources,
                  "One source with motion and wrench, or one for each:\n"
                  "rtde:HOST[:PORT]  Universal Robots: joints and the raw wrench of the flange's sensor\n"
                  "rdt:HOST[:PORT]  Net F/T sensor (ATI, Schunk)\n"
                  "foxglove:HOST[:PORT]  Foxglove WebSocket bridge\n"
                  "rosbridge:HOST[:PORT]  rosbridge\n"
                  "udp:PORT  JSON objects in datagrams, with a CSV's column names\n"
                  "replay:FILE  a recording, in real time\n"
                  "virtual:SEED  a simulated Panda that moves automatically, to try Heft without a robot")
      ->type_name("")
      ->required();
  app->add_option("--record", options->record, "Write samples to this CSV as they arrive")->type_name("FILE");
  app->add_option("--meta", options->meta, "Setup file: robot, sensor mount, wrench sign, gravity")->type_name("FILE");
  app->add_option("--robot", options->robot, "panda or a URDF, instead of the setup file's")->type_name("ROBOT");
  app->add_option("--duration", options->duration, "Stop after this many seconds; otherwise at Ctrl-C")->type_name("S");
  addConventionChoice(*app, options->conventions);
  app->add_option("--shape", options->shape, "Shape of the tool, as in 'heft estimate'")->type_name("SHAPE");
  app->add_option("--shape-file", options->shapeFile, "Shape as JSON: several bodies, meshes")->type_name("FILE");
  app->add_option("--json", options->json, "Write the final estimate as JSON; - is stdout")->type_name("FILE");
  app->add_flag("--force", options->force, "Overwrite an existing result file");
  app->footer(
      "Examples:\n"
      "  heft live replay:rec.csv --duration 5\n"
      "  heft live rdt:192.168.1.1 foxglove:localhost --record demo.csv --meta rig.meta.json\n"
      "  heft live udp:9870 --json result.json\n"
      "  heft live rtde:192.168.0.10 --robot ur5e.urdf --record demo.csv\n\n"
      "Lost, late and malformed packets are counted and shown. Nothing is sent to a sensor but the request for its\n"
      "data; in particular it is never tared. A recording never replaces a file.");
  return {app, [options] { run(*options); }};
}

}  // namespace heft::cli
