#include "core/import/join.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <set>

#include "core/base/remedy.h"
#include "core/base/say.h"
#include "core/base/text.h"
#include "core/import/align.h"
#include "core/math/statistics.h"
#include "core/motion/motion.h"
#include "core/recording/checks.h"
#include "core/recording/plain_form.h"

namespace heft {

namespace {

constexpr double kSameClock = 0.5;        ///< [s] Delays from stamp to recorder that differ less belong to one clock.
constexpr double kLittleExplained = 0.5;  ///< Share of the force's variance
constexpr double kEpoch = 1e9;            ///< [s] Later times count from 1970, earlier ones from some start.
constexpr double kLongestGapSteps = 5.0;  ///< Across longer gaps nothing is interpolated.
constexpr double kMissingShare = 0.05;    ///< Up to this share of samples may lack a velocity.
constexpr std::int64_t kRestart = 500'000'000;  ///< [ns] Samples that come late are late by less.
constexpr double kNoDelay = 0.06;               ///< [s] A little to either side, so that the fit at none is seen.
constexpr double kWideReach = 10.0;             ///< [s] Delays on a common clock are looked for up to this.
constexpr double kLongestReach = 600.0;         ///< [s] Offsets between unrelated clocks are looked for up to this.

/// Rows of some columns of one stream.
struct Signal {
  std::size_t stream = 0;
  std::vector<std::int64_t> nanoseconds;
  VectorXd time;  ///< [s] after the joint beginning
  MatrixXd values;
  double step = 0.0;  ///< [s] median

  bool empty() const { return values.cols() == 0; }
};

double quantile(std::vector<double> values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

class Joiner {
 public:
  Joiner(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns, const MappingWishes& wishes,
         Findings& findings)
      : streams_(streams), columns_(columns), wishes_(wishes), findings_(findings) {}

  std::optional<double> explained(RecordingMeta meta) {
    if (const auto failure = makeSignals(std::move(meta)); failure || unrelated_) return std::nullopt;
    const auto moved = specificForce();
    if (!moved) return std::nullopt;
    return findOffset(inWrenchAxes(*moved), moved->startTime, moved->rateHz, wrench_.time, wrench_.values.leftCols<3>(),
                      -kNoDelay, kNoDelay)
        .explained;
  }

  Result<Recording> join(RecordingMeta meta) {
    if (auto failure = makeSignals(std::move(meta))) return *failure;
    if (auto failure = align()) return *failure;
    if (auto failure = resample()) return *failure;
    for (const auto s : {wrench_.stream, motion().stream}) {
      if (!recording_.labels.empty()) break;
      takeLabels(s);
    }
    return std::move(recording_);
  }

 private:
  /// All signals on their own times, in the plain form.
  std::optional<Error> makeSignals(RecordingMeta meta) {
    recording_.file = streams_[columns_[0].stream].file;
    recording_.meta = std::move(meta);
    for (const auto& column : columns_) used_.insert(column.stream);
    if (auto failure = checkOffsets()) return *failure;
    chooseClocks();
    chooseSenders();
    setAsideSparse();
    if (auto failure = refuseRestarts()) return *failure;
    wrench_ = signalOf({"fx", "fy", "fz", "tx", "ty", "tz"});
    joints_ = signalOf(numbered("q"));
    velocities_ = signalOf(numbered("dq"));
    quaternion_ = signalOf({"qx", "qy", "qz", "qw"});
    for (const auto& form : rotationForms())
      if (quaternion_.empty()) quaternion_ = quaternionsOf(signalOf(form), form);
    position_ = signalOf({"px", "py", "pz"});
    for (const auto* signal : {&wrench_, &joints_, &velocities_, &quaternion_, &position_})
      if (!signal->empty() && signal->nanoseconds.size() < 2)
        return errorAt({streams_[signal->stream].file, 0, 0},
                       heft::say("{} has fewer than two complete samples.", nameOf(signal->stream)),
                       heft::say("Record again, or choose other columns."));
    makeTimes();
    if (auto failure = toPlainForm()) return *failure;
    makeQuaternionsSmooth();
    return std::nullopt;
  }

  void note(Severity severity, const char* code, std::string text, std::string remedy = {}) {
    findings_.push_back({severity, code, std::move(text), std::move(remedy), {recording_.file, 0, 0}});
  }

  /// Joints and velocities of one stream have the same to say.
  void noteOnce(Severity severity, const char* code, const std::string& text) {
    const bool said = std::any_of(findings_.begin(), findings_.end(),
                                  [&](const Finding& finding) { return finding.code == code && finding.text == text; });
    if (!said) note(severity, code, text);
  }

  std::string nameOf(std::size_t stream) const {
    const auto& each = streams_[stream];
    return each.name.empty() || each.name == "/" ? each.file : each.name;
  }

  std::string howToShift(std::size_t stream, double seconds) const {
    return remedy(Remedy::stateOffset, fmt::format("\"{}\": {:.4f}", displayName(nameOf(stream)), seconds));
  }

  std::vector<std::string> numbered(const std::string& prefix) const {
    std::vector<std::string> out;
    for (int j = 1; j <= 64; ++j) {
      const auto name = fmt::format("{}{}", prefix, j);
      if (std::none_of(columns_.begin(), columns_.end(), [&](const auto& c) { return c.column == name; })) break;
      out.push_back(name);
    }
    return out;
  }

  bool sameFile() const {
    for (const auto s : used_)
      if (streams_[s].file != streams_[*used_.begin()].file) return false;
    return true;
  }

  /// Stamps of the messages' headers are when something was measured; the recorder's times come after the network.
  void chooseClocks() {
    clockShift_.assign(streams_.size(), 0);
    useStamps_.assign(streams_.size(), false);
    if (wishes_.clock == "received") return;
    std::vector<std::pair<std::size_t, double>> delays;
    bool allStamped = true;
    for (const auto s : used_) {
      const auto& stream = streams_[s];
      std::vector<double> delay;
      bool stamped = !stream.stamps.empty() && stream.stamps.size() == stream.received.size() &&
                     std::all_of(stream.stamps.begin(), stream.stamps.end(), [](auto t) { return t != 0; });
      if (stamped)
        stamped = *std::max_element(stream.stamps.begin(), stream.stamps.end()) >
                  *std::min_element(stream.stamps.begin(), stream.stamps.end());
      allStamped = allStamped && stamped;
      if (!stamped) continue;
      for (std::size_t k = 0; k < stream.stamps.size(); ++k)
        delay.push_back(1e-9 * static_cast<double>(stream.received[k] - stream.stamps[k]));
      delays.emplace_back(s, quantile(std::move(delay), 0.05));
    }
    if (!allStamped) {
      if (!delays.empty())
        note(Severity::info, "clock_received",
             heft::say("Not every topic stamps its messages, so the recorder's times are used for all."));
      return;
    }
    for (const auto& [s, delay] : delays) useStamps_[s] = true;
    const auto [least, most] = std::minmax_element(delays.begin(), delays.end(),
                                                   [](const auto& a, const auto& b) { return a.second < b.second; });
    if (wishes_.clock == "header" || most->second - least->second < kSameClock) return;
    for (const auto& [s, delay] : delays) {
      clockShift_[s] = nanoseconds(delay);
      note(Severity::warning, "clock_shifted",
           heft::say("The stamps of {} are on another clock: {:.4f} s were added, from when its messages arrived.",
                     nameOf(s), delay),
           heft::say("The transport's delay is not known.") + " " + howToShift(s, 0.0));
    }
  }

  /// An offset that is stated for something that is not there was misspelt.
  std::optional<Error> checkOffsets() const {
    for (const auto& [name, seconds] : wishes_.offset) {
      const bool known = std::any_of(streams_.begin(), streams_.end(), [&wanted = name](const Stream& stream) {
        return wanted == stream.name || wanted == stream.file ||
               wanted == std::filesystem::path(stream.file).filename().string();
      });
      if (known) continue;
      std::vector<std::string> names;
      for (const auto s : used_) names.push_back(nameOf(s));
      return errorAt({recording_.file, 0, 0},
                     heft::say("an offset is stated for \"{}\", which is not there.", printable(name)),
                     heft::say("What was chosen is {}.", fmt::join(names, ", ")));
    }
    return std::nullopt;
  }

  bool isPart(const ColumnSource& column, const char* prefix) const {
    return column.column.starts_with(prefix) && column.column.size() > std::string_view(prefix).size();
  }

  /// Velocities and a position that hardly ever come are worth less than the rows that lack them.
  void setAsideSparse() {
    const auto sparse = [&](const std::vector<std::string>& names, const std::string& what) {
      std::size_t missing = 0, rows = 0;
      for (const auto& column : columns_) {
        if (std::find(names.begin(), names.end(), column.column) == names.end()) continue;
        const auto& values = streams_[column.stream].values[column.field];
        std::size_t here = 0;
        rows = 0;
        for (std::size_t k = 0; k < values.size(); ++k) {
          if (!reported(column.stream, k)) continue;
          ++rows;
          here += std::isfinite(values[k]) ? 0 : 1;
        }
        missing = std::max(missing, here);
      }
      if (rows == 0 || static_cast<double>(missing) <= kMissingShare * static_cast<double>(rows)) return;
      std::erase_if(columns_, [&](const ColumnSource& column) {
        return std::find(names.begin(), names.end(), column.column) != names.end();
      });
      note(Severity::info, "columns_set_aside",
           heft::say("{} missing in {} of {} samples and left aside.", what, missing, rows));
    };
    sparse(numbered("dq"), heft::say("The joint velocities are"));
    if (!numbered("q").empty()) return;
    sparse({"px", "py", "pz"}, heft::say("The position is"));
  }

  /// Columns that tell what a stream's rows are about: joints, else the wrench, else the orientation.
  std::vector<const std::vector<double>*> coreOf(std::size_t stream) const {
    for (const auto& names : {numbered("q"), std::vector<std::string>{"fx", "fy", "fz", "tx", "ty", "tz"},
                              std::vector<std::string>{"qx", "qy", "qz", "qw"}}) {
      std::vector<const std::vector<double>*> out;
      for (const auto& column : columns_)
        if (column.stream == stream && std::find(names.begin(), names.end(), column.column) != names.end())
          out.push_back(&streams_[stream].values[column.field]);
      if (!out.empty()) return out;
    }
    return {};
  }

  /// Rows of one sender: those that hold all core columns.
  struct Sender {
    std::vector<std::size_t> rows;
    double spread = 0.0;  ///< Sum of the columns' standard deviations.
  };

  /// Several nodes may send the same joints on one topic: zeros, a simulation, a second arm. Where their values do not
  /// continue each other, the one that moves most is taken.
  void chooseSenders() {
    for (const auto s : used_) {
      const auto core = coreOf(s);
      if (core.empty()) continue;
      std::map<int, Sender> senders;
      const auto& stream = streams_[s];
      for (std::size_t k = 0; k < stream.received.size(); ++k) {
        bool complete = true, zero = true;
        for (const auto* values : core) {
          complete = complete && k < values->size() && std::isfinite((*values)[k]);
          zero = zero && complete && (*values)[k] == 0.0;
        }
        if (!complete) continue;
        const int sender = k < stream.sender.size() ? stream.sender[k] : 0;
        senders[zero ? -1 : sender].rows.push_back(k);
      }
      if (senders.size() < 2) continue;
      for (auto& [id, sender] : senders) {
        for (const auto* values : core) {
          std::vector<double> here;
          for (const auto k : sender.rows) here.push_back((*values)[k]);
          const double mean = std::accumulate(here.begin(), here.end(), 0.0) / static_cast<double>(here.size());
          double squares = 0.0;
          for (const double value : here) squares += (value - mean) * (value - mean);
          sender.spread += std::sqrt(squares / static_cast<double>(here.size()));
        }
      }
      const auto main = std::max_element(senders.begin(), senders.end(), [](const auto& a, const auto& b) {
        return a.second.spread < b.second.spread;
      });
      for (const auto& [id, sender] : senders) {
        if (id == main->first || continues(s, core, main->second, sender)) continue;
        for (const auto k : sender.rows) dropped_[s].insert(k);
        const std::string who = id >= 0 && static_cast<std::size_t>(id) < stream.senders.size()
                                    ? stream.senders[static_cast<std::size_t>(id)]
                                    : std::string();
        note(Severity::warning, "other_publisher",
             id < 0
                 ? heft::say("{} of {} samples of {} are all zeros between others: another publisher sends there, "
                             "too. They were left out.",
                             sender.rows.size(), stream.received.size(), nameOf(s))
                 : heft::say("{} of {} samples of {} do not fit the others: another publisher sends there, too ({}). "
                             "The one that moves was taken.",
                             sender.rows.size(), stream.received.size(), nameOf(s), who));
      }
    }
  }

  /// Whether the rows of `other` lie between those of `main` in value as they do in time.
  bool continues(std::size_t s, const std::vector<const std::vector<double>*>& core, const Sender& main,
                 const Sender& other) const {
    const auto& times = streams_[s].received;
    double off = 0.0;
    std::size_t inside = 0;
    std::size_t next = 0;
    for (const auto k : other.rows) {
      while (next < main.rows.size() && main.rows[next] < k) ++next;
      if (next == 0 || next == main.rows.size()) continue;
      const auto a = main.rows[next - 1], b = main.rows[next];
      const double whole = static_cast<double>(times[b] - times[a]);
      const double share = whole > 0.0 ? static_cast<double>(times[k] - times[a]) / whole : 0.0;
      for (const auto* values : core)
        off += std::abs((*values)[k] - (1.0 - share) * (*values)[a] - share * (*values)[b]);
      ++inside;
    }
    return inside == 0 || off < 0.2 * main.spread * static_cast<double>(inside);
  }

  /// Whether row k of a stream is of the publisher that gives the motion: where several share a topic, others' rows
  /// lack all of its joints.
  bool reported(std::size_t stream, std::size_t k) const {
    if (const auto found = dropped_.find(stream); found != dropped_.end() && found->second.contains(k)) return false;
    const bool joints = std::any_of(columns_.begin(), columns_.end(), [&](const auto& c) {
      return c.stream == stream && isPart(c, "q") && !c.column.ends_with('x') && !c.column.ends_with('y') &&
             !c.column.ends_with('z') && !c.column.ends_with('w');
    });
    if (!joints) return true;
    for (const auto& column : columns_) {
      if (column.stream != stream || !isPart(column, "q")) continue;
      const auto& values = streams_[stream].values[column.field];
      if (k < values.size() && std::isfinite(values[k])) return true;
    }
    return false;
  }

  /// Times of a used stream that go back over what was there: two recordings in one, or two clocks on one topic.
  std::optional<Error> refuseRestarts() {
    for (const auto s : used_) {
      const auto& stream = streams_[s];
      if (useStamps_[s] && restartsAt(s, stream.stamps) && !restartsAt(s, stream.received)) {
        for (const auto each : used_) {
          useStamps_[each] = false;
          clockShift_[each] = 0;
        }
        note(
            Severity::warning, "clock_restarts",
            heft::say("The stamps of {} start again in the middle; the recorder's times are used for all.", nameOf(s)));
      }
    }
    for (const auto s : used_) {
      const auto& stream = streams_[s];
      const auto& times = useStamps_[s] ? stream.stamps : stream.received;
      const auto at = restartsAt(s, times);
      if (!at) continue;
      return errorAt({stream.file, 0, 0},
                     heft::say("the times of {} fall from {:.4f} s to {:.4f} s at sample {}, over what was there "
                               "already: two recordings, or two clocks.",
                               nameOf(s), 1e-9 * static_cast<double>(times[*at - 1]),
                               1e-9 * static_cast<double>(times[*at]), *at + 1),
                     heft::say("Split the recording there, or record one source only."));
    }
    return std::nullopt;
  }

  /// The first sample whose time falls by more than half a second back into times that were there: a few samples that
  /// came late do not count, nor do samples that are there twice. Nothing if the order is sound.
  std::optional<std::size_t> restartsAt(std::size_t s, const std::vector<std::int64_t>& times) const {
    std::optional<std::size_t> fall;
    for (std::size_t k = 1; k < times.size() && !fall; ++k)
      if (times[k - 1] - times[k] > kRestart) fall = k;
    if (!fall) return std::nullopt;
    std::vector<double> steps;
    for (std::size_t k = 1; k < times.size(); ++k)
      if (times[k] > times[k - 1]) steps.push_back(static_cast<double>(times[k] - times[k - 1]));
    if (steps.empty()) return fall;
    const double usual = median(std::move(steps));
    std::vector<std::size_t> order(times.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return times[a] < times[b]; });
    const auto core = coreOf(s);
    std::size_t crowded = 0;
    for (std::size_t i = 1; i < order.size(); ++i) {
      const auto a = order[i - 1], b = order[i];
      if (static_cast<double>(times[b] - times[a]) >= 0.75 * usual) continue;
      const bool twice = times[a] == times[b] && std::all_of(core.begin(), core.end(), [&](const auto* values) {
                           return a < values->size() && b < values->size() && (*values)[a] == (*values)[b];
                         });
      crowded += twice ? 0 : 1;
    }
    if (20 * crowded < order.size()) return std::nullopt;
    return fall;
  }

  /// A rotation in one of rotationForms() as quaternions.
  Signal quaternionsOf(Signal signal, const std::vector<std::string>& form) const {
    if (signal.empty()) return signal;
    MatrixXd out(signal.values.rows(), 4);
    for (Eigen::Index k = 0; k < out.rows(); ++k) {
      const Eigen::RowVectorXd row = signal.values.row(k);
      Quaterniond q;
      if (form[0] == "r11") {
        Matrix3d R;
        R << row.segment<3>(0), row.segment<3>(3), row.segment<3>(6);
        q = Quaterniond(R);
        // A matrix that is no rotation shows by a quaternion that is none.
        if (std::abs(R.determinant() - 1.0) > 0.2) q.coeffs().setZero();
      } else if (form[0] == "rvx") {
        const Vector3d v = row.head<3>().transpose();
        q = v.norm() > 0.0 ? Quaterniond(Eigen::AngleAxisd(v.norm(), v.normalized())) : Quaterniond::Identity();
      } else {
        const bool abc = form[0] == "kuka_a";
        const double yaw = row(abc ? 0 : 2), pitch = row(1), roll = row(abc ? 2 : 0);
        q = Eigen::AngleAxisd(yaw, Vector3d::UnitZ()) * Eigen::AngleAxisd(pitch, Vector3d::UnitY()) *
            Eigen::AngleAxisd(roll, Vector3d::UnitX());
      }
      out.row(k) = q.coeffs().transpose();
    }
    // The order of a quaternion that is stated is another's, and is undone later on.
    if (recording_.meta.conventions.quaternionOrder == Conventions::QuaternionOrder::wxyz) {
      const MatrixXd xyz = out.leftCols<3>();
      out.col(0) = out.col(3).eval();
      out.rightCols<3>() = xyz;
    }
    signal.values = std::move(out);
    return signal;
  }

  /// Who sends what the chosen joints are not in: " (position[finger])".
  std::string otherSenders(std::size_t s) const {
    const auto& stream = streams_[s];
    std::set<int> mine, all;
    for (std::size_t k = 0; k < stream.sender.size(); ++k) {
      all.insert(stream.sender[k]);
      if (reported(s, k)) mine.insert(stream.sender[k]);
    }
    std::vector<std::string> names;
    for (const int sender : all)
      if (!mine.contains(sender) && names.size() < 3) names.push_back(stream.senders[static_cast<std::size_t>(sender)]);
    return names.empty() ? std::string() : fmt::format(" ({})", fmt::join(names, "; "));
  }

  Signal signalOf(const std::vector<std::string>& names) {
    Signal out;
    std::vector<const ColumnSource*> sources;
    for (const auto& name : names) {
      const auto found =
          std::find_if(columns_.begin(), columns_.end(), [&](const auto& c) { return c.column == name; });
      if (found == columns_.end()) return out;
      sources.push_back(&*found);
    }
    if (sources.empty()) return out;
    out.stream = sources[0]->stream;
    const auto& stream = streams_[out.stream];
    const auto rows = stream.received.size();
    std::vector<std::pair<std::int64_t, std::size_t>> order;
    std::size_t missing = 0;
    std::size_t others = 0;
    std::size_t backwards = 0;
    for (std::size_t k = 0; k < rows; ++k) {
      if (!reported(out.stream, k)) {
        others += dropped_.contains(out.stream) ? 0 : 1;
        continue;
      }
      bool complete = true;
      for (const auto* source : sources) {
        const auto& values = stream.values[source->field];
        complete = complete && k < values.size() && std::isfinite(values[k]);
      }
      if (!complete) {
        ++missing;
        continue;
      }
      const auto time = (useStamps_[out.stream] ? stream.stamps[k] : stream.received[k]) + clockShift_[out.stream] +
                        offsetOf(out.stream);
      if (!isSoundStamp(time)) {
        ++missing;
        continue;
      }
      if (!order.empty() && time < order.back().first) ++backwards;
      order.emplace_back(time, k);
    }
    if (missing > 0)
      noteOnce(Severity::warning, "values_missing",
               heft::say("{} of {} samples of {} lack a value and were left out.", missing, rows, nameOf(out.stream)));
    if (others > 0)
      noteOnce(Severity::info, "other_publisher",
               heft::say("{} of {} samples of {} have none of these joints: another publisher sends there, too{}. They "
                         "were left out.",
                         others, rows, nameOf(out.stream), otherSenders(out.stream)));
    if (backwards > 0) {
      std::stable_sort(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
      noteOnce(Severity::warning, "time_sorted",
               heft::say("{} samples of {} were not in the order of their times and were sorted.", backwards,
                         nameOf(out.stream)));
    }
    const auto before = order.size();
    order.erase(
        std::unique(order.begin(), order.end(), [](const auto& a, const auto& b) { return a.first == b.first; }),
        order.end());
    if (order.size() < before)
      noteOnce(Severity::warning, "time_repeated",
               heft::say("{} of {} samples of {} repeat a time and were left out.", before - order.size(), before,
                         nameOf(out.stream)));
    out.values.resize(static_cast<Eigen::Index>(order.size()), static_cast<Eigen::Index>(sources.size()));
    for (std::size_t r = 0; r < order.size(); ++r) {
      out.nanoseconds.push_back(order[r].first);
      for (std::size_t c = 0; c < sources.size(); ++c)
        out.values(static_cast<Eigen::Index>(r), static_cast<Eigen::Index>(c)) =
            sources[c]->scale * stream.values[sources[c]->field][order[r].second];
    }
    return out;
  }

  std::int64_t offsetOf(std::size_t s) const {
    for (const auto& [name, seconds] : wishes_.offset)
      if (name == streams_[s].name || name == streams_[s].file ||
          name == std::filesystem::path(streams_[s].file).filename().string())
        return nanoseconds(seconds);
    return 0;
  }
  bool offsetStated(std::size_t s) const {
    for (const auto& [name, seconds] : wishes_.offset)
      if (name == streams_[s].name || name == streams_[s].file ||
          name == std::filesystem::path(streams_[s].file).filename().string())
        return true;
    return false;
  }

  Signal& motion() { return joints_.empty() ? quaternion_ : joints_; }

  void makeTimes() {
    // Times that count from 1970 begin at the motion's first sample; others stay as they are, so that marks fit.
    unrelated_ = !sameFile() && !clocksRelated();
    const auto origin = [](const Signal& signal) {
      const auto first = signal.nanoseconds.front();
      return 1e-9 * static_cast<double>(first) > kEpoch ? first : 0;
    };
    const auto common = origin(motion());
    motionZero_ = common;
    wrenchZero_ = unrelated_ ? origin(wrench_) : common;
    for (auto* signal : {&wrench_, &joints_, &velocities_, &quaternion_, &position_}) {
      if (signal->empty()) continue;
      const auto zero = unrelated_ ? origin(*signal) : common;
      const auto size = static_cast<Eigen::Index>(signal->nanoseconds.size());
      signal->time.resize(size);
      std::vector<double> steps;
      for (Eigen::Index k = 0; k < size; ++k) {
        signal->time(k) = 1e-9 * static_cast<double>(signal->nanoseconds[static_cast<std::size_t>(k)] - zero);
        if (k > 0) steps.push_back(signal->time(k) - signal->time(k - 1));
      }
      signal->step = median(std::move(steps));
    }
  }

  /// Of each signal by itself; the position has to wait for the orientation at its times.
  std::optional<Error> toPlainForm() {
    plain_.emplace(recording_.meta);
    if (!wrench_.empty()) plain_->undoWrench(wrench_.values);
    plain_->undoAngles(joints_.values);
    plain_->undoAngles(velocities_.values);
    if (!quaternion_.empty()) plain_->undoQuaternionOrder(quaternion_.values);
    if (!quaternion_.empty()) plain_->undoDirection(quaternion_.values);
    if (joints_.empty()) return std::nullopt;
    Recording angles;
    angles.meta = recording_.meta;
    angles.time = joints_.time;
    angles.q = std::move(joints_.values);
    ColumnMap map;
    map.joints.assign(static_cast<std::size_t>(angles.q.cols()), 1);
    std::vector<std::uint32_t> lines(static_cast<std::size_t>(angles.q.rows()), 0);
    if (auto failure = checkAngles({angles, map, recording_.file, lines, findings_, false})) return failure;
    joints_.values = std::move(angles.q);
    return std::nullopt;
  }

  /// Two files share a clock if both count from 1970 and overlap.
  bool clocksRelated() {
    const auto& a = motion().nanoseconds;
    const auto& b = wrench_.nanoseconds;
    if (offsetStated(motion().stream) || offsetStated(wrench_.stream)) return true;
    const double shorter = 1e-9 * static_cast<double>(std::min(a.back() - a.front(), b.back() - b.front()));
    const double overlap = 1e-9 * static_cast<double>(std::min(a.back(), b.back()) - std::max(a.front(), b.front()));
    return 1e-9 * static_cast<double>(a.front()) > kEpoch && 1e-9 * static_cast<double>(b.front()) > kEpoch &&
           overlap > 0.2 * shorter;
  }

  /// q and -q are one rotation; neighbours get the same sign before anything is averaged.
  void makeQuaternionsSmooth() {
    auto& values = quaternion_.values;
    for (Eigen::Index k = 1; k < values.rows(); ++k)
      if (values.row(k).dot(values.row(k - 1)) < 0.0) values.row(k) = -values.row(k);
  }

  /// The sensor's specific force from the motion alone.
  std::optional<Motion> specificForce() {
    Recording alone;
    alone.file = recording_.file;
    alone.meta = recording_.meta;
    if (!joints_.empty() && !alone.meta.robot && joints_.values.cols() == 7) alone.meta.robot = "panda";
    const Signal& from = motion();
    alone.time = from.time;
    alone.wrench.setZero(from.time.size(), 6);
    Findings aside;
    std::optional<RobotModel> robot;
    if (!joints_.empty()) {
      if (!alone.meta.robot) return std::nullopt;
      auto made = robotFor(alone.meta, aside);
      if (!made || made->dof() != joints_.values.cols()) return std::nullopt;
      robot = std::move(*made);
      alone.q = joints_.values;
    } else {
      alone.quaternion = quaternion_.values;
      for (Eigen::Index k = 0; k < alone.quaternion.rows(); ++k) {
        const double norm = alone.quaternion.row(k).norm();
        if (norm < 0.5) return std::nullopt;
        alone.quaternion.row(k) /= norm;
      }
    }
    MotionOptions options;
    options.cutoffHz = 5.0;
    options.outputRateHz = 100.0;
    auto motion = motionOf(alone, robot ? &*robot : nullptr, options);
    if (!motion || motion->size() < 50 || !motion->specificForce.allFinite()) return std::nullopt;
    return std::move(*motion);
  }

  /// The specific force in the axes that the wrench comes in.
  Eigen::Matrix3Xd inWrenchAxes(const Motion& motion) const {
    Eigen::Matrix3Xd out = motion.specificForce;
    if (recording_.meta.conventions.wrenchAxes == Conventions::WrenchAxes::base)
      for (Eigen::Index k = 0; k < out.cols(); ++k) out.col(k) = motion.R_BS[static_cast<std::size_t>(k)] * out.col(k);
    return out;
  }

  std::optional<Error> align() {
    if (wrench_.stream == motion().stream) return std::nullopt;
    const auto how = howToShift(wrench_.stream, 0.0);
    const auto moved = recording_.meta.kind == RecordingKind::motion ? specificForce() : std::nullopt;
    if (!moved && !unrelated_) return std::nullopt;
    const auto& motionTime = motion().time;
    double from = -0.5;
    double to = 0.5;
    if (unrelated_) {
      from = std::max(motionTime(0) - wrench_.time(wrench_.time.size() - 1),
                      motionTime(0) - wrench_.time(0) - kLongestReach);
      to = std::min(motionTime(motionTime.size() - 1) - wrench_.time(0),
                    motionTime(0) - wrench_.time(0) + kLongestReach);
    }
    OffsetEstimate offset;
    if (moved)
      offset = findOffset(inWrenchAxes(*moved), moved->startTime, moved->rateHz, wrench_.time,
                          wrench_.values.leftCols<3>(), from, to);
    const auto figures = heft::say("{:.3f} s (+- {:.3f} s; the motion then explains {:.0f} % of the force)",
                                   offset.seconds, 2.0 * offset.std, 100.0 * offset.explained);
    if (!unrelated_ && moved && !offset.sure && offset.explained < kLittleExplained) {
      // The best delay inside explains little: it may be longer than any that one expects on a common clock.
      const auto wide = findOffset(inWrenchAxes(*moved), moved->startTime, moved->rateHz, wrench_.time,
                                   wrench_.values.leftCols<3>(), -kWideReach, kWideReach);
      if (wide.sure && std::abs(wide.seconds) > 0.5) {
        note(Severity::warning, "time_offset_estimated",
             heft::say(
                 "The force of {} does not follow the motion of {} within half a second, but does when shifted by "
                 "{:.3f} s (+- {:.3f} s; the motion then explains {:.0f} % of the force); nothing was shifted.",
                 nameOf(wrench_.stream), nameOf(motion().stream), wide.seconds, 2.0 * wide.std, 100.0 * wide.explained),
             heft::say("The recorder lagged, or one clock is wrong.") + " " + howToShift(wrench_.stream, wide.seconds));
        return std::nullopt;
      }
    }
    if (unrelated_) {
      if (!offset.sure)
        return errorAt({recording_.file, 0, 0},
                       heft::say("the clocks of {} and {} have nothing in common, and the data do not tell how much "
                                 "one is later than the other.",
                                 nameOf(motion().stream), nameOf(wrench_.stream)),
                       how);
      wrench_.time.array() += offset.seconds;
      wrenchShift_ = offset.seconds;
      // What would have to be stated to get the same: it counts between the clocks as the files have them.
      const double stated =
          1e-9 * (static_cast<double>(motionZero_) - static_cast<double>(wrenchZero_)) + offset.seconds;
      note(
          Severity::warning, "clock_offset",
          heft::say("{} and {} are on different clocks: the wrench was shifted by {}.", nameOf(motion().stream),
                    nameOf(wrench_.stream), figures),
          heft::say(
              "Found by letting the force follow the motion; a delay of the sensor itself is thereby taken out, too.") +
              " " + howToShift(wrench_.stream, stated));
    } else if (offset.sure) {
      note(std::abs(offset.seconds) > std::max(0.02, 4.0 * offset.std) ? Severity::warning : Severity::info,
           "time_offset_estimated",
           heft::say("On their common clock the force of {} follows the motion of {} best when shifted by {}; nothing "
                     "was shifted.",
                     nameOf(wrench_.stream), nameOf(motion().stream), figures),
           howToShift(wrench_.stream, offset.seconds));
    }
    return std::nullopt;
  }

  /// Both signals at the times of the slower one.
  std::optional<Error> resample() {
    Signal& moving = motion();
    const bool together = wrench_.stream == moving.stream && wrench_.nanoseconds == moving.nanoseconds;
    const bool wrenchSlower = wrench_.step > 1.01 * moving.step;
    const Signal& base = wrenchSlower ? wrench_ : moving;
    const double overlapFrom = std::max(wrench_.time(0), moving.time(0));
    const double overlapTo = std::min(wrench_.time(wrench_.time.size() - 1), moving.time(moving.time.size() - 1));
    std::vector<double> times;
    std::size_t inGaps = 0;
    for (const double t : base.time) {
      if (t < overlapFrom || t > overlapTo) continue;
      if (nearSamples(wrench_, t, base.step) && nearSamples(moving, t, base.step))
        times.push_back(t);
      else
        ++inGaps;
    }
    if (times.size() < 2)
      return errorAt(
          {recording_.file, 0, 0},
          heft::say("{} and {} do not overlap in time: {:.3f} to {:.3f} s and {:.3f} to {:.3f} s.",
                    nameOf(moving.stream), nameOf(wrench_.stream), moving.time(0), moving.time(moving.time.size() - 1),
                    wrench_.time(0), wrench_.time(wrench_.time.size() - 1)),
          heft::say("Were they recorded together, or is one clock late?") + " " + howToShift(wrench_.stream, 0.0));
    const VectorXd at = Eigen::Map<const VectorXd>(times.data(), static_cast<Eigen::Index>(times.size()));
    const auto on = [&](const Signal& signal) -> MatrixXd {
      if (signal.empty()) return {};
      if (signal.time.size() == at.size() && signal.time == at) return signal.values;
      return averageAt(signal.time, signal.values, clamped(at, signal),
                       signal.step < 0.67 * base.step ? base.step : 0.0);
    };
    recording_.time = at;
    recording_.wrench = on(wrench_);
    recording_.q = on(joints_);
    recording_.dq = on(velocities_);
    if (!quaternion_.empty()) recording_.quaternion = on(quaternion_);
    if (!position_.empty() && !quaternion_.empty()) {
      MatrixXd unit = recording_.quaternion;
      unit.rowwise().normalize();
      recording_.position = on(position_);
      plain_->undoPosition(recording_.position, unit);
    }
    if (wishes_.poseOfFlange && !quaternion_.empty()) fromFlangeToSensor();

    if (!together) {
      const Signal& other = wrenchSlower ? moving : wrench_;
      note(Severity::info, "streams_joined",
           heft::say("{} ({:.4g} Hz) and {} ({:.4g} Hz) were joined on the times of {}; {}.", nameOf(moving.stream),
                     1.0 / moving.step, nameOf(wrench_.stream), 1.0 / wrench_.step, nameOf(base.stream),
                     other.step < 0.67 * base.step ? heft::say("the faster one is averaged over each step")
                                                   : heft::say("the other one is interpolated")));
    }
    if (inGaps > 0)
      note(Severity::warning, "stream_gaps",
           heft::say("At {} of {} times one of the streams has a gap; they were left out.", inGaps,
                     inGaps + times.size()));
    if (moving.step > 0.0201 && moving.step > 2.0 * wrench_.step)
      note(Severity::warning, "motion_rate_low",
           heft::say("The motion comes at {:.3g} Hz only; inertia needs about 100 Hz or more.", 1.0 / moving.step),
           heft::say("Panda's ROS driver publishes at 30 Hz by default: raise its publish rate to 1000 Hz."));
    return std::nullopt;
  }

  /// What the user labelled in the file of stream `like`, on the recording's times.
  void takeLabels(std::size_t like) {
    const bool withWrench = like == wrench_.stream;
    for (std::size_t s = 0; s < streams_.size(); ++s) {
      const Stream& stream = streams_[s];
      const auto field = std::find(stream.fields.begin(), stream.fields.end(), kLabelField);
      if (stream.file != streams_[like].file || field == stream.fields.end()) continue;
      const auto& values = stream.values[static_cast<std::size_t>(field - stream.fields.begin())];
      const std::int64_t zero = (withWrench ? wrenchZero_ : motionZero_) - offsetOf(s) - clockShift_[like];
      std::vector<std::pair<double, double>> labelled;
      for (std::size_t k = 0; k < std::min(values.size(), stream.received.size()); ++k)
        labelled.emplace_back(1e-9 * (static_cast<double>(stream.received[k]) - static_cast<double>(zero)) +
                                  (withWrench ? wrenchShift_ : 0.0),
                              values[k]);
      std::sort(labelled.begin(), labelled.end());
      if (labelled.empty()) continue;
      const double step = std::max(wrench_.step, motion().step);
      std::vector<std::optional<MarkLabel>> labels;
      for (const double t : recording_.time) {
        auto next = std::lower_bound(labelled.begin(), labelled.end(), std::pair(t, -2.0));
        if (next == labelled.end() || (next != labelled.begin() && t - (next - 1)->first < next->first - t)) --next;
        const bool known = next->second >= 0.0 && std::abs(next->first - t) <= step;
        labels.push_back(known ? std::optional(static_cast<MarkLabel>(std::lround(next->second))) : std::nullopt);
      }
      recording_.labels = std::move(labels);
      return;
    }
  }

  static VectorXd clamped(const VectorXd& at, const Signal& signal) {
    return at.cwiseMax(signal.time(0)).cwiseMin(signal.time(signal.time.size() - 1));
  }

  static bool nearSamples(const Signal& signal, double t, double step) {
    const auto after = std::lower_bound(signal.time.begin(), signal.time.end(), t) - signal.time.begin();
    if (after >= signal.time.size()) return false;
    if (after == 0 || signal.time(after) == t) return true;
    return signal.time(after) - signal.time(after - 1) <= kLongestGapSteps * std::max(signal.step, step);
  }

  /// X_BS = X_BF X_FS for poses of the flange.
  void fromFlangeToSensor() {
    const Isometry3d X_FS = poseFromXyzRpy(recording_.meta.mount.xyz, recording_.meta.mount.rpy);
    for (Eigen::Index k = 0; k < recording_.quaternion.rows(); ++k) {
      Quaterniond q(recording_.quaternion(k, 3), recording_.quaternion(k, 0), recording_.quaternion(k, 1),
                    recording_.quaternion(k, 2));
      q.normalize();
      if (recording_.position.rows() > 0) recording_.position.row(k) += (q * X_FS.translation()).transpose();
      const Quaterniond turned = q * Quaterniond(X_FS.linear());
      recording_.quaternion.row(k) = turned.coeffs().transpose();
    }
    note(Severity::info, "pose_of_flange", heft::say("The poses are the flange's; the sensor's follow by its mount."));
  }

  const std::vector<Stream>& streams_;
  std::vector<ColumnSource> columns_;
  const MappingWishes& wishes_;
  Findings& findings_;
  std::optional<PlainForm> plain_;
  std::set<std::size_t> used_;
  std::vector<std::int64_t> clockShift_;
  std::vector<bool> useStamps_;
  std::map<std::size_t, std::set<std::size_t>> dropped_;  ///< Rows of other publishers, by stream.
  bool unrelated_ = false;
  std::int64_t motionZero_ = 0, wrenchZero_ = 0;  ///< [ns] What time 0 is in each of the two files.
  double wrenchShift_ = 0.0;                      ///< [s] added to the wrench's times
  Signal wrench_, joints_, velocities_, quaternion_, position_;
  Recording recording_;
};

}  // namespace

std::optional<double> explainedByMotion(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns,
                                        const MappingWishes& wishes, RecordingMeta meta) {
  Findings aside;
  return Joiner(streams, columns, wishes, aside).explained(std::move(meta));
}

Result<Recording> joinStreams(const std::vector<Stream>& streams, const std::vector<ColumnSource>& columns,
                              const MappingWishes& wishes, RecordingMeta meta, Findings& findings) {
  return Joiner(streams, columns, wishes, findings).join(std::move(meta));
}

}  // namespace heft
