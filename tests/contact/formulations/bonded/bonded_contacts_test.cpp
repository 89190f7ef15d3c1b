// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/bonded/bonded_contacts.hpp"

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
          "[contact][bonded_contacts]") {
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

TEST_CASE("a cohesive zone resists slip by the ratio of its critical gaps", "[contact][bonded_contacts]") {
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

TEST_CASE("a threaded joint holds by both openings and fades when it fails", "[contact][bonded_contacts]") {
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
          "[contact][bonded_contacts]") {
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
