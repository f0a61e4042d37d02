// Memory of the programs comes from mimalloc, in pages of 2 MB where the system has them, and what was freed is kept
// for what is allocated next. A diagnosis allocates and frees matrices of megabytes all the time; where each comes from
// the system anew, in pages of 4 kB that are zeroed one by one, that is a fifth of the time of a short one.
#include <mimalloc.h>

namespace {

void keepLargePages(int, char**, char**) {
  mi_option_disable(mi_option_large_os_pages);
  mi_option_disable(mi_option_page_reset);
  mi_option_set(mi_option_eager_commit_delay, 0);
}

/// Runs before any library allocates: the first of mimalloc's segments, 32 MB each, has such pages, too.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeAll)(int, char**, char**) = &keepLargePages;

}  // namespace
