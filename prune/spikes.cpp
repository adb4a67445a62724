#include "spikes.h"

#include <algorithm>
#include <map>

#include "bodies.h"
#include "star.h"

namespace crossloft {
namespace {

std::uint32_t face_of(const CellComplex& complex, const Facet& facet) {
  const auto& v = complex.mesh.vertices[facet.tet];
  const auto& slots = kFacetSlots[facet.facet];
  return complex.common_face(v[slots[0]], v[slots[1]], v[slots[2]]);
}

/// By body, whether all it stands on is one part of the sections within one face.
std::map<std::uint32_t, bool> stand_on_one_face(const CellComplex& complex, const Ground& ground,
                                                Bodies& bodies) {
  std::map<std::uint32_t, bool> is_one;
  for (std::uint32_t g = 0; g < ground.size(); ++g) {
    const std::uint32_t body = bodies.of_ground(g);  // its smallest ground triangle
    const bool like_first = ground.part(g) == ground.part(body) &&
                            face_of(complex, ground.facet(g)) == face_of(complex, ground.facet(body));
    is_one.try_emplace(body, true).first->second &= like_first;
  }
  return is_one;
}

}  // namespace

std::vector<Spike> find_spikes(const CellComplex& complex, const Ground& ground,
                               const std::vector<std::uint8_t>& kept, std::int32_t limit,
                               const std::function<std::int32_t(std::uint32_t)>& confidence) {
  Bodies bodies(complex, ground, kept);
  std::map<std::uint32_t, bool> may_be = stand_on_one_face(complex, ground, bodies);
  std::map<std::uint32_t, Spike> spikes;
  for (std::uint32_t t = 0; t < kept.size(); ++t) {
    if (kept[t] == 0) continue;
    const auto body = may_be.find(bodies.of_tet(t));
    if (body == may_be.end() || !body->second) continue;
    const std::int32_t sure = confidence(t);
    body->second = sure < limit;
    Spike& spike = spikes.try_emplace(body->first, Spike{sure, {}}).first->second;
    spike.confidence = std::max(spike.confidence, sure);
    spike.tets.push_back(t);
  }
  std::vector<Spike> list;
  for (auto& [body, spike] : spikes)
    if (may_be[body]) list.push_back(std::move(spike));
  return list;
}

std::uint32_t drop_bodies(const CellComplex& complex, const Ground& ground, std::vector<TetName> tets,
                          std::vector<std::uint8_t>& kept) {
  std::sort(tets.begin(), tets.end());
  Bodies bodies(complex, ground, kept);  // known from here on, whatever goes
  std::vector<std::uint32_t> dropped;
  for (std::uint32_t t = 0; t < kept.size(); ++t)
    if (kept[t] != 0 && std::binary_search(tets.begin(), tets.end(), sorted_vertices(complex.mesh, t)))
      dropped.push_back(bodies.of_tet(t));
  std::sort(dropped.begin(), dropped.end());
  dropped.erase(std::unique(dropped.begin(), dropped.end()), dropped.end());
  for (std::uint32_t t = 0; t < kept.size(); ++t)
    if (kept[t] != 0 && std::binary_search(dropped.begin(), dropped.end(), bodies.of_tet(t))) kept[t] = 0;
  return static_cast<std::uint32_t>(dropped.size());
}

}  // namespace crossloft
