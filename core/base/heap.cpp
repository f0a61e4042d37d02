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

bool keeps = false, hasTwo = false;
/// glibc reserves this much address space for the heap of a thread, at a multiple of it (HEAP_MAX_SIZE in its arena.c).
constexpr std::size_t kThreadHeap = std::size_t{64} << 20;

bool isLimited(int resource) {
  rlimit limit{};
  return ::getrlimit(resource, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY;
}

bool isAddressSpaceScarce() { return isLimited(RLIMIT_AS) || isLimited(RLIMIT_DATA); }

void adviseLargePages(std::uintptr_t from, std::size_t size) {
  ::madvise(reinterpret_cast<void*>(from), size, MADV_HUGEPAGE);  // NOLINT(performance-no-int-to-ptr)
}

/// Lets the heap have address space at once, since only what it has can be advised of. What is not touched takes no
/// memory.
void askForLargePages() {
  constexpr std::size_t kLargePage = std::size_t{2} << 20;
  constexpr std::size_t kMost = std::size_t{4} << 30;  // An hour at 1 kHz takes 1.7 GB.
  if (isAddressSpaceScarce()) return;
  const auto memory = static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::getpagesize());
  const std::size_t size = std::min(kMost, memory / 2);
  void* const room = std::malloc(size);
  if (room == nullptr) return;
  const auto from = reinterpret_cast<std::uintptr_t>(room) / kLargePage * kLargePage + kLargePage;
  if (size > kLargePage) adviseLargePages(from, size - kLargePage);
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

void useTwoHeaps() noexcept {
  if (!keeps || isAddressSpaceScarce()) return;
  mallopt(M_ARENA_MAX, 2);
  mallopt(M_TOP_PAD, static_cast<int>(kThreadHeap));  // Opened whole, so that all of it can be advised of
  hasTwo = true;
}

void useLargePagesInThread() noexcept {
  if (!hasTwo) return;
  void* const first = std::malloc(1);
  adviseLargePages(reinterpret_cast<std::uintptr_t>(first) / kThreadHeap * kThreadHeap, kThreadHeap);
  std::free(first);
}

void giveFreedMemoryBack() {
  malloc_trim(0);
  if (keeps) askForLargePages();  // The heap's end went, and what was advised of it.
}

}  // namespace heft
