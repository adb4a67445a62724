#include "cell_colours.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

namespace crossloft {
namespace {

using Graph = std::vector<std::vector<std::uint32_t>>;

/// Which cells share an arc: the neighbours of each site, ascending.
Graph neighbours_of(const MoebiusDiagram& diagram) {
  Graph graph(diagram.sites.size());
  for (const MoebiusArc& arc : diagram.arcs) {
    graph[arc.sites[0]].push_back(arc.sites[1]);
    graph[arc.sites[1]].push_back(arc.sites[0]);
  }
  for (auto& list : graph) {
    std::sort(list.begin(), list.end());
    list.erase(std::unique(list.begin(), list.end()), list.end());
  }
  return graph;
}

/// Takes away, one by one, a site with the fewest neighbours left. Coloured in the reverse order each site
/// meets few coloured ones: at most five if the graph is planar. Source: Matula, Beck, Smallest-last ordering
/// and clustering and graph coloring algorithms (1983).
std::vector<std::uint32_t> smallest_last_order(const Graph& graph) {
  std::vector<std::size_t> degree(graph.size());
  std::set<std::pair<std::size_t, std::uint32_t>> left;
  for (std::uint32_t s = 0; s < graph.size(); ++s) left.emplace(degree[s] = graph[s].size(), s);
  std::vector<std::uint32_t> order;
  while (!left.empty()) {
    const std::uint32_t s = left.extract(left.begin()).value().second;
    order.push_back(s);
    for (const std::uint32_t t : graph[s]) {
      if (left.erase({degree[t], t}) > 0) left.emplace(--degree[t], t);
    }
  }
  std::reverse(order.begin(), order.end());
  return order;
}

}  // namespace

std::vector<std::uint32_t> colour_cells(const MoebiusDiagram& diagram, std::uint32_t colours) {
  const Graph graph = neighbours_of(diagram);
  std::vector<std::uint32_t> colour(graph.size(), kNone), used(colours, 0);
  for (const std::uint32_t s : smallest_last_order(graph)) {
    // Fewest neighbours of that colour (none if possible), then the colour that has been used least.
    std::vector<std::pair<std::uint32_t, std::uint32_t>> cost(colours);
    for (std::uint32_t c = 0; c < colours; ++c) cost[c] = {0, used[c]};
    for (const std::uint32_t t : graph[s]) {
      if (colour[t] != kNone) ++cost[colour[t]].first;
    }
    colour[s] = static_cast<std::uint32_t>(std::min_element(cost.begin(), cost.end()) - cost.begin());
    ++used[colour[s]];
  }
  return colour;
}

}  // namespace crossloft
