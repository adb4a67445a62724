#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "../geom/failing.h"
#include "byte_reader.h"
#include "read_mesh.h"
#include "surface_builder.h"
#include "token_reader.h"

namespace crossloft {
namespace {

enum class Number : std::uint8_t { none, int8, uint8, int16, uint16, int32, uint32, float32, float64 };

enum class Role : std::uint8_t { ignored, x, y, z, corners };

struct Property {
  Number type = Number::none;
  Number size_type = Number::none;  ///< type of the length of a list, none for a plain value
  Role role = Role::ignored;
};

struct Element {
  bool is_vertex = false;
  std::uint32_t count = 0;
  std::vector<Property> properties;
};

struct Header {
  bool ascii = false;
  std::endian order = std::endian::little;
  std::uint32_t vertices = 0;
  std::vector<Element> elements;
};

Number number_named(std::string_view name) {
  struct Name {
    std::string_view old_name, new_name;
    Number type;
  };
  static constexpr Name kNames[] = {
      {"char", "int8", Number::int8},        {"uchar", "uint8", Number::uint8},
      {"short", "int16", Number::int16},     {"ushort", "uint16", Number::uint16},
      {"int", "int32", Number::int32},       {"uint", "uint32", Number::uint32},
      {"float", "float32", Number::float32}, {"double", "float64", Number::float64}};
  for (const Name& known : kNames) {
    if (name == known.old_name || name == known.new_name) return known.type;
  }
  return Number::none;
}

Number number_type(TokenReader& in, std::string_view name) {
  const Number type = number_named(name);
  if (type == Number::none) in.fail(ErrorCode::syntax, quoted(name) + " is no type of a PLY property");
  return type;
}

Role role_of(std::string_view element, std::string_view name, bool is_list) {
  if (element == "face" && is_list) {
    return name == "vertex_indices" || name == "vertex_index" ? Role::corners : Role::ignored;
  }
  if (element != "vertex" || is_list || name.size() != 1) return Role::ignored;
  return name == "x" ? Role::x : name == "y" ? Role::y : name == "z" ? Role::z : Role::ignored;
}

Property read_property(TokenReader& in, std::string_view element) {
  Property property;
  const std::string_view first = in.token("the type of a property");
  const bool is_list = first == "list";
  if (is_list) property.size_type = number_type(in, in.token("the type of a list's length"));
  property.type = number_type(in, is_list ? in.token("the type of a property") : first);
  property.role = role_of(element, in.token("the name of a property"), is_list);
  return property;
}

void read_format(TokenReader& in, Header& header) {
  const std::string_view format = in.token("the format");
  header.ascii = format == "ascii";
  header.order = format == "binary_big_endian" ? std::endian::big : std::endian::little;
  if (!header.ascii && format != "binary_big_endian" && format != "binary_little_endian") {
    in.fail(ErrorCode::syntax, quoted(format) + " is no format of a PLY file");
  }
}

bool has_role(const Element& element, Role role) {
  return std::any_of(element.properties.begin(), element.properties.end(),
                     [role](const Property& p) { return p.role == role; });
}

/// Every vertex then takes bytes of the file, and corners of faces mean the vertices of one element.
void check_vertex_element(TokenReader& in, const std::vector<Element>& elements) {
  const auto is_vertex = [](const Element& e) { return e.is_vertex; };
  if (std::count_if(elements.begin(), elements.end(), is_vertex) != 1)
    return in.fail(ErrorCode::syntax, "the header of the PLY file does not have one element vertex");
  const Element& vertex = *std::find_if(elements.begin(), elements.end(), is_vertex);
  for (const Role coordinate : {Role::x, Role::y, Role::z})
    if (!has_role(vertex, coordinate))
      in.fail(ErrorCode::syntax, "the vertices of the PLY file do not have x, y and z");
}

Header read_header(TokenReader& in) {
  Header header;
  std::string_view element;
  if (in.token("the word ply") != "ply")
    in.fail(ErrorCode::syntax, "the file does not begin with the word ply");
  bool has_format = false;
  while (in.ok()) {
    const std::string_view keyword = in.token("the header of the PLY file");
    if (keyword == "end_header") break;
    if (keyword == "format") {
      read_format(in, header);
      has_format = true;
    } else if (keyword == "element") {
      element = in.token("the name of an element");
      header.elements.push_back({element == "vertex", in.count("the number of elements"), {}});
      if (element == "vertex") header.vertices = header.elements.back().count;
    } else if (keyword == "property" && !header.elements.empty()) {
      header.elements.back().properties.push_back(read_property(in, element));
    } else if (keyword != "comment" && keyword != "obj_info") {
      in.fail(ErrorCode::syntax, quoted(keyword) + " has no place in the header of a PLY file");
    }
    in.skip_line();
  }
  if (!has_format) in.fail(ErrorCode::syntax, "the header of the PLY file has no format");
  check_vertex_element(in, header.elements);
  return header;
}

/// The values after the header, as text or as bytes. All PLY types fit a double exactly.
class Body {
 public:
  Body(TokenReader& text, std::optional<ByteReader> bytes) : text_(text), bytes_(bytes) {}

  bool ok() const { return text_.ok(); }
  void fail(ErrorCode code, std::string message) { text_.fail(code, std::move(message)); }

  double value(Number type, const char* what) {
    if (!bytes_.has_value()) return text_.real(what);
    const double v = binary_value(type);
    if (!bytes_->ok()) fail(ErrorCode::truncated, std::string("the file ends where ") + what + " should be");
    return v;
  }

  /// A value without meaning here, which may even be NaN.
  void skip(Number type) {
    if (bytes_.has_value())
      value(type, "a value");
    else
      text_.token("a value");
  }

  void expect_end() {
    if (!bytes_.has_value()) return text_.expect_end();
    if (const std::size_t left = bytes_->left(); left != 0)
      fail(ErrorCode::syntax,
           std::to_string(left) + " bytes follow where the file should end; is a count too small?");
  }

 private:
  double binary_value(Number type) {
    switch (type) {
      case Number::int8:
        return bytes_->read<std::int8_t>();
      case Number::uint8:
        return bytes_->read<std::uint8_t>();
      case Number::int16:
        return bytes_->read<std::int16_t>();
      case Number::uint16:
        return bytes_->read<std::uint16_t>();
      case Number::int32:
        return bytes_->read<std::int32_t>();
      case Number::uint32:
        return bytes_->read<std::uint32_t>();
      case Number::float32:
        return static_cast<double>(bytes_->read<float>());
      case Number::float64:
        return bytes_->read<double>();
      case Number::none:
        break;
    }
    return 0;
  }

  TokenReader& text_;
  std::optional<ByteReader> bytes_;
};

/// The length of a list. It only bounds a loop that ends with the file: nothing is allocated for it.
std::uint32_t read_length(Body& body, Number type) {
  const double length = body.value(type, "the length of a list");
  const bool good = length >= 0 && length < kNone && length == std::floor(length);
  if (!good) body.fail(ErrorCode::bad_count, "the length of a list is no whole number from 0 up");
  return good ? static_cast<std::uint32_t>(length) : 0;
}

std::uint32_t read_corner(Body& body, Number type, std::uint32_t vertices) {
  const double corner = body.value(type, "a corner of a face");
  const bool good = corner >= 0 && corner < vertices && corner == std::floor(corner);
  if (!good) {
    body.fail(ErrorCode::index_out_of_range,
              "a corner of a face names none of the " + std::to_string(vertices) + " vertices");
  }
  return good ? static_cast<std::uint32_t>(corner) : 0;
}

class ElementReader {
 public:
  ElementReader(Body& body, std::uint32_t vertices, Surface& surface)
      : body_(body), vertices_(vertices), surface_(surface) {}

  void read(const Element& element) {
    if (element.properties.empty()) return;  // takes no bytes, however many there are
    for (std::uint32_t i = 0; i < element.count && body_.ok(); ++i) {
      Vec3 point;
      for (const Property& property : element.properties) read(property, point);
      if (element.is_vertex) add_point(point);
    }
  }

 private:
  void read(const Property& property, Vec3& point) {
    if (property.size_type != Number::none) return read_list(property);
    double* const coordinate[] = {nullptr, &point.x, &point.y, &point.z};
    if (property.role == Role::ignored) return body_.skip(property.type);
    *coordinate[static_cast<int>(property.role)] = body_.value(property.type, "a vertex coordinate");
  }

  void read_list(const Property& property) {
    const std::uint32_t length = read_length(body_, property.size_type);
    corners_.clear();
    for (std::uint32_t i = 0; i < length && body_.ok(); ++i) {
      if (property.role == Role::corners)
        corners_.push_back(read_corner(body_, property.type, vertices_));
      else
        body_.skip(property.type);
    }
    if (property.role != Role::corners || !body_.ok()) return;
    if (length < 3)
      body_.fail(ErrorCode::bad_count, "a face has fewer than three corners");
    else
      add_fan(surface_, corners_);
  }

  void add_point(const Vec3& point) {
    surface_.points.push_back(point);
    if (is_finite(point)) return;
    body_.fail(ErrorCode::not_finite, "vertex " + std::to_string(surface_.points.size() - 1) +
                                          " has a coordinate that is no finite number");
  }

  Body& body_;
  std::uint32_t vertices_;
  Surface& surface_;
  std::vector<std::uint32_t> corners_;
};

/// A binary body begins after the one line end that closes the header; blanks may stand before it.
std::string_view binary_body(TokenReader& in, std::string_view bytes) {
  if (!in.at_line_end()) in.fail(ErrorCode::syntax, "something follows end_header on its line");
  bytes.remove_prefix(in.offset());
  if (bytes.starts_with("\r\n")) return bytes.substr(2);
  return bytes.empty() ? bytes : bytes.substr(1);
}

}  // namespace

Result<Surface> parse_ply(std::string_view bytes, std::string name) {
  return or_out_of_memory([&]() -> Result<Surface> {
    TokenReader in(bytes, std::move(name));
    const Header header = read_header(in);
    std::optional<ByteReader> binary;
    if (in.ok() && !header.ascii) binary.emplace(binary_body(in, bytes), header.order);
    if (!in.ok()) return in.error();
    Body body(in, binary);
    Surface surface;
    constexpr std::size_t kLeastVertexBytes = 3;  // three int8
    surface.points.reserve(in.room_for(header.vertices, kLeastVertexBytes));
    ElementReader reader(body, header.vertices, surface);
    for (const Element& element : header.elements) reader.read(element);
    body.expect_end();
    if (in.ok()) return surface;
    Error error = in.error();
    if (!header.ascii) error.line = 0;
    return error;
  });
}

}  // namespace crossloft
