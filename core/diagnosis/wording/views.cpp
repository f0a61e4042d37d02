#include "core/diagnosis/wording/views.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <string_view>
#include <utility>

#include "core/base/say.h"
#include "core/diagnosis/causes/catalogue.h"
#include "core/diagnosis/model/noise.h"
#include "core/diagnosis/wording/words.h"
#include "core/math/periodogram.h"

namespace heft::diagnosis {

namespace {

/// Mean square over the judged blocks, a channel each.
Vector6d meanSquare(const DiagnosisSeries& series, const Wrenches& left) {
  Vector6d sum = Vector6d::Zero();
  double count = 0.0;
  for (Eigen::Index n = 0; n < left.cols(); ++n)
    if (series.judged[static_cast<std::size_t>(n)]) {
      sum += left.col(n).cwiseAbs2();
      count += 1.0;
    }
  return sum / std::max(1.0, count);
}

double rateOf(const DiagnosisSeries& series) {
  return series.time.size() > 1 ? 1.0 / (series.time(1) - series.time(0)) : 50.0;
}

}  // namespace

TellingStretch tellingStretch(const DiagnosisSeries& series, const DiagnosedCause& cause) {
  const Family family = infoOf(cause.id).family;
  const double seconds = family == Family::timing ? 0.5 : 4.0;
  if (const auto channel = sentenceChannel(cause))
    return tellingStretch(series, cause.before, cause.after, seconds, *channel, *channel + 1);
  const bool ofForce = (family == Family::externalForce || family == Family::load || family == Family::contact) &&
                       std::ranges::none_of(cause.parameters, [](const CauseParameter& p) {
                         return p.unit.starts_with("N m") || p.name.starts_with("turning");
                       });
  return tellingStretch(series, cause.before, cause.after, seconds, 0, ofForce ? 3 : 6);
}

TellingStretch tellingStretch(const DiagnosisSeries& series, const Wrenches& before, const Wrenches& after,
                              double seconds, int firstChannel, int endChannel) {
  TellingStretch out;
  out.channel = firstChannel;
  const Eigen::Index n = std::min(before.cols(), after.cols());
  if (n < 2) return out;
  const Vector6d was = meanSquare(series, before), is = meanSquare(series, after);
  for (int c = firstChannel + 1; c < endChannel; ++c)
    if (was(c) / std::max(1e-18, is(c)) > was(out.channel) / std::max(1e-18, is(out.channel))) out.channel = c;
  const auto length = std::clamp<Eigen::Index>(static_cast<Eigen::Index>(std::lround(seconds * rateOf(series))), 1, n);
  double sum = 0.0, best = -1e300;
  Eigen::Index start = 0;
  const auto gain = [&](Eigen::Index k) {
    return series.judged[static_cast<std::size_t>(k)]
               ? std::pow(before(out.channel, k), 2) - std::pow(after(out.channel, k), 2)
               : 0.0;
  };
  for (Eigen::Index k = 0; k < n; ++k) {
    sum += gain(k) - (k >= length ? gain(k - length) : 0.0);
    if (k + 1 >= length && sum > best) {
      best = sum;
      start = k + 1 - length;
    }
  }
  out.from = series.time(start);
  out.to = series.time(start + length - 1);
  return out;
}

Spectrum spectrumOf(const DiagnosisSeries& series, bool torque) {
  Spectrum out;
  const double rate = rateOf(series);
  const auto length = static_cast<Eigen::Index>(2.5 * rate);
  const Eigen::Index lines = length / 2;
  VectorXd before = VectorXd::Zero(lines), after = VectorXd::Zero(lines);
  double count = 0.0;
  const Wrenches was = series.measured - series.before, is = series.measured - series.after;
  const auto powerOf = [&](const Wrenches& left, Eigen::Index from) {
    const MatrixXd three = left.block(torque ? 3 : 0, from, 3, length);
    return VectorXd(2.0 / rate * taperedPower(three, lines).colwise().sum().transpose());
  };
  for (Eigen::Index from = 0; from + length <= series.time.size(); from += length / 2) {
    const auto begin = series.judged.begin() + from;
    if (!std::all_of(begin, begin + length, [](bool j) { return j; })) continue;
    count += 1.0;
    before += powerOf(was, from);
    after += powerOf(is, from);
  }
  if (count == 0.0) return out;
  out.before = (before / (3.0 * count)).cwiseSqrt();
  out.after = (after / (3.0 * count)).cwiseSqrt();
  out.frequency.resize(lines);
  for (Eigen::Index k = 0; k < lines; ++k)
    out.frequency(k) = rate * static_cast<double>(k + 1) / static_cast<double>(length);
  std::vector<double> high(out.after.data() + lines / 2, out.after.data() + lines);
  std::nth_element(high.begin(), high.begin() + static_cast<std::ptrdiff_t>(high.size() / 2), high.end());
  out.floor = high.empty() ? 0.0 : high[high.size() / 2];
  return out;
}

VectorXd noiseLevel(const DiagnosisSeries& series, bool torque, const VectorXd& frequency) {
  const double rate = rateOf(series);
  const Noise noise = fitNoise(series.measured - series.after, stretchesOf(series.judged), nullptr);
  VectorXd power = VectorXd::Zero(frequency.size());
  for (std::size_t c = torque ? 3 : 0; c < (torque ? 6u : 3u); ++c) {
    const ArModel& model = noise.channels[c];
    for (Eigen::Index k = 0; k < frequency.size(); ++k) {
      std::complex<double> denominator(1.0);
      for (int j = 0; j < model.order(); ++j)
        denominator -= model.coefficients(j) * std::polar(1.0, -2.0 * M_PI * (j + 1) * frequency(k) / rate);
      power(k) += 2.0 / rate * model.sigma * model.sigma / std::norm(denominator);
    }
  }
  return (power / 3.0).cwiseSqrt();
}

Result<std::vector<Witness>> witnesses(const Recording& recording, const RobotModel* robot) {
  MotionOptions options;
  options.cutoffHz = kDefaultCutoffHz;
  const auto motion = motionOf(recording, robot, options);
  if (!motion) return motion.error();
  const Signals signals = signalsOf(recording, *std::move(motion), robot);
  const Eigen::Index n = signals.size();
  Eigen::Matrix3Xd gravity(3, n), load = signals.kinematics.specificForce;
  for (Eigen::Index k = 0; k < n; ++k)
    gravity.col(k) = signals.R_BS[static_cast<std::size_t>(k)].transpose() * signals.gravity.normalized();
  const Eigen::Matrix3Xd rate = diagnosis::rateOf(gravity, signals.rateHz);
  // What gravity alone would press onto the sensor is taken off again: this is the motion's own part.
  const Eigen::Matrix3Xd inertial = load + signals.gravity.norm() * gravity;
  std::vector<Witness> out;
  const auto add = [&](const char* kind, const char* unit, const Eigen::MatrixXd& rows) {
    constexpr std::array<const char*, 3> kAxis{"_x", "_y", "_z"};
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      VectorXd value(signals.blocks());
      for (Eigen::Index b = 0; b < signals.blocks(); ++b)
        value(b) = rows.row(i).segment(b * signals.samplesPerBlock, signals.samplesPerBlock).mean();
      out.push_back(
          {rows.rows() == 3 ? fmt::format("{}{}", kind, kAxis[static_cast<std::size_t>(i)]) : kind, unit, value});
    }
  };
  Eigen::RowVectorXd time(n);
  for (Eigen::Index k = 0; k < n; ++k) time(k) = signals.time(k);
  add("time", "s", time);
  add("gravity", "", gravity);
  add("gravity-rate", "1/s", rate);
  if (signals.positionKnown) {
    add("position", "m", signals.position);
    add("velocity", "m/s", signals.velocity);
    add("velocity-sign", "", signals.velocity.cwiseSign());
    add("acceleration", "m/s²", inertial);
  }
  add("turning", "rad/s", signals.kinematics.omega);
  add("load", "m/s²", load.colwise().norm());
  return out;
}

std::string witnessWords(const std::string& id) {
  constexpr std::array<std::pair<std::string_view, const char*>, 9> kKinds{
      {{"time", heft::toSay("time")},
       {"gravity", heft::toSay("gravity’s direction, {}")},
       {"gravity-rate", heft::toSay("how gravity’s direction changes, {}")},
       {"position", heft::toSay("position, {}")},
       {"velocity", heft::toSay("velocity, {}")},
       {"velocity-sign", heft::toSay("sign of the velocity, {}")},
       {"acceleration", heft::toSay("acceleration, {}")},
       {"turning", heft::toSay("turning, {}")},
       {"load", heft::toSay("load")}}};
  const auto underscore = id.rfind('_');
  const std::string_view kind = std::string_view(id).substr(0, underscore);
  const std::string axis = underscore == std::string::npos ? "" : id.substr(underscore + 1);
  const auto known = std::ranges::find(kKinds, kind, &std::pair<std::string_view, const char*>::first);
  return known == kKinds.end() ? id : heft::say(fmt::runtime(known->second), axis);
}

double correlation(const DiagnosisSeries& series, const VectorXd& witness, const VectorXd& difference) {
  double n = 0, sx = 0, sy = 0, sxx = 0, syy = 0, sxy = 0;
  for (Eigen::Index k = 0; k < std::min(witness.size(), difference.size()); ++k) {
    if (!series.judged[static_cast<std::size_t>(k)]) continue;
    const double x = witness(k), y = difference(k);
    n += 1, sx += x, sy += y, sxx += x * x, syy += y * y, sxy += x * y;
  }
  const double vx = n * sxx - sx * sx, vy = n * syy - sy * sy;
  return n > 2 && vx > 1e-18 && vy > 1e-18 ? (n * sxy - sx * sy) / std::sqrt(vx * vy) : 0.0;
}

}  // namespace heft::diagnosis
