// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/penalty.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// thickness, stiffness, mass per area
const PenaltyProperties soft{0.2, 100.0, 3.0}, hard{0.1, 300.0, 6.0};

}  // namespace

TEST_CASE("the springs of two sides stand in series", "[contact][penalty]") {
  const SurfacePair pair;
  CHECK(make_pair_penalty(soft, &hard, pair).stiffness == Approx(75.0));
  CHECK(make_pair_penalty(hard, &soft, pair).stiffness == Approx(75.0));
  CHECK(make_pair_penalty(soft, &soft, pair).stiffness == Approx(50.0));
  CHECK(make_pair_penalty(soft, nullptr, pair).stiffness == 100.0);
  // Verification case U4: K/t of 1e11/0.01 and 2e11/0.02.
  const PenaltyProperties first{0.01, 1e11 / 0.01, 1.0}, second{0.02, 2e11 / 0.02, 1.0};
  CHECK(make_pair_penalty(first, &second, pair).stiffness == Approx(5e12).epsilon(1e-12));
}

TEST_CASE("a rigid side has no spring and no mass of its own, two of them have those of their elements",
          "[contact][penalty]") {
  SurfacePair pair;
  pair.damping_fraction = 0.1;
  const double modulus = GENERATE(1e-4, 1.0, 1e4);
  const PenaltyProperties rigid{0.2, 100.0 * modulus, 3.0 * modulus, true};
  const double damping = 0.2 * std::sqrt(300.0 * 6.0);
  CHECK(make_pair_penalty(rigid, &hard, pair).stiffness == 300.0);
  CHECK(make_pair_penalty(hard, &rigid, pair).stiffness == 300.0);
  CHECK(make_pair_penalty(rigid, &hard, pair).damping == Approx(damping));
  CHECK(make_pair_penalty(rigid, &rigid, pair).stiffness == Approx(50.0 * modulus));
}

TEST_CASE("the penalty gets stiffer with depth, one of the pair's own does not", "[contact][penalty]") {
  SurfacePair pair;
  const PairPenalty penalty = make_pair_penalty(soft, &hard, pair);
  CHECK(penalty.law.slope(0.004) == 1.0);
  CHECK(penalty.law.slope(0.05) > 50.0);
  pair.penalty_stiffness = 1e6;
  CHECK(make_pair_penalty(soft, &hard, pair).law.slope(0.05) == 1.0);
}

TEST_CASE("the penalty gets stiffer behind the depth that either side had at the start",
          "[contact][penalty]") {
  PenaltyProperties overlapping = soft;
  overlapping.start_depth = 0.06;
  for (const PairPenalty& penalty : {make_pair_penalty(overlapping, &hard, SurfacePair{}),
                                     make_pair_penalty(hard, &overlapping, SurfacePair{})}) {
    CHECK(penalty.law.spring_depth(0.064) == 0.064);
    CHECK(penalty.law.slope(0.11) == make_pair_penalty(soft, &hard, SurfacePair{}).law.slope(0.05));
  }
}

TEST_CASE("a pair scales the stiffness or has its own", "[contact][penalty]") {
  SurfacePair pair;
  pair.penalty_scale = 0.5;
  CHECK(make_pair_penalty(soft, &hard, pair).stiffness == Approx(37.5));
  pair.penalty_stiffness = 1e6;
  CHECK(make_pair_penalty(soft, &hard, pair).stiffness == Approx(5e5));
  CHECK(make_pair_penalty(soft, nullptr, pair).stiffness == Approx(5e5));
}

TEST_CASE("damping is a share of the critical one of both masses", "[contact][penalty]") {
  SurfacePair pair;
  CHECK(make_pair_penalty(soft, &hard, pair).damping == 0.0);
  pair.damping_fraction = 0.1;
  CHECK(make_pair_penalty(soft, &hard, pair).damping == Approx(0.2 * std::sqrt(75.0 * 2.0)));
  CHECK(make_pair_penalty(soft, nullptr, pair).damping == Approx(0.2 * std::sqrt(100.0 * 3.0)));
}

TEST_CASE("contact reaches half the thinner element deep, or as deep as the pair says",
          "[contact][penalty]") {
  SurfacePair pair;
  CHECK(make_pair_penalty(soft, &hard, pair).depth == Approx(0.05));
  CHECK(make_pair_penalty(soft, nullptr, pair).depth == Approx(0.1));
  pair.normal_tolerance = 0.07;
  CHECK(make_pair_penalty(soft, &hard, pair).depth == 0.07);
}
