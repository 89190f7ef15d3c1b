// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_detection.hpp"

#include "support/catch.hpp"
#include "support/law_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

TEST_CASE("welds of nodes hold as much both ways as one way", "[contact][contact_detection]") {
  const std::string model =
      GENERATE(std::string("begin spring weld model m\nnormal displacement function = pull\n"
                           "tangential displacement function = shear\nend\n"),
               std::string("begin surface weld model m\nnormal capacity = 8\ntangential capacity = 4\nend\n"),
               std::string("begin area weld model m\nnormal capacity = 8\ntangential capacity = 4\nend\n"));
  const std::string functions =
      line_function("pull", "0 0\n0.1 50\n") + line_function("shear", "0 0\n0.2 40\n");
  const auto deck = [&](const std::string& sides) {
    return "contact surface lower contains surface_1\ncontact surface upper contains surface_2\n"
           "begin interaction\nconstraint formulation = node_face\nfriction model = m\n"
           "penalty stiffness = 1000\n" +
           sides + "end\n" + model;
  };
  for (const double size : {1.0, 0.5}) {
    MeshBuilder b;
    b.add_hexes({.id = 1, .size = {1, 1, 1}});
    const double edge = 0.5 - 0.5 * size;  // in the middle of the lower cube
    b.add_hexes({.id = 2, .origin = {edge, edge, 1}, .size = {size, size, 1}, .share_nodes = false});
    for (const std::int64_t body : {1, 2}) {
      b.add_side_set(body, "",
                     [body](const CandidateSide& c) { return c.block_id == body && c.centroid.z() == 1.0; });
    }
    ContactBodies one(b, deck("side a = lower\nside b = upper\n"), functions);
    ContactBodies both(b, deck("surfaces = lower upper\n"), functions);
    one.ask();
    both.ask();
    double most = 0.0;
    for (int i = 0; i < 8; ++i) {
      const Vector3d force = force_after(one, {0.004, 0, 0.005});
      CHECK((force_after(both, {0.004, 0, 0.005}) - force).norm() < 1e-9);
      most = std::max(most, force.norm());
    }
    CHECK(most > 1.0);
  }
}

TEST_CASE("forces of holds that are only looked at are those of the step", "[contact][contact_detection]") {
  const std::string model =
      GENERATE(std::string("begin cohesive zone model m\ntraction displacement function = zone\n"
                           "critical normal gap = 0.1\ncritical tangential gap = 0.2\nend\n"),
               std::string("begin spring weld model m\nnormal displacement function = zone\n"
                           "tangential displacement function = zone\nfailure decay cycles = 3\nend\n"),
               std::string("begin area weld model m\nnormal capacity = 50\ntangential capacity = 80\n"
                           "failure decay cycles = 3\nend\n"));
  ContactBodies bodies(law_mesh(0.0), law_deck(model), line_function("zone", "0 0\n0.5 10\n1 0\n"));
  bodies.ask();
  for (int i = 0; i < 12; ++i) {
    force_after(bodies, {0.01, 0, 0.01});
    Vector3d sum = Vector3d::Zero();
    for (const ConstraintForces& held : bodies.contact.constraint_forces()) {
      const Vector3d on_first = held.forces.forces.leftCols<4>().rowwise().sum();
      sum += held.constraint.is_swapped ? on_first : Vector3d(-on_first);
    }
    CHECK((sum - bodies.force_on(1)).norm() < 1e-9);
  }
}
