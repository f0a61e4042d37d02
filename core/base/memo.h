#pragma once
// Answers that cost much, kept for who asks again soon.
#include <algorithm>
#include <cstddef>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>

namespace heft {

/// The latest few answers by what was asked. Safe to share between threads.
template <class Question, class Answer>
class Memo {
 public:
  explicit Memo(std::size_t kept) : kept_(kept) {}

  /// `make(question)`, unless it is known. Two threads that ask for the same at once may both make it.
  template <class Make>
  std::shared_ptr<const Answer> answer(const Question& question, const Make& make) {
    {
      const std::lock_guard lock(mutex_);
      const auto known = std::ranges::find(answers_, question, &Pair::first);
      if (known != answers_.end()) {
        std::rotate(answers_.begin(), known, known + 1);
        return answers_.front().second;
      }
    }
    auto made = std::make_shared<const Answer>(make(question));
    const std::lock_guard lock(mutex_);
    answers_.emplace_front(question, made);
    if (answers_.size() > kept_) answers_.pop_back();
    return made;
  }

  void forget() {
    const std::lock_guard lock(mutex_);
    answers_.clear();
  }

 private:
  using Pair = std::pair<Question, std::shared_ptr<const Answer>>;

  std::size_t kept_;
  std::mutex mutex_;
  std::deque<Pair> answers_;  ///< The latest first
};

}  // namespace heft
