// SPDX-License-Identifier: BSD-3-Clause
// What contact remembers between steps: saved and restored, and taken over by a later procedure.
#include <memory>

#include "contact/enforcement/contact_force.hpp"
#include "core/base/errors.hpp"
#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string rough_memory =
    "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.5\n";

/// A cube that has been pressed on another one, and dragged along it.
std::unique_ptr<ContactBodies> dragged(const std::string& lines) {
  auto bodies = std::make_unique<ContactBodies>(stacked_cubes(0.0, 2, 0.1), general_contact(lines));
  bodies->ask();
  bodies->set_velocity(1, {0.001, 0.002, -0.004});
  for (int i = 0; i < 5; ++i) bodies->step(1.0);
  return bodies;
}

/// As at the start of the procedure after.
void go_on_from(const ContactBodies& earlier, ContactBodies& bodies) {
  bodies.x = earlier.x;
  bodies.v = earlier.v;
  bodies.time = earlier.time;
  bodies.dt = earlier.dt;
}

bool are_like(const std::string& lines, const std::string& earlier, int cells = 2) {
  ContactBodies one(stacked_cubes(0.0, 2, 0.1), general_contact(lines)),
      other(stacked_cubes(0.0, cells, 0.1), general_contact(earlier));
  CHECK(one.contact.is_like(other.contact) == other.contact.is_like(one.contact));
  return one.contact.is_like(other.contact);
}

/// Cubes in load steps, with multipliers.
struct LoadSteps : ContactBodies {
  explicit LoadSteps(const std::string& lines)
      : ContactBodies(stacked_cubes(0.0, 2, 0.1), as_static(lines)) {}
  static Region as_static(const std::string& lines) {
    Region region;
    region.contact = parse_contact(general_contact(lines));
    region.contact->enforcement.is_static = true;
    region.contact->enforcement.enforcement = Enforcement::augmented_lagrange;
    return region;
  }
  void load(const Eigen::Vector3d& way) {
    time += 1.0;
    dt = 1.0;
    contact.begin_trials({time, dt, x, Eigen::Matrix3Xd::Zero(3, x.cols()), 1.0});
    v.setZero();
    set_velocity(1, way);
    x += v;
    contact.accept_trial(motion(), forces);
  }
};

}  // namespace

TEST_CASE("contact goes on from a stored state to the bit", "[contact][contact_force]") {
  const std::string lines = formulation() + GENERATE(std::string("friction model = tied\n"), rough_memory);
  const auto straight = dragged(lines);
  StateArchive saves;
  straight->contact.archive(straight->motion(), saves);
  const SavedState stored = saves.take();
  ContactBodies resumed(stacked_cubes(0.0, 2, 0.1), general_contact(lines));
  go_on_from(*straight, resumed);
  StateArchive restores(stored);
  resumed.contact.archive(resumed.motion(), restores);
  for (int i = 0; i < 3; ++i) {
    straight->step(1.0);
    resumed.step(1.0);
    CHECK(resumed.forces == straight->forces);
    CHECK(resumed.contact.stored() == straight->contact.stored());
  }
  CHECK(straight->force_size() > 0.0);
  CHECK(resumed.contact.histories()[{0}].friction_work == straight->contact.histories()[{0}].friction_work);
}

TEST_CASE("contact of other surfaces does not go on from a stored state", "[contact][contact_force]") {
  const auto straight = dragged("");
  StateArchive saves;
  straight->contact.archive(straight->motion(), saves);
  const SavedState stored = saves.take();
  ContactBodies other(stacked_cubes(0.0, 3, 0.1), general_contact());
  StateArchive restores(stored);
  CHECK_THROWS_AS(other.contact.archive(other.motion(), restores), FileError);
}

TEST_CASE("contact is like that of an earlier procedure by surfaces, pairs and what these hold",
          "[contact][contact_force]") {
  CHECK(are_like("", ""));
  CHECK_FALSE(are_like("", "", 3));
  CHECK_FALSE(are_like("", "self contact = on\n"));
  CHECK(are_like(node_face, ""));  // the formulation does not matter to what only touches
  CHECK_FALSE(are_like(node_face + "friction model = tied\n", "friction model = tied\n"));
  CHECK_FALSE(are_like("", "friction model = tied\n"));
  CHECK_FALSE(are_like("", rough_memory));
  CHECK_FALSE(are_like("", "contact offset = 0.01\n"));
  CHECK_FALSE(are_like("", "interaction behavior = infinitesimal_sliding\n"));
  CHECK_FALSE(are_like("", "separation = off\n"));
  CHECK(are_like("", "penalty stiffness = 10\n"));
}

TEST_CASE("explicit contact takes over all that explicit contact before it remembers",
          "[contact][contact_force]") {
  const std::string lines = formulation() + rough_memory;
  const auto straight = dragged(lines);
  ContactBodies later(stacked_cubes(0.0, 2, 0.1), general_contact(lines)),
      fresh(stacked_cubes(0.0, 2, 0.1), general_contact(lines));
  go_on_from(*straight, later);
  go_on_from(*straight, fresh);
  REQUIRE(later.contact.is_like(straight->contact));
  later.contact.take_over(straight->contact, straight->motion(), later.motion(), 0.0);
  for (int i = 0; i < 3; ++i) {
    straight->step(1.0);
    later.step(1.0);
    CHECK(later.forces == straight->forces);
  }
  fresh.step(1.0);
  fresh.step(1.0);
  CHECK(fresh.forces != straight->forces);
}

TEST_CASE("load steps take over the multipliers of load steps", "[contact][contact_force][statics]") {
  const std::string form = formulation();
  LoadSteps earlier(form);
  earlier.ask();
  earlier.load({0, 0, -0.02});
  earlier.contact.update_multipliers(1e-9);
  earlier.load({0, 0, 0.0});
  const double pressed = lift(earlier);
  REQUIRE(pressed > 0.0);
  LoadSteps later(form);
  go_on_from(earlier, later);
  later.contact.take_over(earlier.contact, earlier.motion(), later.motion(), 0.0);
  for (LoadSteps* steps : {&earlier, &later}) steps->load({0, 0, 0});
  CHECK(later.forces == earlier.forces);
  CHECK_FALSE(later.contact.multipliers().empty());
}

TEST_CASE("explicit contact behind load steps begins with their forces, and its ties with their springs",
          "[contact][contact_force][statics]") {
  LoadSteps earlier("friction model = tied\n");
  earlier.ask();
  earlier.load({0.001, 0, 0.002});
  const double pulled = lift(earlier);
  REQUIRE(pulled < 0.0);
  ContactBodies later(stacked_cubes(0.0, 2, 0.1), general_contact("friction model = tied\n"));
  go_on_from(earlier, later);
  later.v.setZero();
  later.dt = 0.0;
  const Motion ended{earlier.time, 0.0, earlier.x, later.v, 1.0};
  REQUIRE(later.contact.is_like(earlier.contact));
  later.contact.take_over(earlier.contact, ended, later.motion(), 10.0);
  later.ask();
  CHECK(later.contact.ties().size() == earlier.contact.ties().size());
  CHECK((later.force_on(1) - earlier.force_on(1)).norm() < 1e-9 * earlier.force_on(1).norm());
}
