#pragma once
/// Numbers 0, 1, .. for the few vertices that one insertion meets.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "large_pages.h"

namespace crossloft::detail {

/// A sparse set: a vertex is in iff the number noted for it names it, so that clearing forgets all at once.
class LocalVertices {
 public:
  /// For vertices below `count` and the ghost.
  void make_room(std::size_t count) {
    if (number_.size() <= count) resize_in_large_pages(number_, count + 1);
  }
  void clear() { size_ = 0; }
  std::size_t size() const { return size_; }
  std::uint32_t operator[](std::size_t number) const { return vertices_[number]; }
  /// REQUIRES: the vertex is in.
  std::uint32_t number(std::uint32_t vertex) const { return number_[place(vertex)]; }
  /// Room for so many more: an addition asks for nothing.
  void reserve(std::size_t more) {
    if (vertices_.size() < size_ + more) vertices_.resize(2 * (size_ + more));
  }
  /// False if it was in before. Does the same in both cases, since no processor foresees which it is.
  /// REQUIRES: reserved room.
  bool add(std::uint32_t vertex) {
    std::uint32_t& number = number_[place(vertex)];
    // A number left from before is below the length of the list, which never shrinks.
    const auto is_new = static_cast<std::uint32_t>((number >= size_) | (vertices_[number] != vertex));
    number ^= (number ^ size_) & (0u - is_new);
    vertices_[number] = vertex;
    size_ += is_new;
    return is_new != 0;
  }

 private:
  static std::size_t place(std::uint32_t vertex) { return vertex + 1u; }  // the ghost in front

  std::uint32_t size_ = 0;
  std::vector<std::uint32_t> vertices_;  ///< longer than size_
  std::vector<std::uint32_t> number_;
};

}  // namespace crossloft::detail
