// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/external_force.hpp"
#include "core/elements/minimum_nodal_mass.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/constrained_cube.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes side by side, on the first of which another program's element stands.
Mesh cubes_of_loads() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
  b.add_side_set(1, "top", [](const CandidateSide& side) { return side.centroid.z() == 1; });
  b.add_node_set(1, "edge", [](const Eigen::Vector3d& x) { return x.x() == 0 && x.z() == 0; });
  return b.build();
}

/// Forces, or moments, of some lines at a time, over a step of 0.5, at velocities of (1 2 4).
struct MadeLoads {
  explicit MadeLoads(const std::string& lines, double inertia = 1.0)
      : mesh(cubes_of_loads()), deck(mesh, lines) {
    mass.setLinSpaced(1.0, 12.0);
    inertias.setConstant(inertia);
    inertias.col(2).setConstant(minimum_nodal_mass);
    made.emplace(make_external_force(deck.scope(), mass, inertias));
  }
  Eigen::Matrix3Xd forces(double time = 0.0) {
    Eigen::Matrix3Xd all = Eigen::Matrix3Xd::Constant(3, 12, 99.0);
    made->set_forces({time, 0.5, mesh.coordinates(), v}, all);
    return all;
  }

  Mesh mesh;
  ConditionDeck deck;
  Eigen::RowVectorXd mass = Eigen::RowVectorXd(12), inertias = Eigen::RowVectorXd(12);
  Eigen::Matrix3Xd v = Eigen::Vector3d(1, 2, 4).replicate(1, 12);
  std::optional<ExternalForce> made;
};

std::string load_messages(const std::string& lines, double inertia = minimum_nodal_mass) {
  return MadeLoads(lines, inertia).deck.messages();
}

}  // namespace

TEST_CASE("loads that cannot act are refused or warned of at their block", "[core][conditions]") {
  CHECK(
      load_messages(condition_block("prescribed moment", "node set = edge\ncomponent = x\nfunction = one")) ==
      "c.i:1:1: error: the prescribed moment cannot act: none of its nodes has rotations: only those of "
      "shells, beams and point inertias do; forces on "
      "several nodes make a moment\n");
  CHECK(
      load_messages(condition_block("pressure", "surface = top\nfunction = one\nmasking method = contact")) ==
      "c.i:1:1: error: the pressure has MASKING METHOD = CONTACT, which is not supported; take faces out "
      "with REMOVE SURFACE\n");
  CHECK(load_messages(condition_block("pressure",
                                      "surface = top\nfunction = one\n"
                                      "external force contribution output name = blow")) ==
        "c.i:1:1: warning: the forces of the pressure alone are not written as 'blow'; force_external holds "
        "those of all loads [condition-ignored]\n");
  CHECK(load_messages(condition_block("pressure", "surface = tip\nfunction = onne")) ==
        "c.i:2:11: error: the mesh has no side set 'tip'; did you mean 'top'?\n"
        "c.i:3:12: error: there is no function 'onne'; did you mean 'one'?\n");
}

TEST_CASE("gravity of no set is that of all nodes, its constant times its scale", "[core][conditions]") {
  MadeLoads all(
      condition_block("gravity", "direction = slanted\ngravitational constant = 10\nscale factor = -0.5"));
  CHECK(all.deck.messages() == "");
  const Eigen::Matrix3Xd forces = all.forces();
  for (Eigen::Index i = 0; i < 12; ++i)
    CHECK(forces.col(i).isApprox(-5.0 * all.mass(i) * Eigen::Vector3d(0.6, 0.8, 0)));
  MadeLoads some(condition_block("gravity", "node set = edge\ncomponents = x z\nfunction = ramp"));
  CHECK(some.forces(2.0).colwise().norm().count() == 2);
  CHECK(some.forces(2.0).col(3).isApprox(2.0 * 4.0 * Eigen::Vector3d(1, 0, 1)));
}

TEST_CASE("a moment on one node without rotations names it", "[core][conditions]") {
  const std::string lines =
      condition_block("prescribed moment", "node = 2 3 4\ncomponent = x\nfunction = one");
  CHECK(load_messages(lines, 1.0) ==
        "c.i:1:1: error: the prescribed moment cannot act on node 3: it has no rotations; forces on several "
        "nodes "
        "make a moment\n");
  CHECK(MadeLoads(lines, 1.0).forces().isZero(0.0));
}

TEST_CASE("loads that are wrong make no forces, the others do", "[core][conditions]") {
  MadeLoads loads(condition_block("pressure", "surface = top\nfunction = one\nmasking method = on") +
                  condition_block("prescribed force", "node set = edge\ncomponent = x\nfunction = onne") +
                  condition_block("traction", "surface = top\ndirection = slantd\nfunction = one") +
                  condition_block("prescribed force", "node set = edge\ncomponent = y\nfunction = one"));
  CHECK(loads.deck.messages() ==
        "c.i:1:1: error: the pressure has MASKING METHOD = ON, which is not supported; take faces out with "
        "REMOVE "
        "SURFACE\n"
        "c.i:9:12: error: there is no function 'onne'; did you mean 'one'?\n"
        "c.i:13:13: error: there is no direction 'slantd'; did you mean 'slanted'?\n");
  CHECK(loads.forces().rowwise().sum() == Eigen::Vector3d(0, 2, 0));
}

TEST_CASE("a traction of some components pulls along each", "[core][conditions]") {
  MadeLoads pulled(condition_block("traction",
                                   "surface = top\ndirection = across\nfunction = ramp\n"
                                   "inactive periods = p2"));
  CHECK(pulled.forces(0.5).rowwise().sum().isApprox(0.5 * 2.0 * Eigen::Vector3d(-0.8, 0.6, 0)));
  CHECK(pulled.forces(1.5).isZero(0.0));
  CHECK(pulled.forces(2.0).rowwise().sum().isApprox(2.0 * 2.0 * Eigen::Vector3d(-0.8, 0.6, 0)));
}
