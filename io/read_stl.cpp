#include <array>
#include <bit>
#include <string>
#include <unordered_map>
#include <utility>

#include "../geom/failing.h"
#include "byte_reader.h"
#include "read_mesh.h"
#include "token_reader.h"

namespace crossloft {
namespace {

constexpr std::size_t kHeaderBytes = 80, kCountBytes = 4, kFacetBytes = 50;

struct HashPoint {
  std::size_t operator()(const Vec3& p) const {
    std::uint64_t h = 0;
    for (const double c : {p.x, p.y, p.z}) {
      h = (h ^ std::bit_cast<std::uint64_t>(c)) * 0x9E3779B97F4A7C15u;
      h ^= h >> 32;
    }
    return static_cast<std::size_t>(h);
  }
};

/// Makes points with equal coordinates one vertex, numbered by first appearance.
class Welder {
 public:
  void add_triangle(const std::array<Vec3, 3>& corners) {
    const std::array<std::uint32_t, 3> t{weld(corners[0]), weld(corners[1]), weld(corners[2])};
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
      surface_.triangles.push_back(t);
    else
      ++dropped_;
  }

  Surface finish(const Context& context) {
    context.note("points of the STL file with equal coordinates were joined: " +
                 std::to_string(surface_.points.size()) + " vertices");
    if (dropped_ != 0)
      context.warn(std::to_string(dropped_) + " STL facets without three different corners dropped");
    return std::move(surface_);
  }

 private:
  std::uint32_t weld(Vec3 p) {
    p = p + Vec3{};  // -0 becomes +0, so that equal coordinates have equal bits
    const auto next = static_cast<std::uint32_t>(surface_.points.size());
    const auto [at, is_new] = vertex_.try_emplace(p, next);
    if (is_new) surface_.points.push_back(p);
    return at->second;
  }

  Surface surface_;
  std::unordered_map<Vec3, std::uint32_t, HashPoint> vertex_;
  std::size_t dropped_ = 0;
};

std::uint32_t facets_of_binary(std::string_view bytes) {
  if (bytes.size() < kHeaderBytes + kCountBytes) return 0;
  return ByteReader(bytes.substr(kHeaderBytes)).read<std::uint32_t>();
}

/// Binary files may begin with the word "solid" too, so the size decides first.
bool is_binary(std::string_view bytes) {
  const bool has_size_of_binary =
      bytes.size() >= kHeaderBytes + kCountBytes &&
      bytes.size() == kHeaderBytes + kCountBytes + kFacetBytes * std::uint64_t{facets_of_binary(bytes)};
  if (has_size_of_binary) return true;
  TokenReader in(bytes, {});
  return in.token("") != "solid" || bytes.find('\0') != std::string_view::npos;
}

Result<Surface> parse_binary(std::string_view bytes, std::string name, const Context& context) {
  if (bytes.size() < kHeaderBytes + kCountBytes) {
    return Error{
        .code = ErrorCode::truncated, .message = "the file ends within its header", .file = std::move(name)};
  }
  const std::uint64_t facets = facets_of_binary(bytes);
  if (bytes.size() < kHeaderBytes + kCountBytes + kFacetBytes * facets) {
    return Error{.code = ErrorCode::truncated,
                 .message = "the file ends before its " + std::to_string(facets) + " facets",
                 .file = std::move(name)};
  }
  Welder welder;
  ByteReader in(bytes.substr(kHeaderBytes + kCountBytes));
  for (std::uint64_t f = 0; f < facets; ++f) {
    std::array<Vec3, 3> corners;
    for (int i = 0; i < 3; ++i) in.read<float>();  // the normal, which the corners give
    for (Vec3& corner : corners) {
      corner.x = in.read<float>(), corner.y = in.read<float>(), corner.z = in.read<float>();
      if (is_finite(corner)) continue;
      return Error{.code = ErrorCode::not_finite,
                   .message = "facet " + std::to_string(f) + " has a coordinate that is no finite number",
                   .file = std::move(name)};
    }
    in.read<std::uint16_t>();
    welder.add_triangle(corners);
  }
  if (in.left() != 0)  // some programs pad their files
    context.warn(std::to_string(in.left()) + " bytes after the last facet of the STL file were passed over");
  return welder.finish(context);
}

/// Between the corners of a facet stand "endloop endfacet facet normal x y z outer loop"; only "vertex"
/// counts, and three of them make a facet.
Result<Surface> parse_ascii(std::string_view text, std::string name, const Context& context) {
  TokenReader in(text, std::move(name));
  in.token("the word solid");
  in.skip_line();
  Welder welder;
  std::array<Vec3, 3> corners;
  std::size_t known = 0;
  bool complete = false;
  while (in.ok() && !in.at_end()) {
    const std::string_view keyword = in.token("a keyword");
    complete = keyword == "endsolid";
    if (keyword == "vertex" && known < corners.size()) {
      corners[known++] = in.point("a vertex coordinate");
    } else if (keyword == "endfacet" && known == corners.size()) {
      welder.add_triangle(corners);
      known = 0;
    } else if (keyword == "vertex" || keyword == "endfacet") {
      in.fail(ErrorCode::syntax, "a facet does not have three corners");
    } else if (keyword == "facet" || keyword == "solid" || keyword == "endsolid") {
      if (known != 0) in.fail(ErrorCode::syntax, "a facet does not end before this");
      in.skip_line();
    } else if (keyword != "outer" && keyword != "loop" && keyword != "endloop") {
      in.fail(ErrorCode::syntax, quoted(keyword) + " is no word of an STL file");
    }
  }
  if (!complete) in.fail(ErrorCode::truncated, "the file ends before the word endsolid");
  if (!in.ok()) return in.error();
  return welder.finish(context);
}

}  // namespace

Result<Surface> parse_stl(std::string_view bytes, std::string name, const Context& context) {
  return or_out_of_memory([&]() -> Result<Surface> {
    return is_binary(bytes) ? parse_binary(bytes, std::move(name), context)
                            : parse_ascii(bytes, std::move(name), context);
  });
}

}  // namespace crossloft
