#pragma once
// Long work off the GUI thread: it works on a snapshot, reports its progress, and can be cancelled.
#include <QObject>
#include <QString>
#include <QTimer>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>

#include "core/base/progress.h"
#include "core/base/result.h"

namespace heft {

/// Runs one job at a time. Starting another asks the one under way to stop, without waiting, and drops its result. All
/// calls and all signals belong to the thread that owns the runner; only the work itself runs elsewhere, so it must own
/// everything it reads.
class JobRunner : public QObject {
  Q_OBJECT
 public:
  explicit JobRunner(QObject* parent = nullptr);
  /// Stops the work under way and waits for it.
  ~JobRunner() override;

  /// `work(progress)` returns Result<T>; `done(Result<T>)` is called on this thread, also when it was cancelled, but
  /// not when a later job replaced it. An exception that escapes `work` becomes its error.
  template <class Work, class Done>
  void start(const QString& title, Work work, Done done) {
    using R = std::invoke_result_t<Work, const Progress&>;
    launch(title, [work = std::move(work), done = std::move(done)](const Progress& progress) mutable {
      std::shared_ptr<R> result;
      try {
        result = std::make_shared<R>(work(progress));
      } catch (const std::exception& e) {
        result = std::make_shared<R>(Error{std::string("unexpected: ") + e.what()});
      }
      return std::function<void()>([result, done = std::move(done)]() mutable { done(std::move(*result)); });
    });
  }

  bool running() const { return running_; }
  QString title() const { return title_; }
  double fraction() const { return fraction_; }
  void cancel();

 signals:
  void started(const QString& title);
  void progressed(double fraction, const QString& what);
  void finished();

 private:
  struct Shared;
  using Task = std::function<std::function<void()>(const Progress&)>;
  void launch(const QString& title, Task task);
  void finish(quint64 ticket, const std::function<void()>& completion);
  void pollProgress();

  std::shared_ptr<Shared> shared_;
  std::map<quint64, std::jthread> workers_;  ///< By ticket: the newest, and replaced ones that have not noticed yet.
  QTimer poll_;
  QString title_;
  double fraction_ = 0.0;
  quint64 ticket_ = 0;
  bool running_ = false;
};

}  // namespace heft
