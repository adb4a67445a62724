#pragma once
/// The main job as a sequence of stages over shared data; internal to reconstruct/.

#include <array>
#include <chrono>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "../arrangement/data_box.h"
#include "../geom/parallel.h"
#include "../prune/confidence.h"
#include "../prune/section_field.h"
#include "branching.h"
#include "bridges.h"
#include "cell_builder.h"
#include "glue.h"
#include "mend.h"
#include "numbering.h"
#include "observer.h"
#include "reconstruct.h"
#include "roofs.h"

namespace crossloft {

class Stopwatch {
 public:
  /// Seconds since the last call.
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

 private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

class EdgeRing;
struct OpenEdge;
struct Window;

/// That tolerances, confidences and weights are in their ranges, choices are some of those that there are,
/// and requests do not contradict each other. Error: usage.
Result<Done> check_options(const Options& options);

/// One component of the surface, as cells see it.
struct Piece {
  bool is_cavity = false, is_largest = false;
  std::map<std::uint32_t, std::vector<TetName>> bodies;     ///< by cell: its tetrahedra at the surface
  std::map<std::uint32_t, std::vector<Triangle>> cavities;  ///< by cell: facets at it
};

/// A point inside a cell that divides it.
struct InsidePoint {
  LatticePoint point;
  std::uint32_t round = 0;  ///< of dividing, in which it came
};

/// What pruning a cell starts from.
struct CellInHand {
  CellId id;
  std::vector<FaceId> ids;  ///< faces not on the box
  std::vector<CellFace> faces;
  BuiltCell built;
  std::optional<Ground> ground;
  CellShape shape;           ///< mode natural
  CellMemory memory;         ///< of the shape
  std::vector<Vec3> places;  ///< of points inside that it waits for
};

/// A spike of a cell (prune/spikes.h), and where it stands.
struct SpikeOnFace {
  std::int32_t confidence = 0;
  TetName tet{};  ///< one of it, by final numbers
  std::vector<GroundTriangle> ground;
};

/// The tetrahedra of all cells and what the cells know of their facets.
struct SolidInCells {
  std::vector<std::array<std::uint32_t, 4>> tets;
  KnownFacets known;
};

/// A cell while it is worked on, and what it leaves behind.
struct CellState {
  std::unique_ptr<CellTriangulation> triangulation;  ///< kept only while points may come
  std::vector<std::array<std::uint32_t, 4>> tets;    ///< kept ones, by final vertex numbers
  std::uint32_t first_tet = 0, tet_count = 0;        ///< where they are in Pipeline::tets_, if they are there
  /// In step: the facet glued to each of its facets, as 4 * position of its tetrahedron + slot; kNone
  /// elsewhere
  std::vector<std::array<std::uint32_t, 4>> partners;
  CellReport report;
  double delaunay_seconds = 0, pruning_seconds = 0;
  CellRequests asked;        ///< of other than the user, by final numbers
  SecondThoughts questions;  ///< by final numbers
  Answers answers;           ///< to them, by final numbers and faces of the arrangement
  std::vector<std::array<std::uint32_t, 4>> bridge_tets;
  std::vector<GroundTriangle> bridge_ground;
  CellBridges bridges;              ///< mode natural
  std::vector<SpikeOnFace> spikes;  ///< mode natural
  std::vector<std::array<std::uint32_t, 4>> roof_tets;
  std::vector<GroundTriangle> ground;   ///< internal triangles that kept tetrahedra stand on
  std::vector<std::uint32_t> feet;      ///< in step: the facets there; what bridges stand on comes after
  std::vector<InsidePoint> inside;      ///< by round, and each in lexicographic order
  std::vector<std::uint32_t> interior;  ///< in step: their numbers, ascending
  BuiltCell built;                      ///< only for an observer
  PruneResult pruned;
  bool may_branch = false;              ///< samples are wanted if it lacks something
  bool lacks_roof = false;              ///< handles had to be taken out of it: samples over holes are wanted
  bool due = true;                      ///< to be pruned: not yet done, or its faces have changed
  bool undivided = false;               ///< without the points inside that it wants: samples may come first
  std::unique_ptr<CellInHand> waiting;  ///< the cell as it is until then, if it is undivided

  void renumber(std::span<const std::uint32_t> number);
  void begin_anew();
  void move_to(SolidInCells& solid);
};

/// run(), and fill_cells() in it, go through the stages in the order in which they are declared. Where the
/// second look or a spike changes cells, bridges are built anew.
class Pipeline {
 public:
  Pipeline(const Sections& sections, const Options& options, const Context& context, Observer* observer)
      : sections_(sections), options_(options), context_(context), observer_(observer) {}
  Result<Reconstruction> run();
  /// The same for a part of a stack.
  Result<Reconstruction> run_window(Window& window);

 private:
  // reconstruct.cpp
  Result<Done> frame();
  Result<Done> arrange();
  // face_stage.cpp
  Result<Done> triangulate_faces();
  // cell_stage.cpp
  Result<Done> fill_cells();
  // interior_stage.cpp
  bool is_in(InCells which, CellId id) const;
  Result<Done> divide(CellInHand& hand, CellState& state) const;
  void number_inside_points();
  // bridge_stage.cpp
  void build_bridges();
  void close_edges(std::span<OpenEdge> open, std::vector<BuiltBridges>& built);
  bool build_at(OpenEdge& open, bool may_make_handles, std::vector<BuiltBridges>& built);
  bool build_bridge(std::uint32_t cell, std::uint32_t number, bool may_make_handles, EdgeRing& ring,
                    BuiltBridges& built);
  void remove_bridges();
  // second_look_stage.cpp
  Result<Done> look_again();
  Result<std::vector<Piece>> find_pieces();
  /// Those that are due, though the solid has been put together.
  Result<Done> prune_again();
  // spike_stage.cpp
  Result<Done> drop_spikes();
  // thicken_stage.cpp
  Result<Done> thicken();
  Result<std::vector<CellRoofs>> roofs_on(std::uint32_t side);
  void take_roofs(std::vector<CellRoofs> roofs);
  // glue_stage.cpp
  Result<Done> glue_cells();
  SolidInCells make_room();
  SolidInCells take_solid();
  void give_tets_back();
  // window.cpp
  std::uint32_t slab_of(CellId id) const;
  void note_slabs();
  void locate_surface();
  std::vector<std::uint32_t> slabs_of(std::span<const std::uint32_t> vertices) const;

  Result<Done> check_joins() const;
  Result<Done> check_input() const;
  void report_crossings();
  void find_heard_requests();
  void explain_requests();
  void explain_empty();

  /// Faces with samples are triangulated anew; vertices get new numbers in the same order.
  Result<Done> refine_faces(std::span<const std::vector<LatticePoint>> samples);
  void classify_lines();
  void finish_faces();
  void drop_what_samples_need();
  void drop_what_cells_need();

  std::vector<FaceId> inner_faces(CellId id) const;
  std::vector<CellFace> cell_faces(CellId id, std::span<const FaceId> ids) const;
  Result<Done> prune_due_cells();
  Result<Done> prune_cell(CellId id, CellState& state);
  Result<std::unique_ptr<CellInHand>> take_in_hand(CellId id, CellState& state) const;
  void cover_by_joint(const CellInHand& hand);
  Result<Done> check_layer(std::span<const CellFace> faces, const BuiltCell& layer) const;
  Result<BuiltCell> triangulate(std::span<const CellFace> faces, CellState& state) const;
  Result<Done> build(CellInHand& hand, CellState& state) const;
  PruneResult prune_built(const CellInHand& hand, const CellRequests& asked) const;
  Result<Done> answer(CellInHand& hand, CellState& state) const;
  void take_pruned(const CellInHand& hand, PruneResult& pruned, CellState& state);
  Result<Done> check_pruned(const BuiltCell& cell, const PruneResult& pruned) const;
  void report_topology(const BuiltCell& cell, const NaturalReport& natural, CellReport& report) const;
  void cover(std::span<const CellFace> faces, std::span<const FaceId> ids,
             std::span<const GroundTriangle> ground);
  void cover(CellId id, std::span<const GroundTriangle> ground);
  void cover_finally();
  Result<Done> find_branching_cells();
  bool is_near_branching(std::span<const FaceId> ids) const;
  bool may_take_samples(const CellState& state, std::span<const CellFace> faces) const;
  Result<Done> add_samples();
  Result<CellBranching> branch(CellId id, CellState& state);
  void take_tets();
  void finish_cells();

  Rounding rounding(const GluedSurface& glued) const;
  void mend(const GluedSurface& glued);
  void separate(const GluedSurface& glued);
  void report_planes();

  Error cancelled() const { return make_error(ErrorCode::cancelled, "cancelled"); }
  void note(std::string text) {
    context_.note(text);
    result_.report.notes.push_back(std::move(text));
  }
  void warn(std::string text) {
    context_.warn(text);
    result_.report.warnings.push_back(std::move(text));
  }
  template <class Work>
  Result<Done> for_all(std::size_t count, std::string_view stage, Work&& work) const {
    return crossloft::for_all(count, context_, stage, std::forward<Work>(work));
  }

  const Sections& sections_;
  const Options& options_;
  const Context& context_;
  Observer* observer_;
  Stopwatch watch_;
  LatticePointStore store_;
  FramedSections framed_;
  std::unique_ptr<GluedSurface> glued_;  ///< of the tetrahedra as they are, if they have been glued
  std::unique_ptr<Arrangement> arrangement_;
  SectionGraph graph_;
  std::vector<FaceInput> inputs_;  ///< by face of the arrangement, like faces_
  std::vector<FaceTriangulation> faces_;
  std::unique_ptr<PlaneLocators> locators_;
  std::unique_ptr<LineEdges> line_edges_;
  Numbering numbering_;
  std::unique_ptr<LazySectionField> field_;  ///< if joins in doubt may ask it
  std::vector<CellState> cells_;             ///< by cell of the arrangement
  bool samples_may_come_ = false;            ///< cells are pruned to see where branching samples are wanted
  bool points_may_come_ = false;             ///< cells may be divided by points inside
  std::vector<std::array<std::uint32_t, 4>> tets_;       ///< of the solid, taken out of the cells
  KnownFacets known_;                                    ///< of tets_, unless they have been glued
  std::vector<std::array<std::uint32_t, 4>> roof_tets_;  ///< of flat regions
  std::vector<std::uint32_t> thickened_;                 ///< by plane: its flat regions that got a plate
  std::vector<std::uint8_t> heard_;                      ///< by request: 1 if some cell has both contours
  Window* window_ = nullptr;                             ///< if the sections are a part of a stack
  Reconstruction result_;
};

}  // namespace crossloft
