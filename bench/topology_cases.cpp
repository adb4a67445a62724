#include "topology_cases.h"

#include <utility>

#include "../inspect/solids.h"
#include "../io/read_mesh.h"

namespace crossloft::bench {
namespace {

using Planes = std::function<std::vector<CuttingPlane>(const Bounds&, std::uint64_t seed)>;

Planes random_set(std::uint32_t count) {
  return [count](const Bounds& box, std::uint64_t seed) { return random_planes(box, count, seed); };
}
Planes fan_set(std::uint32_t count) {
  return [count](const Bounds& box, std::uint64_t seed) { return fan_planes(box, count, seed); };
}

Planes stack_set(std::uint32_t count) {
  return [count](const Bounds& box, std::uint64_t seed) {
    return parallel_planes(box, count, random_planes(box, 1, seed)[0].normal);
  };
}

Surface ring() { return torus(1, 0.4, 96, 48); }

}  // namespace

std::vector<TopologyCase> topology_cases() {
  return {{"torus by 10", ring, random_set(10)},
          {"torus by 16", ring, random_set(16)},
          {"torus by 45", ring, random_set(45)},
          {"genus 2 by 24", [] { return genus2_solid(); }, random_set(24)},
          {"genus 2 by fan 24", [] { return genus2_solid(); }, fan_set(24)},
          {"genus 3 by 30", [] { return genus3_solid(); }, random_set(30)},
          {"trefoil by 25", [] { return trefoil_solid(); }, random_set(25)},
          {"trefoil by 40", [] { return trefoil_solid(); }, random_set(40)},
          {"vessels by 20", [] { return vessel_solid(); }, random_set(20)},
          {"vessels by fan 24", [] { return vessel_solid(); }, fan_set(24)},
          {"gyroid by 40", [] { return gyroid_solid(); }, random_set(40)},
          {"nested shells by 12", [] { return nested_shells(); }, random_set(12)}};
}

std::vector<TopologyCase> stack_cases() {
  const std::vector<std::pair<const char*, std::function<Surface()>>> solids{
      {"torus", ring},
      {"genus 2", [] { return genus2_solid(); }},
      {"genus 3", [] { return genus3_solid(); }},
      {"trefoil", [] { return trefoil_solid(); }},
      {"vessels", [] { return vessel_solid(); }},
      {"gyroid", [] { return gyroid_solid(); }},
      {"nested shells", [] { return nested_shells(); }}};
  std::vector<TopologyCase> cases;
  for (const auto& [name, solid] : solids)
    for (const std::uint32_t count : {10U, 16U, 25U, 40U})
      cases.push_back({name + (" by " + std::to_string(count) + " slices"), solid, stack_set(count)});
  return cases;
}

Result<TopologyCase> mesh_case(const std::string& path, std::uint32_t planes) {
  auto mesh = read_surface(path);
  if (!mesh) return mesh.error();
  const std::string name = path.substr(path.find_last_of('/') + 1) + " by " + std::to_string(planes);
  return TopologyCase{name, [surface = std::move(mesh).value()] { return surface; }, random_set(planes)};
}

}  // namespace crossloft::bench
