#pragma once
/// How a tetrahedron touches a growing solid (simple_growth.h).

#include <array>
#include <cstdint>
#include <vector>

#include "../geom/disjoint_sets.h"
#include "cell_complex.h"
#include "ground.h"

namespace crossloft {

/// The contact of one tetrahedron.
struct Contact {
  unsigned facets = 0;  ///< bit i: the facet opposite slot i is in the contact
  int parts = 0;        ///< connected parts of the contact
  int loops = 0;        ///< first Betti number of the contact
  /// [i]: a body of the solid at facet i; equal within a part.
  std::array<std::uint32_t, 4> bodies{};

  bool is_simple() const { return parts == 1 && loops == 0; }
  bool is_dome() const { return parts == 1 && loops > 0; }
  /// All of the tetrahedron is in contact: it is the last of a hole.
  bool is_plug() const { return parts == 1 && loops < 0; }
  /// Disks in different bodies.
  bool is_join() const { return parts > 1 && loops == 0 && different_bodies() == parts; }
  /// By which adding the tetrahedron changes the Euler characteristic of the solid.
  int change() const { return loops + 1 - parts; }
  /// Two disks in one body: it would get a handle.
  bool is_handle() const { return parts == 2 && loops == 0 && different_bodies() == 1; }
  int different_bodies() const;
};

/// A solid that starts as the ground of a cell and grows. What is added in a trial can be taken back.
class GrowingSolid {
 public:
  GrowingSolid(const CellComplex& complex, const Ground& ground);

  const std::vector<std::uint8_t>& kept() const { return kept_; }
  bool has(std::uint32_t t) const { return kept_[t] != 0; }
  /// O(1) and the degrees of the edges between facets of the contact.
  Contact contact(std::uint32_t t);
  void add(std::uint32_t t);
  void begin_trial() { in_trial_ = true; }
  /// O(what the trial has added).
  void end_trial(bool keep);
  /// Tetrahedra outside the solid next to t, across facets and beyond the solid at edges between facets of
  /// the contact; one for each part of the outside there that is not at the section's end, or several.
  std::vector<std::uint32_t> outside_around(std::uint32_t t, const Contact& contact) const;
  /// Which part of the solid within the star of vertex v is across facet i of t. REQUIRES: something is.
  std::uint32_t part_across(std::uint32_t t, unsigned i, std::uint32_t v) {
    return find(corners_, across(t, i, v));
  }
  /// The body that ground triangle g is part of.
  std::uint32_t body_of_ground(std::uint32_t g) { return find(bodies_, g); }

 private:
  std::uint32_t across(std::uint32_t t, unsigned i, std::uint32_t v) const;
  std::uint32_t ground_corner(std::uint32_t g, std::uint32_t v) const;
  std::uint32_t body_across(std::uint32_t t, unsigned i);
  unsigned glued_facets(std::uint32_t t) const;
  Facet end_of_turn(std::uint32_t t, unsigned i, unsigned j) const;
  bool closes_edge(std::uint32_t t, unsigned i, unsigned j) const;
  std::uint32_t find(DisjointSets& sets, std::uint32_t x) { return in_trial_ ? sets.root(x) : sets.find(x); }
  void join(DisjointSets& sets, std::vector<std::uint32_t>& joined, std::uint32_t a, std::uint32_t b);

  const CellComplex& complex_;
  const Ground& ground_;
  std::vector<std::uint8_t> kept_;
  /// Corners of ground triangles, 3 g + k, then of tetrahedra, 4 t + slot: equal within a vertex's star if
  /// the solid connects them there.
  DisjointSets corners_;
  DisjointSets bodies_;  ///< ground triangles, then tetrahedra: smallest member is a ground triangle
  std::uint32_t first_tet_corner_;
  bool in_trial_ = false;
  std::vector<std::uint32_t> tried_;                           ///< tetrahedra of the trial
  std::vector<std::uint32_t> joined_corners_, joined_bodies_;  ///< roots that it has joined to others
};

}  // namespace crossloft
