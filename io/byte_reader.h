#pragma once
/// Numbers of either byte order from a block of bytes.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "byte_writer.h"

namespace crossloft {

/// Reads one number after the other. Past the end every read gives 0 and ok() is false.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes, std::endian order = std::endian::little)
      : bytes_(bytes), order_(order) {}

  bool ok() const { return ok_; }
  std::size_t left() const { return bytes_.size() - at_; }

  template <class T>
  T read() {
    if (left() < sizeof(T)) ok_ = false;
    if (!ok_) return T{};
    BitsOf<T> bits = 0;
    for (std::size_t i = 0; i < sizeof(T); ++i) {
      const auto byte = static_cast<unsigned char>(bytes_[at_ + i]);
      const std::size_t place = order_ == std::endian::little ? i : sizeof(T) - 1 - i;
      bits =
          static_cast<BitsOf<T>>(bits | static_cast<BitsOf<T>>(static_cast<BitsOf<T>>(byte) << (8 * place)));
    }
    at_ += sizeof(T);
    return std::bit_cast<T>(bits);
  }

 private:
  std::string_view bytes_;
  std::endian order_;
  std::size_t at_ = 0;
  bool ok_ = true;
};

}  // namespace crossloft
