#pragma once
// The solid of a cell written down again from its definition, on sets of vertices: no neighbours, no turning
// around edges, no corners.

#include <cstdint>
#include <map>
#include <vector>

#include "prune/cell_complex.h"

namespace crossloft::test {

using Simplex = std::vector<std::uint32_t>;  ///< vertices, ascending
using Flags = std::vector<std::uint8_t>;

Simplex sorted(Simplex s);
bool has(const Simplex& s, const Simplex& face);
Simplex common(const Simplex& s, const Simplex& t);

/// Numbers 0..n-1 put into groups by pairs; group = smallest number in it. O(n) a pair.
class Groups {
 public:
  explicit Groups(std::size_t size);
  void put_together(std::size_t a, std::size_t b);
  std::size_t of(std::size_t x) const { return group_[x]; }
  std::size_t count() const;

 private:
  std::vector<std::size_t> group_;
};

/// Pieces of the cell are its tetrahedra, by their numbers, and after them the *collar*: one prism on each
/// hull triangle. The solid is the kept tetrahedra and the prisms on internal triangles, all else is outside.
/// Two pieces touch in the vertices they share if these are a triangle, or a hull edge between two prisms.
class BruteSolid {
 public:
  explicit BruteSolid(const CellComplex& cell);

  struct Counts {
    std::size_t sections = 0, bodies = 0, outsides = 0, voids = 0, curves = 0, bare = 0;
    std::int64_t genus = 0, euler = 0;
    bool every_part_is_a_surface = true;  ///< its genus is an integer that is not negative
  };
  Counts count(const Flags& kept) const;

  /// Euler characteristic of the solid with wedges apart at edges and stars apart at vertices.
  std::int64_t euler_of_solid(const Flags& kept) const;
  /// Connected parts of the solid through facets, by piece; pieces outside are alone.
  Groups bodies(const Flags& kept) const;
  /// The pieces at a simplex that are in the solid, in groups that hang together through facets with it.
  Groups star(const Flags& kept, const Simplex& simplex) const;
  /// The piece on the other side of a triangle of tetrahedron t, a prism on the hull.
  std::size_t across(std::uint32_t t, const Simplex& triangle) const;
  bool is_solid(const Flags& kept, std::size_t piece) const;
  /// Prisms on internal triangles.
  std::vector<std::size_t> ground() const;

  const std::vector<Simplex>& pieces() const { return pieces_; }
  std::size_t tets() const { return tets_; }

 private:
  struct Touch {
    std::size_t a, b;
    Simplex common;
  };
  /// S: a triangle with solid on one side, and the piece there.
  struct Wall {
    Simplex triangle;
    std::size_t solid;
  };
  std::vector<Wall> walls(const Flags& kept) const;
  Groups outsides(const Flags& kept) const;
  void count_surface(const Flags& kept, Counts& counts) const;

  std::size_t tets_;
  std::vector<Simplex> pieces_;
  std::vector<std::uint8_t> is_ground_;  ///< by piece
  std::vector<Touch> touches_;
  std::map<Simplex, std::vector<std::size_t>> faces_[3];  ///< pieces at each vertex, edge and triangle
};

}  // namespace crossloft::test
