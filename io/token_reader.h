#pragma once
/// White-space separated tokens of a text with the line each stands on, and numbers read from them.
///
/// The first failure is kept with its place; from then on every read gives 0 and ok() is false, so that a
/// parser reads a record and asks once. Numbers don't depend on the locale and are correctly rounded. Line
/// ends are LF, CRLF or CR.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "../geom/result.h"
#include "../geom/vec3.h"

namespace crossloft {

/// Some editors begin a UTF-8 text with one.
std::string_view without_byte_order_mark(std::string_view text);

class TokenReader {
 public:
  /// `comment` starts a comment that goes to the end of the line; 0 means the format has none. The text must
  /// outlive the reader. A UTF-8 byte order mark is skipped.
  TokenReader(std::string_view text, std::string file, char comment = '\0');
  /// For a text from the middle of a file: the line of its first character, and the size of the file.
  void begin_at(std::uint32_t line, std::uint64_t file_size) {
    line_ = token_line_ = line;
    file_size_ = file_size;
  }

  bool ok() const { return ok_; }
  const Error& error() const { return error_; }
  /// Keeps the first failure, at the line of the last token.
  void fail(ErrorCode code, std::string message);

  /// Where messages say the reader is; kNone is nowhere.
  void enter(std::uint32_t plane, std::uint32_t contour = kNone);

  /// 1-based line of the last token.
  std::uint32_t line() const { return token_line_; }
  /// True when no token is left.
  bool at_end();
  /// True when no token is left on this line.
  bool at_line_end();
  void skip_line();
  /// Byte offset just after the last token.
  std::size_t offset() const { return at_; }

  /// The next token. `what` says in messages what was expected, e.g. "a vertex coordinate".
  std::string_view token(const char* what);
  /// A finite number. Errors: syntax, not_finite (also for a decimal beyond the range of a double).
  double real(const char* what);
  Vec3 point(const char* what);
  /// A whole number >= 0. bad_count when negative, fractional, or so large that the file can't hold as many.
  std::uint32_t count(const char* what) { return count_in(token(what), what); }
  /// An index in [0, size). Errors: syntax, index_out_of_range.
  std::uint32_t index(const char* what, std::uint32_t size) { return index_in(token(what), what, size); }
  /// The same for a part of the last token.
  std::uint32_t count_in(std::string_view text, const char* what);
  std::uint32_t index_in(std::string_view text, const char* what, std::uint32_t size);
  std::int32_t integer(const char* what);

  /// Fails with syntax when tokens are left: a file that goes on has a wrong count somewhere.
  void expect_end();

  /// `count`, but no more than the text left can hold of items of at least `least_bytes`: safe to reserve.
  std::size_t room_for(std::uint32_t count, std::size_t least_bytes) const;

 private:
  bool begins_comment(char c) const { return comment_ != '\0' && c == comment_; }
  bool skip_blanks(bool over_lines);

  std::string_view text_;
  std::uint64_t file_size_;
  std::size_t at_ = 0;
  std::uint32_t line_ = 1;
  std::uint32_t token_line_ = 1;
  char comment_;
  bool ok_ = true;
  Error error_;
};

/// A token as it may appear in a message: quoted, cut to 24 characters, without control characters.
std::string quoted(std::string_view token);

/// Numbers of a whole token; false when it is not one, or out of the type's range.
bool parse_integer(std::string_view token, std::int64_t& value);
/// Accepts a leading '+'; values beyond the range become infinite, those below it 0.
bool parse_real(std::string_view token, double& value);

}  // namespace crossloft
