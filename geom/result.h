#pragma once
/// Errors are values: `Result<T>` is a T or an Error that says what, and where in the input.

#include <cstdint>
#include <string>
#include <utility>
#include <variant>

#include "ids.h"

namespace crossloft {

enum class ErrorCode : std::uint8_t {
  usage,                  ///< an argument makes no sense (program exit 2)
  file_not_readable,      ///< no such file, no permission, or it vanished while read
  file_not_writable,      ///< the target could not be written whole; it is left as it was
  syntax,                 ///< the text is not of the format
  truncated,              ///< the file ends before its counts say so
  bad_count,              ///< a count that is negative, fractional or absurd
  index_out_of_range,     ///< an edge or component names a vertex that is not there
  not_finite,             ///< NaN or infinity among the coordinates
  zero_normal,            ///< a plane without direction
  off_plane,              ///< a vertex further from its plane than the plane tolerance
  open_chain,             ///< contour edges that do not close
  self_crossing,          ///< contour edges of one plane that cross each other
  contradicting_planes,   ///< the same plane given twice with sections that contradict
  no_plane,               ///< a file without a cutting plane
  too_thin,               ///< contours so close to each other that no triangulation of bearable size follows them
  out_of_memory,          ///< an allocation failed, in builds with exceptions
  not_closed,             ///< a mesh that bounds no solid, where one is needed
  too_large,              ///< over a limit of an index or coordinate type
  cancelled,              ///< the context's cancel flag was raised
  internal,               ///< a broken invariant: a defect of this library (program exit 4)
};

/// What went wrong and where. Fields that do not apply hold 0 (line) or kNone.
struct Error {
  ErrorCode code = ErrorCode::internal;
  std::string message;             ///< one sentence without file or line
  std::string file;                ///< as the user named it
  std::uint32_t line = 0;          ///< 1-based
  std::uint32_t plane = kNone;     ///< 0-based position in the file
  std::uint32_t contour = kNone;   ///< 0-based position in its plane
};

/// An error without a place.
inline Error make_error(ErrorCode code, std::string message) { return {code, std::move(message), {}, 0, kNone, kNone}; }

/// "FILE:LINE: plane 3, contour 1: message", leaving out what does not apply; planes and contours count from 0.
std::string to_string(const Error& error);

template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  /// REQUIRES: ok().
  T& value() & { return *std::get_if<0>(&state_); }
  const T& value() const& { return *std::get_if<0>(&state_); }
  T&& value() && { return std::move(*std::get_if<0>(&state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T* operator->() { return std::get_if<0>(&state_); }
  const T* operator->() const { return std::get_if<0>(&state_); }

  /// REQUIRES: !ok().
  Error& error() & { return *std::get_if<1>(&state_); }
  const Error& error() const& { return *std::get_if<1>(&state_); }

 private:
  std::variant<T, Error> state_;
};

/// The value of an operation that only succeeds or fails: `Result<Done>`.
struct Done {};

}  // namespace crossloft
