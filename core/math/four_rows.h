#pragma once
// Four rows of a column at once, in two of a processor's registers or in one.

namespace heft {

/// Sums over rows go in four parts on every machine, so that all find the same.
using FourRows = double __attribute__((vector_size(32)));

/// The same anywhere in memory: Clang takes an alignment below the type's own only from a packed structure.
struct [[gnu::packed, gnu::may_alias]] FourRowsInMemory {
  FourRows rows;
};

[[gnu::always_inline]] inline FourRowsInMemory& inMemory(double* at) {
  return *reinterpret_cast<FourRowsInMemory*>(at);
}
[[gnu::always_inline]] inline const FourRowsInMemory& inMemory(const double* at) {
  return *reinterpret_cast<const FourRowsInMemory*>(at);
}
[[gnu::always_inline]] inline double sumOf(const FourRows& x) { return (x[0] + x[1]) + (x[2] + x[3]); }

namespace detail {

/// Whether one register holds four rows.
inline bool fourRowsFitOneRegister() {
#if defined(__x86_64__)
  static const bool kAvx2 = __builtin_cpu_supports("avx2") != 0;
  return kAvx2;
#else
  return false;
#endif
}

#if defined(__x86_64__)
#define HEFT_FOUR_ROWS_IN_ONE_REGISTER __attribute__((target("avx2")))
#else
#define HEFT_FOUR_ROWS_IN_ONE_REGISTER
#endif

template <class Work>
HEFT_FOUR_ROWS_IN_ONE_REGISTER void inOneRegister(const Work& work) {
  work();
}

#undef HEFT_FOUR_ROWS_IN_ONE_REGISTER

}  // namespace detail

/// Calls work(), which is compiled for processors with a register for four rows, too. It is a lambda that is always
/// inlined, and so is what it calls: the rest is compiled for every processor.
template <class Work>
void withFourRows(const Work& work) {
  if (detail::fourRowsFitOneRegister())
    detail::inOneRegister(work);
  else
    work();
}

}  // namespace heft
