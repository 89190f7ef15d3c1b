// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/close_window.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes above each other.
struct Cubes : ContactParts {
  Cubes() : ContactParts(made(), general_contact()) {}
  static MeshBuilder made() {
    MeshBuilder b;
    b.add_hexes({.id = 1});
    return b.add_hexes({.id = 2, .origin = {0, 0, 1.1}});
  }
  /// Moves a node in a step of size 1, and asks.
  CandidateUse step(double way) {
    v.setZero();
    v(0, 3) = way;
    x(0, 3) += way;
    move();
    ContactStepContext now = context(1.0);
    window.choose(now);
    range = now.close_range;
    return now.candidates;
  }

  CloseWindow window;
  CloseRange range;
};

}  // namespace

TEST_CASE("close candidates are found anew when a node has moved out of their range",
          "[contact][close_window]") {
  Cubes cubes;
  CHECK(cubes.step(0.001) == CandidateUse::renew_close);
  CHECK(cubes.range.motion == Approx(8 * 0.001));
  CHECK(cubes.range.soon >= 2.0 * 0.001 * cubes.context(1.0).ahead());
  CHECK(cubes.window.note(1, 2));
  for (int step = 1; step <= 7; ++step)
    CHECK(cubes.step(step % 2 == 0 ? 0.001 : -0.001) == CandidateUse::close);
  CHECK(cubes.step(0.0011) == CandidateUse::renew_close);
}

TEST_CASE("what may close sooner than close candidates allow for has them found anew",
          "[contact][close_window]") {
  Cubes cubes;
  CHECK(cubes.step(0.0005) == CandidateUse::renew_close);
  CHECK(cubes.step(0.0007) == CandidateUse::close);
  CHECK(cubes.step(0.0008) == CandidateUse::renew_close);
}

TEST_CASE("all candidates are looked at where leaving some out would not pay, or not be right",
          "[contact][close_window]") {
  Cubes cubes;
  CHECK(cubes.step(0.2) == CandidateUse::all);  // three such steps move out of any range
  CHECK(cubes.step(0.001) == CandidateUse::renew_close);
  CHECK_FALSE(cubes.window.note(2, 3));
  CHECK(cubes.step(0.001) == CandidateUse::all);
  cubes.window.forget();
  CHECK(cubes.step(0.001) == CandidateUse::renew_close);
  cubes.window.forget();
  ContactStepContext context = cubes.context(0.0);  // before the first step
  cubes.window.choose(context);
  CHECK(context.candidates == CandidateUse::all);
  context.dt = 1.0;
  context.is_static = true;
  cubes.window.choose(context);
  CHECK(context.candidates == CandidateUse::all);
}
