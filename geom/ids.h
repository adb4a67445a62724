#pragma once
/// Strong index types: a plane's number can't be passed where a vertex's is meant.

#include <cstdint>
#include <functional>

namespace crossloft {

/// The one sentinel of every index of the library, strong or raw.
inline constexpr std::uint32_t kNone = 0xFFFFFFFFu;

template <class Tag>
struct Id {
  std::uint32_t value = kNone;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t v) : value(v) {}
  constexpr bool valid() const { return value != kNone; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using VertexId = Id<struct VertexTag>;  ///< a section vertex, global
using PlaneId = Id<struct PlaneTag>;    ///< a cutting plane, in canonical order
using CellId = Id<struct CellTag>;      ///< a cell of the arrangement
using FaceId = Id<struct FaceTag>;      ///< a face (2-cell) of the arrangement

}  // namespace crossloft

template <class Tag>
struct std::hash<crossloft::Id<Tag>> {
  std::size_t operator()(crossloft::Id<Tag> id) const noexcept { return id.value; }
};
