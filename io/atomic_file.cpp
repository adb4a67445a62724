#include "atomic_file.h"

#include <cerrno>
#include <filesystem>
#include <system_error>
#include <utility>

#include "../geom/failing.h"
#include "open_file.h"

namespace crossloft {
namespace {

namespace fs = std::filesystem;

Error not_writable(const std::string& path, const std::string& why) {
  return {.code = ErrorCode::file_not_writable, .message = "cannot be written: " + why, .file = path};
}

/// Creates a file that was not there. `name` becomes the first free ".NAME.N.tmp" beside `target`; exclusive
/// creation keeps concurrent writers apart.
std::FILE* create_beside(const std::string& target, std::string& name) {
  constexpr int kMostTemporaries = 1000;
  const fs::path path(target);
  for (int i = 0; i < kMostTemporaries; ++i) {
    name =
        (path.parent_path() / ("." + path.filename().string() + "." + std::to_string(i) + ".tmp")).string();
    errno = 0;
    std::FILE* file = std::fopen(name.c_str(), "w+bx");
    if (file != nullptr || errno != EEXIST) return file;
  }
  return nullptr;
}

}  // namespace

Result<std::string> link_target(const std::string& path) {
  constexpr int kMostLinks = 40;  // as Linux follows
  std::error_code failure;
  fs::path real = path;
  for (int links = 0; links <= kMostLinks; ++links) {
    // What is there is asked of the system: links of /proc name pipes by what is no path.
    if (fs::exists(real, failure)) {
      const fs::path canonical = fs::canonical(real, failure);
      return failure ? real.string() : canonical.string();
    }
    const fs::path next = fs::read_symlink(real, failure);
    if (failure) return real.string();  // no link, or in a folder that is not there
    real = real.parent_path() / next;
  }
  return not_writable(path, reason(ELOOP));
}

Result<Done> read_pieces(const std::string& path, const std::function<bool(std::string_view)>& take) {
  const auto file = open_to_read(path);
  if (!file) return file.error();
  char buffer[kPieceBytes];
  errno = 0;
  for (std::size_t n = 0; (n = std::fread(buffer, 1, sizeof buffer, file->get())) != 0;)
    if (!take({buffer, n})) return Done{};
  if (std::ferror(file->get()) != 0) return not_readable(path, reason(errno));
  return Done{};
}

Result<std::string> read_file(const std::string& path) {
  return or_out_of_memory([&]() -> Result<std::string> {
    std::string bytes;
    std::error_code unknown;
    const auto size = fs::file_size(path, unknown);
    if (!unknown) bytes.reserve(static_cast<std::size_t>(size));
    const Result<Done> read = read_pieces(path, [&](std::string_view piece) {
      bytes.append(piece);
      return true;
    });
    if (!read.ok()) return read.error();
    return bytes;
  });
}

Result<AtomicFile> AtomicFile::create(const std::string& path) {
  auto target = link_target(path);
  if (!target) return target.error();
  AtomicFile out;
  out.path_ = path;
  out.target_ = std::move(target).value();
  std::error_code ignored;
  const fs::file_status status = fs::status(out.target_, ignored);
  if (fs::is_directory(status)) return not_writable(path, "it is a directory");

  errno = 0;
  if (fs::is_regular_file(status)) {
    // Renaming would replace a target that its owner has made read-only: ask first.
    const OpenFile probe(std::fopen(out.target_.c_str(), "r+b"));
    if (probe == nullptr) return not_writable(path, reason(errno));
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    out.file_ = std::fopen(out.target_.c_str(), "wb");
  } else {
    out.file_ = create_beside(out.target_, out.temporary_);
    if (out.file_ == nullptr) out.temporary_.clear();
  }
  if (out.file_ == nullptr) return not_writable(path, reason(errno));
  if (fs::is_regular_file(status)) fs::permissions(out.temporary_, status.permissions(), ignored);
  return out;
}

AtomicFile::AtomicFile(AtomicFile&& other) noexcept
    : file_(std::exchange(other.file_, nullptr)),
      path_(std::move(other.path_)),
      target_(std::move(other.target_)),
      temporary_(std::exchange(other.temporary_, {})),
      error_(other.error_) {}

AtomicFile::~AtomicFile() { discard(); }

void AtomicFile::discard() {
  if (file_ != nullptr) std::fclose(std::exchange(file_, nullptr));
  if (!temporary_.empty()) std::remove(temporary_.c_str());
  temporary_.clear();
}

void AtomicFile::append(std::string_view bytes) {
  if (failed() || bytes.empty()) return;
  errno = 0;
  if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) error_ = errno != 0 ? errno : EIO;
}

void AtomicFile::overwrite(std::string_view bytes) {
  if (failed()) return;
  errno = 0;
  const bool done = std::fseek(file_, 0, SEEK_SET) == 0 &&
                    std::fwrite(bytes.data(), 1, bytes.size(), file_) == bytes.size() &&
                    std::fseek(file_, 0, SEEK_END) == 0;
  if (!done) error_ = errno != 0 ? errno : EIO;
}

Result<Done> AtomicFile::move_to(AtomicFile& other, const std::function<bool()>& is_cancelled) {
  errno = 0;
  if (!failed() && std::fseek(file_, 0, SEEK_SET) != 0) error_ = errno != 0 ? errno : EIO;
  char buffer[kPieceBytes];
  for (std::size_t n = 0; !failed() && (n = std::fread(buffer, 1, sizeof buffer, file_)) != 0;) {
    if (is_cancelled()) return Error{ErrorCode::cancelled, "writing was cancelled", path_, 0, kNone, kNone};
    other.append({buffer, n});
  }
  if (!failed() && std::ferror(file_) != 0) error_ = errno != 0 ? errno : EIO;
  if (failed()) return not_writable(path_, reason(error_));
  discard();
  return Done{};
}

Result<Done> AtomicFile::commit() {
  errno = 0;
  // Buffered bytes may meet a full disk only here. After a failure the file may have been closed before.
  if (file_ != nullptr && std::fclose(std::exchange(file_, nullptr)) != 0 && !failed())
    error_ = errno != 0 ? errno : EIO;
  std::error_code renamed;
  if (!failed() && !temporary_.empty()) fs::rename(temporary_, target_, renamed);
  if (!failed() && !renamed) {
    temporary_.clear();
    return Done{};
  }
  discard();
  return not_writable(path_, failed() ? reason(error_) : renamed.message());
}

Result<Done> write_file(const std::string& path, std::string_view bytes) {
  return or_out_of_memory([&]() -> Result<Done> {
    Result<AtomicFile> file = AtomicFile::create(path);
    if (!file.ok()) return file.error();
    file->append(bytes);
    return file->commit();
  });
}

}  // namespace crossloft
