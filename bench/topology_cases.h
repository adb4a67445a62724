#pragma once
/// Solids of known topology, and the sets of planes that cut them.

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "../inspect/slice.h"

namespace crossloft::bench {

struct TopologyCase {
  std::string name;
  std::function<Surface()> solid;
  std::function<std::vector<CuttingPlane>(const Bounds&, std::uint64_t seed)> planes;
};

/// Those of docs/natural.md.
std::vector<TopologyCase> topology_cases();

/// The same solids by 10, 16, 25 and 40 parallel slices; the seed gives the direction.
std::vector<TopologyCase> stack_cases();

/// A mesh of the user's, cut by `planes` random planes. Error: the file can't be read.
Result<TopologyCase> mesh_case(const std::string& path, std::uint32_t planes);

}  // namespace crossloft::bench
