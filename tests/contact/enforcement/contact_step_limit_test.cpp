// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_step_limit.hpp"

#include <cmath>

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes that come to penetrate each other a little, pressed apart by penalty.
struct PressedCubes {
  PressedCubes() : bodies(stacked_cubes(0.001), general_contact("enforcement = penalty\n")) {
    bodies.ask();
    bodies.shift(1, {0.0, 0.0, -0.002});
    bodies.ask();
    mobility.update(0.0);
  }
  StepSprings springs() const {
    const ContactForce& contact = bodies.contact;
    return {contact.kinematics(), contact.rules(), contact.points(), contact.constraint_forces(),
            contact.pair_steps()};
  }
  StepSprings none() const {
    StepSprings springs = this->springs();
    return {springs.kinematics, springs.rules, {}, {}, springs.pairs};
  }

  ContactBodies bodies;
  ContactMobility mobility{bodies.model};
};

/// The step that an eigenvalue leaves beside elements with a stable step of 1.
double step_beside(double eigenvalue) {
  return std::min(2.0 / std::sqrt(4.0 + eigenvalue), 1.0 / std::sqrt(eigenvalue));
}

}  // namespace

TEST_CASE("the step that contact leaves is that of its springs beside those of elements",
          "[contact][enforcement]") {
  PressedCubes cubes;
  REQUIRE_FALSE(cubes.bodies.contact.points().empty());
  ContactStepLimit limit;
  CHECK(limit.find(1.0, cubes.none(), cubes.mobility) == std::numeric_limits<double>::infinity());
  CHECK(limit.lost_share() == 0.0);
  const double soft = limit.find(1e6, cubes.springs(), cubes.mobility);  // of contact alone
  ContactStepLimit beside;
  const double both = beside.find(1.0, cubes.springs(), cubes.mobility);
  CHECK(both == Approx(step_beside(1.0 / (soft * soft))));
  CHECK(beside.lost_share() == 1.0 - both);
}

TEST_CASE("springs that pull limit the step after the coming one, also after a restart",
          "[contact][enforcement]") {
  PressedCubes cubes;
  ContactStepLimit pulling, resumed, pressing;
  pulling.note_pulls(cubes.springs(), cubes.mobility);
  const double expected = pressing.find(1.0, cubes.springs(), cubes.mobility);
  CHECK(pulling.find(1.0, cubes.none(), cubes.mobility) == expected);
  StateArchive to;
  pulling.archive(to);
  const SavedState saved = to.take();
  StateArchive from(saved);
  resumed.archive(from);
  CHECK(resumed.lost_share() == pulling.lost_share());
  CHECK(resumed.find(1.0, cubes.none(), cubes.mobility) == expected);
}
