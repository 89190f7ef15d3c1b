// SPDX-License-Identifier: BSD-3-Clause
#include "core/definition/interaction.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

PairSettings settings(double value) {
  PairSettings made;
  made.friction_model = DeckName{value > 1.0 ? "rub" : "glue", {}};
  made.formulation = value > 1.0 ? ConstraintFormulation::node_face : ConstraintFormulation::face_face;
  made.behavior = value > 1.0 ? InteractionBehavior::no_interaction : InteractionBehavior::sliding;
  made.normal_tolerance = made.tangential_tolerance = made.capture_tolerance = value;
  made.overlap_normal_tolerance = made.overlap_tangential_tolerance = value;
  made.tracking_distance = value;
  made.search_distance = value > 1.0 ? SearchDistance{value} : SearchDistance{};
  made.penalty_scale = made.damping_fraction = value;
  made.separation = value > 1.0;
  made.sides = value > 1.0 ? ShellSides::top : ShellSides::bottom;
  made.penalty_stiffness = value > 1.0 ? PenaltyStiffness{value} : PenaltyStiffness{};
  return made;
}

bool are_equal(const PairSettings& a, const PairSettings& b) {
  return a.friction_model == b.friction_model && a.formulation == b.formulation && a.behavior == b.behavior &&
         a.normal_tolerance == b.normal_tolerance && a.tangential_tolerance == b.tangential_tolerance &&
         a.overlap_normal_tolerance == b.overlap_normal_tolerance &&
         a.overlap_tangential_tolerance == b.overlap_tangential_tolerance &&
         a.capture_tolerance == b.capture_tolerance && a.tracking_distance == b.tracking_distance &&
         a.search_distance == b.search_distance && a.penalty_scale == b.penalty_scale &&
         a.separation == b.separation && a.sides == b.sides && a.penalty_stiffness == b.penalty_stiffness &&
         a.damping_fraction == b.damping_fraction;
}

}  // namespace

TEST_CASE("every setting that a pair lacks comes from the defaults", "[core][interaction]") {
  CHECK(are_equal(with_defaults({}, settings(2.0)), settings(2.0)));
}

TEST_CASE("a pair keeps its own settings", "[core][interaction]") {
  CHECK(are_equal(with_defaults(settings(1.0), settings(2.0)), settings(1.0)));
  CHECK(are_equal(with_defaults(settings(1.0), {}), settings(1.0)));
}

TEST_CASE("a pair's own way to take its start keeps those of the defaults away",
          "[definition][interaction]") {
  PairSettings defaults, own;
  defaults.gap.overlap_ramp_time = 2.0;
  defaults.gap.contact_offset = 0.1;
  CHECK(with_defaults(own, defaults).gap == defaults.gap);
  own.gap.ignore_initial_overlap = false;
  CHECK_FALSE(with_defaults(own, defaults).gap.overlap_ramp_time);
  CHECK(with_defaults(own, defaults).gap.contact_offset == 0.1);
  own.gap.ignore_initial_overlap.reset();
  own.gap.initial_clearance = 0.0;
  CHECK_FALSE(with_defaults(own, defaults).gap.contact_offset);
  CHECK_FALSE(with_defaults(own, defaults).gap.overlap_ramp_time);
}
