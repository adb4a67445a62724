#include <algorithm>
#include <utility>
#include <vector>

#include "../geom/failing.h"
#include "read_sections.h"
#include "section_conventions.h"
#include "token_reader.h"

namespace crossloft {
namespace {

/// A closed chain of vertices. `parent` is the component that a hole is in, kNone for no hole.
struct Component {
  std::uint32_t parent = kNone;
  std::int32_t label = 1;
  std::uint32_t line = 0;
  std::vector<std::uint32_t> vertices;
};

/// Components close implicitly; a first vertex repeated at the end would only add an edge of length 0.
void drop_explicit_closure(const PlaneSection& plane, std::vector<std::uint32_t>& loop) {
  while (loop.size() > 1 && plane.vertices[loop.front()] == plane.vertices[loop.back()]) loop.pop_back();
}

void add_edges(const Component& component, std::uint32_t contour, std::int32_t material,
               PlaneSection& plane) {
  std::vector<std::uint32_t> loop = component.vertices;
  drop_explicit_closure(plane, loop);
  if (loop.size() < 2) return;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::uint32_t next = loop[(i + 1) % loop.size()];
    plane.edges.push_back({loop[i], next, material, 0, contour, component.line});
  }
}

class CslReader {
 public:
  CslReader(std::string_view text, std::string name, const Context& context)
      : in_(text, name), context_(context) {
    sections_.source = std::move(name);
  }

  Result<Sections> read() {
    read_header();
    for (std::uint32_t p = 0; p < planes_ && in_.ok(); ++p) {
      if (context_.cancelled()) in_.fail(ErrorCode::cancelled, "reading was cancelled");
      read_plane(p);
    }
    in_.enter(kNone);
    in_.expect_end();
    if (!in_.ok()) return in_.error();
    if (has_outside_label_)
      context_.warn("components with a label below 1, which names the outside, are taken as 1");
    settle_sign_of_offset(sections_, context_);
    note_materials(sections_, context_);
    return std::move(sections_);
  }

 private:
  void read_header() {
    const std::string_view keyword = in_.token("the word CSLC");
    if (keyword != "CSLC")
      in_.fail(ErrorCode::syntax, "the file begins with " + quoted(keyword) + ", not CSLC");
    planes_ = in_.count("the number of planes");
    if (planes_ == 0) in_.fail(ErrorCode::no_plane, "the file has no cutting plane");
    in_.integer("the number of labels");  // wrong in many files, and not needed
  }

  void read_plane(std::uint32_t p) {
    in_.enter(p);
    PlaneSection plane;
    in_.integer("the number of a plane");
    plane.line = in_.line();
    const std::uint32_t vertices = in_.count("the number of vertices");
    const std::uint32_t components = in_.count("the number of components");
    read_plane_equation(in_, plane);
    read_vertices(in_, vertices, plane);
    read_components(p, components, plane);
    sections_.planes.push_back(std::move(plane));
  }

  void read_components(std::uint32_t p, std::uint32_t count, PlaneSection& plane) {
    constexpr std::size_t kLeastBytes = 4;  // "0 1 "
    std::vector<Component> components;
    components.reserve(in_.room_for(count, kLeastBytes));
    for (std::uint32_t c = 0; c < count && in_.ok(); ++c) {
      in_.enter(p, c);
      components.push_back(read_component(static_cast<std::uint32_t>(plane.vertices.size()), count));
    }
    // Holes may come before their parents, so materials are known only here.
    for (std::uint32_t c = 0; c < count && in_.ok(); ++c) {
      add_edges(components[c], c, material_of(components, c), plane);
    }
  }

  Component read_component(std::uint32_t vertices, std::uint32_t components) {
    constexpr std::size_t kLeastBytes = 2;  // "0 "
    Component component;
    const std::uint32_t size = read_size(components, component);
    component.label = in_.integer("the label of a component");
    component.vertices.reserve(in_.room_for(size, kLeastBytes));
    for (std::uint32_t i = 0; i < size && in_.ok(); ++i) {
      component.vertices.push_back(in_.index("a vertex of a component", vertices));
    }
    has_outside_label_ = has_outside_label_ || (component.label < 1 && component.parent == kNone);
    return component;
  }

  /// "NI" or "NIhP". A hole whose parent isn't there gets an error, not a guess.
  std::uint32_t read_size(std::uint32_t components, Component& component) {
    const std::string_view text = in_.token("the size of a component");
    component.line = in_.line();
    const std::size_t mark = text.find_first_of("hH");
    const std::uint32_t size = in_.count_in(text.substr(0, mark), "the size of a component");
    if (mark != std::string_view::npos) {
      component.parent = in_.index_in(text.substr(mark + 1), "the parent of a hole", components);
    }
    return size;
  }

  /// The material inside of a component: its label, for a hole that of its parent, since the label of a hole
  /// is its parent's in some files and 2 in others.
  static std::int32_t material_of(const std::vector<Component>& components, std::uint32_t c) {
    const std::uint32_t owner = components[c].parent != kNone ? components[c].parent : c;
    return std::max(components[owner].label, 1);
  }

  TokenReader in_;
  const Context& context_;
  Sections sections_;
  std::uint32_t planes_ = 0;
  bool has_outside_label_ = false;
};

}  // namespace

Result<Sections> parse_csl(std::string_view text, std::string name, const Context& context) {
  return or_out_of_memory(
      [&]() -> Result<Sections> { return CslReader(text, std::move(name), context).read(); });
}

}  // namespace crossloft
