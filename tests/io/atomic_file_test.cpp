#include "../../io/atomic_file.h"

#include <csignal>
#include <utility>

#include <sys/resource.h>

#include <doctest/doctest.h>

#include "scratch.h"

using namespace crossloft;
namespace fs = std::filesystem;

TEST_CASE("a file is written whole and leaves nothing beside it") {
  const Scratch scratch;
  const std::string bytes("a\0b\r\n\xFF", 6);
  REQUIRE(write_file(scratch.path("f"), bytes).ok());
  CHECK(*read_file(scratch.path("f")) == bytes);
  REQUIRE(write_file(scratch.path("f"), "").ok());
  CHECK(read_file(scratch.path("f"))->empty());
  CHECK(scratch.files() == 1);
}

TEST_CASE("a file is read in pieces of one size, until nobody wants more") {
  const Scratch scratch;
  std::string bytes;
  for (std::size_t i = 0; i < 2 * kPieceBytes + 5; ++i) bytes += static_cast<char>(i * i % 251);
  const std::string path = scratch.add("f", bytes);
  std::string together;
  std::vector<std::size_t> sizes;
  const auto keep = [&](std::string_view piece) {
    together += piece;
    sizes.push_back(piece.size());
    return true;
  };
  REQUIRE(read_pieces(path, keep).ok());
  CHECK(together == bytes);
  CHECK(sizes == std::vector<std::size_t>{kPieceBytes, kPieceBytes, 5});
  int pieces = 0;
  REQUIRE(read_pieces(path, [&](std::string_view) { return ++pieces < 2; }).ok());
  CHECK(pieces == 2);
  CHECK(read_pieces(scratch.path("none"), keep).error().code == ErrorCode::file_not_readable);
  CHECK(read_pieces(scratch.path(), keep).error().code == ErrorCode::file_not_readable);
}

TEST_CASE("without commit the target stays as it was") {
  const Scratch scratch;
  scratch.add("f", "old");
  {
    Result<AtomicFile> file = AtomicFile::create(scratch.path("f"));
    REQUIRE(file.ok());
    file->append("new");
    const AtomicFile moved = std::move(*file);
    CHECK(scratch.files() == 2);
    CHECK(scratch.bytes("f") == "old");
  }
  CHECK(scratch.files() == 1);
  CHECK(scratch.bytes("f") == "old");
}

TEST_CASE("two writers of one target do not meet; the last to commit wins") {
  const Scratch scratch;
  Result<AtomicFile> first = AtomicFile::create(scratch.path("f"));
  Result<AtomicFile> second = AtomicFile::create(scratch.path("f"));
  REQUIRE((first.ok() && second.ok()));
  first->append("first");
  second->append("second");
  CHECK(second->commit().ok());
  CHECK(first->commit().ok());
  CHECK(scratch.bytes("f") == "first");
  CHECK(scratch.files() == 1);
}

TEST_CASE("a full disk is an error that leaves the old file and no other") {
  const Scratch scratch;
  scratch.add("f", "old");
  // A limit on the size of files fails as a full disk does, at the write that meets it.
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  rlimit small = before;
  small.rlim_cur = 1000;
  REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
  const Result<Done> at_close = write_file(scratch.path("f"), std::string(1001, 'x'));
  const Result<Done> at_write = write_file(scratch.path("f"), std::string(1 << 20, 'x'));
  setrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, handler);

  for (const Result<Done>& result : {at_close, at_write}) {
    REQUIRE_FALSE(result.ok());
    CHECK(result.error().code == ErrorCode::file_not_writable);
    CHECK(result.error().file == scratch.path("f"));
  }
  CHECK(scratch.bytes("f") == "old");
  CHECK(scratch.files() == 1);
}

TEST_CASE("targets that can't be written") {
  const Scratch scratch;
  CHECK(write_file(scratch.path("none/f"), "x").error().code == ErrorCode::file_not_writable);
  CHECK(write_file(scratch.path(), "x").error().message == "cannot be written: it is a directory");
  CHECK(write_file("", "x").error().code == ErrorCode::file_not_writable);
  if (fs::exists("/dev/full")) {
    CHECK(write_file("/dev/full", "x").error().code == ErrorCode::file_not_writable);
    CHECK(fs::is_character_file("/dev/full"));
  }
  if (geteuid() != 0) {  // root may write anything
    scratch.add("locked", "old");
    fs::permissions(scratch.path("locked"), fs::perms::owner_read);
    CHECK(write_file(scratch.path("locked"), "x").error().code == ErrorCode::file_not_writable);
    CHECK(scratch.bytes("locked") == "old");
  }
}

TEST_CASE("a link is followed and permissions stay") {
  const Scratch scratch;
  scratch.add("f", "old");
  fs::permissions(scratch.path("f"), fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(scratch.path("f"), scratch.path("link"));
  REQUIRE(write_file(scratch.path("link"), "new").ok());
  CHECK(fs::is_symlink(scratch.path("link")));
  CHECK(scratch.bytes("f") == "new");
  CHECK(fs::status(scratch.path("f")).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

TEST_CASE("a link to what is not there yet is followed") {
  const Scratch scratch;
  fs::create_directory(scratch.path("folder"));
  fs::create_symlink("folder/second", scratch.path("first"));
  fs::create_symlink("../target", scratch.path("folder/second"));
  CHECK(fs::path(*link_target(scratch.path("first"))).lexically_normal() == scratch.path("target"));
  REQUIRE(write_file(scratch.path("first"), "new").ok());
  CHECK(fs::is_symlink(scratch.path("first")));
  CHECK(fs::is_symlink(scratch.path("folder/second")));
  CHECK(scratch.bytes("target") == "new");
  CHECK(scratch.files() == 3);
}

TEST_CASE("links in a circle and into a folder that is not there stay, and are errors") {
  const Scratch scratch;
  fs::create_symlink("b", scratch.path("a"));
  fs::create_symlink("a", scratch.path("b"));
  const Result<Done> circle = write_file(scratch.path("a"), "x");
  REQUIRE_FALSE(circle.ok());
  CHECK(circle.error().code == ErrorCode::file_not_writable);
  CHECK(circle.error().file == scratch.path("a"));
  fs::create_symlink("none/f", scratch.path("c"));
  CHECK(write_file(scratch.path("c"), "x").error().code == ErrorCode::file_not_writable);
  for (const char* link : {"a", "b", "c"}) CHECK(fs::is_symlink(scratch.path(link)));
}

TEST_CASE("files that can't be read say why") {
  const Scratch scratch;
  CHECK(read_file(scratch.path("none")).error().message == "cannot be read: No such file or directory");
  CHECK(read_file(scratch.path()).error().message == "cannot be read: it is a directory");
  if (geteuid() != 0) {
    scratch.add("locked", "x");
    fs::permissions(scratch.path("locked"), fs::perms::none);
    CHECK(read_file(scratch.path("locked")).error().message == "cannot be read: Permission denied");
  }
}
