#pragma once
/// Closed meshes that the project makes itself: test data and the demo. All are closed oriented 2-manifolds,
/// made with + - * / sqrt only, hence the same to the bit on every platform.

#include <cstdint>
#include <functional>

#include "../reconstruct/surface.h"
#include "../geom/bounds.h"

namespace crossloft {

/// Tube of radius r around the circle of radius R about the z axis, as the nu x nv parameter grid, each
/// quadrilateral cut in two. REQUIRES: R > r > 0, nu, nv >= 3.
Surface torus(double R, double r, std::uint32_t nu, std::uint32_t nv);
/// The box as 12 triangles.
Surface box_mesh(const Bounds& box);

/// The solid { field < 0 } within the box by marching tetrahedra: `cells` cubes along the longest side, six
/// tetrahedra each. Closed at the box's sides. Vertices keep 2 % of an edge's length away from its ends, so
/// no triangle is degenerate. O(cells^3). Source: Doi and Koide 1991.
Surface implicit_solid(const std::function<double(const Vec3&)>& field, const Bounds& box,
                       std::uint32_t cells);

// Solids within about [-1, 1]^3; `cells` as above.
Surface genus2_solid(std::uint32_t cells = 64);   ///< two rings that share a bar
Surface genus3_solid(std::uint32_t cells = 64);   ///< a disk with three holes
Surface trefoil_solid(std::uint32_t cells = 64);  ///< tube along the trefoil knot, genus 1
Surface vessel_solid(std::uint32_t cells = 64);   ///< tree of tapering tubes, genus 0
Surface gyroid_solid(std::uint32_t cells = 48);   ///< one side of a gyroid within a ball, genus 2
Surface nested_shells(std::uint32_t cells = 48);  ///< ball with a cavity that holds a ball: three components
/// The solid of the demo: a bear with its arms akimbo, 1.9 tall, z up, facing -y. Limbs branch from the body
/// and two holes go through (genus 2).
Surface demo_solid(std::uint32_t cells = 96);

}  // namespace crossloft
