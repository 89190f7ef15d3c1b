// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/tied_contacts.hpp"

#include "support/catch.hpp"
#include "support/law_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

const std::string rub = "begin constant friction model rub\nfriction coefficient = 0.3\nend\n";

/// No net force and no net moment, of forces that are there.
void check_balance(const ContactBodies& bodies) {
  CHECK(bodies.force_size() > 0.1);
  CHECK(bodies.net_force().norm() < 1e-10);
  CHECK(bodies.net_moment().norm() < 1e-9);
}

}  // namespace

TEST_CASE("a surface weld ties up to its capacities, fades and leaves its failed model",
          "[contact][tied_contacts]") {
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

TEST_CASE("an area weld fails at tractions, by both together", "[contact][tied_contacts]") {
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

TEST_CASE("finding the forces of a weld changes nothing, taking its failure over ends it",
          "[contact][tied_contacts]") {
  ContactParts parts(law_mesh(0.0), law_deck("begin surface weld model m\nnormal capacity = 8\n"
                                             "tangential capacity = 4\nfailure decay cycles = 2\nend\n"));
  parts.search();
  TiedContacts tied;
  tied.find_candidates(parts.context(), {parts.face_partners, parts.node_faces, 0.15}, false,
                       parts.constrained);
  REQUIRE(tied.constraints().size() == 1);
  const Tie tie = tied.constraints().front();
  CHECK(parts.constrained.holds_faces(tie.first_face(), tie.second));
  parts.x.rightCols(8).row(2).array() += 0.02;  // 20 of 8
  parts.move();
  std::vector<ConstraintForces> found, again;
  tied.detect(parts.context(), found);
  tied.detect(parts.context(), again);
  REQUIRE(found.size() == 1);
  REQUIRE(again.size() == 1);
  CHECK(found[0].fails);
  CHECK(found[0].forces.forces == again[0].forces.forces);
  CHECK(tied.constraints().size() == 1);
  DecayingConstraints decaying;
  tied.update(parts.context(), found, parts.constrained, decaying);
  CHECK(tied.constraints().empty());
  CHECK(!parts.constrained.holds_faces(tie.first_face(), tie.second));
  REQUIRE(decaying.constraints().size() == 1);
  for (const double left : {0.5, 0.0}) {
    std::vector<ConstraintForces> decayed;
    decaying.step(parts.context(0.1), decayed);
    REQUIRE(decayed.size() == 1);
    CHECK((decayed[0].forces.forces - left * found[0].forces.forces).norm() < 1e-9);
  }
  CHECK(decaying.constraints().empty());
}
