#include "cell_writer.h"

namespace crossloft::detail {
namespace {

/// One array of the appended block: what it is, and its bytes without the leading length.
struct DataArray {
  const char* attributes;
  std::uint64_t bytes;
};

}  // namespace

void write_vtu_header(ByteWriter& out, std::uint64_t points, std::uint64_t cells, std::uint64_t corners) {
  const DataArray coordinates{"type=\"Float64\" Name=\"Points\" NumberOfComponents=\"3\"", points * 24};
  const DataArray arrays[] = {{"type=\"Int32\" Name=\"connectivity\"", cells * corners * 4},
                              {"type=\"Int64\" Name=\"offsets\"", cells * 8},
                              {"type=\"UInt8\" Name=\"types\"", cells}};
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
  out.decimal(points).text("\" NumberOfCells=\"").decimal(cells).text("\">\n      <Points>\n");
  array(coordinates);
  out.text("      </Points>\n      <Cells>\n");
  for (const DataArray& data : arrays) array(data);
  out.text("      </Cells>\n    </Piece>\n  </UnstructuredGrid>\n  <AppendedData encoding=\"raw\">\n_");
}

void write_vtu_points(ByteWriter& out, std::span<const Vec3> points) {
  out.little_endian(std::uint64_t{points.size()} * 24);
  for (const Vec3& p : points) out.little_endian(p.x).little_endian(p.y).little_endian(p.z);
}

void write_medit_points(ByteWriter& out, std::span<const Vec3> points) {
  out.text("MeshVersionFormatted 2\nDimension 3\nVertices\n").decimal(points.size()).text("\n");
  for (const Vec3& p : points) out.decimal(p).text(" 0\n");
}

Error too_many_cells(const std::string& path) {
  return {
      .code = ErrorCode::too_large, .message = "there are more than 2^31 - 1 points or cells", .file = path};
}

Error missing_vertex(const std::string& path, const char* cell) {
  return {.code = ErrorCode::index_out_of_range,
          .message = std::string(cell) + " names a missing vertex",
          .file = path};
}

}  // namespace crossloft::detail
