#pragma once
// What the C library does with memory that was freed.

namespace heft {

/// Keeps freed memory of up to 256 MB for what is allocated next. By default each matrix of more than 128 kB comes from
/// the system anew, zeroed page by page, and goes back to it, which stops the other thread for a moment. For main();
/// does nothing where the C library is not glibc.
void keepFreedMemory();

}  // namespace heft
