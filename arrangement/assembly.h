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

  /// O(n log n) in the number of elements.
  Arrangement run(std::span<const LatticePlane> given_and_box, const LatticeBox& box);

 private:
  void number_vertices();
  void number_edges();
  void choose_edge_planes();
  void number_faces();
  void lay_out_faces();
  void number_cells();
  void lay_out_cells();
  void invert_lists();
  void fill_rows();
  void hash_rows();

  const GrowingComplex& grown_;
  Arrangement out_;
  std::vector<std::uint32_t> vertex_ids_, edge_ids_, face_ids_;  ///< grown to final
  std::vector<std::uint32_t> old_faces_;                         ///< final to grown
};

/// Where the search for a sign vector starts in a table of a power of two `slots`.
std::size_t first_slot(SignView signs, std::size_t slots);

}  // namespace crossloft
