#pragma once
/// Lists that are filled through a pointer, so that an entry can be written before it is known to count.

#include <cstddef>
#include <vector>

namespace crossloft::detail {

template <class T>
class Scratch {
 public:
  T* begin() { return items_.data(); }
  T* end() { return begin() + size_; }
  const T* begin() const { return items_.data(); }
  const T* end() const { return begin() + size_; }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t i) const { return items_[i]; }

  /// An empty list with room for so many items, one of them written in vain.
  T* restart(std::size_t room) {
    size_ = 0;
    return more(room);
  }
  /// The end of the list, with room for so many more.
  T* more(std::size_t room) {
    if (items_.size() < size_ + room + 1) items_.resize(2 * (size_ + room) + 64);
    return end();
  }
  void end_at(const T* end) { size_ = static_cast<std::size_t>(end - begin()); }

 private:
  std::vector<T> items_;
  std::size_t size_ = 0;
};

}  // namespace crossloft::detail
