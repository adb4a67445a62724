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

/// Those of the table in prune/README.md.
std::vector<TopologyCase> topology_cases();

}  // namespace crossloft::bench
