#pragma once
/// Points and cells of one kind as `.vtu` (VTK XML, appended raw data) or `.mesh` (Medit, ASCII), streamed.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>

#include "../geom/vec3.h"
#include "byte_writer.h"
#include "file_extension.h"

namespace crossloft::detail {

/// How the formats call a simplex.
struct CellKind {
  std::uint8_t vtk_type;
  std::string_view medit_section;  ///< empty: Medit knows no such elements
  const char* name;
};

inline constexpr CellKind kCellKinds[] = {{1, "", "a point"},
                                          {3, "Edges", "an edge"},
                                          {5, "Triangles", "a triangle"},
                                          {10, "Tetrahedra", "a tetrahedron"}};

/// `Cells` has size() and [i], an array of corners.
template <class Cells>
inline constexpr std::size_t kCorners =
    std::tuple_size_v<std::remove_cvref_t<decltype(std::declval<const Cells&>()[0])>>;
template <class Cells>
inline constexpr CellKind kKind = kCellKinds[kCorners<Cells> - 1];

/// The XML before the data. Every array is preceded by its length in a UInt64.
void write_vtu_header(ByteWriter& out, std::uint64_t points, std::uint64_t cells, std::uint64_t corners);
void write_vtu_points(ByteWriter& out, std::span<const Vec3> points);

template <class Cells>
void write_vtu(ByteWriter& out, std::span<const Vec3> points, const Cells& cells) {
  const std::uint64_t count = cells.size(), corners = kCorners<Cells>;
  write_vtu_header(out, points.size(), count, corners);
  write_vtu_points(out, points);
  out.little_endian(count * corners * 4);
  for (std::size_t i = 0; i < count && !out.hopeless(); ++i) {
    for (const std::uint32_t v : cells[i]) out.little_endian(v);
  }
  out.little_endian(count * 8);
  for (std::uint64_t i = 1; i <= count && !out.hopeless(); ++i) out.little_endian(corners * i);
  out.little_endian(count);
  for (std::uint64_t i = 0; i < count; ++i) out.little_endian(kKind<Cells>.vtk_type);
  out.text("\n  </AppendedData>\n</VTKFile>\n");
}

/// Medit counts vertices from 1.
void write_medit_points(ByteWriter& out, std::span<const Vec3> points);

template <class Cells>
void write_medit(ByteWriter& out, std::span<const Vec3> points, const Cells& cells) {
  write_medit_points(out, points);
  if (!kKind<Cells>.medit_section.empty()) {
    out.text(kKind<Cells>.medit_section).text("\n").decimal(cells.size()).text("\n");
    for (std::size_t i = 0; i < cells.size() && !out.hopeless(); ++i) {
      for (const std::uint32_t v : cells[i]) out.decimal(v + 1).text(" ");
      out.text("1\n");
    }
  }
  out.text("End\n");
}

Error too_many_cells(const std::string& path);
Error missing_vertex(const std::string& path, const char* cell);

template <class Cells>
Result<Done> check_cells(const std::string& path, std::size_t points, const Cells& cells) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (points > kMost || cells.size() > kMost) return too_many_cells(path);
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const auto corners = cells[i];
    if (*std::max_element(corners.begin(), corners.end()) >= points)
      return missing_vertex(path, kKind<Cells>.name);
  }
  return Done{};
}

/// All or nothing. Errors: usage (extension), index_out_of_range, too_large, file_not_writable, cancelled.
template <class Cells>
Result<Done> write_cells(const std::string& path, std::span<const Vec3> points, const Cells& cells,
                         const Context& context) {
  const std::string extension = file_extension(path);
  if (extension != "vtu" && extension != "mesh") return unknown_extension(path, ".vtu and .mesh");
  if (Result<Done> good = check_cells(path, points.size(), cells); !good.ok()) return good;
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file.ok()) return file.error();
  ByteWriter out(std::move(*file), context);
  extension == "vtu" ? write_vtu(out, points, cells) : write_medit(out, points, cells);
  return out.finish();
}

}  // namespace crossloft::detail
