#include "core/base/keep_memory.h"

#include <cstdlib>  // Says whether it is glibc

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace heft {

void keepFreedMemory() {
#ifdef __GLIBC__
  constexpr int kMegabyte = 1 << 20;
  mallopt(M_MMAP_THRESHOLD, 32 * kMegabyte);
  mallopt(M_TRIM_THRESHOLD, 256 * kMegabyte);
  mallopt(M_TOP_PAD, 16 * kMegabyte);
#endif
}

}  // namespace heft
