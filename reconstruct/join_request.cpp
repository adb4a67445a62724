#include "join_request.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace crossloft {

Result<Done> check_named(const PlaneSection* section, std::uint32_t plane, std::uint32_t contour) {
  if (section == nullptr)
    return Error{ErrorCode::usage, "a request to join names a plane that is not there", {}, 0, plane,
                 contour};
  const auto& edges = section->edges;
  if (std::none_of(edges.begin(), edges.end(), [&](const ContourEdge& e) { return e.contour == contour; }))
    return Error{
        ErrorCode::usage, "a request to join names a contour that is not there", {}, section->line, plane,
        contour};
  return Done{};
}

Result<Done> check_against_each_other(std::span<const JoinRequest> requests) {
  using Contour = std::pair<std::uint32_t, std::uint32_t>;
  std::vector<std::tuple<Contour, Contour, bool>> said;
  for (const JoinRequest& r : requests) {
    const auto [first, second] =
        std::minmax({Contour{r.plane_a, r.contour_a}, Contour{r.plane_b, r.contour_b}});
    said.emplace_back(first, second, r.join);
  }
  std::sort(said.begin(), said.end());
  for (std::size_t i = 0; i < said.size(); ++i) {
    const auto& [a, b, join] = said[i];
    if (a == b)
      return Error{ErrorCode::usage, "a request to join names one contour twice", {}, 0, a.first, a.second};
    if (i > 0 && said[i - 1] == std::tuple{a, b, !join})
      return Error{ErrorCode::usage,
                   "two requests to join contradict each other: contour " + std::to_string(b.second) +
                       " of plane " + std::to_string(b.first) + " is to be joined with this one, and is not",
                   {},
                   0,
                   a.first,
                   a.second};
  }
  return Done{};
}

std::vector<std::string> why_unheard(std::span<const JoinRequest> requests, PruneMode mode,
                                     std::span<const std::uint8_t> heard) {
  if (requests.empty()) return {};
  if (mode != PruneMode::natural) return {"requests to join do nothing: they are for mode natural alone"};
  const auto name = [](std::uint32_t plane, std::uint32_t contour) {
    return "contour " + std::to_string(contour) + " of plane " + std::to_string(plane);
  };
  std::vector<std::string> list;
  for (std::size_t i = 0; i < requests.size(); ++i)
    if (const JoinRequest& r = requests[i]; heard[i] == 0)
      list.push_back("a request to join does nothing: no cell has both " + name(r.plane_a, r.contour_a) +
                     " and " + name(r.plane_b, r.contour_b));
  return list;
}

}  // namespace crossloft
