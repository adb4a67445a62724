#pragma once
/// The shells of a surface that comes piece by piece: how many, what they enclose, their handles.

#include <cstdint>
#include <vector>

#include "../geom/disjoint_sets.h"

namespace crossloft {

/// What is known of a part of a closed surface.
struct ShellPart {
  std::uint64_t vertices = 0, triangles = 0;  ///< each counted in one part
  double volume = 0;                          ///< signed, of the cones over its triangles
};

class Shells {
 public:
  struct Totals {
    std::uint64_t bodies = 0, cavities = 0;  ///< shells with a volume above 0, and the others
    std::uint64_t genus = 0;                 ///< handles of all of them
    double volume = 0;
  };

  /// A part that is connected to none before, as far as is known; its number.
  std::uint32_t add() {
    parts_.emplace_back();
    return sets_.add();
  }
  void count(std::uint32_t shell, const ShellPart& part) { add_to(parts_[sets_.find(shell)], part); }
  /// Two parts are of one shell.
  void join(std::uint32_t a, std::uint32_t b) {
    a = sets_.find(a), b = sets_.find(b);
    if (a == b) return;
    sets_.join(a, b);
    add_to(parts_[sets_.find(a)], parts_[sets_.find(a) == a ? b : a]);
  }

  /// REQUIRES: all shells are closed.
  Totals totals() {
    Totals sum;
    for (std::uint32_t s = 0; s < parts_.size(); ++s) {
      if (!sets_.is_root(s)) continue;
      const ShellPart& p = parts_[s];
      ++(p.volume > 0 ? sum.bodies : sum.cavities);
      sum.genus += (2 - p.vertices + p.triangles / 2) / 2;  // V - E + F = 2 - 2 g with E = 3 F / 2
      sum.volume += p.volume;
    }
    return sum;
  }

 private:
  static void add_to(ShellPart& sum, const ShellPart& part) {
    sum.vertices += part.vertices;
    sum.triangles += part.triangles;
    sum.volume += part.volume;
  }

  DisjointSets sets_;
  std::vector<ShellPart> parts_;
};

}  // namespace crossloft
