// SPDX-License-Identifier: BSD-3-Clause
#include <numeric>

#include "core/base/errors.hpp"
#include "core/conditions/kinematic_constraints.hpp"
#include "core/elements/minimum_nodal_mass.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/constrained_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// What making the constraints of some lines says.
std::string constraint_messages(const std::string& lines) {
  const Mesh mesh = constrained_cube();
  ConditionDeck deck(mesh, lines);
  make_kinematic_constraints(deck.scope());
  make_rotation_constraints(deck.scope(), Eigen::RowVectorXd());
  return deck.messages();
}

/// The cube's nodes 1 to 3 are the rigid body "a", 4 and 5 "b"; the others are free.
class RigidScope {
 public:
  explicit RigidScope(const std::string& lines) : mesh_(constrained_cube()), deck_(mesh_, lines) {
    rigid_.body_of = {{0}, {0}, {0}, {1}, {1}, {}, {}, {}};
    rigid_.counts = {3, 2};
    rigid_.names = {"a", "b"};
    MeshParts parts;
    parts.coordinates.resize(3, 2);
    parts.coordinates << 1, 2, 1, 2, 1, 2;
    rigid_.references = std::make_shared<const Mesh>(std::move(parts));
  }
  RigidScope(const RigidScope&) = delete;
  RigidScope& operator=(const RigidScope&) = delete;

  ConditionScope scope() {
    const ConditionScope of_deck = deck_.scope();
    return {of_deck.definition,
            of_deck.region,
            of_deck.time_stepping_blocks,
            mesh_,
            of_deck.diagnostics,
            nullptr,
            &rigid_};
  }
  std::string messages() const { return deck_.messages(); }

 private:
  Mesh mesh_;
  ConditionDeck deck_;
  RigidNodes rigid_;
};

std::vector<std::uint32_t> constrained_nodes(const KinematicConstraints& constraints) {
  std::vector<std::uint32_t> nodes;
  for (const NodeIndex node : constraints.nodes()) nodes.push_back(node.value);
  return nodes;
}

using ConstrainedNodes = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("two conditions on one degree of freedom name both lines and a node", "[core][conditions]") {
  const std::string fixed = condition_block("fixed displacement", "node set = n3 n5 n6\ncomponents = x y");
  const std::string moved = "include all blocks\nfunction = one\n";
  const std::string end = "; take the nodes out of one of them, or give them other periods\n";
  CHECK(
      constraint_messages(fixed + condition_block("prescribed velocity", moved + "component = y")) ==
      "c.i:5:1: error: the prescribed velocity and the fixed displacement at c.i:1:1 both drive node 3 and 2 "
      "more in one direction at one time" +
          end);
  CHECK(constraint_messages(fixed + condition_block("prescribed velocity", moved + "component = z")) == "");
  CHECK(
      constraint_messages(fixed +
                          condition_block("prescribed velocity", moved + "cylindrical axis = spin")) ==
      "c.i:5:1: error: the prescribed velocity and the fixed displacement at c.i:1:1 both drive node 3 and 2 "
      "more in one direction at one time" +
          end);
  CHECK(
      constraint_messages(
          condition_block("prescribed displacement", "node set = n1\nfunction = one\ncomponent = x") +
          condition_block("prescribed velocity", moved + "direction = slanted")) ==
      "c.i:6:1: error: the prescribed velocity and the prescribed displacement at c.i:1:1 both drive node 1 "
      "in one direction at one time" +
          end);
  CHECK(constraint_messages(
            condition_block("prescribed displacement",
                            "node set = n1\nfunction = one\ncomponent = x\n"
                            "active periods = p1 p3") +
            condition_block("prescribed velocity", moved + "component = x\nactive periods = p2")) == "");
}

TEST_CASE("what solids cannot do is refused, what changes nothing is ignored", "[core][conditions]") {
  CHECK(constraint_messages(condition_block("fixed rotation", "block = block_1\ncomponents = x y z")) ==
        "c.i:1:1: warning: the fixed rotation has no effect: none of its nodes has rotations, as those of "
        "shells, beams and point inertias do "
        "[condition-ignored]\n");
  CHECK(constraint_messages(
            condition_block("prescribed rotation", "block = block_1\ncomponent = x\nfunction = one")) ==
        "c.i:1:1: error: the prescribed rotation cannot act: none of its nodes has rotations, as those of "
        "shells, beams and point inertias do; PRESCRIBED "
        "DISPLACEMENT or VELOCITY with CYLINDRICAL AXIS turns nodes about an axis\n");
  CHECK(constraint_messages(condition_block("prescribed velocity",
                                            "block = block_1\ncylindrical axis = none\nfunction = one")) ==
        "d.i:37:13: error: the axis 'none' runs through one point only; its two points lie at one place\n");
  CHECK(
      constraint_messages(
          condition_block("prescribed velocity", "block = block_1\ncomponent = x\nfunction = of_stress")) ==
      "d.i:27:35: error: the function of the prescribed velocity reads 'stress(xx)', which conditions do not "
      "know; they know the global time and x, y and z of the nodal coordinates, model_coordinates, "
      "displacement and velocity\n");
}

TEST_CASE("rotations are held and driven as places are, about an axis by its direction",
          "[core][conditions]") {
  const Mesh mesh = constrained_cube();
  ConditionDeck deck(mesh, condition_block("fixed rotation", "node set = n1 n2\ncomponents = x y") +
                               condition_block("prescribed rotation",
                                               "node set = n1\ncomponent = z\n"
                                               "function = ramp") +
                               condition_block("prescribed rotational velocity",
                                               "node set = n3\ncylindrical axis = spin\nfunction = one"));
  Eigen::RowVectorXd inertia = Eigen::RowVectorXd::Ones(8);
  inertia.col(1).setConstant(minimum_nodal_mass);  // node 2 is one of solids alone
  const KinematicConstraints kinematic_constraints = make_rotation_constraints(deck.scope(), inertia);
  CHECK(deck.messages().empty());
  CHECK(kinematic_constraints.nodes().size() == 2);
  const Eigen::Matrix3Xd x = mesh.coordinates(), zero = Eigen::Matrix3Xd::Zero(3, 8);
  const Eigen::Matrix3Xd angle = 0.25 * Eigen::Matrix3Xd::Ones(3, 8);
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Ones(3, 8);
  kinematic_constraints.constrain({0.5, 0.5, 0.5, x, zero, &angle}, a);
  CHECK(a.col(0) == Eigen::Vector3d(0.0, 0.0, (1.0 - 0.25) / 0.5 / 0.5));  // to the angle 1 at time 1
  CHECK(a.col(1) == Eigen::Vector3d::Ones());
  CHECK(a.col(2) == Eigen::Vector3d(1.0, 1.0, 2.0));  // a rate of 1 from rest in half a unit of time
}

TEST_CASE("nodes of rigid bodies are for the bodies, whole ones alone", "[core][conditions]") {
  RigidScope rigid(condition_block("fixed displacement", "node set = n1 n2 n3 n5 n6\ncomponents = x y"));
  CHECK(constrained_nodes(make_kinematic_constraints(rigid.scope())) == ConstrainedNodes{5});
  CHECK(rigid.messages() ==
        "c.i:1:1: warning: the fixed displacement leaves out nodes of the rigid body 'b'; name its block or "
        "the "
        "body itself to act on all of it [condition-rigid]\n");
  const KinematicConstraints bodies = make_body_constraints(rigid.scope());
  CHECK(constrained_nodes(bodies) == ConstrainedNodes{0});
  CHECK(constrained_nodes(make_body_rotation_constraints(rigid.scope())).empty());
  // The places of bodies are those of their references.
  const Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Constant(3, 2, 1.0), v = Eigen::Matrix3Xd::Constant(3, 2, 6.0);
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Constant(3, 2, 4.0);
  bodies.constrain({0.0, 1.0, 2.0, x, v}, a);
  CHECK(a.col(0) == Eigen::Vector3d(-4, -4, 4));
  CHECK(a.col(1) == Eigen::Vector3d(4, 4, 4));
}

TEST_CASE("bodies turn where all their nodes are named, about an axis by its direction",
          "[core][conditions]") {
  RigidScope rigid(condition_block("fixed rotation", "node set = n1 n2 n3\ncomponents = x y") +
                   condition_block("prescribed rotational velocity",
                                   "include all blocks\ncylindrical axis = spin\nfunction = one"));
  const KinematicConstraints turning = make_body_rotation_constraints(rigid.scope());
  CHECK(rigid.messages() == "");
  CHECK(constrained_nodes(turning) == ConstrainedNodes{0, 1});
  CHECK(constrained_nodes(make_body_constraints(rigid.scope())).empty());
  const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, 2);
  Eigen::Matrix3Xd a = Eigen::Matrix3Xd::Constant(3, 2, 4.0);
  turning.constrain({0.0, 1.0, 1.0, still, still, &still}, a);
  CHECK(a.col(0).isApprox(Eigen::Vector3d(0, 0, 1)));
  CHECK(a.col(1).isApprox(Eigen::Vector3d(4, 4, 1)));
}

TEST_CASE("a value that is not finite ends the run at the rigid body that it is of", "[core][conditions]") {
  RigidScope rigid(
      condition_block("prescribed velocity", "node set = n4 n5\ncomponent = x\nfunction = bad_at_x"));
  const KinematicConstraints bodies = make_body_constraints(rigid.scope());
  REQUIRE(constrained_nodes(bodies) == ConstrainedNodes{1});
  const Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Ones(3, 2), still = Eigen::Matrix3Xd::Zero(3, 2);
  Eigen::Matrix3Xd a = still;
  std::string said;
  try {
    bodies.constrain({0.5, 0.0, 1.0, x, still}, a);
  } catch (const SolveError& error) {
    said = error.what();
  }
  CHECK(said ==
        "time 1: the function of the prescribed velocity at c.i:1:1 has no finite value for the rigid body "
        "'b'");
}

TEST_CASE("conflicts on bodies are reported, what their nodes said is not reported again",
          "[core][conditions]") {
  RigidScope rigid(condition_block("prescribed velocity", "node set = n4 n5\ncomponent = x\nfunction = one") +
                   condition_block("fixed displacement", "node set = n1 n2 n4 n5\ncomponent = x"));
  make_kinematic_constraints(rigid.scope());
  const std::string of_nodes =
      "c.i:6:1: warning: the fixed displacement leaves out nodes of the rigid body 'a'; name its block or "
      "the "
      "body itself to act on all of it [condition-rigid]\n";
  CHECK(rigid.messages() == of_nodes);
  make_body_constraints(rigid.scope());
  CHECK(rigid.messages() ==
        "c.i:1:1: error: the prescribed velocity and the fixed displacement at c.i:6:1 both drive the rigid "
        "body "
        "'b' in one direction at one time; take the nodes out of one of them, or give them other periods\n" +
            of_nodes);
  RigidNodes none;
  const ConditionScope scope = rigid.scope();
  CHECK(make_body_constraints(
            {scope.definition, scope.region, {}, scope.mesh, scope.diagnostics, nullptr, &none})
            .nodes()
            .empty());
}

TEST_CASE("a block without nodes or with wrong names drives nothing", "[core][conditions]") {
  const Mesh mesh = constrained_cube();
  const std::string lines =
      GENERATE(std::string("block = block_1\nremove block = block_1\ncomponent = x\nfunction = one"),
               std::string("node set = n1\ndirection = slantd\nfunction = one"),
               std::string("node set = n1\ncomponent = x\nfunction = onne"));
  ConditionDeck deck(mesh, condition_block("prescribed velocity", lines));
  CHECK(make_kinematic_constraints(deck.scope()).nodes().empty());
  CHECK(deck.messages() != "");
}
