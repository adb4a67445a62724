// The diagrams of a cell's faces against the general diagram of the same sites.

#include <map>

#include "../../moebius/diagram.h"
#include "face_cells.h"

using namespace crossloft;
using namespace crossloft::test;

namespace {

struct End {
  Vec2 at;
  bool finite;
};

/// An arc of either diagram, walked with the lower vertex on the left.
struct PlainArc {
  End from, to;
  bool whole = false, over_half = false;
};
using Pairs = std::map<std::array<std::uint32_t, 2>, std::vector<PlainArc>>;

Pairs pairs_of(const std::vector<FaceArc>& arcs) {
  Pairs pairs;
  for (const FaceArc& arc : arcs)
    pairs[arc.sites].push_back({{arc.from, !arc.from_infinite && !arc.whole},
                                {arc.to, !arc.to_infinite && !arc.whole},
                                arc.whole,
                                arc.over_half});
  return pairs;
}

Pairs pairs_of(const MoebiusDiagram& diagram, const std::vector<std::uint32_t>& vertex) {
  Pairs pairs;
  for (const MoebiusArc& arc : diagram.arcs) {
    std::array<std::uint32_t, 2> sites{vertex[arc.sites[0]], vertex[arc.sites[1]]};
    const auto end = [&](std::uint32_t v) {
      return v == kNone ? End{{}, false} : End{diagram.vertices[v], true};
    };
    PlainArc plain{end(arc.from), end(arc.to), !arc.curve.is_line && arc.from == kNone, arc.over_half};
    if (sites[0] > sites[1]) {
      std::swap(sites[0], sites[1]);
      std::swap(plain.from, plain.to);
    }
    pairs[sites].push_back(plain);
  }
  return pairs;
}

bool agree(const PlainArc& a, const PlainArc& b, double tolerance) {
  const auto same = [&](const End& p, const End& q) {
    // Far ends are worse conditioned: compare by direction and size.
    const Vec2 d = p.at - q.at;
    const double scale = std::max(1.0, std::sqrt(dot(p.at, p.at)));
    return p.finite == q.finite && (!p.finite || std::sqrt(dot(d, d)) <= tolerance * scale);
  };
  return same(a.from, b.from) && same(a.to, b.to) && a.whole == b.whole && a.over_half == b.over_half;
}

/// Sites in units of the cell, so that the general diagram's numbers stay small. Returns the number of arcs.
std::size_t check_face(const Cell& cell, std::uint32_t face, double unit, double tolerance) {
  const std::vector<FaceSite> sites = sites_of(cell, face);
  std::vector<MoebiusSite> moebius;
  std::vector<std::uint32_t> vertex;
  for (std::uint32_t v = 0; v < sites.size(); ++v) {
    if (sites[v].height == 0) continue;
    const double height = sites[v].height / unit;
    moebius.push_back({(1 / unit) * sites[v].foot, 1 / height, -height});
    vertex.push_back(v);
  }
  const auto diagram = moebius_diagram(moebius);
  REQUIRE(diagram.ok());
  std::vector<FaceArc> arcs = all_arcs(cell)[face];
  for (FaceArc& arc : arcs) arc.from = (1 / unit) * arc.from, arc.to = (1 / unit) * arc.to;
  const Pairs ours = pairs_of(arcs), theirs = pairs_of(diagram.value(), vertex);
  CHECK(ours.size() == theirs.size());
  std::size_t different = 0, count = 0;
  for (const auto& [sites_of_pair, list] : ours) {
    const auto other = theirs.find(sites_of_pair);
    if (other == theirs.end() || other->second.size() != list.size()) {
      ++different;
      continue;
    }
    for (const PlainArc& arc : list) {
      ++count;
      different += std::none_of(other->second.begin(), other->second.end(),
                                [&](const PlainArc& b) { return agree(arc, b, tolerance); });
    }
  }
  CHECK(different == 0);
  return count;
}

}  // namespace

TEST_CASE("random cells") {
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    CAPTURE(seed);
    Cell cell = random_cell(3 + seed, 1000000, seed);
    scatter(cell, 40, 20000, seed);
    cell.finish();
    for (std::uint32_t f = 0; f < cell.planes.size(); ++f) {
      CAPTURE(f);
      CHECK(check_face(cell, f, 1e6, 1e-9) > 50);
    }
  }
}

TEST_CASE("boxes, where opposite faces are parallel") {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    CAPTURE(seed);
    Cell cell = box_cell(1 << 20);
    scatter(cell, 40, 1 << 20, seed);
    cell.finish();
    for (std::uint32_t f = 0; f < 6; ++f) {
      CAPTURE(f);
      CHECK(check_face(cell, f, 1 << 20, 1e-9) > 100);
    }
  }
}
