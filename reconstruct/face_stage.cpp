/// Faces of the arrangement: triangulated, and again if samples come.

#include <algorithm>
#include <string>

#include "assemble.h"
#include "messages.h"
#include "pipeline.h"
#include "window.h"

namespace crossloft {

/// Other numbers for its vertices, in the same order: number[number before].
void CellState::renumber(std::span<const std::uint32_t> number) {
  if (triangulation) triangulation->renumber(number);
  for (std::uint32_t& v : built.vertices) v = number[v];
  if (waiting)
    for (std::uint32_t& v : waiting->built.vertices) v = number[v];
  crossloft::renumber(bridges, number);
  for (SpikeOnFace& spike : spikes)
    for (std::uint32_t& v : spike.tet) v = number[v];
  for (auto& tet : tets)
    for (std::uint32_t& v : tet) v = number[v];
}

Result<Done> Pipeline::triangulate_faces() {
  inputs_ = face_inputs(graph_, *arrangement_, context_);
  locators_ = std::make_unique<PlaneLocators>(graph_);
  faces_.resize(inputs_.size());
  const auto good = for_all(inputs_.size(), "faces", [&](std::size_t f) -> Result<Done> {
    const FaceId id{static_cast<std::uint32_t>(f)};
    if (arrangement_->on_box(id)) return Done{};
    auto face = triangulate_face(graph_, *arrangement_, *locators_, inputs_[f]);
    if (!face) return face.error();
    faces_[f] = std::move(face).value();
    inputs_[f].walls = {};  // with samples it starts from the walls of the triangulation
    return Done{};
  });
  if (!good) return good;
  numbering_ = number_vertices(graph_, faces_);
  classify_lines();
  result_.report.seconds.faces = watch_.lap();
  return Done{};
}

Result<Done> Pipeline::refine_faces(std::span<const std::vector<LatticePoint>> samples) {
  std::vector<std::uint8_t> left_out(faces_.size(), 0);
  const auto good = for_all(faces_.size(), "faces", [&](std::size_t f) -> Result<Done> {
    if (samples[f].empty()) return Done{};
    auto face = refine_face(graph_, *arrangement_, *locators_, inputs_[f], faces_[f], samples[f]);
    if (!face && face.error().code == ErrorCode::too_thin) {
      left_out[f] = 1;
      return Done{};  // it has a triangulation without samples
    }
    if (!face) return face.error();
    faces_[f] = std::move(face).value();
    return Done{};
  });
  if (!good) return good;
  if (const auto faces = std::count(left_out.begin(), left_out.end(), 1); faces != 0)
    note(tell_unsampled(static_cast<std::size_t>(faces)));
  for (std::size_t f = 0; f < faces_.size() && window_; ++f)
    if (left_out[f] != 0) window_->unsampled.push_back(faces_[f].plane);
  const Numbering before = std::move(numbering_);
  numbering_ = number_vertices(graph_, faces_);
  std::vector<std::uint32_t> number = renumbering(before, numbering_);
  for (CellState& cell : cells_) {
    number.resize(before.points.size());
    for (std::uint32_t& v : cell.interior) {
      v += static_cast<std::uint32_t>(numbering_.points.size() - before.points.size());
      number.push_back(v);
    }
    cell.renumber(number);
  }
  classify_lines();
  return Done{};
}

/// Edges on lines get their kinds.
void Pipeline::classify_lines() {
  line_edges_ = std::make_unique<LineEdges>(graph_);
  const auto in_face = [](const Location& at) { return at.dimension == 2; };
  if (std::all_of(graph_.locations.begin(), graph_.locations.end(), in_face)) return;  // as in a stack
  for (const FaceTriangulation& face : faces_) line_edges_->add(face);
  line_edges_->finish();
  for (FaceTriangulation& face : faces_) {
    const std::vector<std::uint8_t> on_some_line = line_edges_->vertices_on_lines(face);
    for (FaceEdge& e : face.edges) {
      if (e.b >= on_some_line.size() || (on_some_line[e.a] & on_some_line[e.b]) == 0) continue;
      const std::uint32_t u = face.vertices[e.a], v = face.vertices[e.b];
      if (line_edges_->on_line(u, v)) e.kind = line_edges_->kind(u, v);
    }
  }
}

/// No more samples will come: what they would have needed goes, since with many vertices the peak of memory
/// is still to come.
void Pipeline::drop_what_samples_need() {
  inputs_ = {};
  locators_.reset();
  if (!field_) graph_.points = {};
}

/// Nothing is pruned again: so does what the cells needed.
void Pipeline::drop_what_cells_need() {
  for (FaceTriangulation& face : faces_) face.edges = {}, face.border = {};
  for (CellState& cell : cells_) {
    cell.triangulation.reset();
    if (glued_) cell.partners = {};
  }
  line_edges_.reset();
  graph_.points = {};
  graph_.locations = {};
}

/// Faces are final, and the sections are what they say.
void Pipeline::finish_faces() {
  for (const FaceTriangulation& face : faces_) {
    result_.report.edge_splits += static_cast<std::uint32_t>(face.added.size()) - face.samples;
    result_.report.branching_samples += face.samples;
    result_.report.branching_faces += face.samples != 0;
  }
  if (observer_)
    for (const FaceTriangulation& face : faces_)
      if (face.face.valid()) observer_->on_face(face, numbering_);
  drop_what_cells_need();
  result_.sections = assemble_sections(framed_, graph_, faces_, numbering_, context_);
  result_.report.seconds.faces += watch_.lap();
}

}  // namespace crossloft
