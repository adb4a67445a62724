#include <algorithm>
#include <utility>
#include <vector>

#include "section_conventions.h"
#include "section_grammar.h"

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

/// One plane on its way.
class CslPlane {
 public:
  CslPlane(TokenReader& in, std::uint32_t position) : in_(in), position_(position) {}

  ParsedPlane read() {
    in_.integer("the number of a plane");
    PlaneSection& plane = parsed_.section;
    plane.line = in_.line();
    const std::uint32_t vertices = in_.count("the number of vertices");
    const std::uint32_t components = in_.count("the number of components");
    read_plane_equation(in_, plane);
    read_vertices(in_, vertices, plane);
    read_components(components);
    return std::move(parsed_);
  }

 private:
  void read_components(std::uint32_t count) {
    constexpr std::size_t kLeastBytes = 4;  // "0 1 "
    PlaneSection& plane = parsed_.section;
    std::vector<Component> components;
    components.reserve(in_.room_for(count, kLeastBytes));
    for (std::uint32_t c = 0; c < count && in_.ok(); ++c) {
      in_.enter(position_, c);
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
    if (component.label < 1 && component.parent == kNone) parsed_.has_outside_label = true;
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

  TokenReader& in_;
  std::uint32_t position_;
  ParsedPlane parsed_;
};

std::uint32_t read_header(TokenReader& in) {
  const std::string_view keyword = in.token("the word CSLC");
  if (keyword != "CSLC")
    in.fail(ErrorCode::syntax, "the file begins with " + quoted(keyword) + ", not CSLC");
  const std::uint32_t planes = in.count("the number of planes");
  if (planes == 0) in.fail(ErrorCode::no_plane, "the file has no cutting plane");
  in.integer("the number of labels");  // wrong in many files, and not needed
  return planes;
}

ParsedPlane read_plane(TokenReader& in, std::uint32_t position) { return CslPlane(in, position).read(); }

}  // namespace

const SectionGrammar& csl_grammar() {
  static constexpr SectionGrammar kGrammar{read_header, read_plane};
  return kGrammar;
}

}  // namespace crossloft
