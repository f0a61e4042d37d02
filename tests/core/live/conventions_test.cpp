// Live samples in every convention, as their source gives them, and joints that wrap.
#include <numbers>

#include "core/live/plain_samples.h"
#include "core/live/recorder.h"
#include "core/live/session.h"
#include "core/live/sources.h"
#include "core/motion/sensor_axes.h"
#include "tests/core/import/fixtures.h"
#include "tests/core/live/collected.h"
#include "tests/support/in_conventions.h"

namespace heft {
namespace {

using namespace testing_support;
using LiveConventions = InFolder;
using ::testing::HasSubstr;

/// Rows of a file as a source would send them.
std::vector<LiveSample> samplesOf(const FileNumbers& numbers, MotionForm form) {
  std::vector<LiveSample> out;
  for (const auto& row : numbers.rows) {
    LiveSample sample;
    sample.time = row[0];
    if (form == MotionForm::joints) {
      sample.q.emplace();
      sample.dq.emplace();
      for (std::size_t j = 0; j < 7; ++j) {
        (*sample.q)[j] = row[1 + j];
        (*sample.dq)[j] = row[8 + j];
      }
    } else {
      sample.position = Vector3d(row[1], row[2], row[3]);
      sample.orientation = Quaterniond(row[7], row[4], row[5], row[6]);
    }
    sample.wrench = Eigen::Map<const Vector6d>(row.data() + row.size() - 6);
    out.push_back(sample);
  }
  return out;
}

RecordingMeta metaIn(const nlohmann::json& conventions, const RecordingMeta& rig) {
  Findings findings;
  return *parseMeta(withRig(conventions, rig).dump(), "live.meta.json", ".", findings);
}

TEST_F(LiveConventions, EverySampleComesInThePlainForm) {
  const PlainMotion motion(40);
  const Recording& expected = motion.recording;
  for (const auto& conventions : conventionsToTry()) {
    for (const auto form : {MotionForm::joints, MotionForm::poses}) {
      SCOPED_TRACE(conventions.dump() + (form == MotionForm::joints ? " joints" : " poses"));
      const auto meta = metaIn(conventions, expected.meta);
      const auto plain = PlainSamples::create(meta, form == MotionForm::joints ? &RobotModel::panda() : nullptr);
      ASSERT_TRUE(plain) << plain.error().message;
      const auto samples = samplesOf(numbersIn(conventions, motion, form), form);
      const auto file = folder_ / "live.csv";
      std::filesystem::remove(file);
      std::filesystem::remove(folder_ / "live.meta.json");
      {
        auto recorder = Recorder::create(file, meta);
        ASSERT_TRUE(recorder) << recorder.error().message;
        for (const auto& sample : samples) recorder->add(sample);
      }
      for (std::size_t k = 0; k < samples.size(); ++k) {
        const auto sample = plain->plain(samples[k]);
        ASSERT_TRUE(sample) << sample.error().message;
        const auto row = static_cast<Eigen::Index>(k);
        ASSERT_LT((*sample->wrench - expected.wrench.row(row).transpose()).norm(), 1e-12);
        if (sample->q) {
          ASSERT_LT((Eigen::Map<const VectorXd>(sample->q->data(), 7) - expected.q.row(row).transpose()).norm(), 1e-12);
          ASSERT_LT((Eigen::Map<const VectorXd>(sample->dq->data(), 7) - expected.dq.row(row).transpose()).norm(),
                    1e-12);
        } else {
          ASSERT_LT((*sample->position - expected.position.row(row).transpose()).norm(), 1e-12);
          ASSERT_LT((sample->orientation->coeffs() - expected.quaternion.row(row).transpose()).norm(), 1e-12);
        }
      }
      // The recording holds what came, and its setup file what that means.
      auto read = openRecording(file);
      ASSERT_TRUE(read) << read.error().message;
      ASSERT_TRUE(toSensorAxes(read->recording));
      EXPECT_LT(differenceFrom(motion, read->recording), 1e-12);
    }
  }
}

TEST_F(LiveConventions, SamplesThatDoNotTellThePoseAreRefused) {
  const PlainMotion motion(5);
  const nlohmann::json conventions = {{"sensor", {{"wrench_point", "base"}}}};
  const auto meta = metaIn(conventions, motion.recording.meta);
  const auto plain = PlainSamples::create(meta, nullptr);
  ASSERT_TRUE(plain);
  auto sample = samplesOf(numbersIn(conventions, motion, MotionForm::poses), MotionForm::poses)[0];
  EXPECT_TRUE(plain->plain(sample));
  sample.position.reset();
  EXPECT_THAT(plain->plain(sample).error().message, HasSubstr("do not tell where the sensor is"));
  RecordingMeta elsewhere = meta;
  elsewhere.mount.parent = "tool0";
  EXPECT_THAT(PlainSamples::create(elsewhere, &RobotModel::panda()).error().message, HasSubstr("tool0"));
}

TEST_F(LiveConventions, AReplayIsInThePlainForm) {
  const PlainMotion motion(60);
  const nlohmann::json conventions = {{"sensor", {{"wrench_axes", "base"}, {"torque_unit", "N mm"}}},
                                      {"angle_unit", "deg"}};
  const auto file = write("rec.csv", numbersIn(conventions, motion, MotionForm::joints).csv());
  const auto meta = write("other.json", withRig(conventions, motion.recording.meta).dump());
  Collected collected;
  const auto source = makeLiveSource("replay:" + file.string() + "?speed=100", meta);
  ASSERT_TRUE(source) << source.error().message;
  ASSERT_TRUE((*source)->start(collected.sink()));
  ASSERT_TRUE(collected.reach(60)) << (*source)->status().text;
  (*source)->stop();
  const auto samples = collected.samples();
  for (std::size_t k = 0; k < samples.size(); ++k)
    EXPECT_LT((*samples[k].wrench - motion.recording.wrench.row(static_cast<Eigen::Index>(k)).transpose()).norm(),
              1e-12);
}

TEST(LiveTurns, AreTakenOutBeforeSamplesAreInterpolated) {
  for (const double turn : {2.0 * std::numbers::pi, 360.0}) {
    StreamMerger merger;
    merger.setTurn(turn);
    std::vector<LiveSample> out;
    const auto angle = [&](double t) { return turn * (0.45 + 0.2 * std::sin(t)); };
    for (int k = 0; k < 4000; ++k) {
      const double t = 0.001 * k;
      LiveSample wrench;
      wrench.time = t;
      wrench.wrench = Vector6d::Zero();
      if (k % 7 == 0) merger.add(wrench, out);
      LiveSample joints;
      joints.time = t + 0.0003;
      joints.q = std::array<double, 7>{};
      (*joints.q)[3] = std::remainder(angle(joints.time), turn);
      if (k % 20 == 0) merger.add(joints, out);
    }
    ASSERT_GT(out.size(), 150u);
    for (const auto& sample : out) ASSERT_NEAR((*sample.q)[3], angle(sample.time), 1e-3 * turn);
    EXPECT_EQ(merger.wrapped(), std::vector<int>{3});
  }
}

TEST(LiveTurns, ASessionKnowsThemByTheStatedUnit) {
  class Given : public LiveSource {
   public:
    Result<bool> start(SampleSink sink) override {
      for (int k = 0; k < 100; ++k) {
        LiveSample sample;
        sample.time = 0.01 * k;
        sample.q = std::array<double, 7>{std::fmod(5.0 * k, 360.0)};
        sample.wrench = Vector6d::Zero();
        sink(sample);
      }
      return true;
    }
    void stop() override {}
    SourceStatus status() const override { return {}; }
  };
  LiveSession session;
  Conventions degrees;
  degrees.radPerAngle = std::numbers::pi / 180.0;
  session.setConventions(degrees);
  session.addSource(std::make_unique<Given>());
  ASSERT_TRUE(session.start());
  std::vector<LiveSample> samples;
  session.takeNew(samples);
  ASSERT_EQ(samples.size(), 100u);
  EXPECT_NEAR((*samples.back().q)[0], 495.0, 1e-9);
  EXPECT_EQ(session.status().wrapped, std::vector<int>{0});
}

}  // namespace
}  // namespace heft
