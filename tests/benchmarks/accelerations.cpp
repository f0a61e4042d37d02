// Compares ways to get accelerations, and ways to do without, by the payloads that come out:
//   accelerations [RECORDINGS=20] [SEED=1] [FOLDER OF MEASURED RECORDINGS]
// Simulated: random tools, 20 s, the Gamma's noise, the arm touching nothing; joint angles with quantised velocities at
// 1 kHz, poses alone (0.1 mm and 0.5 mrad of white noise) at 1 kHz and 100 Hz. Median errors of mass, centre of mass
// and inertia about S. Measured: each half of a recording predicts the other.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>
#include <thread>

#include "core/estimation/estimate.h"
#include "core/estimation/map.h"
#include "core/estimation/triangle.h"
#include "core/math/statistics.h"
#include "core/motion/motion.h"
#include "core/recording/csv_reader.h"
#include "core/simulation/simulate.h"
#include "core/wrench/rows.h"
#include "tests/support/random_tool.h"

namespace heft {
namespace {

namespace fs = std::filesystem;

using Answer = std::optional<Payload>;

Answer withMotion(const Recording& recording, const RobotModel* robot, const MotionOptions& motion,
                  Method method = Method::map) {
  EstimateOptions options;
  options.method = method;
  options.motion = motion;
  options.segments = SegmentMode::all;
  const auto report = estimate(recording, robot, options);
  return report ? Answer(report->payload) : std::nullopt;
}

MotionOptions lowPass(double cutoffHz) {
  MotionOptions options;
  options.cutoffHz = cutoffHz;
  return options;
}

MotionOptions savitzkyGolay(int order, int window) {
  MotionOptions options;
  options.smoothing = SmoothingKind::savitzkyGolay;
  options.order = order;
  options.window = window;
  return options;
}

/// Attenuation correction by simulation and extrapolation (Cook & Stefanski 1994): as much noise again as the positions
/// have is added, and what that changes is taken away from the plain estimate.
Answer extrapolated(const Recording& recording, const RobotModel* robot) {
  const auto plain = withMotion(recording, robot, lowPass(kDefaultCutoffHz));
  if (!plain) return plain;
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  const auto noisier = [&](auto& series) {
    for (Eigen::Index c = 0; c < series.cols(); ++c) {
      // Third differences, which smooth motion hardly reaches; their variance is 20 times the samples'.
      const Eigen::Index n = series.rows();
      if (n < 4) return;
      const VectorXd x = series.col(c);
      const VectorXd third = x.tail(n - 3) - 3 * x.segment(2, n - 3) + 3 * x.segment(1, n - 3) - x.head(n - 3);
      const double sd = std::sqrt(third.squaredNorm() / (20.0 * static_cast<double>(n - 3)));
      for (Eigen::Index i = 0; i < n; ++i) series(i, c) += sd * normal(random);
    }
  };
  constexpr int kDraws = 3;
  Vector10d mean = Vector10d::Zero();
  for (int draw = 0; draw < kDraws; ++draw) {
    Recording copy = recording;
    for (Eigen::Index i = 1; i < copy.quaternion.rows(); ++i)
      if (copy.quaternion.row(i).dot(copy.quaternion.row(i - 1)) < 0.0) copy.quaternion.row(i) *= -1.0;
    noisier(copy.q);
    noisier(copy.dq);
    noisier(copy.position);
    noisier(copy.twist);
    noisier(copy.quaternion);
    for (Eigen::Index i = 0; i < copy.quaternion.rows(); ++i) copy.quaternion.row(i).normalize();
    const auto worse = withMotion(copy, robot, lowPass(kDefaultCutoffHz));
    if (!worse) return std::nullopt;
    mean += toParameters(*worse) / kDraws;
  }
  return fromParameters(2.0 * toParameters(*plain) - mean);
}

/// Rows of the weak form in base axes: 6 a window, [bias | phi | y].
struct WeakRows {
  std::vector<Eigen::Matrix<double, 6, kColumns + 1>> windows;
  MatrixXd whitener;  ///< Of what the overlap makes of white noise: windows x windows
};

/// int w R f = int w'' (m p + R h) - m g int w, and
/// int w [p x R f + R tau] = -int w (m p + R h) x g - int w' [p x (m v + R (omega x h)) + (R h) x v + R I omega]
/// with w = (1 - s^2)^4 on windows of `length` seconds, a quarter apart: no acceleration anywhere.
WeakRows weakRows(const Motion& motion, const Vector3d& gravity, double length) {
  const auto half = static_cast<Eigen::Index>(std::lround(0.5 * length * motion.rateHz));
  const Eigen::Index size = 2 * half + 1, hop = std::max<Eigen::Index>(1, half / 2);
  const double dt = 1.0 / motion.rateHz, scale = motion.rateHz / static_cast<double>(half);
  VectorXd w(size), w1(size), w2(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    const double s = static_cast<double>(i - half) / static_cast<double>(half), u = 1.0 - s * s;
    w(i) = u * u * u * u;
    w1(i) = -8.0 * s * u * u * u * scale;
    w2(i) = (48.0 * s * s * u * u - 8.0 * u * u * u) * scale * scale;
  }
  WeakRows out;
  const auto edge = static_cast<Eigen::Index>(0.1 * static_cast<double>(motion.size()));
  for (Eigen::Index from = edge; from + size <= motion.size() - edge; from += hop) {
    Eigen::Matrix<double, 6, kColumns + 1> A = Eigen::Matrix<double, 6, kColumns + 1>::Zero();
    // Any fixed point serves as the origin of p; a near one keeps force noise out of the torque equation.
    const Vector3d origin = motion.position.middleCols(from, size).rowwise().mean();
    for (Eigen::Index i = 0; i < size; ++i) {
      const Eigen::Index k = from + i;
      const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
      const Vector3d p = motion.position.col(k) - origin, v = motion.velocity.col(k), omega = motion.omega.col(k);
      const Vector3d f = R * motion.wrench.col(k).head<3>(), tau = R * motion.wrench.col(k).tail<3>();
      A.block<3, 3>(0, 0) += w(i) * R;
      A.block<3, 1>(0, 6) += w2(i) * p - w(i) * gravity;
      A.block<3, 3>(0, 7) += w2(i) * R;
      A.block<3, 1>(0, 16) += w(i) * f;
      A.block<3, 3>(3, 0) += w(i) * skew(p) * R;
      A.block<3, 3>(3, 3) += w(i) * R;
      A.block<3, 1>(3, 6) += -w(i) * p.cross(gravity) - w1(i) * p.cross(v);
      A.block<3, 3>(3, 7) += w(i) * skew(gravity) * R - w1(i) * (skew(p) * R * skew(omega) - skew(v) * R);
      Eigen::Matrix<double, 3, 6> L;
      L << omega.x(), omega.y(), omega.z(), 0, 0, 0,  //
          0, omega.x(), 0, omega.y(), omega.z(), 0,   //
          0, 0, omega.x(), 0, omega.y(), omega.z();
      A.block<3, 6>(3, 10) += -w1(i) * R * L;
      A.block<3, 1>(3, 16) += w(i) * (p.cross(f) + tau);
    }
    out.windows.push_back(dt * A);
  }
  const auto count = static_cast<Eigen::Index>(out.windows.size());
  MatrixXd overlap = MatrixXd::Zero(count, count);
  for (Eigen::Index lag = 0; lag * hop < size; ++lag) {
    const double share = w.tail(size - lag * hop).dot(w.head(size - lag * hop)) / w.squaredNorm();
    for (Eigen::Index i = 0; i + lag < count; ++i) overlap(i, i + lag) = overlap(i + lag, i) = share;
  }
  overlap.diagonal().array() += 1e-3;
  out.whitener = overlap.llt().matrixL().solve(MatrixXd::Identity(count, count));
  return out;
}

Answer weakForm(const Recording& recording, const RobotModel* robot, double length) {
  MotionOptions options = lowPass(kDefaultCutoffHz);
  options.outputRateHz = 0.0;
  const auto motion = motionOf(recording, robot, options);
  if (!motion || !motion->originAccelerationKnown) return std::nullopt;
  const WeakRows weak = weakRows(*motion, recording.meta.gravity, length);
  const auto count = static_cast<Eigen::Index>(weak.windows.size());
  if (count < 20) return std::nullopt;
  std::array<MatrixXd, 6> channels;
  for (int c = 0; c < 6; ++c) {
    MatrixXd rows(count, kColumns + 1);
    for (Eigen::Index k = 0; k < count; ++k) rows.row(k) = weak.windows[static_cast<std::size_t>(k)].row(c);
    channels[static_cast<std::size_t>(c)] = weak.whitener.triangularView<Eigen::Lower>() * rows;
  }
  Vector6d sd;
  sd << Vector3d::Constant(0.05), Vector3d::Constant(0.002);
  sd *= std::sqrt(length / motion->rateHz);
  const MapPrior prior = vaguePrior(1.0, Vector3d::Zero());
  MapSolution solution;
  for (int round = 0; round < 3; ++round) {
    TriangleBuilder builder;
    for (int c = 0; c < 6; ++c) builder.add(MatrixXd(channels[static_cast<std::size_t>(c)] / sd(c)));
    solution = solveMap(builder.finish(), prior, true, round == 0 ? Vector10d(Vector10d::Zero()) : solution.v);
    Eigen::Matrix<double, kColumns + 1, 1> x;
    x << -solution.bias, -solution.phi, 1.0;
    for (int c = 0; c < 6; ++c)
      sd(c) =
          std::max(1e-9, (channels[static_cast<std::size_t>(c)] * x).norm() / std::sqrt(static_cast<double>(count)));
  }
  return fromParameters(solution.phi);
}

struct Way {
  const char* name;
  std::function<Answer(const Recording&, const RobotModel*)> run;
};

const std::vector<Way>& ways() {
  const auto smoothed = [](const MotionOptions& motion, Method method = Method::map) {
    return [=](const Recording& recording, const RobotModel* robot) {
      return withMotion(recording, robot, motion, method);
    };
  };
  const auto weak = [](double length) {
    return [=](const Recording& recording, const RobotModel* robot) { return weakForm(recording, robot, length); };
  };
  static const std::vector<Way> list{{"Savitzky-Golay 3/10", smoothed(savitzkyGolay(3, 10))},
                                     {"Savitzky-Golay 5/31", smoothed(savitzkyGolay(5, 31))},
                                     {"Savitzky-Golay 3/51", smoothed(savitzkyGolay(3, 51))},
                                     {"low-pass 25 Hz", smoothed(lowPass(25.0))},
                                     {"low-pass 12 Hz", smoothed(lowPass(12.0))},
                                     {"low-pass 6 Hz", smoothed(lowPass(6.0))},
                                     {"low-pass automatic", smoothed(lowPass(0.0))},
                                     {"weak form 0.2 s", weak(0.2)},
                                     {"weak form 0.5 s", weak(0.5)},
                                     {"tls, noise-scaled", smoothed(lowPass(0.0), Method::tls)},
                                     {"25 Hz, attenuation", extrapolated}};
  return list;
}

enum class Source { joints, poses1000, poses100 };

struct Motions {
  const char* name;
  MotionKind kind;
  double speed;
};
constexpr Motions kMotions[] = {{"excitation", MotionKind::excitation, 1.0},
                                {"pick-and-place", MotionKind::pickAndPlace, 1.0},
                                {"free", MotionKind::free, 1.0},
                                {"slow free", MotionKind::free, 0.3}};

Recording simulated(const Payload& payload, Source source, const Motions& motion, std::mt19937& random) {
  const RobotModel& panda = RobotModel::panda();
  SimulateOptions options;
  options.motion = motion.kind;
  options.speed = motion.speed;
  options.seed = random();
  options.rateHz = source == Source::poses100 ? 100.0 : 1000.0;
  auto result = simulate(panda, payload, options);
  if (!result) throw std::runtime_error(result.error().message);
  Recording recording = std::move(result->recording);
  recording.wrench -= result->contactWrench;
  if (source == Source::joints) return recording;
  const int link = *panda.findLink(options.mount.parent);
  const Isometry3d X_LS = poseFromXyzRpy(options.mount.xyz, options.mount.rpy);
  std::normal_distribution<double> normal;
  const auto noise = [&](double sd) { return Vector3d{sd * normal(random), sd * normal(random), sd * normal(random)}; };
  recording.position.resize(recording.rows(), 3);
  recording.quaternion.resize(recording.rows(), 4);
  for (Eigen::Index k = 0; k < recording.rows(); ++k) {
    const Isometry3d X_BS = panda.linkPose(result->q.row(k).transpose(), link) * X_LS;
    recording.position.row(k) = (X_BS.translation() + noise(1e-4)).transpose();
    recording.quaternion.row(k) =
        Quaterniond(Matrix3d(X_BS.linear() * rotationFromVector(noise(5e-4)))).coeffs().transpose();
  }
  recording.q.resize(0, 0);
  recording.dq.resize(0, 0);
  recording.meta.robot.reset();
  return recording;
}

struct Errors {
  double mass = NAN, com = NAN, inertia = NAN;
};

Errors errorsOf(const Answer& answer, const Payload& truth) {
  if (!answer) return {};
  const Matrix3d I = inertiaAboutOrigin(truth);
  return {100.0 * std::abs(answer->mass / truth.mass - 1.0),
          100.0 * (answer->com - truth.com).norm() / truth.com.norm(),
          100.0 * (inertiaAboutOrigin(*answer) - I).norm() / I.norm()};
}

void compareSimulated(Source source, int recordings, unsigned seed) {
  const std::size_t count = std::size(kMotions) * static_cast<std::size_t>(recordings);
  std::vector<std::vector<Errors>> errors(count, std::vector<Errors>(ways().size()));
  std::atomic<std::size_t> next{0};
  {
    std::vector<std::jthread> workers;
    for (unsigned t = 0; t < std::max(1u, std::thread::hardware_concurrency()); ++t)
      workers.emplace_back([&] {
        for (std::size_t i = next++; i < count; i = next++) {
          std::mt19937 random(seed * 100003u + static_cast<unsigned>(i));
          const Payload truth = test::randomTool(random).payload;
          const Recording recording =
              simulated(truth, source, kMotions[i / static_cast<std::size_t>(recordings)], random);
          for (std::size_t w = 0; w < ways().size(); ++w)
            errors[i][w] = errorsOf(ways()[w].run(recording, &RobotModel::panda()), truth);
        }
      });
  }
  fmt::print("{:<22}", "median errors [%]");
  for (const auto& motion : kMotions) fmt::print("{:>24}", motion.name);
  fmt::print("\n{:<22}", "");
  for (std::size_t m = 0; m < std::size(kMotions); ++m) fmt::print("{:>10}{:>6}{:>8}", "m", "c", "I_S");
  fmt::print("\n");
  for (std::size_t w = 0; w < ways().size(); ++w) {
    fmt::print("{:<22}", ways()[w].name);
    for (std::size_t m = 0; m < std::size(kMotions); ++m) {
      std::vector<double> mass, com, inertia;
      for (std::size_t i = 0; i < static_cast<std::size_t>(recordings); ++i) {
        const Errors& e = errors[m * static_cast<std::size_t>(recordings) + i][w];
        const auto orInfinity = [](double value) { return std::isnan(value) ? INFINITY : value; };
        mass.push_back(orInfinity(e.mass));
        com.push_back(orInfinity(e.com));
        inertia.push_back(orInfinity(e.inertia));
      }
      fmt::print("{:>10.3f}{:>6.2f}{:>8.2f}", median(mass), median(com), median(inertia));
    }
    fmt::print("\n");
  }
  fmt::print("\n");
  std::fflush(stdout);
}

Recording part(const Recording& whole, Eigen::Index from, Eigen::Index count) {
  Recording out = whole;
  const auto cut = [&](auto& series) {
    if (series.rows() > 0) series = series.middleRows(from, count).eval();
  };
  cut(out.time);
  cut(out.q);
  cut(out.dq);
  cut(out.position);
  cut(out.quaternion);
  cut(out.twist);
  cut(out.wrench);
  out.labels.clear();
  out.extra.clear();
  return out;
}

/// Robust scatter of what `answer` misses, mean over the three force and three torque channels, whatever the bias. The
/// same motion (12 Hz) and unsmoothed wrench for every way.
std::pair<double, double> missed(const Answer& answer, const Recording& recording, const RobotModel* robot) {
  const auto motion = motionOf(recording, robot, lowPass(12.0));
  if (!answer || !motion) return {NAN, NAN};
  const WrenchRows rows = rowsOf(*motion, 50.0);
  std::array<std::vector<double>, 6> residual;
  for (Eigen::Index k = 0; k < rows.size(); ++k) {
    const Vector6d r = rows.wrench.col(k) - rows.Y[static_cast<std::size_t>(k)] * toParameters(*answer);
    for (int c = 0; c < 6; ++c) residual[static_cast<std::size_t>(c)].push_back(r(c));
  }
  return {(robustStd(residual[0]) + robustStd(residual[1]) + robustStd(residual[2])) / 3.0,
          (robustStd(residual[3]) + robustStd(residual[4]) + robustStd(residual[5])) / 3.0};
}

void compareMeasured(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".csv") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  for (const auto& file : files) {
    const auto read = readRecording(file);
    if (!read || read->recording.meta.kind == RecordingKind::poses) continue;
    const Eigen::Index half = read->recording.rows() / 2;
    const Recording halves[] = {part(read->recording, 0, half), part(read->recording, half, half)};
    fmt::print("{}\n{:<22}{:>12}{:>14}\n", file.filename().string(), "other half missed by", "force [N]",
               "torque [N m]");
    for (const auto& way : ways()) {
      const auto a = missed(way.run(halves[0], &RobotModel::panda()), halves[1], &RobotModel::panda());
      const auto b = missed(way.run(halves[1], &RobotModel::panda()), halves[0], &RobotModel::panda());
      fmt::print("{:<22}{:>12.4f}{:>14.5f}\n", way.name, 0.5 * (a.first + b.first), 0.5 * (a.second + b.second));
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
}

int run(int argc, char** argv) {
  const int recordings = argc > 1 ? std::stoi(argv[1]) : 20;
  const unsigned seed = argc > 2 ? static_cast<unsigned>(std::stoul(argv[2])) : 1;
  const fs::path folder = argc > 3 ? fs::path(argv[3]) : fs::path(HEFT_SOURCE_DIR) / ".." / "shared" / "realdata";
  fmt::print("{} recordings of 20 s a motion, seed {}\n\njoint angles and quantised velocities, 1 kHz\n", recordings,
             seed);
  compareSimulated(Source::joints, recordings, seed);
  fmt::print("poses, 0.1 mm and 0.5 mrad of noise, 1 kHz\n");
  compareSimulated(Source::poses1000, recordings, seed);
  fmt::print("poses, 0.1 mm and 0.5 mrad of noise, 100 Hz\n");
  compareSimulated(Source::poses100, recordings, seed);
  if (fs::exists(folder)) compareMeasured(folder);
  return 0;
}

}  // namespace
}  // namespace heft

int main(int argc, char** argv) {
  try {
    return heft::run(argc, argv);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
