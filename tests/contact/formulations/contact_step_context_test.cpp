// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/contact_step_context.hpp"

#include "contact/interface_laws/make_interface_laws.hpp"
#include "support/catch.hpp"
#include "support/friction_law.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// a-b slides, b-c is tied, c with itself has friction, a-c is glued from time 1 on.
SurfacePairs four_pairs() {
  SurfacePairs pairs(4);
  pairs[{0}].second = {1};
  pairs[{1}].second = {2};
  pairs[{1}].law = share(friction_law("glued"));
  pairs[{2}].first = {1};
  pairs[{2}].second = {2};
  pairs[{2}].law = share(friction_law("tied"));
  pairs[{3}].first = pairs[{3}].second = SurfaceIndex{2};
  pairs[{3}].law = share(coulomb(0.3));
  for (const PairIndex i : indices(pairs)) pairs[i].interaction = std::to_string(i.value);
  return pairs;
}

std::vector<ActiveTimes> late_second() {
  std::vector<ActiveTimes> times(4);
  times[1] = ActiveTimes({{1.0, 2.0}});
  return times;
}

}  // namespace

TEST_CASE("rules of pairs are found by two surfaces in either order", "[contact][contact_step_context]") {
  const auto pairs = four_pairs();
  const PairRules rules(pairs, late_second(), 3);
  CHECK(rules.find({0}, {1}) == PairIndex{0});
  CHECK(rules.find({1}, {0}) == PairIndex{0});
  CHECK(rules.find({2}, {0}) == PairIndex{1});
  CHECK(rules.find({1}, {2}) == PairIndex{2});
  CHECK(rules.find({2}, {2}) == PairIndex{3});
  CHECK(!rules.find({0}, {0}));
  CHECK(!rules.find({1}, {1}));
}

TEST_CASE("rules of pairs say how their sides hold each other", "[contact][contact_step_context]") {
  const auto pairs = four_pairs();
  PairRules rules(pairs, late_second(), 3);
  CHECK(rules[{2}].law == ContactLaw::tied);
  CHECK(!rules.has_friction());
  Diagnostics diagnostics;
  rules.set_laws(make_pair_laws(pairs, {}, diagnostics));
  CHECK(rules[{0}].law == ContactLaw::sliding);
  CHECK(rules[{0}].friction == 0.0);
  CHECK(rules[{1}].law == ContactLaw::glued);
  CHECK(rules[{2}].law == ContactLaw::tied);
  CHECK(rules[{3}].law == ContactLaw::sliding);
  CHECK(rules[{3}].friction == 0.3);
  CHECK(rules[{3}].pair == &pairs[{3}]);
  CHECK(rules.has_friction());
}

TEST_CASE("a pair acts in its periods while contact does", "[contact][contact_step_context]") {
  const auto pairs = four_pairs();
  PairRules rules(pairs, late_second(), 3);
  rules.activate(0.5, true);
  CHECK(rules[{0}].is_active);
  CHECK(!rules[{1}].is_active);
  rules.activate(1.5, true);
  CHECK(rules[{1}].is_active);
  rules.activate(1.5, false);
  CHECK(!rules[{0}].is_active);
  CHECK(!rules[{1}].is_active);
}

TEST_CASE("glued places are known by both sides, faces apart from nodes", "[contact][contact_step_context]") {
  ConstrainedPairs constrained;
  CHECK(constrained.add_faces({3}, {7}));
  CHECK(!constrained.add_faces({3}, {7}));
  CHECK(constrained.holds_faces({3}, {7}));
  CHECK(!constrained.holds_faces({7}, {3}));
  CHECK(!constrained.holds_node({3}, {7}));
  CHECK(constrained.add_node({3}, {7}));
  CHECK(constrained.holds_node({3}, {7}));
  CHECK(!constrained.add_node({3}, {7}));
}
