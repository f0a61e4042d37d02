// libFuzzer on one parser: fuzz_parsers --parser=NAME CORPUS [libFuzzer's options]
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string_view>

#include "tests/fuzz/parsers.h"

namespace {
const heft::fuzz::Parser* chosen = nullptr;
}

extern "C" int LLVMFuzzerInitialize(int* count, char*** arguments) {
  constexpr std::string_view kOption = "--parser=";
  for (int i = 1; i < *count; ++i) {
    const std::string_view word = (*arguments)[i];
    if (word.starts_with(kOption)) chosen = heft::fuzz::parserNamed(word.substr(kOption.size()));
  }
  if (chosen) return 0;
  std::fputs("Choose one with --parser=NAME:\n", stderr);
  for (const auto& parser : heft::fuzz::parsers())
    std::fprintf(stderr, "  %.*s\n", static_cast<int>(parser.name.size()), parser.name.data());
  std::exit(2);
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  chosen->run({reinterpret_cast<const char*>(data), size});
  return 0;
}
