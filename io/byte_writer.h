#pragma once
/// Numbers as text and as bytes, and a file that is written from them in large pieces.

#include <bit>
#include <charconv>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

#include "../geom/context.h"
#include "../geom/result.h"
#include "../geom/vec3.h"
#include "atomic_file.h"

namespace crossloft {

/// Appends the shortest decimal that reads back as the same number, in any locale.
template <class Number>
requires std::integral<Number> || std::floating_point<Number>
void append_decimal(std::string& text, Number value) {
  char digits[32];  // a double takes at most 24 characters
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// Appends "x y z".
inline void append_decimal(std::string& text, const Vec3& p) {
  append_decimal(text, p.x);
  append_decimal(text += ' ', p.y);
  append_decimal(text += ' ', p.z);
}

/// The unsigned integer with the bits of an arithmetic type.
template <class T>
using BitsOf =
    std::conditional_t<sizeof(T) == 8, std::uint64_t,
                       std::conditional_t<sizeof(T) == 4, std::uint32_t,
                                          std::conditional_t<sizeof(T) == 2, std::uint16_t, std::uint8_t>>>;

/// Appends the bytes of a number, the least significant first.
template <class T>
requires std::integral<T> || std::floating_point<T>
void append_little_endian(std::string& bytes, T value) {
  const auto bits = std::bit_cast<BitsOf<T>>(value);
  for (std::size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>((bits >> (8 * i)) & 0xFF);
}

/// Appends to an AtomicFile through a buffer, and ends early when the context is cancelled.
class ByteWriter {
 public:
  ByteWriter(AtomicFile file, const Context& context) : file_(std::move(file)), context_(context) {}

  ByteWriter& text(std::string_view bytes) { return buffer_ += bytes, spill(); }
  template <class T>
  ByteWriter& decimal(const T& value) {
    return append_decimal(buffer_, value), spill();
  }
  template <class T>
  ByteWriter& little_endian(T value) {
    return append_little_endian(buffer_, value), spill();
  }

  /// append(buffer) adds to what is written.
  template <class Append>
  ByteWriter& from(Append&& append) {
    return append(buffer_), spill();
  }

  /// True when nothing more needs to be written, since finish() will fail.
  bool hopeless() const { return cancelled_ || file_.failed(); }

  /// Errors: file_not_writable, cancelled; the target is then as it was.
  Result<Done> finish() {
    if (cancelled_)
      return Error{.code = ErrorCode::cancelled, .message = "writing was cancelled", .file = file_.path()};
    file_.append(buffer_);
    return file_.commit();
  }

 private:
  ByteWriter& spill() {
    constexpr std::size_t kPiece = 1 << 18;
    if (buffer_.size() < kPiece) return *this;
    cancelled_ = cancelled_ || context_.cancelled();
    if (!hopeless()) file_.append(buffer_);
    buffer_.clear();
    return *this;
  }

  AtomicFile file_;
  const Context& context_;
  std::string buffer_;
  bool cancelled_ = false;
};

}  // namespace crossloft
