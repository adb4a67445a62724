#pragma once
/// The predicates as types with one static member, ask(strategy, case), so that tests and benchmarks go
/// through them as through the strategies.

#include <string_view>
#include <tuple>

#include "../geom/strategies/strategy.h"
#include "predicate_cases.h"

namespace crossloft::bench {

using strategies::Verdict;

struct Orient2d {
  static constexpr std::string_view kName = "orient2d";
  template <class S>
  static Verdict ask(const S& s, const PlanarCase& c) {
    return s.orient2d(c[0], c[1], c[2]);
  }
};
struct Incircle {
  static constexpr std::string_view kName = "incircle";
  template <class S>
  static Verdict ask(const S& s, const PlanarCase& c) {
    return s.incircle(c[0], c[1], c[2], c[3]);
  }
};
struct Orient3d {
  static constexpr std::string_view kName = "orient3d";
  template <class S>
  static Verdict ask(const S& s, const SpaceCase& c) {
    return s.orient3d(c[0].position, c[1].position, c[2].position, c[3].position);
  }
};
struct Insphere {
  static constexpr std::string_view kName = "insphere";
  template <class S>
  static Verdict ask(const S& s, const SpaceCase& c) {
    return s.insphere(c[0].position, c[1].position, c[2].position, c[3].position, c[4].position);
  }
};
struct PowerTest {
  static constexpr std::string_view kName = "power_test";
  template <class S>
  static Verdict ask(const S& s, const SpaceCase& c) {
    return s.power_test(c[0], c[1], c[2], c[3], c[4]);
  }
};
struct LatticeOrient3d {
  static constexpr std::string_view kName = "lattice orient3d";
  template <class S>
  static Verdict ask(const S& s, const LatticeCase& c) {
    return s.orient3d(c.points[0], c.points[1], c.points[2], c.points[3]);
  }
};
struct LatticeInsphere {
  static constexpr std::string_view kName = "lattice insphere";
  template <class S>
  static Verdict ask(const S& s, const LatticeCase& c) {
    return s.insphere(c.points[0], c.points[1], c.points[2], c.points[3], c.points[4]);
  }
};
struct LatticeOrient2d {
  static constexpr std::string_view kName = "lattice orient2d";
  template <class S>
  static Verdict ask(const S& s, const LatticeCase& c) {
    return s.orient2d(c.plane, c.in_plane[0], c.in_plane[1], c.in_plane[2]);
  }
};
struct LatticeIncircle {
  static constexpr std::string_view kName = "lattice incircle";
  template <class S>
  static Verdict ask(const S& s, const LatticeCase& c) {
    return s.incircle(c.plane, c.in_plane[0], c.in_plane[1], c.in_plane[2], c.in_plane[3]);
  }
};
struct SideOfPlane {
  static constexpr std::string_view kName = "side_of_plane";
  template <class S>
  static Verdict ask(const S& s, const LatticeCase& c) {
    return s.side_of_plane(c.plane, c.points[0]);
  }
};
struct SideOfMeet {
  static constexpr std::string_view kName = "side_of_meet";
  template <class S>
  static Verdict ask(const S& s, const LatticeCase& c) {
    return s.side_of_meet(c.planes[0], c.planes[1], c.planes[2], c.planes[3]);
  }
};

using PlanarQuestions = std::tuple<Orient2d, Incircle>;
using SpaceQuestions = std::tuple<Orient3d, Insphere, PowerTest>;
using LatticeQuestions =
    std::tuple<LatticeOrient3d, LatticeInsphere, LatticeOrient2d, LatticeIncircle, SideOfPlane, SideOfMeet>;

/// f.operator()<Q>() for every predicate Q of such a list.
template <class Questions, class F>
void for_each_question(const F& f) {
  [&]<class... Q>(std::tuple<Q...>*) { (f.template operator()<Q>(), ...); }(static_cast<Questions*>(nullptr));
}

}  // namespace crossloft::bench
