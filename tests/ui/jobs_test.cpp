#include <gtest/gtest.h>

#include <QSignalSpy>
#include <QTest>
#include <QThread>
#include <atomic>
#include <chrono>
#include <thread>

#include "ui/jobs/job_runner.h"

namespace heft {
namespace {

using namespace std::chrono_literals;

/// Works until it is stopped.
Result<int> endless(const Progress& progress) {
  while (!progress.cancelled()) std::this_thread::sleep_for(1ms);
  return Error{"stopped", true};
}

TEST(JobRunner, ResultArrivesOnTheCallersThread) {
  JobRunner runner;
  QSignalSpy started(&runner, &JobRunner::started), finished(&runner, &JobRunner::finished);
  int value = 0;
  QThread* thread = nullptr;
  std::thread::id worker;
  runner.start(
      "adding",
      [&worker](const Progress&) -> Result<int> {
        worker = std::this_thread::get_id();
        return 41 + 1;
      },
      [&](Result<int> result) {
        value = *result;
        thread = QThread::currentThread();
      });
  EXPECT_TRUE(runner.running());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !runner.running(); }));
  EXPECT_EQ(value, 42);
  EXPECT_EQ(thread, QThread::currentThread());
  EXPECT_NE(worker, std::this_thread::get_id());
  EXPECT_EQ(started.count(), 1);
  EXPECT_EQ(started.at(0).at(0).toString(), "adding");
  EXPECT_EQ(finished.count(), 1);
}

TEST(JobRunner, CancelReachesTheWorkAndIsNoFailure) {
  JobRunner runner;
  bool cancelled = false;
  runner.start("endless", endless, [&](Result<int> result) { cancelled = !result && result.error().cancelled; });
  QTest::qWait(20);
  EXPECT_TRUE(runner.running());
  runner.cancel();
  ASSERT_TRUE(QTest::qWaitFor([&] { return !runner.running(); }, 2000));
  EXPECT_TRUE(cancelled);
}

TEST(JobRunner, TheNextJobReplacesTheOneUnderWay) {
  JobRunner runner;
  bool firstCame = false;
  int second = 0;
  runner.start("first", endless, [&](Result<int>) { firstCame = true; });
  runner.start(
      "second", [](const Progress&) -> Result<int> { return 2; }, [&](Result<int> result) { second = *result; });
  EXPECT_EQ(runner.title(), "second");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !runner.running(); }));
  QTest::qWait(50);
  EXPECT_EQ(second, 2);
  EXPECT_FALSE(firstCame);
}

TEST(JobRunner, ProgressIsReportedInOrder) {
  JobRunner runner;
  std::vector<double> seen;
  QObject::connect(&runner, &JobRunner::progressed, &runner,
                   [&](double fraction, const QString&) { seen.push_back(fraction); });
  runner.start(
      "steps",
      [](const Progress& progress) -> Result<int> {
        for (int i = 0; i <= 10; ++i) {
          progress(i / 10.0, "step");
          std::this_thread::sleep_for(20ms);
        }
        return 0;
      },
      [](Result<int>) {});
  ASSERT_TRUE(QTest::qWaitFor([&] { return !runner.running(); }));
  ASSERT_GE(seen.size(), 2u);
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end()));
  EXPECT_EQ(seen.back(), 1.0);
}

TEST(JobRunner, AnExceptionBecomesTheError) {
  JobRunner runner;
  std::string message;
  runner.start(
      "throws", [](const Progress&) -> Result<int> { throw std::runtime_error("no such luck"); },
      [&](Result<int> result) { message = result.error().message; });
  ASSERT_TRUE(QTest::qWaitFor([&] { return !runner.running(); }));
  EXPECT_NE(message.find("no such luck"), std::string::npos);
}

TEST(JobRunner, DestructionStopsTheWork) {
  std::atomic<bool> ended = false;
  {
    JobRunner runner;
    runner.start(
        "endless",
        [&ended](const Progress& progress) {
          auto result = endless(progress);
          ended = true;
          return result;
        },
        [](Result<int>) { FAIL() << "nobody is there any more"; });
    QTest::qWait(10);
  }
  EXPECT_TRUE(ended);
  QTest::qWait(10);
}

}  // namespace
}  // namespace heft
