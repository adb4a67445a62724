/// Cells of the arrangement: triangulated, pruned, and again if their faces got samples.

#include "pipeline.h"

#include <algorithm>

#include "../prune/confidence.h"
#include "../prune/solidity.h"
#include "../prune/star.h"
#include "../prune/verify.h"
#include "layer_cell.h"
#include "pruning_input.h"
#include "self_check.h"

namespace crossloft {
namespace {

std::vector<GroundTriangle> ground_under(const BuiltCell& cell, const std::vector<std::uint8_t>& kept) {
  std::vector<GroundTriangle> list;
  auto next = cell.ground.begin();
  for (std::size_t t = 0; t < kept.size(); ++t) {
    const auto& kinds = cell.complex.facets[t];
    const auto last = next + std::count(kinds.begin(), kinds.end(), FacetKind::internal);
    if (kept[t] != 0) list.insert(list.end(), next, last);
    next = last;
  }
  return list;
}

std::vector<SpikeOnFace> spikes_of(const BuiltCell& cell, const NaturalReport& report) {
  std::vector<SpikeOnFace> list;
  if (report.spikes.empty()) return list;
  std::vector<std::uint32_t> spike_of(cell.complex.mesh.size(), kNone);
  for (const Spike& spike : report.spikes) {
    for (const std::uint32_t t : spike.tets) spike_of[t] = static_cast<std::uint32_t>(list.size());
    TetName name = sorted_vertices(cell.complex.mesh, spike.tets[0]);
    for (std::uint32_t& v : name) v = cell.vertices[v];  // ascending too
    list.push_back({spike.confidence, name, {}});
  }
  auto next = cell.ground.begin();
  for (std::size_t t = 0; t < spike_of.size(); ++t)
    for (const FacetKind kind : cell.complex.facets[t]) {
      if (kind != FacetKind::internal) continue;
      if (spike_of[t] != kNone) list[spike_of[t]].ground.push_back(*next);
      ++next;
    }
  return list;
}

/// New lists of the cell's part of the solid, no longer than they need: together they are much of the memory.
void renew_lists(const BuiltCell& cell, const std::vector<std::uint8_t>& kept, CellState& state) {
  const auto tets = static_cast<std::size_t>(std::count(kept.begin(), kept.end(), std::uint8_t{1}));
  state.tets = {}, state.partners = {}, state.feet = {};
  state.tets.resize(tets);
  state.partners.resize(tets, {kNone, kNone, kNone, kNone});
  state.ground = ground_under(cell, kept);
  state.ground.shrink_to_fit();
  state.feet.reserve(state.ground.size());
}

/// The cell's part of the solid into its lists.
void take_kept(const BuiltCell& cell, const std::vector<std::uint8_t>& kept, CellState& state) {
  const TetMesh& mesh = cell.complex.mesh;
  std::vector<std::uint32_t> position(kept.size(), kNone);
  renew_lists(cell, kept, state);
  std::uint32_t next = 0;
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    if (kept[t] == 0) continue;
    const std::uint32_t at = position[t] = next++;
    for (std::size_t i = 0; i < 4; ++i) {
      state.tets[at][i] = cell.vertices[mesh.vertices[t][i]];
      const auto facet = 4 * at + static_cast<std::uint32_t>(i);
      if (cell.complex.facets[t][i] == FacetKind::internal) state.feet.push_back(facet);
      const std::uint32_t n = mesh.neighbours[t][i];
      if (n == kNone || position[n] == kNone) continue;  // the later one of two joins them
      const unsigned back = facet_towards(mesh, n, t);
      state.partners[at][i] = 4 * position[n] + back;
      state.partners[position[n]][back] = facet;
    }
  }
}

}  // namespace

void add_up(const CellReport& cell, TopologyReport& sum) {
  sum.handles += cell.topology.genus;
  sum.handles_before += cell.genus_before;
  sum.handles_asked += cell.handles_asked;
  sum.grown_cells += cell.grown ? 1U : 0U;
  sum.walls += std::max(cell.topology.outsides, 1U) - 1;
  sum.voids += cell.topology.voids;
  sum.bodies_joined += cell.joined_alone;
  sum.walls_opened += cell.opened;
  sum.spikes_dropped += cell.dropped;
  for (const JoinReport& join : cell.joins) {
    ++(join.done ? sum.joins : sum.refused_joins);
    if (join.done) sum.weakest_join = std::min(sum.weakest_join, join.confidence);
  }
}

std::vector<FaceId> Pipeline::inner_faces(CellId id) const {
  std::vector<FaceId> ids;
  for (const FaceId f : arrangement_->faces_of(id))
    if (!arrangement_->on_box(f)) ids.push_back(f);
  return ids;
}

std::vector<CellFace> Pipeline::cell_faces(CellId id, std::span<const FaceId> ids) const {
  std::vector<CellFace> faces;
  for (const FaceId f : ids)
    faces.push_back(
        {&faces_[f.value], numbering_.of_face[f.value], arrangement_->cells_of(f)[0] == id ? 0u : 1u});
  return faces;
}

/// Marks the section triangles that the cell covers; each cell has its own side of each face.
void Pipeline::cover(std::span<const CellFace> faces, std::span<const FaceId> ids,
                     std::span<const GroundTriangle> ground) {
  const auto covered = [&](std::size_t f) -> auto& { return faces_[ids[f].value].covered[faces[f].side]; };
  for (std::size_t f = 0; f < faces.size(); ++f) std::fill(covered(f).begin(), covered(f).end(), 0);
  for (const GroundTriangle& g : ground) covered(g.face)[g.triangle] = 1;
}

void Pipeline::cover(CellId id, std::span<const GroundTriangle> ground) {
  const std::vector<FaceId> ids = inner_faces(id);
  cover(cell_faces(id, ids), ids, ground);
}

/// Until now the cells may show what lacks solid ground instead (prune_cell).
void Pipeline::cover_finally() {
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    if (cells_[c].report.tets_r0 == 0) continue;
    std::vector<GroundTriangle>& ground = cells_[c].ground;
    ground.insert(ground.end(), cells_[c].bridge_ground.begin(), cells_[c].bridge_ground.end());
    cover(CellId{c}, ground);
  }
}

PruneResult Pipeline::prune_built(const CellInHand& hand, const CellRequests& asked) const {
  const CellComplex& complex = hand.built.complex;
  if (options_.mode != PruneMode::natural) return prune(complex, *hand.ground, {}, {options_.mode, {}}, {});
  CellRequests requests = by_local_numbers(asked, hand.built);
  requests.wishes = cell_wishes(options_.joins, hand.faces, hand.built);
  requests.walls = is_in(InCells::automatic, hand.id);  // elsewhere a hull has one wide part
  requests.handles = !is_in(InCells::automatic, hand.id);  // where planes meet none was ever found
  requests.cancel = context_.cancel;
  return prune(complex, *hand.ground, hand.shape, {options_.mode, options_.natural}, requests);
}

/// Joins by places instead of the cell's vertices.
void Pipeline::report_topology(const BuiltCell& cell, const NaturalReport& natural,
                               CellReport& report) const {
  const auto place = [&](std::uint32_t v) { return framed_.grid.from_lattice(cell.points[v]); };
  const auto share = [](std::int32_t confidence) { return static_cast<double>(confidence) / kCertain; };
  report.topology = natural.after;
  report.genus_before = natural.before.genus;
  report.handles_asked = natural.handles;
  report.grown = natural.grown;
  report.joined_alone = natural.joined_alone;
  report.opened = natural.opened;
  report.dropped = natural.dropped;
  report.joins.clear();
  report.domes.clear();
  for (const Join& j : natural.joins)
    report.joins.push_back({place(j.a), place(j.b), share(j.confidence), j.done});
  for (const std::int32_t c : natural.domes) report.domes.push_back(share(c));
}

Result<Done> Pipeline::check_pruned(const BuiltCell& cell, const PruneResult& pruned) const {
  return self_check("pruning", [&] {
    if (!verify(cell.complex)) return "a cell's tetrahedra or kinds are wrong";
    if (options_.mode == PruneMode::natural)
      return verify_natural(cell.complex, pruned) ? "" : "a cell has a handle, a hole or a wrong report";
    const bool may_fail = options_.mode == PruneMode::paper_literal;  // as documented
    return may_fail || verify(cell.complex, pruned) ? "" : "a cell is not solid";
  });
}

Result<Done> Pipeline::check_layer(std::span<const CellFace> faces, const BuiltCell& layer) const {
  return self_check("Delaunay between two planes", [&] {
    CellTriangulation triangulation(faces.size());
    if (!triangulation.add(faces, numbering_.points)) return "no triangulation";
    const auto inserted = build_cell(faces, triangulation, *line_edges_, numbering_.graph_vertex);
    if (!inserted) return "other facets";
    return kinds_of(inserted->complex) == kinds_of(layer.complex) ? "" : "other tetrahedra or kinds";
  });
}

/// Points inside the cell need a triangulation that takes them.
Result<BuiltCell> Pipeline::triangulate(std::span<const CellFace> faces, CellState& state) const {
  if (state.inside.empty()) {
    Stopwatch watch;
    if (auto layer = build_layer_cell(faces, numbering_.points)) {
      state.delaunay_seconds += watch.lap();
      state.triangulation.reset();
      if (auto good = check_layer(faces, *layer); !good) return good.error();
      return std::move(*layer);
    }
  }
  if (!state.triangulation) state.triangulation = std::make_unique<CellTriangulation>(faces.size());
  CellTriangulation& triangulation = *state.triangulation;
  const double before = triangulation.seconds();
  if (auto done = triangulation.add(faces, numbering_.points); !done) return done.error();
  const std::size_t known = triangulation.inside_count();
  std::vector<LatticePoint> inside;
  for (std::size_t k = known; k < state.inside.size(); ++k) inside.push_back(state.inside[k].point);
  if (auto done = triangulation.add_inside(inside, std::span(state.interior).subspan(known)); !done)
    return done.error();
  state.delaunay_seconds += triangulation.seconds() - before;
  return build_cell(faces, triangulation, *line_edges_, numbering_.graph_vertex);
}

/// Its triangulation takes in what it lacks. Without tetrahedra there is no more than that.
Result<Done> Pipeline::build(CellInHand& hand, CellState& state) const {
  auto built = triangulate(hand.faces, state);
  if (!built) return built.error();
  hand.built = std::move(built).value();
  if (hand.built.complex.mesh.size() == 0) return Done{};
  Stopwatch watch;
  hand.ground.emplace(hand.built.complex);
  if (options_.mode == PruneMode::natural) {
    hand.shape = cell_shape(*arrangement_, hand.id, hand.ids, hand.built);
    hand.shape.memory = &hand.memory;
  }
  state.pruning_seconds += watch.lap();
  return Done{};
}

/// As it was left waiting, or built; nothing if there is nothing that could be kept.
Result<std::unique_ptr<CellInHand>> Pipeline::take_in_hand(CellId id, CellState& state) const {
  const bool is_built = state.waiting != nullptr;
  auto hand = is_built ? std::move(state.waiting) : std::make_unique<CellInHand>();
  hand->id = id;
  hand->ids = inner_faces(id);
  hand->faces = cell_faces(id, hand->ids);
  if (is_built) return hand;
  if (!has_section(hand->faces)) return std::unique_ptr<CellInHand>();
  if (auto done = build(*hand, state); !done) return done.error();
  if (hand->built.complex.mesh.size() == 0) return std::unique_ptr<CellInHand>();
  return hand;
}

Result<Done> Pipeline::prune_cell(CellId id, CellState& state) {
  state.due = state.undivided = false;
  auto taken = take_in_hand(id, state);
  if (!taken) return taken.error();
  if (!*taken) return Done{};
  CellInHand& hand = **taken;
  if (!state.questions.empty()) return answer(hand, state);
  if (auto done = divide(hand, state); !done) return done;
  Stopwatch watch;
  // Where planes meet, samples are wanted for nothing but what is covered.
  if (state.undivided && is_in(InCells::automatic, id)) {
    cover_by_joint(hand);
    state.pruning_seconds += watch.lap();
    state.waiting = std::move(taken).value();
    return Done{};
  }
  // Joins in doubt wait for the points.
  const bool asks = is_in(options_.natural.look_around, id) && !state.undivided;
  hand.shape.field = asks ? field_.get() : nullptr;
  PruneResult pruned = prune_built(hand, state.asked);
  if (context_.cancelled()) return cancelled();
  if (auto good = check_pruned(hand.built, pruned); !good) return good;
  report_topology(hand.built, pruned.natural, state.report);
  state.pruning_seconds += watch.lap();
  take_pruned(hand, pruned, state);
  if (!may_take_samples(state, hand.faces) && !state.undivided && !state.lacks_roof)
    state.triangulation.reset();
  if (state.undivided)
    state.waiting = std::move(taken).value();
  else if (observer_)
    state.built = std::move(hand.built), state.pruned = std::move(pruned);
  return Done{};
}

/// All that a solid subset can cover.
void Pipeline::cover_by_joint(const CellInHand& hand) {
  cover(hand.faces, hand.ids, ground_under(hand.built, prune(hand.built.complex, PruneMode::joint).kept));
}

void Pipeline::take_pruned(const CellInHand& hand, PruneResult& pruned, CellState& state) {
  const BuiltCell& cell = hand.built;
  CellReport& report = state.report;
  report.faces = static_cast<std::uint32_t>(hand.faces.size());
  report.vertices = cell.complex.vertex_count;
  report.tets_r0 = pruned.r0, report.tets_r1 = pruned.r1, report.tets_r2 = pruned.r2,
  report.tets_r3 = pruned.r3;
  report.bad_links = pruned.natural.after.bad_links;
  take_kept(cell, pruned.kept, state);
  if (options_.mode == PruneMode::natural) state.bridges = find_bridges(cell, *hand.ground, pruned.kept);
  state.spikes = spikes_of(cell, pruned.natural);
  // Natural may leave a section no more than a spike that no solid subset would have: it lacks samples even
  // so. Where natural is solid and covers all, so does the largest solid subset.
  const CellTopology& topology = pruned.natural.after;
  state.lacks_roof = samples_may_come_ && report.genus_before > 0 && !is_in(InCells::automatic, hand.id);
  const bool ask_joint =
      samples_may_come_ && options_.mode == PruneMode::natural && is_near_branching(hand.ids) &&
      !(topology.bare == 0 && topology.bad_links == 0 && has_ground_everywhere(cell.complex, pruned.kept));
  if (ask_joint)
    cover_by_joint(hand);
  else
    cover(hand.faces, hand.ids, state.ground);
}

/// Whether samples may be wanted in a cell that has been pruned; what is covered from its other sides is not
/// known yet.
bool Pipeline::may_take_samples(const CellState& state, std::span<const CellFace> faces) const {
  return state.may_branch && (!options_.branching.only_where_lacking() || is_somewhere_bare(faces));
}

/// Whether the cell, or one across its faces, is asked what it lacks: it looks at what both cover.
bool Pipeline::is_near_branching(std::span<const FaceId> ids) const {
  return std::any_of(ids.begin(), ids.end(), [&](FaceId f) {
    const auto cells = arrangement_->cells_of(f);
    return std::any_of(cells.begin(), cells.end(), [&](CellId c) { return cells_[c.value].may_branch; });
  });
}

/// A cell's components are no more than those of its faces together, and as many where the faces have no
/// vertices in common: most cells are told by that, all of a stack.
Result<Done> Pipeline::find_branching_cells() {
  const BranchingOptions& wanted = options_.branching;
  if (wanted.mode == Branching::off && !wanted.cutting) return Done{};
  std::vector<std::uint32_t> components(faces_.size());
  std::vector<std::uint8_t> on_lines(faces_.size());
  const auto count = [&](std::size_t f) -> Result<Done> {
    components[f] = section_components(faces_[f]);
    const auto& v = faces_[f].vertices;
    on_lines[f] = std::any_of(v.begin(), v.end(), [&](auto x) { return graph_.locations[x].dimension != 2; });
    return Done{};
  };
  if (auto done = for_all(faces_.size(), "facing sections", count); !done) return done;
  return for_all(cells_.size(), "facing sections", [&](std::size_t c) -> Result<Done> {
    const CellId id{static_cast<std::uint32_t>(c)};
    const std::vector<FaceId> ids = inner_faces(id);
    std::uint32_t most = 0;
    bool meet = false;
    for (const FaceId f : ids) most += components[f.value], meet |= on_lines[f.value] != 0;
    cells_[c].may_branch = most > wanted.most_without_samples() &&
                           (!meet || BranchingCell(graph_, *arrangement_, *locators_, ids,
                                                   cell_faces(id, ids), numbering_.points, wanted)
                                         .may_branch());
    return Done{};
  });
}

Result<Done> Pipeline::prune_due_cells() {
  return for_all(cells_.size(), "cells", [&](std::size_t c) -> Result<Done> {
    if (!cells_[c].due) return Done{};
    return prune_cell(CellId{static_cast<std::uint32_t>(c)}, cells_[c]);
  });
}

/// Diagrams and samples of one cell, where there can be any.
Result<CellBranching> Pipeline::branch(CellId id, CellState& state) {
  if (!state.may_branch && !state.lacks_roof) return CellBranching{};
  const std::vector<FaceId> ids = inner_faces(id);
  const std::vector<CellFace> faces = cell_faces(id, ids);
  if (options_.branching.only_where_lacking() && !observer_ && !state.lacks_roof && !is_somewhere_bare(faces))
    return CellBranching{};
  BranchingCell cell(graph_, *arrangement_, *locators_, ids, faces, numbering_.points, options_.branching);
  cell.find_bare();
  if (state.lacks_roof) cell.find_holes();
  if (!cell.lacks_something() && !observer_) return CellBranching{};
  std::unique_ptr<CellTriangulation> faces_only;  // a diagram has no sites inside the cell
  auto& triangulation = state.inside.empty() ? state.triangulation : faces_only;
  if (!triangulation) triangulation = std::make_unique<CellTriangulation>(faces.size());
  if (auto done = triangulation->add(faces, numbering_.points); !done) return done.error();
  if (triangulation->dimension() < 3) return CellBranching{};
  return cell.run(*triangulation, observer_ != nullptr);
}

/// A face of it got samples. Points that it took inside before had numbers that samples have now, and others
/// may be wanted. What has been made of them goes too: renumber() would not know them any more.
void CellState::begin_anew() {
  due = true;
  waiting.reset();
  spikes.clear();
  if (inside.empty()) return;
  inside.clear(), interior.clear();
  triangulation.reset();
  tets.clear(), partners.clear(), feet.clear(), ground.clear();
  bridges = {}, built = {}, pruned = {};
}

Result<Done> Pipeline::add_samples() {
  std::vector<CellBranching> found(cells_.size());
  const auto good = for_all(cells_.size(), "branching", [&](std::size_t c) -> Result<Done> {
    auto branching = branch(CellId{static_cast<std::uint32_t>(c)}, cells_[c]);
    if (!branching) return branching.error();
    found[c] = std::move(branching).value();
    return Done{};
  });
  if (!good) return good;
  std::vector<std::vector<LatticePoint>> samples(faces_.size());
  for (const CellBranching& cell : found) {
    result_.report.seconds.branching += cell.seconds;
    for (const FaceBranching& face : cell.faces) {
      merge_samples(face, samples[face.face.value]);
      if (observer_) observer_->on_branching(face, faces_[face.face.value], numbering_);
    }
  }
  for (std::uint32_t f = 0; f < samples.size(); ++f)
    if (!samples[f].empty())
      for (const CellId c : arrangement_->cells_of(FaceId{f})) cells_[c.value].begin_anew();
  for (CellState& cell : cells_) {
    cell.due |= cell.undivided;
    if (!cell.due) cell.triangulation.reset();
  }
  const bool none =
      std::all_of(samples.begin(), samples.end(), [](const auto& list) { return list.empty(); });
  return none ? Result<Done>(Done{}) : refine_faces(samples);
}

/// Without samples first: automatic branching looks at what that leaves bare.
Result<Done> Pipeline::fill_cells() {
  cells_.resize(arrangement_->cell_count());
  const NaturalOptions& natural = options_.natural;
  if (options_.mode == PruneMode::natural && natural.look_around != InCells::off)
    field_ = std::make_unique<LazySectionField>([this] { return section_field(graph_); });
  points_may_come_ = options_.mode == PruneMode::natural && natural.divide != InCells::off;
  const Branching mode = options_.branching.mode;
  const bool takes_samples = mode != Branching::off || options_.branching.cutting;
  samples_may_come_ = mode == Branching::automatic;
  if (auto done = find_branching_cells(); !done) return done;
  if (!takes_samples || samples_may_come_)
    if (auto done = prune_due_cells(); !done) return done;
  samples_may_come_ = false;
  if (takes_samples) {
    if (auto done = add_samples(); !done) return done;
    if (auto done = prune_due_cells(); !done) return done;
  }
  points_may_come_ = false;
  for (CellState& cell : cells_) cell.triangulation.reset();
  number_inside_points();
  drop_what_samples_need();
  build_bridges();
  if (options_.mode == PruneMode::natural)
    if (auto done = look_again(); !done) return done;
  if (auto done = drop_spikes(); !done) return done;
  cover_finally();
  if (options_.thicken > 0)
    if (auto done = thicken(); !done) return done;
  find_heard_requests();
  result_.report.seconds.cells = watch_.lap();
  finish_faces();
  finish_cells();
  return Done{};
}

/// Out of the cells, with what they know if it is still to be glued.
void Pipeline::take_tets() {
  if (glued_ && !tets_.empty()) return;
  SolidInCells solid = take_solid();
  tets_ = std::move(solid.tets);
  if (!glued_) known_ = std::move(solid.known);
}

void Pipeline::finish_cells() {
  Report& report = result_.report;
  take_tets();
  if (window_) note_slabs();
  for (std::uint32_t c = 0; c < cells_.size(); ++c) {
    CellState& cell = cells_[c];
    if (cell.report.tets_r0 == 0) continue;
    report.cells.push_back(cell.report);
    report.bad_links += cell.report.bad_links;
    add_up(cell.report, report.topology);
    report.seconds.delaunay += cell.delaunay_seconds;
    report.seconds.pruning += cell.pruning_seconds;
    if (observer_) observer_->on_cell(CellId{c}, cell.built, cell.pruned);
  }
  cells_.clear();
  for (std::uint32_t i = 0; i < roof_tets_.size(); ++i)
    known_.loose.push_back(static_cast<std::uint32_t>(tets_.size()) + i);
  tets_.insert(tets_.end(), roof_tets_.begin(), roof_tets_.end());
  if (!glued_) known_.partner.resize(4 * tets_.size(), kNone);
  report.seconds.cells += watch_.lap();
}

}  // namespace crossloft
