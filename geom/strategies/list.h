#pragma once
/// The list of all strategies, which tests and benchmarks go through. A new one is its file and a line here.

#include <tuple>

#include "ball.h"
#include "boost_integers.h"
#include "boost_rationals.h"
#include "cascade.h"
#include "double_double.h"
#include "expansion.h"
#include "fixed_integers.h"
#include "gmp_integers.h"
#include "gmp_rationals.h"
#include "interval.h"
#include "naive_double.h"
#include "production.h"
#include "semi_static_filter.h"
#include "static_filter.h"

namespace crossloft::strategies {

using Strategies = std::tuple<  //
    NaiveDouble,                //
    StaticFilter,               //
    SemiStaticFilter,           //
    IntervalStrategy,           //
    Ball,                       //
    DoubleDoubleStrategy,       //
    Expansions,                 //
    FixedIntegers,              //
    GmpIntegers,                //
    GmpRationals,               //
    BoostIntegers,              //
    BoostRationals,             //
    Cascade<SemiStaticFilter, IntervalStrategy, GmpRationals>, Cascade<SemiStaticFilter, Expansions>,
    Cascade<SemiStaticFilter, FixedIntegers>, Cascade<SemiStaticFilter, DoubleDoubleStrategy, FixedIntegers>,
    Cascade<StaticFilter, SemiStaticFilter, DoubleDoubleStrategy, Expansions>,  //
    Crossloft>;

/// f.operator()<S>() for every strategy S, in the order of the list.
template <class F>
void for_each_strategy(const F& f) {
  [&]<class... S>(std::tuple<S...>*) {
    (f.template operator()<S>(), ...);
  }(static_cast<Strategies*>(nullptr));
}

}  // namespace crossloft::strategies
