#pragma once
/// What `.contour` and `.csl` have in common: the header of a plane, the sign of D, and materials.

#include "../arrangement/sections.h"
#include "../geom/context.h"
#include "token_reader.h"

namespace crossloft {

/// Reads "A B C D" into the plane. Errors: those of TokenReader::real, zero_normal.
void read_plane_equation(TokenReader& in, PlaneSection& plane);

/// Reads `count` vertices into the plane.
void read_vertices(TokenReader& in, std::uint32_t count, PlaneSection& plane);

/// The convention of D is n.x + D = 0, but files with n.x = D exist. One sign is chosen for the whole file,
/// the one with the smaller mean distance of the vertices from their planes; when it is n.x = D, offsets are
/// negated and the context is told.
void settle_sign_of_offset(Sections& sections, const Context& context);

/// Tells the context when walls bound more than one material: inside is any material.
void note_materials(const Sections& sections, const Context& context);

}  // namespace crossloft
