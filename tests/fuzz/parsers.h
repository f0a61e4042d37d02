#pragma once
// Every parser of input that comes from outside, each as a function of bytes: for libFuzzer and for replaying corpora.
#include <cstdint>
#include <span>
#include <string_view>

namespace heft::fuzz {

struct Parser {
  std::string_view name;
  /// Reads the bytes. Whatever they are, it returns; what it reads is checked, and the program aborted if a number that
  /// was accepted is none.
  void (*run)(std::string_view bytes);
};

std::span<const Parser> parsers();

/// Null if there is none of that name.
const Parser* parserNamed(std::string_view name);

}  // namespace heft::fuzz
