#pragma once
/// Files read whole or piece by piece, and files written whole or not at all.

#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <string_view>

#include "../geom/result.h"

namespace crossloft {

/// The bytes of a file. Errors: file_not_readable, with the reason (missing, a directory, no permission).
Result<std::string> read_file(const std::string& path);

/// Records of 24 or of 32 bytes fit without a rest.
inline constexpr std::size_t kPieceBytes = 3 << 14;
/// Hands the bytes of a file to `take` in pieces of kPieceBytes, the last of which may be shorter, until it
/// returns false. Errors: as read_file.
Result<Done> read_pieces(const std::string& path, const std::function<bool(std::string_view)>& take);

/// The file that a write to `path` reaches: links are followed, even where they lead to what is not there
/// yet. Error: file_not_writable, if links lead in a circle.
Result<std::string> link_target(const std::string& path);

/// A file under construction: bytes go to a new file beside the target, which takes the target's name on
/// commit(). Until then, and after any failure, the target is as it was; the destructor removes what was not
/// committed. A link is followed, the permissions of an existing target are kept, and a target that is no
/// regular file (a pipe, /dev/stdout) is written directly. A process that is killed leaves the temporary file
/// (".NAME.N.tmp") behind.
class AtomicFile {
 public:
  static Result<AtomicFile> create(const std::string& path);
  ~AtomicFile();
  AtomicFile(AtomicFile&& other) noexcept;
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;
  AtomicFile& operator=(AtomicFile&&) = delete;

  /// Adds bytes at the end. A failed write is remembered and reported by commit().
  void append(std::string_view bytes);
  bool failed() const { return error_ != 0; }
  /// The target is no regular file, and is being written in its place.
  bool is_direct() const { return temporary_.empty(); }
  /// Replaces the first bytes of the file. REQUIRES: not is_direct(), and no more bytes than it has.
  void overwrite(std::string_view bytes);
  /// Appends all its bytes to another file, piece by piece. REQUIRES: not is_direct(). Errors:
  /// file_not_writable, cancelled, as soon as `is_cancelled` says so.
  Result<Done> move_to(AtomicFile& other, const std::function<bool()>& is_cancelled);
  /// The target, as the user named it.
  const std::string& path() const { return path_; }

  /// Completes the file. Errors: file_not_writable (disk full, no permission); nothing is left behind then.
  Result<Done> commit();

 private:
  AtomicFile() = default;
  void discard();

  std::FILE* file_ = nullptr;
  std::string path_;       ///< as the user named it
  std::string target_;     ///< with links resolved
  std::string temporary_;  ///< empty when the target is written directly
  int error_ = 0;          ///< errno of the first failure
};

/// Writes a whole file at once: create, append, commit.
Result<Done> write_file(const std::string& path, std::string_view bytes);

}  // namespace crossloft
