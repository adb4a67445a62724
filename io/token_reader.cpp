#include "token_reader.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>
#include <utility>

namespace crossloft {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::string_view without_plus(std::string_view token) {
  const bool plus = token.size() > 1 && token[0] == '+' && token[1] != '-';
  return plus ? token.substr(1) : token;
}

/// Tells overflow from underflow of a well-formed decimal that std::from_chars calls out of range: the sign
/// of the decimal exponent of its first digit that is not 0.
bool is_huge(std::string_view decimal) {
  std::int64_t magnitude = 0;
  bool in_fraction = false, found = false;
  std::size_t i = decimal[0] == '-' ? 1 : 0;
  for (; i < decimal.size() && (is_digit(decimal[i]) || decimal[i] == '.'); ++i) {
    if (decimal[i] == '.')
      in_fraction = true;
    else if (found)
      magnitude += in_fraction ? 0 : 1;
    else if (decimal[i] != '0')
      found = true;
    else
      magnitude -= in_fraction ? 1 : 0;
  }
  if (i >= decimal.size()) return magnitude > 0;
  const std::string_view digits = without_plus(decimal.substr(i + 1));
  std::int64_t exponent = 0;
  if (!parse_integer(digits, exponent)) return digits[0] != '-';
  return exponent > -magnitude;
}

}  // namespace

std::string quoted(std::string_view token) {
  constexpr std::size_t kMost = 24;
  std::string text = "'";
  for (const char c : token.substr(0, kMost)) text += c >= ' ' && c <= '~' ? c : '?';
  return text + (token.size() > kMost ? "...'" : "'");
}

bool parse_integer(std::string_view token, std::int64_t& value) {
  token = without_plus(token);
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  return error == std::errc() && end == token.data() + token.size();
}

bool parse_real(std::string_view token, double& value) {
  token = without_plus(token);
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (end != token.data() + token.size() || error == std::errc::invalid_argument) return false;
  if (error == std::errc::result_out_of_range) {
    value = is_huge(token) ? std::numeric_limits<double>::infinity() : 0.0;
    if (token[0] == '-') value = -value;
  }
  return true;
}

std::string_view without_byte_order_mark(std::string_view text) {
  return text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
}

TokenReader::TokenReader(std::string_view text, std::string file, char comment)
    : text_(text), file_size_(text.size()), comment_(comment) {
  error_.file = std::move(file);
  at_ = text.size() - without_byte_order_mark(text).size();
}

void TokenReader::fail(ErrorCode code, std::string message) {
  if (!ok_) return;
  ok_ = false;
  error_.code = code;
  error_.message = std::move(message);
  error_.line = token_line_;
}

void TokenReader::enter(std::uint32_t plane, std::uint32_t contour) {
  if (!ok_) return;
  error_.plane = plane;
  error_.contour = contour;
}

/// Moves to the next character of a token; false when the text, or without `over_lines` the line, ends
/// before.
bool TokenReader::skip_blanks(bool over_lines) {
  for (; at_ < text_.size(); ++at_) {
    const char c = text_[at_];
    if (is_line_end(c)) {
      if (!over_lines) return false;
      const bool crlf = c == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
      line_ += crlf ? 0 : 1;
    } else if (begins_comment(c)) {
      while (at_ + 1 < text_.size() && !is_line_end(text_[at_ + 1])) ++at_;
    } else if (!is_blank(c)) {
      return true;
    }
  }
  return false;
}

bool TokenReader::at_end() { return !skip_blanks(true); }

bool TokenReader::at_line_end() { return !skip_blanks(false); }

void TokenReader::skip_line() {
  while (at_ < text_.size() && !is_line_end(text_[at_])) ++at_;
}

std::string_view TokenReader::token(const char* what) {
  if (!ok_) return {};
  const bool found = skip_blanks(true);
  token_line_ = line_;
  if (!found) {
    fail(ErrorCode::truncated, std::string("the file ends where ") + what + " should be");
    return {};
  }
  const std::size_t begin = at_;
  while (at_ < text_.size() && !is_blank(text_[at_]) && !is_line_end(text_[at_]) &&
         !begins_comment(text_[at_]))
    ++at_;
  return text_.substr(begin, at_ - begin);
}

double TokenReader::real(const char* what) {
  const std::string_view text = token(what);
  if (!ok_) return 0;
  double value = 0;
  if (!parse_real(text, value)) {
    fail(ErrorCode::syntax, quoted(text) + " stands where " + what + " should be");
  } else if (!std::isfinite(value)) {
    fail(ErrorCode::not_finite, std::string(what) + " is " + quoted(text) + ", which is no finite number");
  }
  return ok_ ? value : 0;
}

Vec3 TokenReader::point(const char* what) {
  const double x = real(what), y = real(what), z = real(what);
  return {x, y, z};
}

std::uint32_t TokenReader::count_in(std::string_view text, const char* what) {
  // Each item takes more than a byte, so a larger count can't be true; a small one is left to end in
  // "truncated".
  constexpr std::uint64_t kSmall = 1 << 16;
  const auto most =
      static_cast<std::int64_t>(std::min<std::uint64_t>(std::max(kSmall, file_size_), kNone - 1));
  if (!ok_) return 0;
  std::int64_t value = 0;
  double real_value = 0;
  if (parse_integer(text, value) && value >= 0 && value <= most) return static_cast<std::uint32_t>(value);
  if (!parse_real(text, real_value)) {
    fail(ErrorCode::syntax, quoted(text) + " stands where " + what + " should be");
  } else if (real_value > static_cast<double>(most)) {
    fail(ErrorCode::bad_count, std::string(what) + " is " + quoted(text) + ", more than the file can hold");
  } else {
    fail(ErrorCode::bad_count,
         std::string(what) + " is " + quoted(text) + ", which is no whole number from 0 up");
  }
  return 0;
}

std::uint32_t TokenReader::index_in(std::string_view text, const char* what, std::uint32_t size) {
  if (!ok_) return 0;
  std::int64_t value = 0;
  if (!parse_integer(text, value)) {
    fail(ErrorCode::syntax, quoted(text) + " stands where " + what + " should be");
  } else if (value < 0 || value >= static_cast<std::int64_t>(size)) {
    fail(ErrorCode::index_out_of_range, std::string(what) + " is " + quoted(text) + ", but there are " +
                                            std::to_string(size) + ", counted from 0");
  }
  return ok_ ? static_cast<std::uint32_t>(value) : 0;
}

std::int32_t TokenReader::integer(const char* what) {
  const std::string_view text = token(what);
  std::int64_t value = 0;
  if (ok_ && (!parse_integer(text, value) || value < std::numeric_limits<std::int32_t>::min() ||
              value > std::numeric_limits<std::int32_t>::max())) {
    fail(ErrorCode::syntax, quoted(text) + " stands where " + what + " should be");
  }
  return ok_ ? static_cast<std::int32_t>(value) : 0;
}

void TokenReader::expect_end() {
  if (!ok_ || at_end()) return;
  const std::string_view text = token("");
  fail(ErrorCode::syntax, quoted(text) + " follows where the file should end; is a count too small?");
}

std::size_t TokenReader::room_for(std::uint32_t count, std::size_t least_bytes) const {
  return std::min<std::size_t>(count, (text_.size() - at_) / least_bytes + 1);
}

}  // namespace crossloft
