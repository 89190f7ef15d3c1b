// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/pair_rules.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr SurfaceIndex a{0}, b{1}, c{2};

SurfacePair pair_of(SurfaceIndex first, SurfaceIndex second, bool has_periods = false) {
  SurfacePair pair;
  pair.first = first;
  pair.second = second;
  if (has_periods) pair.periods.active.push_back({"late", {}});
  return pair;
}

/// a and b meet always, and in [1, 2) by an interaction of its own; a meets itself.
struct Turns {
  Turns() {
    pairs.push_back(pair_of(a, a));
    pairs.push_back(pair_of(a, b));
    pairs.push_back(pair_of(a, b, true));
    const ActiveTimes late({{1.0, 2.0}}), rest({{.end = 1.0}, {.begin = 2.0}});
    rules.emplace(pairs, std::vector<ActiveTimes>{{}, rest, late}, 3);
  }
  SurfacePairs pairs;
  std::optional<PairRules> rules;
};

PairInterfaceLaw model_of(const InterfaceLaw& law) {
  PairInterfaceLaw model;
  model.law = std::make_shared<const InterfaceLaw>(law);
  return model;
}

InterfaceLaw coulomb_law(double coefficient) {
  InterfaceLaw law;
  law.friction = coefficient;
  return law;
}

}  // namespace

TEST_CASE("the pair of two surfaces is found in either order", "[contact][pair_rules]") {
  const Turns turns;
  CHECK(turns.rules->find(a, b) == PairIndex{1});
  CHECK(turns.rules->find(b, a) == PairIndex{1});
  CHECK(turns.rules->find(a, a) == PairIndex{0});
  CHECK_FALSE(turns.rules->find(b, b));
  CHECK_FALSE(turns.rules->find(c, a));
}

TEST_CASE("of two pairs of the same surfaces the one whose periods these are has its turn",
          "[contact][pair_rules]") {
  Turns turns;
  PairRules& rules = *turns.rules;
  rules.activate(0.5, true);
  CHECK(rules.find(a, b) == PairIndex{1});
  CHECK_FALSE(rules.have_changed());
  rules.activate(1.0, true);
  CHECK(rules.find(a, b) == PairIndex{2});
  CHECK(rules.find(b, a) == PairIndex{2});
  CHECK(rules.have_changed());
  CHECK(rules[{1}].has_changed);
  CHECK_FALSE(rules[{0}].has_changed);
  CHECK_FALSE(rules[{1}].is_active);
  rules.activate(1.5, true);
  CHECK_FALSE(rules.have_changed());
}

TEST_CASE("no pair acts while contact is off", "[contact][pair_rules]") {
  Turns turns;
  turns.rules->activate(0.5, false);
  for (const PairRule& rule : turns.rules->rules()) CHECK_FALSE(rule.is_active);
}

TEST_CASE("a pair takes friction, reach and pressure from its law", "[contact][pair_rules]") {
  SurfacePairs pairs;
  pairs.push_back(pair_of(a, b));
  pairs.push_back(pair_of(a, c));
  PairRules rules(pairs, std::vector<ActiveTimes>(2), 3);
  CHECK_FALSE(rules.has_friction());
  IndexedVector<PairIndex, PairInterfaceLaw> laws;
  laws.push_back(model_of(coulomb_law(0.25)));
  InterfaceLaw limited = coulomb_law(1.0);
  limited.limit = [](double force, double area, double speed) { return force + 10.0 * area + 100.0 * speed; };
  laws.push_back(model_of(limited));
  rules.set_laws(std::move(laws));
  CHECK(rules.has_friction());
  CHECK(rules[{0}].friction == 0.25);
  CHECK(rules[{0}].interface_law == nullptr);
  CHECK(rules[{1}].interface_law != nullptr);
  CHECK(rules.max_activation_distance({1}) == 0.0);
  CHECK_FALSE(rules[{1}].acts_apart());

  ContactPoint point;
  point.normal = Eigen::Vector3d::UnitZ();
  point.area = 2.0;
  point.force = 8.0;
  point.slip = {3.0, 4.0, 7.0};  // 5 along the surface
  CHECK(rules[{0}].slip_limit(point, 0.5) == 2.0);
  CHECK(rules[{1}].slip_limit(point, 0.5) == 8.0 + 20.0 + 1000.0);
  CHECK(rules[{1}].slip_limit(point, 0.0) == 28.0);  // before the first step nothing slips
  point.force = -1.0;
  CHECK(rules[{0}].slip_limit(point, 0.5) == 0.0);
  CHECK(rules[{1}].slip_limit(point, 0.0) == 20.0);
}

TEST_CASE("a HYBRID pair has one rule for what was close at the start and one for the rest",
          "[contact][pair_rules]") {
  SurfacePairs pairs;
  pairs.push_back(pair_of(a, b));
  PairRules rules(pairs, std::vector<ActiveTimes>(1), 2);
  PairInterfaceLaw hybrid = model_of(coulomb_law(0.5));
  hybrid.far = std::make_shared<const InterfaceLaw>(coulomb_law(0.1));
  IndexedVector<PairIndex, PairInterfaceLaw> laws;
  laws.push_back(hybrid);
  rules.set_laws(std::move(laws));
  rules.mark_close_face({0}, FaceIndex{3});
  rules.mark_close_face({0}, FaceIndex{4});
  rules.mark_close_node({0}, SurfaceNodeIndex{7});
  CHECK(rules.of_faces({0}, {3}, {4}).friction == 0.5);
  CHECK(rules.of_faces({0}, {3}, {5}).friction == 0.1);  // both must have been close
  CHECK(rules.of_node({0}, {7}).friction == 0.5);
  CHECK(rules.of_node({0}, {3}).friction == 0.1);
  CHECK(rules.of_edges({0}, {3}, {4}).friction == 0.1);
  rules.activate(0.0, false);
  CHECK_FALSE(rules.of_node({0}, {3}).is_active);
}
