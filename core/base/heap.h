#pragma once
// How a program's memory is managed.

namespace heft {

/// From now on what was freed is kept for what is allocated next, in one heap for all threads and in pages of 2 MB
/// where the system has them. An estimate and a diagnosis allocate and free matrices of megabytes all the time; where
/// each comes from the system anew, in pages of 4 kB that are zeroed one by one, that is up to a third of their time.
void keepFreedMemory();

/// From the next thread on there are two such heaps: two threads that allocate all the time do not wait for each
/// other's lock, which is a quarter of a diagnosis' time. Costs up to a twentieth of memory. Call it before there is
/// any other thread.
void useTwoHeaps() noexcept;

/// Large pages for the calling thread where it has the second heap. Only advice: a heap that it shares has them
/// already.
void useLargePagesInThread() noexcept;

/// Gives what is free back to the system, as after long work. Walks the heap: milliseconds a gigabyte.
void giveFreedMemoryBack();

}  // namespace heft
