// A surface written piece by piece is the surface written at once.
#include "../../io/surface_stream.h"

#include <doctest/doctest.h>
#include <sys/resource.h>

#include <algorithm>
#include <csignal>
#include <filesystem>
#include <string>

#include "../../inspect/solids.h"
#include "../../io/atomic_file.h"
#include "../../io/read_mesh.h"
#include "../../io/write_mesh.h"
#include "scratch.h"

using namespace crossloft;

namespace {

namespace fs = std::filesystem;

/// Hands the surface on in pieces of some points and then some triangles of these.
Result<Done> take(SurfaceStream& stream, const Surface& surface, std::size_t pieces) {
  std::vector<std::array<std::uint32_t, 3>> left = surface.triangles;
  for (std::size_t k = 0; k < pieces; ++k) {
    const std::size_t begin = surface.points.size() * k / pieces,
                      end = surface.points.size() * (k + 1) / pieces;
    const auto later = std::stable_partition(
        left.begin(), left.end(), [&](const auto& t) { return *std::max_element(t.begin(), t.end()) < end; });
    const std::vector<std::array<std::uint32_t, 3>> now(left.begin(), later);
    left.erase(left.begin(), later);
    if (auto good = stream.take({surface.points.data() + begin, end - begin}, now); !good) return good;
  }
  return Done{};
}

std::vector<std::array<std::uint32_t, 3>> sorted(std::vector<std::array<std::uint32_t, 3>> triangles) {
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace

TEST_CASE("Pieces of a surface become one file") {
  const Scratch scratch;
  const Surface surface = trefoil_solid(24);
  for (const std::string name : {"s.ply", "s.obj", "S.OFF"}) {
    auto stream = SurfaceStream::create(scratch.path(name));
    REQUIRE(stream.ok());
    REQUIRE(take(*stream, surface, 7).ok());
    CHECK(!fs::exists(scratch.path(name)));
    REQUIRE(stream->finish().ok());
    const auto read = read_surface(scratch.path(name));
    REQUIRE(read.ok());
    CHECK(read->points == surface.points);
    CHECK(sorted(read->triangles) == sorted(surface.triangles));
  }
  CHECK(scratch.files() == 3);
}

TEST_CASE("But for blanks in the header the bytes are those of a file written at once") {
  const Scratch scratch;
  const Surface surface = torus(1, 0.3, 20, 10);
  for (const std::string name : {"s.ply", "s.obj", "s.off"}) {
    auto stream = SurfaceStream::create(scratch.path(name));
    REQUIRE(stream.ok());
    REQUIRE(take(*stream, surface, 1).ok());
    REQUIRE(stream->finish().ok());
    REQUIRE(write_surface(scratch.path("at_once_" + name), surface).ok());
    std::string streamed = *read_file(scratch.path(name)),
                at_once = *read_file(scratch.path("at_once_" + name));
    const std::size_t blanks = streamed.size() - at_once.size();
    const std::size_t at = streamed.find(std::string(blanks, ' ') + "\n");
    REQUIRE(at != std::string::npos);
    streamed.erase(at, blanks);
    CHECK(streamed == at_once);
  }
}

TEST_CASE("An empty surface is a file, too") {
  const Scratch scratch;
  auto stream = SurfaceStream::create(scratch.path("empty.ply"));
  REQUIRE(stream.ok());
  REQUIRE(stream->finish().ok());
  const auto read = read_surface(scratch.path("empty.ply"));
  REQUIRE(read.ok());
  CHECK(read->points.empty());
}

TEST_CASE("A stream that does not end leaves nothing, and the target as it was") {
  const Scratch scratch;
  REQUIRE(write_file(scratch.path("s.ply"), "old").ok());
  {
    auto stream = SurfaceStream::create(scratch.path("s.ply"));
    REQUIRE(stream.ok());
    REQUIRE(take(*stream, torus(1, 0.3, 20, 10), 3).ok());
    CHECK(scratch.files() == 3);
  }
  CHECK(scratch.files() == 1);
  CHECK(*read_file(scratch.path("s.ply")) == "old");
  auto stream = SurfaceStream::create(scratch.path("s.ply"));
  REQUIRE(stream.ok());
  REQUIRE(take(*stream, torus(1, 0.3, 20, 10), 3).ok());
  const std::atomic<bool> stop = true;
  Context context;
  context.cancel = &stop;
  const auto finished = stream->finish(context);
  REQUIRE(!finished.ok());
  CHECK(finished.error().code == ErrorCode::cancelled);
  CHECK(*read_file(scratch.path("s.ply")) == "old");
}

TEST_CASE("A stream that has ended takes no more") {
  const Scratch scratch;
  const Surface surface = torus(1, 0.3, 20, 10);
  const std::atomic<bool> stop = true;
  Context cancelled;
  cancelled.cancel = &stop;
  for (const Context& context : {Context{}, cancelled}) {
    auto stream = SurfaceStream::create(scratch.path("s.ply"));
    REQUIRE(stream.ok());
    REQUIRE(take(*stream, surface, 3).ok());
    CHECK(stream->finish(context).ok() == !context.cancelled());
    CHECK(stream->finish().error().code == ErrorCode::usage);
    CHECK(take(*stream, surface, 3).error().code == ErrorCode::usage);
  }
  CHECK(read_surface(scratch.path("s.ply"))->triangles.size() == surface.triangles.size());
}

TEST_CASE("What can't be streamed to is an error") {
  const Scratch scratch;
  const auto code_of = [](const Result<SurfaceStream>& stream) {
    return stream.ok() ? ErrorCode::internal : stream.error().code;
  };
  CHECK(code_of(SurfaceStream::create(scratch.path("s.stl"))) == ErrorCode::usage);
  CHECK(code_of(SurfaceStream::create(scratch.path("missing/s.ply"))) == ErrorCode::file_not_writable);
  fs::create_symlink("/dev/null", scratch.path("null.ply"));
  CHECK(code_of(SurfaceStream::create(scratch.path("null.ply"))) == ErrorCode::file_not_writable);
}

TEST_CASE("A failed write stays one, however often it is asked about") {
  const Scratch scratch;
  std::signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  REQUIRE(getrlimit(RLIMIT_FSIZE, &before) == 0);
  const rlimit small{rlim_t{1} << 16, before.rlim_max};
  const Surface surface = torus(1, 0.3, 200, 100);
  {
    auto stream = SurfaceStream::create(scratch.path("s.ply"));
    REQUIRE(stream.ok());
    REQUIRE(setrlimit(RLIMIT_FSIZE, &small) == 0);
    const auto first = take(*stream, surface, 1), second = take(*stream, surface, 1);
    const auto finished = stream->finish();
    REQUIRE(setrlimit(RLIMIT_FSIZE, &before) == 0);
    for (const auto* result : {&first, &second, &finished}) {
      REQUIRE(!result->ok());
      CHECK(result->error().code == ErrorCode::file_not_writable);
    }
  }
  CHECK(scratch.files() == 0);
}
