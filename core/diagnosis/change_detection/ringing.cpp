#include "core/diagnosis/change_detection/ringing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/diagnosis/calibration.h"
#include "core/math/linear_algebra.h"
#include "core/math/statistics.h"

namespace heft::diagnosis {

namespace {

/// Damping. Of what rang, 0.035 at most; what smoothing left of a stop in a clean recording looked like 0.21. A rotor
/// that was switched on looked like 0.004.
constexpr double kShortestRinging = 0.005, kLongestRinging = 0.12;

/// What is left for a while after a stop, a channel a column, each over its usual size; its mean, slope and bend taken
/// off.
struct Window {
  std::size_t contact = 0;
  Eigen::Index from = 0;
  ByChannel left;
  MatrixXd slow;  ///< Orthonormal: what was taken off
  double power = 0.0;
  double setOff = 0.0;  ///< How far the wrench that the model expects jumps just before, in the same unit
};

MatrixXd slowCourses(Eigen::Index count) {
  MatrixXd out(count, 3);
  const VectorXd t = VectorXd::LinSpaced(count, -1.0, 1.0);
  out << VectorXd::Ones(count), t, t.cwiseAbs2();
  return orthonormal(out);
}

/// An orthonormal basis of free swings over a window, its slow courses taken off.
MatrixXd swingsOf(const Window& window, double frequency, double damping, double rateHz) {
  const double w = 2.0 * std::numbers::pi * frequency, fast = w * std::sqrt(1.0 - damping * damping);
  const Eigen::Index count = window.left.rows();
  MatrixXd out(count, 2);
  for (Eigen::Index i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / rateHz, size = std::exp(-damping * w * t);
    out.row(i) << size * std::cos(fast * t), size * std::sin(fast * t);
  }
  out -= window.slow * (window.slow.transpose() * out);
  return orthonormal(out);
}

double explainedBy(const Window& window, double frequency, double damping, double rateHz) {
  return (swingsOf(window, frequency, damping, rateHz).transpose() * window.left).squaredNorm();
}

double explainedBy(const std::vector<Window>& windows, double frequency, double damping, double rateHz) {
  double out = 0.0;
  for (const Window& window : windows) out += explainedBy(window, frequency, damping, rateHz);
  return out;
}

/// From a little after the loudest block of each contact to the next one, or as long as a swing takes to die away.
std::vector<Window> windowsAfter(const std::vector<Contact>& contacts, const Signals& signals, const Wrenches& expected,
                                 const Wrenches& left) {
  constexpr double kSudden = 0.03;  // [s]
  const auto samples = [&](double seconds) { return static_cast<Eigen::Index>(std::lround(seconds * signals.rateHz)); };
  const Eigen::Index m = signals.samplesPerBlock;
  std::vector<Window> out;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    const Stretch& where = contacts[i].blocks;
    Eigen::Index loudest = where.from * m;
    for (Eigen::Index k = loudest; k < std::min(left.cols(), where.to * m); ++k)
      if (left.col(k).squaredNorm() > left.col(loudest).squaredNorm()) loudest = k;
    Window window;
    window.contact = i;
    window.from = loudest + samples(kMoment);
    const Eigen::Index next = i + 1 < contacts.size() ? contacts[i + 1].blocks.from * m : left.cols(),
                       to = std::min(next, window.from + samples(kEvent));
    if (to - window.from < samples(kMoment)) continue;
    window.left = left.middleCols(window.from, to - window.from).transpose();
    window.slow = slowCourses(window.left.rows());
    window.left -= window.slow * (window.slow.transpose() * window.left);
    window.power = window.left.squaredNorm();
    const Eigen::Index begins =
        std::max({Eigen::Index{0}, where.from * m - samples(kMoment), loudest - samples(kEvent)});
    // What changes steadily, however fast, sets nothing swinging.
    const Eigen::Index apart = samples(kSudden);
    for (Eigen::Index k = begins; k + 2 * apart < window.from; ++k)
      window.setOff = std::max(window.setOff,
                               (expected.col(k + 2 * apart) - 2.0 * expected.col(k + apart) + expected.col(k)).norm());
    out.push_back(std::move(window));
  }
  return out;
}

struct Swing {
  double frequencyHz = 0.0, damping = 0.0;
  double explained = -1.0;  ///< Power in all windows together
};

/// The swing that explains most of what is left in the windows; none where it is at the end of what a mount can be.
std::optional<Swing> bestSwing(const std::vector<Window>& windows, double rateHz) {
  Swing out;
  const double fastest = std::min(kStiffestMountHz, 0.45 * rateHz);
  for (double frequency = kSoftestMountHz; frequency < fastest; frequency *= 1.01)
    for (const double damping : {0.01, 0.025, 0.06})
      if (const double explained = explainedBy(windows, frequency, damping, rateHz); explained > out.explained) {
        out.explained = explained;
        out.frequencyHz = frequency;
        out.damping = damping;
      }
  // Closer and closer.
  for (double step = 0.005; step > 1e-5; step *= 0.6)
    for (const double f : {1.0 - step, 1.0, 1.0 + step})
      for (const double d : {1.0 - 30.0 * step, 1.0, 1.0 + 30.0 * step}) {
        const double frequency = std::clamp(out.frequencyHz * f, kSoftestMountHz, fastest),
                     damping = std::clamp(out.damping * d, kShortestRinging, kLongestRinging),
                     explained = explainedBy(windows, frequency, damping, rateHz);
        if (explained <= out.explained) continue;
        out.explained = explained;
        out.frequencyHz = frequency;
        out.damping = damping;
      }
  if (out.frequencyHz <= kSoftestMountHz || out.frequencyHz >= fastest || out.damping <= kShortestRinging ||
      out.damping >= kLongestRinging)
    return std::nullopt;
  return out;
}

}  // namespace

Vector6d usualSpread(const Signals& signals, const Wrenches& left, const std::vector<Contact>& contacts) {
  const std::vector<bool> judged = usableOutside(signals, blocksOf(contacts));
  std::array<std::vector<double>, 6> powers;
  for (Eigen::Index n = 0; n < signals.blocks(); ++n) {
    if (!judged[static_cast<std::size_t>(n)]) continue;
    const Vector6d power =
        left.middleCols(n * signals.samplesPerBlock, signals.samplesPerBlock).rowwise().squaredNorm();
    for (std::size_t c = 0; c < 6; ++c)
      powers[c].push_back(power(static_cast<Eigen::Index>(c)) / static_cast<double>(signals.samplesPerBlock));
  }
  Vector6d out;
  for (std::size_t c = 0; c < 6; ++c)
    out(static_cast<Eigen::Index>(c)) = std::sqrt(powers[c].empty() ? 1.0 : std::max(1e-24, median(powers[c])));
  return out;
}

std::optional<Ringing> ringingIn(const Signals& signals, const Model& model, const std::vector<Contact>& contacts) {
  // Share of what is left after a stop beyond the noise: of mounts 0.93 and more, of bursts of interference 0.8 at
  // most.
  if (signals.rateHz < 2.5 * kSoftestMountHz || contacts.empty()) return std::nullopt;
  const Wrenches expected = predicted(signals, model);
  const Wrenches raw = signals.readings - expected;
  const Vector6d usual = usualSpread(signals, raw, contacts);
  const auto scaled = [&](const Wrenches& w) { return Wrenches(usual.cwiseInverse().asDiagonal() * w); };
  auto windows = windowsAfter(contacts, signals, scaled(expected), scaled(raw));
  std::erase_if(windows, [&](const Window& w) { return w.power < kLoudPower * static_cast<double>(w.left.size()); });
  if (windows.empty()) return std::nullopt;
  const bool alone = windows.size() == 1;
  if (alone && windows.front().power < kLoud * static_cast<double>(windows.front().left.size())) return std::nullopt;

  const auto swing = bestSwing(windows, signals.rateHz);
  if (!swing) return std::nullopt;
  Ringing out;
  out.frequencyHz = swing->frequencyHz;
  out.damping = swing->damping;

  struct Rings {
    const Window* window;
    double explained;
    bool struck;
  };
  std::vector<Rings> all;
  for (const Window& window : windows) {
    const MatrixXd swings = swingsOf(window, out.frequencyHz, out.damping, signals.rateHz);
    const MatrixXd amplitudes = swings.transpose() * window.left;
    const double explained = amplitudes.squaredNorm(),
                 begins = (swings * amplitudes).topRows(4).rowwise().norm().maxCoeff();
    // A jump throws a spring as far beyond where it will rest, and no farther.
    if (explained > kNearlyAll * (window.power - static_cast<double>(window.left.size())))
      all.push_back({&window, explained, begins > window.setOff});
  }
  if (all.empty()) return std::nullopt;
  out.struck = std::ranges::all_of(all, &Rings::struck);
  // What was struck once may be a motor that ran and was switched off.
  if (out.struck && all.size() < 2) return std::nullopt;
  if (!out.struck) std::erase_if(all, &Rings::struck);
  double left = 0.0, count = 0.0;
  for (const Rings& rings : all) {
    const Contact& contact = contacts[rings.window->contact];
    out.evidence += contact.evidence;
    out.when.emplace_back(contact.from, signals.time(rings.window->from + rings.window->left.rows() - 1));
    left += rings.window->power - rings.explained;
    count += static_cast<double>(rings.window->left.size());
  }
  // How far either may be off before the sum of squares grows by what one reading's leaves on average.
  const double unit = left / count;
  const auto deviation = [&](double df, double dd) {
    const double lost = 2.0 * swing->explained -
                        explainedBy(windows, out.frequencyHz + df, out.damping + dd, signals.rateHz) -
                        explainedBy(windows, out.frequencyHz - df, out.damping - dd, signals.rateHz);
    return std::sqrt(2.0 * unit / std::max(lost, 1e-12));
  };
  const double df = 1e-3 * out.frequencyHz, dd = 0.1 * out.damping;
  out.frequencyStd = std::hypot(df * deviation(df, 0.0), kFrequencyError * out.frequencyHz);
  out.dampingStd = std::hypot(dd * deviation(0.0, dd), kEventError * out.damping);
  return out;
}

}  // namespace heft::diagnosis
