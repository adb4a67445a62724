#include "circle.h"
#include "solids.h"

namespace crossloft {

Surface torus(double R, double r, std::uint32_t nu, std::uint32_t nv) {
  Surface mesh;
  for (std::uint32_t i = 0; i < nu; ++i)
    for (std::uint32_t j = 0; j < nv; ++j) {
      const SineCosine u = circle(static_cast<double>(i) / nu), v = circle(static_cast<double>(j) / nv);
      const double radius = R + r * v.cosine;
      mesh.points.push_back({radius * u.cosine, radius * u.sine, r * v.sine});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % nu * nv + j % nv; };
  for (std::uint32_t i = 0; i < nu; ++i)
    for (std::uint32_t j = 0; j < nv; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

Surface box_mesh(const Bounds& box) {
  Surface mesh;
  for (int k = 0; k < 8; ++k)  // bit 0 of k: x, bit 1: y, bit 2: z
    mesh.points.push_back(
        {k & 1 ? box.high.x : box.low.x, k & 2 ? box.high.y : box.low.y, k & 4 ? box.high.z : box.low.z});
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return mesh;
}

}  // namespace crossloft
