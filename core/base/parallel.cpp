#include "core/base/parallel.h"

#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <utility>

#include "core/base/heap.h"

namespace heft {

namespace {

/// The other thread's help is not asked for: it is this one, helps already or is not worth to be woken up.
thread_local bool staysHere = false;

/// A thread that waits for work: to start one each time takes longer than many a piece of work.
class Second {
 public:
  Second() : thread_([this] { run(); }) {}
  ~Second() {
    {
      const std::lock_guard lock(mutex_);
      ends_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }
  Second(const Second&) = delete;
  Second& operator=(const Second&) = delete;

  /// False if it works for somebody else. `work` must stay until takeBack() was called.
  bool give(const std::function<void()>& work) {
    {
      const std::lock_guard lock(mutex_);
      if (state_ != State::waits) return false;
      work_ = &work;
      state_ = State::asked;
    }
    changed_.notify_all();
    return true;
  }

  /// Waits until what was given is done; what was not begun is not done any more. What it threw, or null.
  std::exception_ptr takeBack() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return state_ != State::works; });
    state_ = State::waits;
    return std::exchange(thrown_, nullptr);
  }

 private:
  enum class State { waits, asked, works, done };

  void run() {
    useLargePagesInThread();
    staysHere = true;
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return state_ == State::asked || ends_; });
      if (ends_) return;
      state_ = State::works;
      lock.unlock();
      std::exception_ptr thrown;
      try {
        (*work_)();
      } catch (...) {
        thrown = std::current_exception();
      }
      lock.lock();
      thrown_ = thrown;
      state_ = State::done;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  State state_ = State::waits;
  bool ends_ = false;
  const std::function<void()>* work_ = nullptr;
  std::exception_ptr thrown_;
  std::thread thread_;  ///< The last member: it uses all others
};

}  // namespace

OneThreadScope::OneThreadScope() : before_(std::exchange(staysHere, true)) {}
OneThreadScope::~OneThreadScope() { staysHere = before_; }

namespace detail {

void onBoth(const std::function<void()>& some) {
  static Second second;
  if (staysHere || !second.give(some)) {
    some();
    return;
  }
  std::exception_ptr thrown;
  try {
    const OneThreadScope alone;
    some();
  } catch (...) {
    thrown = std::current_exception();
  }
  const std::exception_ptr other = second.takeBack();
  if (thrown) std::rethrow_exception(thrown);
  if (other) std::rethrow_exception(other);
}

}  // namespace detail

}  // namespace heft
