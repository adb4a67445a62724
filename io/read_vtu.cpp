#include <optional>
#include <string>

#include "../geom/failing.h"
#include "byte_reader.h"
#include "read_mesh.h"
#include "token_reader.h"

namespace crossloft {
namespace {

/// The value of `name="..."` in the first tag that begins with `tag`, nothing when it is not there.
std::optional<std::string_view> attribute(std::string_view xml, const std::string& tag,
                                          const std::string& name) {
  const std::size_t begin = xml.find(tag);
  if (begin == std::string_view::npos) return std::nullopt;
  const std::string_view inside = xml.substr(begin, xml.find('>', begin) - begin);
  const std::string key = " " + name + "=\"";
  const std::size_t at = inside.find(key);
  if (at == std::string_view::npos) return std::nullopt;
  const std::string_view value = inside.substr(at + key.size());
  return value.substr(0, value.find('"'));
}

/// The one layout that write_solid produces, found by its names; see cell_writer.h.
class VtuReader {
 public:
  explicit VtuReader(std::string_view bytes) {
    constexpr std::string_view kMark = "<AppendedData encoding=\"raw\">";
    const std::size_t at = bytes.find(kMark);
    if (at == std::string_view::npos) return;
    header_ = bytes.substr(0, at);
    const std::size_t data = bytes.find('_', at + kMark.size());
    if (data != std::string_view::npos) data_ = bytes.substr(data + 1);
  }

  bool is_known_layout() const {
    return attribute(header_, "<VTKFile", "type") == "UnstructuredGrid" &&
           attribute(header_, "<VTKFile", "byte_order") == "LittleEndian" &&
           attribute(header_, "<VTKFile", "header_type") == "UInt64";
  }

  /// The elements of an array of items of `item_bytes`, nothing when it is missing, cut off or of another
  /// length.
  std::optional<ByteReader> array(const std::string& attributes, std::uint64_t items,
                                  std::uint64_t item_bytes) const {
    const std::optional<std::uint64_t> offset = number("<DataArray " + attributes, "offset");
    if (!offset.has_value() || *offset > data_.size() || items > data_.size()) return std::nullopt;
    ByteReader in(data_.substr(static_cast<std::size_t>(*offset)));
    const auto bytes = in.read<std::uint64_t>();
    if (!in.ok() || bytes != items * item_bytes || in.left() < bytes) return std::nullopt;
    return in;
  }

  std::optional<std::uint64_t> number(const std::string& tag, const std::string& name) const {
    const std::optional<std::string_view> text = attribute(header_, tag, name);
    std::int64_t value = 0;
    if (!text.has_value() || !parse_integer(*text, value) || value < 0) return std::nullopt;
    return static_cast<std::uint64_t>(value);
  }

 private:
  std::string_view header_, data_;
};

bool all_tetrahedra(ByteReader types, std::uint64_t cells) {
  constexpr std::uint8_t kVtkTetra = 10;
  bool all = true;
  for (std::uint64_t i = 0; i < cells; ++i) all = types.read<std::uint8_t>() == kVtkTetra && all;
  return all;
}

}  // namespace

Result<Solid> parse_vtu(std::string_view bytes, std::string name) {
  return or_out_of_memory([&]() -> Result<Solid> {
    const auto bad = [&](ErrorCode code, const char* what) {
      return Error{.code = code, .message = what, .file = name};
    };
    const VtuReader vtu(bytes);
    const auto points = vtu.number("<Piece", "NumberOfPoints"), cells = vtu.number("<Piece", "NumberOfCells");
    if (!vtu.is_known_layout() || !points.has_value() || !cells.has_value()) {
      return bad(ErrorCode::syntax, "the file is no .vtu of the layout written by Crossloft");
    }
    auto coordinates = vtu.array("type=\"Float64\" Name=\"Points\"", *points, 24);
    const auto types = vtu.array("type=\"UInt8\" Name=\"types\"", *cells, 1);
    if (types.has_value() && !all_tetrahedra(*types, *cells))
      return bad(ErrorCode::syntax, "a cell is no tetrahedron");
    auto corners = vtu.array("type=\"Int32\" Name=\"connectivity\"", *cells, 16);
    if (!coordinates.has_value() || !corners.has_value() || !types.has_value()) {
      return bad(ErrorCode::truncated,
                 "a data array is missing or does not have the length that the header says");
    }
    Solid solid;
    solid.points.resize(static_cast<std::size_t>(*points));
    for (Vec3& p : solid.points) {
      p.x = coordinates->read<double>(), p.y = coordinates->read<double>(), p.z = coordinates->read<double>();
      if (!is_finite(p))
        return bad(ErrorCode::not_finite, "a vertex has a coordinate that is no finite number");
    }
    solid.tets.resize(static_cast<std::size_t>(*cells));
    for (auto& tet : solid.tets) {
      for (std::uint32_t& corner : tet) {
        corner = corners->read<std::uint32_t>();
        if (corner >= *points)
          return bad(ErrorCode::index_out_of_range, "a tetrahedron names a missing vertex");
      }
    }
    return solid;
  });
}

}  // namespace crossloft
