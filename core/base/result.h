#pragma once
// What a function returns that may fail for reasons outside the program: a value, or one clear sentence.
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

namespace heft {

/// Why something could not be done: what, where and what to do, in one sentence for a person.
struct Error {
  std::string message;
  bool cancelled = false;  ///< The user stopped it: not a failure.
};

/// Holds a T or an Error. Reading the value of a failed result is a bug and throws std::logic_error.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  bool ok() const { return std::holds_alternative<T>(state_); }
  explicit operator bool() const { return ok(); }

  const T& value() const& {
    requireOk();
    return std::get<T>(state_);
  }
  T& value() & {
    requireOk();
    return std::get<T>(state_);
  }
  T&& value() && {
    requireOk();
    return std::get<T>(std::move(state_));
  }
  const T& operator*() const& { return value(); }
  T& operator*() & { return value(); }
  const T* operator->() const { return &value(); }
  T* operator->() { return &value(); }

  const Error& error() const { return std::get<Error>(state_); }

 private:
  void requireOk() const {
    if (!ok()) throw std::logic_error("value of a failed result: " + std::get<Error>(state_).message);
  }
  std::variant<T, Error> state_;
};

}  // namespace heft
