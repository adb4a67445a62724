#include "messages.h"

namespace crossloft {

std::string why_empty(std::size_t filled) {
  if (filled == 0) return "the surface is empty: no plane has a section";
  if (filled == 1)
    return "the surface is empty: only one plane has a section, so there is nothing to join it to";
  return "the surface is empty: no two sections face each other within one cell of the arrangement";
}

std::string tell_flats(std::size_t regions) {
  return std::to_string(regions) +
         " section regions stay bare on both sides: the solid does not contain them";
}

std::string tell_unsampled(std::size_t faces) {
  return std::to_string(faces) + (faces == 1 ? " face goes" : " faces go") +
         " without branching samples: contours come too close to them";
}

std::string tell_merged(std::size_t vertices) {
  return std::to_string(vertices) +
         " vertices were merged with others, as triangles crossed after rounding: some have no area";
}

std::string tell_crowded(std::size_t copies) {
  return std::to_string(copies) +
         " copies of vertices stay where they touch: too many triangles are around them";
}

std::string tell_contacts(std::size_t pairs, std::size_t copies) {
  return std::to_string(pairs) + " pairs of triangles touch: " + std::to_string(copies) +
         " vertices could not be moved apart";
}

}  // namespace crossloft
