#pragma once
/// Choices read from bytes, so that a fuzzer's input and a random generator's numbers make the same scenes.

#include <cstddef>
#include <cstdint>
#include <span>

namespace crossloft::test {

/// Past the end every byte is 0, which is the plainest choice everywhere.
class ByteSource {
 public:
  explicit ByteSource(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  std::uint8_t byte() { return at_ < bytes_.size() ? bytes_[at_++] : 0; }
  /// In [0, n), n at most 256.
  std::uint32_t below(std::uint32_t n) { return byte() % n; }
  /// In [low, high].
  int between(int low, int high) {
    return low + static_cast<int>(below(static_cast<std::uint32_t>(high - low + 1)));
  }
  bool one_in(std::uint32_t n) { return below(n) == n - 1; }
  template <class T, std::size_t N>
  const T& one_of(const T (&items)[N]) {
    return items[below(N)];
  }
  bool empty() const { return at_ >= bytes_.size(); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

}  // namespace crossloft::test
