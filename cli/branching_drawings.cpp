#include "branching_drawings.h"

#include <unistd.h>

#include <filesystem>

namespace crossloft::cli {
namespace {

namespace fs = std::filesystem;

std::vector<std::vector<Vec2>> section_of(const FaceTriangulation& face, const std::vector<Vec2>& at) {
  std::vector<std::vector<Vec2>> triangles;
  for (std::size_t t = 0; t < face.triangles.size(); ++t) {
    const auto& v = face.triangles[t];
    if (face.internal[t] != 0) triangles.push_back({at[v[0]], at[v[1]], at[v[2]]});
  }
  return triangles;
}

std::vector<std::array<Vec2, 2>> contour_of(const FaceTriangulation& face, const std::vector<Vec2>& at) {
  std::vector<std::array<Vec2, 2>> edges;
  for (const FaceEdge& e : face.edges)
    if (e.kind == EdgeKind::contour) edges.push_back({at[e.a], at[e.b]});
  return edges;
}

Error not_writable(const std::string& folder, const char* why) {
  return Error{ErrorCode::file_not_writable, std::string("cannot be written: ") + why, folder};
}

}  // namespace

void BranchingDrawings::on_sections(const FramedSections& framed, const Arrangement& arrangement,
                                    const SectionGraph&) {
  for (const FramedPlane& plane : framed.planes) sources_.push_back(plane.sources[0]);
  outlines_.resize(arrangement.face_count());
  for (std::uint32_t f = 0; f < outlines_.size(); ++f)
    for (const ArrVertexId v : arrangement.vertices_of(FaceId{f})) {
      const LatticePoint& p = arrangement.point(v);
      outlines_[f].push_back({p.x, p.y, p.z});
    }
}

void BranchingDrawings::on_branching(const FaceBranching& branching, const FaceTriangulation& face,
                                     const Numbering& numbering) {
  const FaceFrame& frame = branching.frame;
  std::vector<Vec2> at, outline;
  for (const std::uint32_t number : numbering.of_face[face.face.value])
    at.push_back(frame.to_plane(numbering.points[number]));
  for (const Vec3& corner : outlines_[face.face.value]) outline.push_back(frame.to_plane(corner));
  const std::string plane = std::to_string(sources_[face.plane]), id = std::to_string(face.face.value);
  const std::string side = branching.side == 1 ? "above" : "below";
  FaceDrawing drawing;
  drawing.title = "plane " + plane + ", face " + id + ", seen from " + side + ": " +
                  std::to_string(branching.arcs.size()) + " arcs, " +
                  std::to_string(branching.samples.size()) + " samples";
  drawing.face.push_back(std::move(outline));
  drawing.section = section_of(face, at);
  drawing.contour = contour_of(face, at);
  for (const FaceArc& arc : branching.arcs) drawing.arcs.push_back(shape_of(arc));
  drawing.sites = branching.sites;
  for (const LatticePoint& sample : branching.samples) drawing.samples.push_back(frame.to_plane(sample));
  drawings_.emplace_back("plane" + plane + "-face" + id + "-" + side + ".svg", std::move(drawing));
}

Result<Done> BranchingDrawings::write(const std::string& folder) const {
  std::error_code failed;
  fs::create_directories(folder, failed);
  if (failed) return not_writable(folder, "the folder cannot be made");
  for (const auto& [name, drawing] : drawings_)
    if (auto written = write_face_svg((fs::path(folder) / name).string(), drawing); !written) return written;
  return Done{};
}

Result<Done> check_folder(const std::string& folder) {
  std::error_code none;
  fs::path there = fs::absolute(fs::path(folder), none);
  while (!fs::exists(there, none) && there.has_relative_path()) there = there.parent_path();
  if (!fs::is_directory(there, none)) return not_writable(folder, "it is not a folder");
  if (access(there.c_str(), W_OK) != 0) return not_writable(folder, "no permission");
  return Done{};
}

}  // namespace crossloft::cli
