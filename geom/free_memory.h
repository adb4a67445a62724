#pragma once
/// Memory that was freed, back to the system.

namespace crossloft {

/// Gives back what the allocator holds free in the middle of its heap, where it can (glibc): for the point at
/// which many small things have gone and few large ones will come, which do not fit into what the small ones
/// left. No effect but on the memory of the process and, where it is used again, on time.
void release_free_memory();

}  // namespace crossloft
