#pragma once
/// How the program wants its heap.

namespace crossloft::cli {

/// Memory that was freed stays with the process to be used again, and the first part of the heap is made of
/// large pages: cells are worked on one after the other, each with some megabytes of its own, and a page
/// fault costs as much as a thousand instructions of work. For a program that ends when its job is done; call
/// it first. glibc on Linux, else no effect.
void prepare_heap();

}  // namespace crossloft::cli
