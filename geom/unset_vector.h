#pragma once
/// Long arrays that several threads fill.

#include <memory>
#include <new>
#include <utility>
#include <vector>

namespace crossloft {

/// resize() leaves numbers as the memory has them.
template <class T>
struct LeavesUnset : std::allocator<T> {
  template <class U>
  struct rebind {
    using other = LeavesUnset<U>;
  };
  LeavesUnset() = default;
  template <class U>
  LeavesUnset(const LeavesUnset<U>&) noexcept {}

  template <class U>
  void construct(U* place) {
    ::new (static_cast<void*>(place)) U;
  }
  template <class U, class... Arguments>
  void construct(U* place, Arguments&&... arguments) {
    std::construct_at(place, std::forward<Arguments>(arguments)...);
  }
};

/// A vector whose memory is first touched by those who fill it: one thread alone would take longer for that
/// than all of them for the filling. REQUIRES: T is a number, or an array of numbers; each is written before
/// it is read.
template <class T>
using UnsetVector = std::vector<T, LeavesUnset<T>>;

}  // namespace crossloft
