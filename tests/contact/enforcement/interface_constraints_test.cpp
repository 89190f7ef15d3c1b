// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/interface_constraints.hpp"

#include "support/catch.hpp"
#include "support/law_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const std::string rub = "begin constant friction model rub\nfriction coefficient = 0.3\nend\n";

/// Bodies that a cohesive zone holds together: it is strongest halfway to its critical gaps.
struct CohesiveBodies : ContactBodies {
  explicit CohesiveBodies(const std::string& formulation)
      : ContactBodies(law_mesh(0.0),
                      law_deck("begin cohesive zone model m\ntraction displacement function = zone\n"
                               "critical normal gap = 0.1\ncritical tangential gap = 0.2\nend\n",
                               formulation),
                      line_function("zone", "0 0\n0.5 10\n1 0\n")) {}
};

/// No net force and no net moment, of forces that are there.
void check_balance(const ContactBodies& bodies) {
  CHECK(bodies.force_size() > 0.1);
  CHECK(bodies.net_force().norm() < 1e-10);
  CHECK(bodies.net_moment().norm() < 1e-9);
}

}  // namespace

TEST_CASE("a cohesive zone follows its curve, unloads to the origin and breaks for good",
          "[contact][interface_constraints]") {
  const std::string formulation = GENERATE(std::string(), by_nodes, both_ways);
  CohesiveBodies bodies(formulation);
  bodies.ask();
  CHECK(bodies.forces.norm() < 1e-10);
  CHECK(force_after(bodies, {0, 0, 0.02}).z() == Approx(-4.0));   // lambda 0.2
  CHECK(force_after(bodies, {0, 0, 0.03}).z() == Approx(-10.0));  // 0.5
  CHECK(friction_work(bodies) == Approx(0.0).margin(1e-12));
  CHECK(force_after(bodies, {0, 0, 0.01}).z() == Approx(-8.0));  // 0.6
  check_balance(bodies);
  CHECK(force_after(bodies, {0, 0, -0.03}).z() == Approx(-4.0));  // 0.3 back on the line to the origin
  // Between the lines to (0.5, 10) and (0.6, 8): 0.1 / 2 x (10 x 0.6 - 8 x 0.5).
  CHECK(friction_work(bodies) == Approx(0.05 * 2.0));
  force_after(bodies, {0, 0, 0.08});
  CHECK(bodies.forces.norm() < 1e-9);
  CHECK(friction_work(bodies) == Approx(0.1 * 5.0));  // all of 0.1 x the area under the curve
  force_after(bodies, {0, 0, -0.08});
  CHECK(bodies.forces.norm() < 1e-9);
  const double penalty = 1000.0;  // both ways of a pair share the area out
  CHECK(force_after(bodies, {0, 0, -0.04}).z() ==
        Approx(penalty * 0.01).epsilon(0.01));  // broken sides touch
}

TEST_CASE("a cohesive zone resists slip by the ratio of its critical gaps",
          "[contact][interface_constraints]") {
  CohesiveBodies bodies(GENERATE(std::string(), by_nodes, both_ways));
  bodies.ask();
  // Slip 0.06: lambda 0.3, traction 6, along the surface 6 x 0.1 / 0.2.
  Vector3d force = force_after(bodies, {0, 0.06, 0});
  CHECK(force.y() == Approx(-3.0));
  // With opening 0.04 lambda is 0.5: 10 / 0.5 x 0.4 across, 10 / 0.5 x 0.5 x 0.3 along.
  force = force_after(bodies, {0, 0, 0.04});
  CHECK(force.z() == Approx(-8.0));
  CHECK(force.y() == Approx(-3.0));
  check_balance(bodies);
}

TEST_CASE("a threaded joint holds by both openings and fades when it fails",
          "[contact][interface_constraints]") {
  const std::string formulation = GENERATE(std::string(), by_nodes, both_ways);
  ContactBodies bodies(
      law_mesh(0.0),
      law_deck(
          "begin threaded model m\nnormal traction function = pull\ntangential traction function = shear\n"
          "tangential traction gap function = let_go\nnormal capacity = 20\ntangential capacity = 100\n"
          "failure decay cycles = 2\nend\n",
          formulation),
      line_function("pull", "0 0\n0.1 50\n") + line_function("shear", "0 0\n0.1 30\n") +
          line_function("let_go", "0 1\n0.1 0\n"));
  bodies.ask();
  CHECK(force_after(bodies, {0.02, 0, 0}).x() == Approx(-6.0));
  Vector3d force = force_after(bodies, {0, 0, 0.02});
  CHECK(force.x() == Approx(-6.0 * 0.8));
  CHECK(force.z() == Approx(-10.0));
  check_balance(bodies);
  // What the gap takes from the shear is lost: 0.2 of 30 / 0.1 x 0.02^2 / 2.
  CHECK(friction_work(bodies) == Approx(0.2 * 0.06));
  force = force_after(bodies, {-0.02, 0, 0.02});
  CHECK(force.z() == Approx(-20.0));  // at its capacity
  CHECK(force_after(bodies, {0, 0, 0}).z() == Approx(-10.0));
  CHECK(force_after(bodies, {0, 0, 0}).norm() < 1e-9);
  CHECK(force_after(bodies, {0, 0, -0.02}).norm() < 1e-9);
}

TEST_CASE("a spring weld has forces of its displacements and fails at their envelope",
          "[contact][interface_constraints]") {
  const bool of_nodes = GENERATE(false, true);
  const double n = of_nodes ? 4.0 : 1.0;  // places
  ContactBodies bodies(
      law_mesh(0.0),
      law_deck(
          "begin spring weld model m\nnormal displacement function = pull\n"
          "tangential displacement function = shear\nfailure decay cycles = 4\nfailed model = rub\nend\n" +
              rub,
          of_nodes ? by_nodes : ""),
      line_function("pull", "0 0\n0.1 50\n") + line_function("shear", "0 0\n0.2 40\n"));
  bodies.ask();
  CHECK(force_after(bodies, {0, 0, 0.05}).z() == Approx(-25.0 * n));
  Vector3d force = force_after(bodies, {0.08, 0, 0});
  CHECK(force.x() == Approx(-16.0 * n));
  check_balance(bodies);
  const double stored = n * (0.5 * 500 * 0.05 * 0.05 + 0.5 * 200 * 0.08 * 0.08);
  CHECK(bodies.contact.histories().front().work == Approx(stored));
  force = force_after(bodies, {0.12, 0, 0});  // (0.5)^2 + (1)^2 > 1
  CHECK(force.x() == Approx(-40.0 * n));
  force = force_after(bodies, {0, 0, 0});
  CHECK(force.x() == Approx(-30.0 * n));
  CHECK(force.z() == Approx(-18.75 * n));
  for (int i = 0; i < 3; ++i) force = force_after(bodies, {0, 0, 0});
  CHECK(force.norm() < 1e-9);
  CHECK(friction_work(bodies) == Approx(n * (0.5 * 500 * 0.05 * 0.05 + 0.5 * 200 * 0.2 * 0.2)));
  force_after(bodies, {0, 0, -0.06});
  force = force_after(bodies, {-0.05, 0, 0});
  CHECK(force.z() == Approx(10.0));
  CHECK(force.x() == Approx(3.0));  // the failed model rubs
}

TEST_CASE("a surface weld ties up to its capacities, fades and leaves its failed model",
          "[contact][interface_constraints]") {
  ContactBodies bodies(law_mesh(0.0),
                       law_deck("begin surface weld model m\nnormal capacity = 8\ntangential capacity = 4\n"
                                "failure decay cycles = 2\nfailed model = rub\nend\n" +
                                rub));
  bodies.ask();
  CHECK(bodies.contact.ties().size() == 1);
  CHECK(force_after(bodies, {0, 0, 0.007}).z() == Approx(-7.0));
  CHECK(force_after(bodies, {0, 0, -0.017}).z() == Approx(10.0));  // pressed, it does not fail
  CHECK(force_after(bodies, {0, 0, 0.02}).z() == Approx(-8.0));    // 10 is brought back to the envelope
  CHECK(bodies.contact.ties().empty());
  CHECK(force_after(bodies, {0, 0, 0}).z() == Approx(-4.0));
  CHECK(force_after(bodies, {0, 0, 0}).norm() < 1e-9);
  CHECK(friction_work(bodies) == Approx(0.5 * 1000 * 0.01 * 0.01));
  force_after(bodies, {0, 0, -0.02});
  const Vector3d force = force_after(bodies, {0.05, 0, 0});
  CHECK(force.z() == Approx(10.0));
  CHECK(force.x() == Approx(-3.0));
}

TEST_CASE("an area weld fails at tractions, by both together", "[contact][interface_constraints]") {
  const std::string formulation = GENERATE(std::string(), by_nodes, both_ways);
  ContactBodies bodies(
      law_mesh(0.0, 1.5),
      law_deck("begin area weld model m\nnormal capacity = 8\ntangential capacity = 8\nend\n", formulation));
  bodies.ask();
  CHECK(force_after(bodies, {0, 0, 0.006}).z() == Approx(-6.0 * 2.25));
  Vector3d force = force_after(bodies, {0.005, 0, 0});  // 0.75^2 + 0.625^2 < 1
  CHECK(force.x() == Approx(-5.0 * 2.25));
  check_balance(bodies);
  force = force_after(bodies, {0.003, 0, 0});  // 0.75^2 + 1 > 1: both by 1.25
  CHECK(force.x() == Approx(-8.0 / 1.25 * 2.25));
  CHECK(force.z() == Approx(-6.0 / 1.25 * 2.25));
  CHECK(force_after(bodies, {0, 0, 0}).norm() < 1e-9);
}

TEST_CASE("welds of nodes hold as much both ways as one way", "[contact][interface_constraints]") {
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

TEST_CASE("forces of holds that are only looked at are those of the step",
          "[contact][interface_constraints]") {
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
