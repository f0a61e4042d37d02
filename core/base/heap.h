#pragma once
// How a program's memory is managed.

namespace heft {

/// From now on what was freed is kept for what is allocated next, in one heap for all threads and in pages of 2 MB
/// where the system has them. An estimate and a diagnosis allocate and free matrices of megabytes all the time; where
/// each comes from the system anew, in pages of 4 kB that are zeroed one by one, that is up to a third of their time.
void keepFreedMemory();

/// Gives what is free back to the system, as after long work. Walks the heap: milliseconds a gigabyte.
void giveFreedMemoryBack();

}  // namespace heft
