// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/contact_energy_watch.hpp"

#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/flying_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The contact of a cube before another one, to which energy is attributed that it has given out.
struct Watched {
  Watched() { cube.run(0); }
  void step(double made, double put_in) {
    State state = cube.simulation.state();
    state.dt = 0.01;
    state.energies = {};
    state.energies.contact = -made;
    state.energies.external = put_in;
    const ContactForce& force = *cube.simulation.contact_force();
    watch.step(force, given_out_by_overlaps(force, false), cube.contact, cube.simulation.model(), state);
  }
  std::string said(double largest) const {
    Energies energies;
    energies.largest = largest;
    Diagnostics warnings;
    watch.warn(cube.contact, energies, warnings);
    return messages(warnings);
  }

  FlyingCube cube;
  ContactEnergyWatch watch;
};

}  // namespace

TEST_CASE("the most that contact has given out from nowhere is reported where it is a hundredth",
          "[app][contact]") {
  Watched watched;
  watched.step(2.0, 100.0);
  watched.step(1.0, 100.0);
  CHECK(watched.said(300.0).empty());
  const std::string said = watched.said(100.0);
  CHECK(
      said.find("contact has given out up to 2 of energy that nothing put in (2 % of the largest term), most "
                "of it between 'lower' and 'upper'") != std::string::npos);
  CHECK(said.find("[contact-energy]") != std::string::npos);
}

TEST_CASE("contact that gives out more than was put in for twenty steps on end ends the run",
          "[app][contact]") {
  Watched watched;
  for (int i = 0; i < 19; ++i) watched.step(3.0, 2.0);
  watched.step(1.0, 2.0);
  for (int i = 0; i < 19; ++i) watched.step(3.0, 2.0);
  CHECK_THROWS_WITH(
      watched.step(3.0, 2.0),
      Catch::Matchers::Contains("contact between 'lower' and 'upper' runs away") &&
          Catch::Matchers::Contains("all contact 3, more than all that was put into the model, 2"));
}

TEST_CASE("what contact has given out survives a restart", "[app][contact]") {
  Watched watched, resumed;
  watched.step(2.0, 100.0);
  StateArchive to;
  watched.watch.archive(to);
  const SavedState saved = to.take();
  StateArchive from(saved);
  resumed.watch.archive(from);
  CHECK(resumed.said(100.0) == watched.said(100.0));
}
