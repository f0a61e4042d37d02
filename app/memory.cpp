// Memory of the programs is kept, see core/base/heap.h.
#include "core/base/heap.h"

namespace {

void beforeAll(int, char**, char**) { heft::keepFreedMemory(); }

/// Runs before any library allocates.
[[gnu::section(".preinit_array"), gnu::used]] void (*const kBeforeAll)(int, char**, char**) = &beforeAll;

}  // namespace
