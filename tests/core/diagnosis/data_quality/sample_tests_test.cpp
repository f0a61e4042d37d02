// What single readings show.
#include "core/diagnosis/data_quality/sample_tests.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/diagnosis/correction/corrected.h"
#include "core/diagnosis/data_quality/clipping.h"
#include "core/diagnosis/data_quality/coarse_motion.h"
#include "core/diagnosis/data_quality/dead_band.h"
#include "core/diagnosis/data_quality/reported_velocities.h"
#include "core/diagnosis/data_quality/time_stamps.h"
#include "core/estimation/spikes.h"
#include "core/simulation/random.h"
#include "tests/core/diagnosis/fixture.h"

namespace heft::test {
namespace {

std::vector<std::string> directCauses(const Recording& recording) {
  MotionOptions options;
  options.cutoffHz = 25.0;
  const auto motion = motionOf(recording, &RobotModel::panda(), options);
  std::vector<std::string> out;
  for (const auto& direct : diagnosis::sampleTests(recording, *motion, diagnosis::rowFactsOf(recording)))
    out.push_back(direct.cause);
  return out;
}

TEST(SampleTests, SilentOnCleanRecordings) {
  for (const auto motion : {MotionKind::free, MotionKind::excitation, MotionKind::pickAndPlace})
    EXPECT_TRUE(directCauses(aRecording(motion, 11)).empty()) << toString(motion);
}

TEST(SampleTests, EachNamesItsOwn) {
  for (const auto& [effect, cause] :
       std::vector<std::pair<EffectRequest, std::string>>{{{"saturation", "", 6.0}, "saturation"},
                                                          {{"spikes", "", 0.5}, "spikes"},
                                                          {{"spikes", "all-axes", 2.5}, "spikes"},
                                                          {{"derivative_noise", "noisy", 20.0}, "derivative_noise"},
                                                          {{"dropouts", "", 6.0}, "dropouts"},
                                                          {{"dropouts", "zeros", 4.0}, "dropouts"},
                                                          {{"jitter", "", 0.8}, "jitter"},
                                                          {{"quantisation", "", 0.5}, "quantisation"},
                                                          {{"motion_lag", "", 30.0}, "motion_lag"}}) {
    const auto found = directCauses(aRecording(MotionKind::free, 12, {effect}));
    EXPECT_NE(std::find(found.begin(), found.end(), cause), found.end()) << effect.id << "/" << effect.form;
  }
}

TEST(SampleTests, CoarseStepsAreNoEndOfTheRange) {
  for (const double step : {0.5, 1.0, 2.0})
    for (const auto motion : {MotionKind::free, MotionKind::pickAndPlace}) {
      const auto found = directCauses(aRecording(motion, 19, {{"quantisation", "", step}}));
      EXPECT_EQ(std::count(found.begin(), found.end(), "saturation"), 0) << step << " " << toString(motion);
      EXPECT_EQ(std::count(found.begin(), found.end(), "quantisation"), 1) << step << " " << toString(motion);
    }
}

/// Where there are many, one has another three rows away, or stands beside a step of the load.
TEST(SampleTests, SpikesThatHideOneAnotherAreFound) {
  const Recording clean = aRecording(MotionKind::pickAndPlace, 24);
  WrenchSamples wrench = clean.wrench;
  std::uint64_t state = 7;
  const auto drawn = [&] {
    return static_cast<double>((state = state * 6364136223846793005u + 1442695040888963407u) >> 33) / 2147483648.0;
  };
  Eigen::Index spikes = 0;
  for (Eigen::Index i = 10; i + 10 < wrench.rows(); ++i)
    for (int c = 0; c < 6; ++c) {
      if (drawn() > 0.01) continue;
      wrench(i, c) += (drawn() < 0.5 ? -1.0 : 1.0) * (c < 3 ? 10.0 : 0.5);
      ++spikes;
    }
  Eigen::Index replaced = 0;
  const WrenchSamples out = withoutSpikes(wrench, replaced);
  ASSERT_GT(spikes, 500);
  Eigen::Index left = 0;
  for (Eigen::Index i = 10; i + 10 < wrench.rows(); ++i)
    for (int c = 0; c < 6; ++c) left += std::abs(out(i, c) - clean.wrench(i, c)) > (c < 3 ? 5.0 : 0.25) ? 1 : 0;
  EXPECT_LT(static_cast<double>(left), 0.002 * static_cast<double>(spikes));
}

TEST(SampleTests, AFewReadingsAtTheEndOfTheRangeAreSeen) {
  for (const double share : {1.5, 4.0, 12.0})
    for (const auto motion : {MotionKind::free, MotionKind::excitation}) {
      const Recording recording = aRecording(motion, 20, {{"saturation", "hard", share}});
      const auto tops = flatTops(recording.wrench);
      ASSERT_EQ(tops.size(), 1u) << share << " " << toString(motion);
      Eigen::Index rows = 0;
      for (const auto& [from, to] : tops.front().runs) rows += to - from;
      EXPECT_NEAR(static_cast<double>(rows) / static_cast<double>(recording.rows()), 0.01 * share, 0.005 * share);
    }
}

TEST(SampleTests, ReadingsCutOffNowAndThenAreGivenBackOnAverage) {
  const Recording whole = aRecording(MotionKind::free, 21),
                  cut = aRecording(MotionKind::free, 21, {{"saturation", "hard", 8.0}});
  const auto tops = flatTops(cut.wrench);
  ASSERT_EQ(tops.size(), 1u);
  const int c = tops.front().channel;
  const auto given = diagnosis::unclipped(cut.wrench, tops, cut.rateHz());
  double was = 0.0, is = 0.0, back = 0.0;
  for (Eigen::Index i = 0; i < cut.rows(); ++i) {
    if (given.lost[static_cast<std::size_t>(i)] || cut.wrench(i, c) == given.wrench(i, c)) continue;
    was += cut.wrench(i, c) - whole.wrench(i, c);
    is += given.wrench(i, c) - whole.wrench(i, c);
    back += 1.0;
  }
  ASSERT_GT(back, 20.0);
  EXPECT_LT(std::abs(is), 0.25 * std::abs(was));
  // And no reading that was not cut off is changed.
  for (Eigen::Index i = 0; i < cut.rows(); ++i) {
    if (cut.wrench(i, c) != tops.front().level) {
      ASSERT_EQ(cut.wrench.row(i), given.wrench.row(i));
    }
  }
}

TEST(SampleTests, TheLagOfReportedVelocitiesIsWithinItsDeviations) {
  for (const char* form : {"late", "filter", "average"})
    for (const double lag : {15.0, 60.0}) {
      const Recording recording = aRecording(MotionKind::free, 16, {{"motion_lag", form, lag}});
      MotionOptions options;
      options.cutoffHz = 25.0;
      const auto found = diagnosis::reportedVelocities(recording, *motionOf(recording, &RobotModel::panda(), options));
      ASSERT_EQ(found.size(), 1u) << form << " " << lag;
      const auto& value = found.front().parameters.front();
      EXPECT_NEAR(value.value, lag, 3.0 * value.std + 0.02 * lag) << form;
      EXPECT_LT(value.std, 0.1 * lag) << form;
    }
}

TEST(SampleTests, AJumpOfThePostureSaysNothingOfReportedVelocities) {
  for (const auto kind : {MotionKind::free, MotionKind::excitation}) {
    // The motion begins once more, as where two files were joined; the sensor reads with noise of its own.
    Recording recording = aRecording(kind, 31);
    const Eigen::Index half = recording.rows() / 2;
    recording.q.bottomRows(half) = recording.q.topRows(half).eval();
    recording.dq.bottomRows(half) = recording.dq.topRows(half).eval();
    recording.wrench.bottomRows(half) = recording.wrench.topRows(half).eval();
    RandomStream random(7, RandomPurpose::white);
    for (Eigen::Index k = half; k < recording.rows(); ++k)
      for (Eigen::Index c = 0; c < 6; ++c) recording.wrench(k, c) += (c < 3 ? 0.05 : 0.002) * random.normal();
    EXPECT_TRUE(directCauses(recording).empty()) << toString(kind);
    // What is wrong with them is found all the same.
    recording.dq *= 0.8;
    EXPECT_EQ(directCauses(recording), std::vector<std::string>{"derivative_noise"}) << toString(kind);
  }
}

/// A driver hands out its last buffer once more: the readings are those of a quarter of a second before, to the last
/// digit.
TEST(SampleTests, ReadingsHandedOutTwiceAreNoTouch) {
  const Recording whole = aRecording(MotionKind::excitation, 19);
  EXPECT_TRUE(replayedStretches(whole.wrench, 20).empty());
  Recording recording = whole;
  const Eigen::Index back = std::lround(0.25 * recording.rateHz());
  for (const double at : {2.1, 5.4, 8.9}) {
    const Eigen::Index from = std::lround(at * recording.rateHz());
    recording.wrench.middleRows(from, back) = whole.wrench.middleRows(from - back, back);
  }
  const auto runs = replayedStretches(recording.wrench, 20);
  ASSERT_EQ(runs.size(), 3u);
  EXPECT_NEAR(recording.time(runs[1].at.from), 5.4, 0.002);
  EXPECT_EQ(runs[1].at.length(), back);
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "dropouts") << said(report);
  EXPECT_EQ(report.causes.front().when.size(), 3u);
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
}

/// Velocities may be means over a while to either side, which are not late; noise of angles and velocities is no mean.
TEST(SampleTests, MeansOfVelocitiesAreFoundAndNoiseIsNone) {
  Recording recording = aRecording(MotionKind::free, 18);
  MotionOptions options;
  options.cutoffHz = 25.0;
  const MatrixXd q = recording.q;
  RandomStream random(18, RandomPurpose::effect);
  const auto foundWith = [&](Eigen::Index reach) {
    for (Eigen::Index i = 0; i < q.rows(); ++i) {
      const Eigen::Index from = std::max<Eigen::Index>(0, i - reach), to = std::min(q.rows() - 1, i + reach);
      recording.dq.row(i) = (q.row(to) - q.row(from)) / (recording.time(to) - recording.time(from));
      for (Eigen::Index j = 0; j < q.cols(); ++j) {
        recording.q(i, j) = q(i, j) + 2e-5 * random.normal();
        recording.dq(i, j) += 2e-3 * random.normal();
      }
    }
    return diagnosis::reportedVelocities(recording, motionOf(recording, &RobotModel::panda(), options).value());
  };
  EXPECT_TRUE(foundWith(2).empty());
  for (const Eigen::Index reach : {25, 50}) {
    const auto found = foundWith(reach);
    ASSERT_EQ(found.size(), 1u) << reach;
    EXPECT_EQ(found.front().cause, "derivative_noise");
    const auto& window = found.front().parameters.front();
    EXPECT_EQ(window.name, "window");
    EXPECT_NEAR(window.value, 2e3 * static_cast<double>(reach) / recording.rateHz(), 3.0 * window.std) << reach;
  }
}

/// The same of a tool's velocity, where poses were recorded and no joints.
TEST(SampleTests, TheLagOfReportedTwistsIsWithinItsDeviations) {
  const Recording joints = aRecording(MotionKind::free, 17);
  MotionOptions options;
  options.cutoffHz = 25.0;
  options.outputRateHz = 0.0;
  const Motion motion = motionOf(joints, &RobotModel::panda(), options).value();
  Recording poses;
  poses.meta = joints.meta;
  poses.time = VectorXd::LinSpaced(motion.size(), motion.time(0), motion.time(motion.size() - 1));
  poses.wrench = motion.wrench.transpose();
  poses.position = motion.position.transpose();
  poses.quaternion.resize(motion.size(), 4);
  Eigen::Matrix<double, Eigen::Dynamic, 6> twist(motion.size(), 6);
  for (Eigen::Index k = 0; k < motion.size(); ++k) {
    const Matrix3d& R = motion.R_BS[static_cast<std::size_t>(k)];
    poses.quaternion.row(k) = Quaterniond(R).coeffs().transpose();
    twist.row(k) << motion.velocity.col(k).transpose(), (R * motion.omega.col(k)).transpose();
  }
  const auto lagOf = [&](double lag) {
    const double keeps = lag > 0.0 ? std::exp(-1.0 / (motion.rateHz * lag)) : 0.0;
    poses.twist = twist;
    for (Eigen::Index k = 1; k < motion.size(); ++k)
      poses.twist.row(k) = keeps * poses.twist.row(k - 1) + (1.0 - keeps) * twist.row(k);
    return diagnosis::reportedVelocities(poses, motionOf(poses, nullptr, options).value());
  };
  EXPECT_TRUE(lagOf(0.0).empty());
  const auto found = lagOf(0.030);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found.front().cause, "motion_lag");
  EXPECT_NEAR(found.front().parameters.front().value, 30.0, 3.0);
}

TEST(SampleTests, SmoothedReadingsThatStandStillWereNotLost) {
  const auto found = directCauses(aRecording(MotionKind::excitation, 18, {{"low_pass_lag", "average", 50.0}}));
  EXPECT_EQ(std::count(found.begin(), found.end(), "dropouts"), 0);
}

/// Somebody switched a motor on nearby: five times the noise for a few seconds is neither spikes nor anything else.
TEST(SampleTests, NoiseThatIsLouderForAWhileIsNoSpike) {
  Recording recording = aRecording(MotionKind::free, 252);
  RandomStream random(252, RandomPurpose::effect);
  for (Eigen::Index i = recording.rows() / 3; i < recording.rows() / 2; ++i)
    for (Eigen::Index c = 0; c < 6; ++c) recording.wrench(i, c) += (c < 3 ? 0.25 : 0.008) * random.normal();
  EXPECT_EQ(directCauses(recording), std::vector<std::string>{});
  // Single readings far off are spikes there, too.
  for (const double share : {0.2, 0.4, 0.45, 0.7})
    recording.wrench(static_cast<Eigen::Index>(share * static_cast<double>(recording.rows())), 2) += 8.0;
  EXPECT_EQ(directCauses(recording), std::vector<std::string>{"spikes"});
}

/// From row to row the load goes further than the noise does.
TEST(SampleTests, SpikesAreFoundWhereTheLoadMovesFast) {
  const Recording whole = aRecording(MotionKind::excitation, 254);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < whole.rows(); i += static_cast<Eigen::Index>(std::lround(whole.rateHz() / 125.0)))
    kept.push_back(i);
  Recording recording = withRows(whole, kept);
  EXPECT_EQ(directCauses(recording), std::vector<std::string>{});
  Eigen::Index replaced = 0;
  for (int k = 1; k <= 12; ++k) recording.wrench(k * recording.rows() / 13, k % 6) += k % 6 < 3 ? 1.5 : 0.12;
  withoutSpikes(recording.wrench, replaced);
  EXPECT_GE(replaced, 8);
  EXPECT_EQ(directCauses(recording), std::vector<std::string>{"spikes"});
}

/// A file with five digits holds 0.01563 and 0.03125 for one and two steps: many of them are off by more than one
/// digit.
TEST(SampleTests, CoarseStepsAreSeenThroughTheDigitsOfTheFile) {
  Recording recording = aRecording(MotionKind::free, 255);
  constexpr double kStep = 1.0 / 96.0, kDigit = 1e-5;
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (Eigen::Index c = 3; c < 6; ++c)
      recording.wrench(i, c) = kDigit * std::round(kStep * std::round(recording.wrench(i, c) / kStep) / kDigit);
  EXPECT_EQ(directCauses(recording), std::vector<std::string>{"quantisation"});
}

/// Noise that is slow stands still for a sample or two: steps of its own size are not coarse.
TEST(SampleTests, SlowNoiseInUsualStepsIsNotCoarse) {
  Recording recording = aRecording(MotionKind::free, 256);
  const Eigen::MatrixXd readings = recording.wrench;
  RandomStream random(256, RandomPurpose::coloured);
  constexpr double kStep = 0.00125, kStays = 0.85;
  Vector3d slow = Vector3d::Zero();
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    const Eigen::Index from = std::max<Eigen::Index>(0, i - 20),
                       count = std::min(recording.rows() - from, i - from + 21);
    for (Eigen::Index c = 0; c < 3; ++c) {
      slow(c) = kStays * slow(c) + kStep * std::sqrt(1.0 - kStays * kStays) * random.normal();
      const double load = readings.col(3 + c).segment(from, count).mean();
      recording.wrench(i, 3 + c) = kStep * std::round((load + slow(c)) / kStep);
    }
  }
  EXPECT_TRUE(directCauses(recording).empty());
}

/// A driver counts in steps of its own what a coarse converter gives it.
TEST(SampleTests, CoarseStepsAreSeenThroughAFinerConverter) {
  Recording recording = aRecording(MotionKind::free, 255);
  constexpr double kStep = 0.27, kFiner = 0.0125;
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (Eigen::Index c = 0; c < 3; ++c)
      recording.wrench(i, c) = kFiner * std::round(kStep * std::round(recording.wrench(i, c) / kStep) / kFiner);
  EXPECT_EQ(directCauses(recording), std::vector<std::string>{"quantisation"});
}

/// In a hundredth of each channel's readings, and so in six of a hundred rows.
TEST(SampleTests, SpikesOnEachChannelForItself) {
  Recording recording = aRecording(MotionKind::free, 253);
  RandomStream random(253, RandomPurpose::effect);
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    for (Eigen::Index c = 0; c < 6; ++c)
      if (random.chance(0.01)) recording.wrench(i, c) += c < 3 ? 3.0 : 0.2;
  EXPECT_EQ(directCauses(recording), std::vector<std::string>{"spikes"});
}

/// Adds `count` leaps that die away within some 10 ms to the given channels, all at the same moments.
Recording withLeaps(Recording recording, std::uint64_t seed, int count, const std::vector<Eigen::Index>& channels) {
  RandomStream random(seed, RandomPurpose::effect);
  for (int k = 0; k < count; ++k) {
    const auto at = static_cast<Eigen::Index>(random.uniform(0.1, 0.9) * static_cast<double>(recording.rows()));
    for (Eigen::Index i = at; i < at + 30; ++i)
      for (const Eigen::Index c : channels)
        recording.wrench(i, c) += (c < 3 ? 6.0 : 0.4) * std::exp(-static_cast<double>(i - at) / 3.0);
  }
  return recording;
}

/// Of one channel it is electricity; what is felt by several may be a knock.
TEST(SampleTests, ALeapOfOneChannelThatDiesAwayIsASpike) {
  const Recording recording = aRecording(MotionKind::free, 254);
  const Recording leaping = withLeaps(recording, 254, 20, {1});
  EXPECT_EQ(directCauses(leaping), std::vector<std::string>{"spikes"});
  Eigen::Index replaced = 0;
  const auto cleaned = withoutSpikes(leaping.wrench, replaced);
  const double before = (leaping.wrench - recording.wrench).norm(), after = (cleaned - recording.wrench).norm();
  EXPECT_LT(after, 0.4 * before);
  EXPECT_TRUE(directCauses(withLeaps(recording, 254, 20, {1, 3})).empty());
}

/// An arm that jerks now and then is felt by several channels at once; a wire that is loose by one alone, or often.
TEST(SampleTests, AFewLeapsOfSeveralChannelsAreNoSpikes) {
  const auto leaping = [](int count, bool alone) {
    Recording recording = aRecording(MotionKind::free, 256);
    for (int k = 1; k <= count; ++k) {
      const Eigen::Index row = k * recording.rows() / (count + 1);
      recording.wrench(row, 0) += 12.0;
      if (!alone) recording.wrench(row, 4) -= 0.8;
    }
    return directCauses(recording);
  };
  EXPECT_EQ(leaping(4, false), std::vector<std::string>{});
  EXPECT_EQ(leaping(4, true), std::vector<std::string>{"spikes"});
  EXPECT_EQ(leaping(40, false), std::vector<std::string>{"spikes"});
}

TEST(SampleTests, UnevenStampsAreNoLostReadings) {
  EXPECT_EQ(directCauses(aRecording(MotionKind::free, 13, {{"jitter", "", 0.8}})), std::vector<std::string>{"jitter"});
}

TEST(SampleTests, StampsOfAMotionTakenUnevenlyAreRight) {
  const Recording recording = aRecording(MotionKind::free, 14);
  // Every row is where its stamp says; which rows there are is up to chance.
  RandomStream random(14, RandomPurpose::effect);
  std::vector<Eigen::Index> kept;
  for (Eigen::Index i = 0; i < recording.rows(); ++i)
    if (random.chance(0.5)) kept.push_back(i);
  EXPECT_FALSE(diagnosis::unevenStamps(withRows(recording, kept)));
}

TEST(SampleTests, EvenStampsAreThoseOfTheRows) {
  const Recording exact = aRecording(MotionKind::free, 15);
  const Recording late = aRecording(MotionKind::free, 15, {{"jitter", "", 1.5}});
  const auto found = diagnosis::unevenStamps(late);
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->spread, 1.5e-3, 0.3e-3);
  // All of them are late by the mean of the lateness; nothing else is left.
  const VectorXd left = found->even - exact.time;
  EXPECT_LT((left.array() - left.mean()).abs().maxCoeff(), 5e-5);
}

/// Angles that are rounded to a quarter of a degree, or interpolated between a few: accelerations from them are not
/// what they were. Nothing was said of either.
TEST(SampleTests, CoarseAnglesAreNamed) {
  const Recording fine = aRecording(MotionKind::excitation, 16);
  Recording rounded = fine;
  const double step = std::numbers::pi / 720.0;
  rounded.q = (fine.q / step).array().round().matrix() * step;
  Recording lines = fine;
  const auto every = static_cast<Eigen::Index>(0.05 * fine.rateHz());
  for (Eigen::Index i = 0; i < fine.rows(); ++i) {
    const Eigen::Index from = i / every * every, to = std::min(fine.rows() - 1, from + every);
    const double share = to > from ? static_cast<double>(i - from) / static_cast<double>(to - from) : 0.0;
    lines.q.row(i) = (1.0 - share) * fine.q.row(from) + share * fine.q.row(to);
  }
  for (const auto& [recording, parameter, size] : {std::tuple{rounded, "step_angle", 0.25}, {lines, "line", 50.0}}) {
    const auto report = diagnosed(recording);
    const DiagnosedCause* cause = named(report, "derivative_noise");
    ASSERT_NE(cause, nullptr) << said(report);
    const CauseParameter* found = findParameter(cause->parameters, parameter);
    ASSERT_NE(found, nullptr) << parameter;
    EXPECT_NEAR(found->value, size, 0.02 * size);
    EXPECT_NE(cause->sentence.find("ccelerations"), std::string::npos) << cause->sentence;
    EXPECT_FALSE(canApply(report, *cause));
  }
  EXPECT_FALSE(diagnosis::coarseMotion(fine));
}

/// Hardly any reading of one channel was inside the sensor's range: it was refused, as if all of it were contact.
TEST(SampleTests, AChannelCutOffNearlyAlwaysIsStillJudged) {
  Recording recording = aRecording(MotionKind::free, 25);
  std::vector<double> sorted(static_cast<std::size_t>(recording.rows()));
  for (Eigen::Index i = 0; i < recording.rows(); ++i) sorted[static_cast<std::size_t>(i)] = recording.wrench(i, 2);
  std::ranges::sort(sorted);
  const double level = sorted[sorted.size() / 6];
  for (Eigen::Index i = 0; i < recording.rows(); ++i) recording.wrench(i, 2) = std::min(recording.wrench(i, 2), level);
  DiagnoseOptions options;
  options.surrogates = 0;
  const auto report = diagnose(recording, &RobotModel::panda(), options);
  ASSERT_TRUE(report.ok()) << report.error().message;
  EXPECT_EQ(report->causes.front().id, "saturation") << said(*report);
  EXPECT_EQ(std::ranges::count(report->causes, "saturation", &DiagnosedCause::id), 1) << said(*report);
}

/// A driver that gives zero for what is small made spikes and touches; a coarse converter's zero is a step like others.
TEST(SampleTests, ADeadBandIsUnknownAndACoarseZeroIsNone) {
  Recording recording = aRecording(MotionKind::free, 304);
  auto fx = recording.wrench.col(0);
  const double width = 0.1 * fx.cwiseAbs().maxCoeff();
  for (Eigen::Index i = 0; i < fx.size(); ++i)
    fx(i) = (std::abs(fx(i)) < width ? 0.0 : fx(i)) - 0.7;  // The zero was set afterwards
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "readings that stick at one value") << said(report);
  EXPECT_TRUE(report.causes.empty()) << said(report);
  EXPECT_TRUE(finds(report, "dead_band"));

  Recording coarse = aRecording(MotionKind::free, 304);
  for (Eigen::Index c = 0; c < 6; ++c) {
    const double step = 0.02 * coarse.wrench.col(c).cwiseAbs().maxCoeff();
    coarse.wrench.col(c) = (coarse.wrench.col(c) / step).array().round().matrix() * step;
  }
  EXPECT_FALSE(finds(diagnosed(coarse), "dead_band"));
}

TEST(SampleTests, AChannelThatNeverChangesIsSaid) {
  Recording recording = aRecording(MotionKind::free, 304);
  recording.wrench.col(5).setConstant(0.012);
  const auto report = diagnose(recording, &RobotModel::panda(), {});
  ASSERT_FALSE(report);
  EXPECT_NE(report.error().message.find("tz stays the same in nearly all rows"), std::string::npos)
      << report.error().message;
}

/// A light tool's torque that hardly leaves one step of a coarse converter is known as well as the step is wide: its
/// channel is judged, and is no channel without noise, at the end of its range or at a standstill.
TEST(SampleTests, AChannelWithinOneCoarseStepIsJudged) {
  const Recording fine = aRecording(MotionKind::free, 304);
  Recording recording = fine;
  const auto tz = fine.wrench.col(5);
  const double step = 1.2 * (tz.maxCoeff() - tz.minCoeff()), from = tz.minCoeff() - 0.55 * step;
  for (int c = 0; c < 6; ++c) {
    const double of = c < 3 ? 0.5 : step;
    recording.wrench.col(c) = ((fine.wrench.col(c).array() - from) / of).round().matrix() * of;
  }
  ASSERT_EQ(recording.wrench.col(5).maxCoeff(), recording.wrench.col(5).minCoeff());
  const auto report = diagnosed(recording);
  EXPECT_NE(named(report, "quantisation"), nullptr) << said(report);
  EXPECT_LT(report.remaining.gain, 1.0) << said(report);
  const Vector3d off = (report.after.payload.com - aTool().com).cwiseAbs();
  EXPECT_LT(off(0), 4.0 * report.after.std.com(0));
  EXPECT_LT(off(1), 4.0 * report.after.std.com(1));

  // Where the others come in finer steps, it was not measured.
  recording.wrench.middleCols<2>(3) = fine.wrench.middleCols<2>(3);
  EXPECT_FALSE(diagnose(recording, &RobotModel::panda(), {}));
}

/// A driver that takes off what is small leaves a channel at zero wherever its load is less: that is no end of its
/// range, though it reads nothing below.
TEST(SampleTests, ZeroIsNoEndOfARange) {
  Recording recording = aRecording(MotionKind::free, 304);
  auto tx = recording.wrench.col(3);
  const double middle = 0.5 * (tx.maxCoeff() + tx.minCoeff());
  tx = (tx.array() - middle).max(0.0);
  EXPECT_TRUE(diagnosis::rowFactsOf(recording).tops.empty());
  tx.array() += 0.2;
  EXPECT_FALSE(diagnosis::rowFactsOf(recording).tops.empty());
}

/// Positions in steps of 2 mm under a little noise: no two readings are the same, and a step is rare from row to row.
TEST(SampleTests, CoarsePositionsUnderNoiseAreNamed) {
  Recording recording = asPoses(aRecording(MotionKind::free, 17));
  RandomStream random(17, RandomPurpose::encoder);
  for (double& p : recording.position.reshaped()) p = 0.002 * std::round(p / 0.002) + 2e-5 * random.normal();
  recording.twist.resize(0, 0);
  const auto report = diagnosed(recording);
  EXPECT_NE(named(report, "derivative_noise"), nullptr) << said(report);
}

/// One channel stands still for a second and a half, the others go on: it was nothing.
TEST(SampleTests, AChannelThatFreezesForAWhileIsUnknown) {
  const Recording whole = aRecording(MotionKind::free, 304);
  Recording recording = whole;
  Eigen::Index at = 0;
  for (Eigen::Index i = 0; i < recording.rows(); ++i) {
    if (recording.time(i) < 5.0) at = i;
    if (recording.time(i) > 5.0 && recording.time(i) < 6.5) recording.wrench(i, 4) = recording.wrench(at, 4);
  }
  const auto report = diagnosed(recording);
  EXPECT_EQ(report.verdict, Verdict::unexplained) << said(report);
  EXPECT_EQ(report.remaining.goesWith, "readings that stick at one value") << said(report);
  const auto frozen = diagnosis::frozenChannel(recording, {}, Vector6d::Zero());
  ASSERT_TRUE(frozen);
  EXPECT_EQ(frozen->channel, 4);
  EXPECT_NEAR(frozen->from, 5.0, 0.01);
  EXPECT_NEAR(frozen->to, 6.5, 0.01);
  EXPECT_FALSE(diagnosis::frozenChannel(whole, {}, Vector6d::Zero()));
  // Rows that were handed out again as a whole are lost readings.
  Recording held = whole;
  for (Eigen::Index i = 1; i < held.rows(); ++i)
    if (held.time(i) > 5.0 && held.time(i) < 6.5) held.wrench.row(i) = held.wrench.row(i - 1);
  EXPECT_FALSE(diagnosis::frozenChannel(held, {}, Vector6d::Zero()));
}

/// Angles that stall for a hundredth of a second, five times, under readings that go on: that was told by nobody, since
/// sharp motion is expected to fit badly.
TEST(SampleTests, AMotionThatStallsIsToldAndPutBack) {
  const Recording still = aRecording(MotionKind::excitation, 366);
  Recording recording = still;
  const auto length = static_cast<Eigen::Index>(0.01 * recording.rateHz());
  for (const double at : {2.0, 3.7, 5.5, 7.1, 9.3}) {
    const auto from = static_cast<Eigen::Index>(at * recording.rateHz());
    for (Eigen::Index i = from; i < from + length; ++i) {
      recording.q.row(i) = recording.q.row(from - 1);
      if (recording.dq.rows() > 0) recording.dq.row(i) = recording.dq.row(from - 1);
    }
  }
  ASSERT_EQ(diagnosed(still).verdict, Verdict::clean);
  const auto report = diagnosed(recording);
  ASSERT_EQ(report.causes.size(), 1u) << said(report);
  EXPECT_EQ(report.causes.front().id, "dropouts");
  EXPECT_EQ(report.verdict, Verdict::explained) << said(report);
  const CauseParameter* share = findParameter(report.causes.front().parameters, "motion_repeated");
  ASSERT_NE(share, nullptr);
  EXPECT_NEAR(share->value, 100.0 * 5.0 * 0.01 / 12.0, 0.1);
}

/// Steps of an eighth of the load and more: what they hide goes with the load, as crosstalk and gains do.
TEST(CoarseSteps, WhatStepsHideIsNoCause) {
  const std::pair<std::uint64_t, double> cases[] = {{14, 1.5}, {15, 1.2}, {22, 2.0}, {32, 2.0}, {34, 1.5}, {36, 1.2}};
  for (const auto& [seed, step] : cases) {
    const auto report = diagnosed(aRecording(MotionKind::pickAndPlace, seed, {{"quantisation", "", step}}));
    for (const auto& cause : report.causes)
      EXPECT_TRUE(cause.id == "quantisation" || cause.id == "contact") << seed << ": " << said(report);
    EXPECT_NE(named(report, "quantisation"), nullptr) << seed << ": " << said(report);
  }
}

TEST(CoarseSteps, WhatGoesBeyondThemIsOne) {
  for (const auto& [effect, size] : {std::pair{"cable_pull", 8.0}, {"coulomb_friction", 2.0}, {"hysteresis", 10.0}}) {
    const auto report = diagnosed(aRecording(MotionKind::free, 41, {{"quantisation", "", 1.5}, {effect, "", size}}));
    EXPECT_NE(named(report, effect), nullptr) << effect << ": " << said(report);
    EXPECT_NE(named(report, "quantisation"), nullptr) << effect << ": " << said(report);
  }
}

/// A channel that reads two or three values in all stands at one of them most of the time.
TEST(CoarseSteps, TheLastOfAFewLevelsIsNoEndOfTheRange) {
  for (const std::uint64_t seed : {23u, 35u, 39u})
    EXPECT_TRUE(flatTops(aRecording(MotionKind::pickAndPlace, seed, {{"quantisation", "", 2.0}}).wrench).empty())
        << seed;
}

}  // namespace
}  // namespace heft::test
