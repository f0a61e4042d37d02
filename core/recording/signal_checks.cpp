#include <algorithm>
#include <cmath>

#include "core/recording/checks.h"

#include "core/base/say.h"
#include "core/recording/frozen.h"
#include "core/recording/leaps.h"

namespace heft {

namespace {

struct Channel {
  Role role;
  int index;
  long field;
  Changes changes;
  std::string name() const { return columnName(role, index); }
};

class SignalChecker {
 public:
  explicit SignalChecker(const Examined& examined)
      : examined_(examined), recording_(examined.recording), rows_(recording_.rows()), time_(recording_.time) {}

  void run() {
    if (rows_ < 3) return;
    std::vector<Changes> wrench = changesOfEach(recording_.wrench);
    wrenchChanges_ = ofAny(wrench);
    motionChanges_.assign(static_cast<std::size_t>(rows_), 0);
    mergeMotion(recording_.q);
    mergeMotion(recording_.quaternion);
    mergeMotion(recording_.position);
    for (int c = 0; c < 6; ++c)
      wrench_.push_back({Role::wrench, c, examined_.map.wrench[static_cast<std::size_t>(c)],
                         std::move(wrench[static_cast<std::size_t>(c)])});
    if (noteFrozenChannels() || recording_.meta.kind == RecordingKind::poses) return;
    noteRepeats();
    noteFrozenWrench();
    noteFrozenMotion();
    noteJumps();
    if (!recording_.wrenchNeedsPose) noteTare();
    noteTorqueUnit();
  }

 private:
  template <class Matrix>
  void mergeMotion(const Matrix& values) {
    if (values.rows() == 0) return;
    const auto changes = changesOf(values);
    for (std::size_t k = 0; k < changes.size(); ++k) motionChanges_[k] = std::max(motionChanges_[k], changes[k]);
  }

  /// True if nothing at all changes, and all else is pointless.
  bool noteFrozenChannels() {
    const bool wrenchLives = everChanges(wrenchChanges_);
    const bool motionLives = everChanges(motionChanges_);
    if (!wrenchLives && !motionLives) {
      examined_.note(Severity::warning, "nothing_changes", {examined_.file, 0, 0},
                     heft::say("All {} rows hold the same wrench and the same posture.", rows_),
                     heft::say("Check that the logger received new data; move the arm while recording."));
      return true;
    }
    for (const auto& channel : wrench_)
      if (!everChanges(channel.changes)) noteFrozen(channel.name(), channel.field, recording_.wrench(0, channel.index));
    if (!motionLives) {
      examined_.note(
          Severity::warning, "motion_frozen", {examined_.file, 0, 0},
          heft::say("The posture never changes while the wrench does."),
          heft::say("Check that the robot's state was logged; with one posture only the weight's direction is seen."));
      return false;
    }
    for (Eigen::Index j = 0; j < recording_.q.cols(); ++j)
      noteIfFrozen(Role::joint, static_cast<int>(j), examined_.map.joints[static_cast<std::size_t>(j)],
                   recording_.q.col(j));
    if (recording_.dq.rows() > 0)
      for (Eigen::Index j = 0; j < recording_.dq.cols(); ++j)
        if (everChanges(recording_.q.col(j)))
          noteIfFrozen(Role::jointVelocity, static_cast<int>(j), examined_.map.velocities[static_cast<std::size_t>(j)],
                       recording_.dq.col(j));
    noteGroup("qx, qy, qz, qw", examined_.map.quaternion[0], recording_.quaternion);
    noteGroup("px, py, pz", examined_.map.position[0], recording_.position);
    noteGroup("vx, vy, vz, wx, wy, wz", examined_.map.twist[0], recording_.twist);
    noteGroup("ax, ay, az", examined_.map.accelerometer[0], recording_.accelerometer);
    return false;
  }

  template <class Column>
  void noteIfFrozen(Role role, int index, long field, const Column& values) {
    if (!everChanges(values)) noteFrozen(columnName(role, index), field, values(0));
  }
  template <class Matrix>
  void noteGroup(const char* names, long field, const Matrix& values) {
    if (values.rows() == 0 || everChanges(values)) return;
    examined_.note(Severity::warning, "channel_frozen", examined_.column(field),
                   heft::say("{} never change while others do.", names), heft::say("Check that they were logged."));
  }
  void noteFrozen(const std::string& name, long field, double value) {
    examined_.note(Severity::warning, "channel_frozen", examined_.column(field),
                   heft::say("{} is {} in every row while others change.", name, value),
                   heft::say("Check that it was logged."));
  }

  void noteRepeats() {
    const auto repeats = [&](const Changes& changes) { return rows_ - 1 - countIn(changes, 1, rows_); };
    const auto report = [&](const std::string& what, const char* code, Eigen::Index count, const Changes& changes,
                            double loud) {
      const double share = static_cast<double>(count) / static_cast<double>(rows_ - 1);
      if (share < 0.02) return;
      const auto first = std::find(changes.begin() + 1, changes.end(), char{0}) - changes.begin();
      if (inSingleSteps(changes)) {
        examined_.note(
            share > loud ? Severity::warning : Severity::info, "coarse_steps", examined_.at(first),
            heft::say("{} of the rows repeat the {} of the row before: its steps are coarser than its noise.",
                      percent(share), what),
            heft::say("Choose a finer measuring range, or a file format with more digits."));
        return;
      }
      examined_.note(share > loud ? Severity::warning : Severity::info, code, examined_.at(first),
                     heft::say("{} of the rows repeat the {} of the row before: new values come at about "
                               "{:.3g} Hz, rows at {:.4g} Hz.",
                               percent(share), what, recording_.rateHz() * (1.0 - share), recording_.rateHz()),
                     share > loud ? heft::say("Log each source at its own rate, or only when it has a new value.")
                                  : std::string());
    };
    const auto wrench = repeats(wrenchChanges_);
    if (everChanges(wrenchChanges_)) report(heft::say("wrench"), "wrench_repeated", wrench, wrenchChanges_, 0.2);
    // An arm at rest repeats its posture honestly, so this is no warning until it is most of the recording.
    if (everChanges(motionChanges_))
      report(heft::say("posture"), "posture_repeated", repeats(motionChanges_), motionChanges_, 0.5);
  }

  void noteFrozenWrench() {
    std::vector<FrozenStretch> whole;
    if (everChanges(wrenchChanges_))
      for (const auto& stretch : frozenStretches(time_, wrenchChanges_, 0.1))
        if (countIn(motionChanges_, stretch.from + 1, stretch.to) > 0) whole.push_back(stretch);
    if (!whole.empty())
      noteStretches(heft::say("The wrench"), examined_.map.wrench[0], whole,
                    heft::say("The sensor's data stopped there; mark it as \"ignore\"."));
    for (const auto& channel : wrench_) {
      if (!everChanges(channel.changes)) continue;
      const auto own = frozenAlone(time_, channel.changes, wrenchChanges_);
      if (!own.empty())
        noteStretches(
            channel.name(), channel.field, own,
            heft::say("The channel was not measured there, or the sensor was saturated; mark it as \"ignore\"."));
    }
  }

  void noteStretches(const std::string& what, long field, const std::vector<FrozenStretch>& stretches,
                     const std::string& remedy) {
    const auto& longest =
        *std::max_element(stretches.begin(), stretches.end(),
                          [](const FrozenStretch& a, const FrozenStretch& b) { return a.length() < b.length(); });
    examined_.note(
        Severity::warning, "stretch_frozen", examined_.at(longest.from, field),
        heft::say("{} stays the same from {:.6g} to {:.6g} s ({} rows){}.", what, time_(longest.from),
                  time_(longest.to - 1), longest.length(),
                  stretches.size() > 1 ? heft::say(", and in {} more segments", stretches.size() - 1) : std::string()),
        remedy);
  }

  /// A logger that hung shows the arm standing, then suddenly elsewhere; an arm that stood starts gently.
  void noteFrozenMotion() {
    if (recording_.q.rows() > 0)
      noteHang(recording_.q, examined_.map.joints[0]);
    else
      noteHang(recording_.quaternion, examined_.map.quaternion[0]);
  }
  template <class Matrix>
  void noteHang(const Matrix& values, long field) {
    const auto hangs = hungPostures(time_, values);
    if (!hangs.empty())
      noteStretches(heft::say("The posture"), field, hangs,
                    heft::say("It jumps afterwards: the robot's data stopped there; mark it as \"ignore\"."));
  }

  void noteJumps() {
    const auto report = [&](const std::vector<Eigen::Index>& leaps, long field, const std::string& what, double size,
                            const std::string& unit) {
      examined_.note(Severity::warning, "motion_jump", examined_.at(leaps.front(), field),
                     heft::say("{} jumps by {:.3g} {} within one row{}.", what, size, unit,
                               leaps.size() > 1 ? heft::say(", and {} times more", leaps.size() - 1) : std::string()),
                     heft::say("Mark that place as \"ignore\" or split the recording there."));
    };
    if (const auto leaps = jointLeaps(time_, recording_.q); !leaps.empty()) {
      Eigen::Index joint = 0;
      const double size =
          (recording_.q.row(leaps.front()) - recording_.q.row(leaps.front() - 1)).cwiseAbs().maxCoeff(&joint);
      report(leaps, examined_.map.joints[static_cast<std::size_t>(joint)],
             columnName(Role::joint, static_cast<int>(joint)), size, "rad");
    }
    const auto size = [](const auto& values, Eigen::Index row) {
      return (values.row(row) - values.row(row - 1)).norm();
    };
    if (const auto leaps = orientationLeaps(time_, recording_.quaternion); !leaps.empty())
      report(leaps, examined_.map.quaternion[0], heft::say("The orientation"),
             2.0 * size(recording_.quaternion, leaps.front()), heft::say("rad (about)"));
    if (const auto leaps = positionLeaps(time_, recording_.position); !leaps.empty())
      report(leaps, examined_.map.position[0], heft::say("The position"), size(recording_.position, leaps.front()),
             "m");
  }

  /// A sensor zeroed with the payload on starts at nothing. That is no harm, but surprises whoever compares biases.
  void noteTare() {
    Eigen::Index count = 1;
    while (count < rows_ && time_(count) - time_(0) < 0.05) ++count;
    if (count < 3 || rows_ < 20 * count) return;
    const auto force = recording_.wrench.leftCols<3>();
    const double start = force.topRows(count).colwise().mean().norm();
    constexpr double kSpikes = 0.01;       // Share of the rows at either end that may be spikes
    constexpr double kNearNothing = 0.02;  // Of the range
    // Spikes only widen the range: where it is too narrow with them, they need not be looked for.
    if (start > kNearNothing * (force.colwise().maxCoeff() - force.colwise().minCoeff()).norm()) return;
    double squares = 0.0;
    for (Eigen::Index c = 0; c < 3; ++c) {
      VectorXd y = force.col(c);
      const auto beyond = static_cast<Eigen::Index>(kSpikes * static_cast<double>(rows_));
      std::nth_element(y.begin(), y.begin() + beyond, y.end());
      const double low = y(beyond);
      std::nth_element(y.begin(), y.end() - 1 - beyond, y.end());
      squares += std::pow(y(rows_ - 1 - beyond) - low, 2);
    }
    const double range = std::sqrt(squares);
    if (range < 2.0 || start > kNearNothing * range) return;
    examined_.note(Severity::info, "wrench_tared", examined_.column(examined_.map.wrench[0]),
                   heft::say("The force starts at {:.2g} N and later spans {:.3g} N: the sensor was probably zeroed "
                             "with the payload on.",
                             start, range),
                   heft::say("The estimated bias then includes the weight in that posture."));
  }

  void noteTorqueUnit() {
    const auto spread = [](const auto& block) { return (block.rowwise() - block.colwise().mean()).norm(); };
    const double force = spread(recording_.wrench.leftCols<3>());
    const double torque = spread(recording_.wrench.rightCols<3>());
    if (torque <= 5.0 * force || torque < 1e-9) return;
    examined_.note(Severity::warning, "torque_unit", examined_.column(examined_.map.wrench[3]),
                   heft::say("Torques vary {:.3g} times as much as forces, as if the payload sat {:.3g} m away.",
                             torque / force, torque / force),
                   heft::say("Check that tx, ty, tz are in N m, not N mm, and forces in N."));
  }

  const Examined& examined_;
  const Recording& recording_;
  const Eigen::Index rows_;
  const VectorXd& time_;
  Changes wrenchChanges_;
  Changes motionChanges_;
  std::vector<Channel> wrench_;
};

}  // namespace

void checkSignals(const Examined& examined) { SignalChecker(examined).run(); }

}  // namespace heft
