#pragma once
/// Second thoughts about a cell, once the whole solid is known.
///
/// A cell can't know what the cells around it do. Together they may leave a small body that nothing is joined
/// with in any of them, or close a hole from all sides to a cavity. Both are unlikely: what one plane, or two
/// or three at their common line or point, meet by chance is rather the tip of a bump or of a dent. So each
/// cell is asked how sure it is, and the least sure of them is told to change.

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "../geom/context.h"
#include "cell_complex.h"
#include "cell_shape.h"
#include "ground.h"
#include "joins.h"
#include "outside.h"

namespace crossloft {

/// One question about each component of the surface: a body by the tetrahedra of the cell at it, a cavity by
/// facets at it (those that the cell does not see from the outside are passed over).
struct SecondThoughts {
  std::vector<std::vector<TetName>> bodies;
  std::vector<std::vector<Triangle>> cavities;

  bool empty() const { return bodies.empty() && cavities.empty(); }
};

struct BodyAnswer {
  bool is_alone = false;        ///< it is one body in this cell, and stands on one part of the sections
  bool can_join = false;        ///< there is a way to another body
  std::int32_t confidence = 0;  ///< of the weakest tetrahedron on the best way
  TetName target{kNone, kNone, kNone, kNone};  ///< a kept one at its end; kNone if that is bare ground
};

/// Of one part of a cavity in the cell.
struct CavityAnswer {
  Opening opening = Opening::none;
  std::uint32_t face = kNone;  ///< of the hole, if it is one
  bool can_open = false;
  std::int32_t confidence = 0;  ///< of the strongest tetrahedron that must go
  TetName from{}, to{};         ///< outside, in the cavity and where the way out leads
};

struct Answers {
  std::vector<BodyAnswer> bodies;
  std::vector<std::vector<CavityAnswer>> cavities;
};

/// Tetrahedra from a body to another one.
struct Way {
  std::vector<std::uint32_t> tets;
  Join join;
  TetName target{kNone, kNone, kNone, kNone};  ///< as in BodyAnswer
};

/// What a cell does about it. `candidates`: what a body may be joined by, contains `kept`.
/// O(n log n) once, and then what the ways come to for each body.
class SecondLook {
 public:
  /// The confidence of a tetrahedron, the same each time.
  using Measure = std::function<std::int32_t(std::uint32_t)>;

  SecondLook(const CellComplex& complex, const Ground& ground, const std::vector<std::uint8_t>& candidates,
             const std::vector<std::uint8_t>& kept, Measure measure);
  ~SecondLook();

  /// One answer for each question, in the order of the questions; O(n log n) more for each part of a cavity.
  /// Once `cancel` is raised they come soon, and mean nothing.
  Answers answer(const SecondThoughts& questions, CancelFlag cancel = nullptr);
  /// The way from a body to another one that is most confident where it is weakest, if simple moves and one
  /// join add it; else nothing, as if the body stands on several parts of the sections.
  Way way_from(const TetName& body);
  /// The way has been added to what is kept.
  void see(const Way& way);

 private:
  struct Bodily;
  bool is_free(std::uint32_t t) const { return candidates_[t] != 0 && kept_[t] == 0; }
  Bodily& bodily();
  BodyAnswer answer_body(const std::vector<TetName>& names);
  Way way_from(std::uint32_t start);
  CavityAnswer answer_part(const OutsidePart& part, std::uint32_t start) const;

  const CellComplex& complex_;
  const Ground& ground_;
  const std::vector<std::uint8_t>& candidates_;
  const std::vector<std::uint8_t>& kept_;
  Measure measure_;
  std::unique_ptr<Bodily> bodily_;  ///< once a body is asked
};

/// What a cell with that solid answers. O(n log n) and a confidence for each tetrahedron that ways come to.
Answers answer_questions(const CellComplex& complex, const Ground& ground, const CellShape& shape,
                         const std::vector<std::uint8_t>& kept, const SecondThoughts& questions,
                         CancelFlag cancel = nullptr);

}  // namespace crossloft
