#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>

#include "byte_writer.h"
#include "file_extension.h"
#include "write_mesh.h"

namespace crossloft {
namespace {

using Tet = std::array<std::uint32_t, 4>;

constexpr std::uint8_t kVtkTetra = 10;

/// One array of the appended block: where it begins there, and its bytes without the leading length.
struct DataArray {
  const char* attributes;
  std::uint64_t bytes;
};

/// The XML before the data. Every array is preceded by its length in a UInt64.
void write_vtu_header(ByteWriter& out, const Solid& solid) {
  const std::uint64_t points = solid.points.size(), tets = solid.tets.size();
  const DataArray coordinates{"type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points * 24};
  const DataArray cells[] = {{"type=\"Int32\" Name=\"connectivity\"", tets * 16},
                             {"type=\"Int64\" Name=\"offsets\"", tets * 8},
                             {"type=\"UInt8\" Name=\"types\"", tets}};
  std::uint64_t offset = 0;
  const auto array = [&](const DataArray& data) {
    out.text("        <DataArray ").text(data.attributes).text(" format=\"appended\" offset=\"");
    out.decimal(offset).text("\"/>\n");
    offset += sizeof(std::uint64_t) + data.bytes;
  };
  out.text(
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"UnstructuredGrid\" version=\"1.0\" "
      "byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n  <UnstructuredGrid>\n    <Piece NumberOfPoints=\"");
  out.decimal(points).text("\" NumberOfCells=\"").decimal(tets).text("\">\n      <Points>\n");
  array(coordinates);
  out.text("      </Points>\n      <Cells>\n");
  for (const DataArray& data : cells) array(data);
  out.text("      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_");
}

void write_vtu(ByteWriter& out, const Solid& solid) {
  const std::uint64_t points = solid.points.size(), tets = solid.tets.size();
  write_vtu_header(out, solid);
  out.little_endian(points * 24);
  for (const Vec3& p : solid.points) out.little_endian(p.x).little_endian(p.y).little_endian(p.z);
  out.little_endian(tets * 16);
  for (const Tet& t : solid.tets) {
    for (const std::uint32_t v : t) out.little_endian(v);
  }
  out.little_endian(tets * 8);
  for (std::uint64_t i = 1; i <= tets; ++i) out.little_endian(4 * i);
  out.little_endian(tets);
  for (std::uint64_t i = 0; i < tets; ++i) out.little_endian(kVtkTetra);
  out.text("\n  </AppendedData>\n</VTKFile>\n");
}

void write_medit(ByteWriter& out, const Solid& solid) {
  out.text("MeshVersionFormatted 2\nDimension 3\nVertices\n").decimal(solid.points.size()).text("\n");
  for (const Vec3& p : solid.points) out.decimal(p).text(" 0\n");
  out.text("Tetrahedra\n").decimal(solid.tets.size()).text("\n");
  for (const Tet& t : solid.tets) {
    for (const std::uint32_t v : t) out.decimal(v + 1).text(" ");
    out.text("1\n");
  }
  out.text("End\n");
}

Result<Done> check(const std::string& path, const Solid& solid) {
  constexpr std::size_t kMost = std::numeric_limits<std::int32_t>::max();
  if (solid.points.size() > kMost || solid.tets.size() > kMost) {
    return Error{
        .code = ErrorCode::too_large, .message = "the solid has more than 2^31 - 1 elements", .file = path};
  }
  for (const Tet& t : solid.tets) {
    if (*std::max_element(t.begin(), t.end()) < solid.points.size()) continue;
    return Error{.code = ErrorCode::index_out_of_range,
                 .message = "a tetrahedron names a missing vertex",
                 .file = path};
  }
  return Done{};
}

}  // namespace

Result<Done> write_solid(const std::string& path, const Solid& solid, const Context& context) {
  const std::string extension = file_extension(path);
  if (extension != "vtu" && extension != "mesh") return unknown_extension(path, ".vtu and .mesh");
  if (Result<Done> good = check(path, solid); !good.ok()) return good;
  Result<AtomicFile> file = AtomicFile::create(path);
  if (!file.ok()) return file.error();
  ByteWriter out(std::move(*file), context);
  extension == "vtu" ? write_vtu(out, solid) : write_medit(out, solid);
  return out.finish();
}

}  // namespace crossloft
