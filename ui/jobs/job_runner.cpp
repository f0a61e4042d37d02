#include "ui/jobs/job_runner.h"

#include <QMetaObject>
#include <QPointer>
#include <chrono>
#include <utility>

#include "core/base/heap.h"

namespace heft {
namespace {

using Clock = std::chrono::steady_clock;

/// Memory that long work has freed goes back to the system, instead of waiting in the allocator for the next.
void giveMemoryBack(Clock::duration worked) {
  constexpr std::chrono::seconds kLong(2);  // Shorter work comes often, and walking the heap takes a moment.
  if (worked < kLong) return;
  giveFreedMemoryBack();
}

}  // namespace

/// Latest progress of the job under way: the worker writes, a timer of the GUI thread reads, so that a chatty worker
/// cannot flood the event queue.
struct JobRunner::Shared {
  std::mutex mutex;
  double fraction = 0.0;
  std::string what;
  bool changed = false;
};

JobRunner::JobRunner(QObject* parent) : QObject(parent) {
  poll_.setInterval(50);
  connect(&poll_, &QTimer::timeout, this, &JobRunner::pollProgress);
}

JobRunner::~JobRunner() {
  for (auto& [ticket, worker] : workers_) worker.request_stop();
  workers_.clear();
}

void JobRunner::launch(const QString& title, Task task) {
  for (auto& [earlier, worker] : workers_) worker.request_stop();
  const quint64 ticket = ++ticket_;
  shared_ = std::make_shared<Shared>();
  title_ = title;
  fraction_ = 0.0;
  running_ = true;
  emit started(title);
  poll_.start();
  workers_[ticket] = std::jthread([this, ticket, shared = shared_,
                                   task = std::move(task)](std::stop_token stop) mutable {
    Progress progress;
    progress.stop = std::move(stop);
    progress.report = [shared](double fraction, std::string_view what) {
      const std::lock_guard lock(shared->mutex);
      shared->fraction = fraction;
      shared->what = what;
      shared->changed = true;
    };
    const auto began = Clock::now();
    auto completion = task(progress);
    giveMemoryBack(Clock::now() - began);
    // `this` is alive here: the destructor joins every worker first. Qt drops the event if the runner dies before it
    // is delivered.
    QMetaObject::invokeMethod(
        this, [this, ticket, completion = std::move(completion)] { finish(ticket, completion); }, Qt::QueuedConnection);
  });
}

void JobRunner::finish(quint64 ticket, const std::function<void()>& completion) {
  workers_.erase(ticket);  // Joins: the worker posted this event as its last act.
  if (ticket != ticket_) return;
  pollProgress();
  poll_.stop();
  running_ = false;
  const QPointer<JobRunner> alive(this);
  completion();
  // The completion may have started the next job; then that one is to be finished, not this.
  if (alive && ticket == ticket_) emit finished();
}

void JobRunner::pollProgress() {
  if (!shared_) return;
  double fraction;
  QString what;
  {
    const std::lock_guard lock(shared_->mutex);
    if (!shared_->changed) return;
    shared_->changed = false;
    fraction = shared_->fraction;
    what = QString::fromStdString(shared_->what);
  }
  fraction_ = fraction;
  emit progressed(fraction, what);
}

void JobRunner::cancel() {
  if (running_) workers_[ticket_].request_stop();
}

}  // namespace heft
