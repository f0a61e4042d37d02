#include "core/base/heap.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace heft {

namespace {

bool keeps = false;

bool isLimited(int resource) {
  rlimit limit{};
  return ::getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

/// Lets the heap have address space at once, since only what it has can be advised of. What is not touched takes no
/// memory.
void askForLargePages() {
  constexpr std::size_t kLargePage = std::size_t{2} << 20;
  constexpr std::size_t kMost = std::size_t{4} << 30;          // An hour at 1 kHz takes 1.7 GB.
  if (isLimited(RLIMIT_AS) || isLimited(RLIMIT_DATA)) return;  // Address space is scarce.
  const auto memory = static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::getpagesize());
  const std::size_t size = std::min(kMost, memory / 2);
  void* const room = std::malloc(size);
  if (room == nullptr) return;
  const auto from = reinterpret_cast<std::uintptr_t>(room) / kLargePage * kLargePage + kLargePage;
  if (size > kLargePage)
    ::madvise(reinterpret_cast<void*>(from), size - kLargePage, MADV_HUGEPAGE);  // NOLINT(performance-no-int-to-ptr)
  std::free(room);
}

}  // namespace

void keepFreedMemory() {
  constexpr int kNever = -1;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TRIM_THRESHOLD, kNever);
  askForLargePages();
  keeps = true;
}

void giveFreedMemoryBack() {
  malloc_trim(0);
  if (keeps) askForLargePages();  // The heap's end went, and what was advised of it.
}

}  // namespace heft
