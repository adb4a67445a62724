#pragma once
/// From the grown complex to the final one: canonical numbers, incidence lists, sign rows, hash of sign
/// vectors. Used by build_arrangement only.

#include <span>
#include <vector>

#include "complex.h"
#include "growing_complex.h"

namespace crossloft {

class ArrangementAssembly {
 public:
  explicit ArrangementAssembly(const GrowingComplex& grown) : grown_(grown) {}

  /// O(v log v) for the vertices, linear in the lists for all else while only a few elements share a vertex.
  Arrangement run(std::span<const LatticePlane> given_and_box, const LatticeBox& box);

 private:
  void number_vertices();
  void number_edges();
  void choose_edge_planes();
  void number_faces();
  void lay_out_faces();
  void number_cells();
  void invert_lists();
  void fill_rows();
  void hash_rows();

  const GrowingComplex::Face& old_face(std::uint32_t use) const {
    return grown_.faces()[grown_.uses()[use].face];
  }

  const GrowingComplex& grown_;
  Arrangement out_;
  std::vector<std::uint32_t> vertex_ids_, edge_ids_;  ///< grown to final
  std::vector<std::uint32_t> loop_starts_;            ///< of each final face: the use of its lowest vertex
};

/// Where the search for a sign vector starts in a table of a power of two `slots`.
std::size_t first_slot(SignView signs, std::size_t slots);

}  // namespace crossloft
