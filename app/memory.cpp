// How the programs' memory is managed: what was freed is kept for what is allocated next, all in one heap, in pages of
// 2 MB where the system has them. An estimate and a diagnosis allocate and free matrices of megabytes all the time;
// where each comes from the system anew, in pages of 4 kB that are zeroed one by one, that is up to a third of the
// time. What is to go back to the system after a long job is given back by malloc_trim().
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>

namespace {

constexpr std::size_t kLargePage = std::size_t{2} << 20;
/// Address space that gets large pages: an hour at 1 kHz takes 1.7 GB. What is not touched takes no memory.
constexpr std::size_t kLargest = std::size_t{4} << 30, kLeast = std::size_t{64} << 20;

/// Lets the heap have address space at once, since only what it has can be advised of.
void askForLargePages() {
  for (std::size_t size = kLargest; size >= kLeast; size /= 2) {
    void* const room = std::malloc(size);
    if (room == nullptr) continue;  // More than this machine's memory, or than the user's limit
    const auto from = reinterpret_cast<std::uintptr_t>(room) / kLargePage * kLargePage + kLargePage;
    ::madvise(reinterpret_cast<void*>(from), size - kLargePage, MADV_HUGEPAGE);  // NOLINT(performance-no-int-to-ptr)
    std::free(room);
    return;
  }
}

void keepFreedMemory(int, char**, char**) {
  constexpr int kNever = -1;
  mallopt(M_MMAP_MAX, 0);
  mallopt(M_ARENA_MAX, 1);
  mallopt(M_TRIM_THRESHOLD, kNever);
  askForLargePages();
}

/// Runs before any library allocates.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeAll)(int, char**, char**) = &keepFreedMemory;

}  // namespace
