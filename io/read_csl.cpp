#include <algorithm>
#include <utility>
#include <vector>

#include "read_sections.h"
#include "section_conventions.h"
#include "token_reader.h"

namespace crossloft {
namespace {

/// A closed chain of vertices. `parent` is the component that a hole is in, kNone for no hole.
struct Component {
  std::uint32_t size = 0;
  std::uint32_t parent = kNone;
  std::int32_t label = 1;
  std::uint32_t line = 0;
  std::vector<std::uint32_t> vertices;
};

/// "NI" or "NIhP". A hole whose parent isn't there gets an error, not a guess.
void read_size(TokenReader& in, std::uint32_t components, Component& component) {
  const std::string_view text = in.token("the size of a component");
  component.line = in.line();
  const std::size_t mark = text.find_first_of("hH");
  const bool hole = mark != std::string_view::npos;
  component.size = in.count_in(text.substr(0, mark), "the size of a component");
  if (hole) component.parent = in.index_in(text.substr(mark + 1), "the parent of a hole", components);
}

Component read_component(TokenReader& in, const PlaneSection& plane, std::uint32_t components) {
  constexpr std::size_t kLeastBytes = 2;  // "0 "
  Component component;
  read_size(in, components, component);
  component.label = in.integer("the label of a component");
  component.vertices.reserve(in.room_for(component.size, kLeastBytes));
  for (std::uint32_t i = 0; i < component.size && in.ok(); ++i) {
    component.vertices.push_back(
        in.index("a vertex of a component", static_cast<std::uint32_t>(plane.vertices.size())));
  }
  return component;
}

/// Components close implicitly; a first vertex repeated at the end would only add an edge of length 0.
void drop_explicit_closure(const PlaneSection& plane, std::vector<std::uint32_t>& loop) {
  while (loop.size() > 1 && plane.vertices[loop.front()] == plane.vertices[loop.back()]) loop.pop_back();
}

void add_edges(const Component& component, std::uint32_t contour, std::int32_t material, PlaneSection& plane) {
  std::vector<std::uint32_t> loop = component.vertices;
  drop_explicit_closure(plane, loop);
  if (loop.size() < 2) return;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t next = loop[(i + 1) % loop.size()];
    plane.edges.push_back({loop[i], next, material, 0, contour, component.line});
  }
}

/// The material inside of a component: its label, for a hole that of its parent, since the label of a hole is its
/// parent's in some files and 2 in others. Labels below 1 can't bound anything and count as 1.
std::int32_t material_of(const std::vector<Component>& components, std::uint32_t c) {
  const Component& component = components[c];
  const std::uint32_t owner = component.parent != kNone ? component.parent : c;
  return std::max(components[owner].label, 1);
}

void read_components(TokenReader& in, std::uint32_t p, std::uint32_t count, PlaneSection& plane) {
  constexpr std::size_t kLeastBytes = 4;  // "0 1 "
  std::vector<Component> components;
  components.reserve(in.room_for(count, kLeastBytes));
  for (std::uint32_t c = 0; c < count && in.ok(); ++c) {
    in.enter(p, c);
    components.push_back(read_component(in, plane, count));
  }
  for (std::uint32_t c = 0; c < count && in.ok(); ++c) {
    add_edges(components[c], c, material_of(components, c), plane);
  }
}

PlaneSection read_plane(TokenReader& in, std::uint32_t p) {
  PlaneSection plane;
  in.integer("the number of a plane");
  plane.line = in.line();
  const std::uint32_t vertices = in.count("the number of vertices");
  const std::uint32_t components = in.count("the number of components");
  read_plane_equation(in, plane);
  read_vertices(in, vertices, plane);
  read_components(in, p, components, plane);
  return plane;
}

}  // namespace

Result<Sections> parse_csl(std::string_view text, std::string name, const Context& context) {
  Sections sections;
  sections.source = name;
  TokenReader in(text, std::move(name));
  const std::string_view keyword = in.token("the word CSLC");
  if (in.ok() && keyword != "CSLC") in.fail(ErrorCode::syntax, "the file begins with " + quoted(keyword) + ", not CSLC");
  const std::uint32_t planes = in.count("the number of planes");
  if (planes == 0) in.fail(ErrorCode::no_plane, "the file has no cutting plane");
  in.integer("the number of labels");  // wrong in many files, and not needed
  for (std::uint32_t p = 0; p < planes && in.ok(); ++p) {
    if (context.cancelled()) in.fail(ErrorCode::cancelled, "reading was cancelled");
    in.enter(p);
    sections.planes.push_back(read_plane(in, p));
  }
  in.enter(kNone);
  in.expect_end();
  if (!in.ok()) return in.error();
  settle_sign_of_offset(sections, context);
  note_materials(sections, context);
  return sections;
}

}  // namespace crossloft
