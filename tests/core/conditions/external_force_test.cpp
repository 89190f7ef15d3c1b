// SPDX-License-Identifier: BSD-3-Clause
#include "core/conditions/external_force.hpp"

#include <omp.h>

#include "core/base/errors.hpp"
#include "core/mesh/face_geometry.hpp"
#include "support/catch.hpp"
#include "support/condition_deck.hpp"
#include "support/constrained_cube.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A brick of 2 x 2 x 1 hexahedra and a wedge-meshed one on top of it.
Mesh loaded_brick() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}, .size = {2, 2, 1}});
  b.add_wedges({.id = 2, .cells = {2, 2, 1}, .origin = {0, 0, 1}, .size = {2, 2, 1}});
  b.add_side_set(1, "top", [](const CandidateSide& side) { return side.centroid.z() > 1.9; });
  b.add_node_set(1, "edge", [](const Eigen::Vector3d& x) { return x.x() == 0 && x.z() == 0; });
  return b.build();
}

/// Positions moved in a smooth, bent way.
Eigen::Matrix3Xd bent(const Mesh& mesh) {
  Eigen::Matrix3Xd x = mesh.coordinates();
  for (auto column : x.colwise())
    column += Eigen::Vector3d(0.2 * column.y() * column.z(), 0.1 * column.x(), 0.3 * column.x() * column.y());
  return x;
}

/// The loads of some lines on a mesh whose nodes have the masses 1, 2, 3, ...
struct Loaded {
  Loaded(const Mesh& on, const std::string& lines) : mesh(on), deck(mesh, lines) {
    for (Eigen::Index i = 0; i < mass.cols(); ++i) mass.col(i).setConstant(double(i + 1));
    force.emplace(make_external_force(deck.scope(), mass));
    x = mesh.coordinates();
    v = Eigen::Matrix3Xd::Zero(3, x.cols());
  }

  Eigen::Matrix3Xd at(double time) {
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Constant(3, x.cols(), 99.0);
    force->set_forces({time, 0.1, x, v}, forces);
    return forces;
  }

  const Mesh& mesh;
  ConditionDeck deck;
  Eigen::RowVectorXd mass = Eigen::RowVectorXd(mesh.n_nodes());
  std::optional<ExternalForce> force;
  Eigen::Matrix3Xd x, v;
};

}  // namespace

TEST_CASE("without loads there are no forces", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  Loaded none(mesh, "");
  CHECK(none.at(0.0).isZero(0.0));
  CHECK(none.force->is_empty());
  Eigen::Matrix3Xd no_columns(3, 0);
  none.force->set_forces({0.0, 0.1, none.x, none.v}, no_columns);
  CHECK(no_columns.cols() == 0);
}

TEST_CASE("gravity is mass times acceleration, and several add", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  Loaded loaded(
      mesh, condition_block("gravity", "component = z\ngravitational constant = 10\nscale factor = -0.5") +
                condition_block("gravity", "node set = edge\ndirection = slanted\nfunction = ramp"));
  CHECK(loaded.deck.messages() == "");
  const Eigen::Matrix3Xd forces = loaded.at(2.0);
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
    const double mass = i + 1.0;
    const bool on_edge = mesh.coordinates()(0, i) == 0 && mesh.coordinates()(2, i) == 0;
    const Eigen::Vector3d side =
        on_edge ? Eigen::Vector3d(1.2 * mass, 1.6 * mass, 0) : Eigen::Vector3d(0, 0, 0);
    CHECK((forces.col(i) - side - Eigen::Vector3d(0, 0, -5 * mass)).norm() < 1e-13);
  }
}

TEST_CASE("a prescribed force acts on each node of its set, in its periods", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  Loaded loaded(mesh, condition_block("prescribed force",
                                      "node set = edge\ncomponents = x z\nfunction = ramp\n"
                                      "scale factor = 2\nactive periods = p1 p3"));
  CHECK(loaded.at(0.5).rowwise().sum().isApprox(Eigen::Vector3d(3, 0, 3)));
  CHECK(loaded.at(0.5).col(0) == Eigen::Vector3d(1, 0, 1));
  CHECK(loaded.at(1.0).isZero(0.0));
  CHECK(loaded.at(2.0).rowwise().sum().isApprox(Eigen::Vector3d(12, 0, 12)));
}

TEST_CASE("the total of a pressure is minus the pressure times the area vectors", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  Loaded loaded(mesh, condition_block("pressure", "surface = top\nfunction = ramp\nscale factor = 3"));
  loaded.x = bent(mesh);
  Eigen::Vector3d expected = Eigen::Vector3d::Zero();
  for (const ElementSide side : mesh.side_sets()[0].sides) {
    const auto n = mesh.side_nodes(side);
    expected -= 6.0 * area_vector(loaded.x.col(n[0].value), loaded.x.col(n[1].value),
                                  loaded.x.col(n[2].value), loaded.x.col(n[3].value));
  }
  CHECK((loaded.at(2.0).rowwise().sum() - expected).norm() < 1e-12);
  CHECK(expected.z() < -20.0);  // it pushes into the body
}

TEST_CASE("a pressure on a closed surface has no net force and no net moment", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  Loaded loaded(mesh, condition_block("pressure", "include all blocks\nfunction = one\nscale factor = 5"));
  loaded.x = bent(mesh);
  const Eigen::Matrix3Xd forces = loaded.at(0.0);
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < forces.cols(); ++i) {
    const Eigen::Vector3d x = loaded.x.col(i), f = forces.col(i);
    moment += x.cross(f);
  }
  CHECK(forces.rowwise().norm().minCoeff() > 1.0);
  CHECK(forces.rowwise().sum().norm() < 1e-12);  // 72 terms of about 2: round-off is 1e-14
  CHECK(moment.norm() < 1e-12);
}

TEST_CASE("a pressure on a six-node face is three twelfths at its midside nodes", "[core][conditions]") {
  MeshBuilder builder;
  for (const Eigen::Vector3d& x : std::vector<Eigen::Vector3d>{{0, 0, 0},
                                                               {2, 0, 0},
                                                               {0, 2, 0},
                                                               {0, 0, 2},
                                                               {1, 0, 0},
                                                               {1, 1, 0},
                                                               {0, 1, 0},
                                                               {0, 0, 1},
                                                               {1, 0, 1},
                                                               {0, 1, 1}})
    builder.add_node(x);
  builder.add_block(1, "", Shape::tet10, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9});
  builder.add_side_set(1, "top", std::vector<ElementSide>{ElementSide({0}, 4)});
  const Mesh mesh = builder.build();
  Loaded loaded(mesh, condition_block("pressure", "surface = top\nfunction = one\nscale factor = 12"));
  const Eigen::Matrix3Xd forces = loaded.at(0.0);  // 24 on an area of 2
  for (const Eigen::Index corner : {0, 1, 2}) CHECK(forces.col(corner).isApprox(Eigen::Vector3d(0, 0, 2)));
  for (const Eigen::Index middle : {4, 5, 6}) CHECK(forces.col(middle).isApprox(Eigen::Vector3d(0, 0, 6)));
  for (const Eigen::Index off : {3, 7, 8, 9}) CHECK(forces.col(off).isZero());
}

TEST_CASE("a traction keeps its direction and takes the area of now", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  Loaded loaded(mesh, condition_block("traction", "surface = top\ndirection = slanted\nfunction = one"));
  loaded.x.row(0) *= 2.0;
  CHECK(loaded.at(0.0).rowwise().sum().isApprox(Eigen::Vector3d(0.6 * 8, 0.8 * 8, 0)));
}

TEST_CASE("a pressure may vary over its faces and be damped", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  Loaded varying(mesh, condition_block("pressure", "surface = top\nfunction = at_x"));
  CHECK(varying.at(0.0).row(2).sum() == Approx(-8.0));  // the mean of 2 x is 2
  Loaded damped(
      mesh, condition_block("pressure", "surface = top\nfunction = one\nvelocity damping coefficient = 0.5"));
  damped.v.row(2).setConstant(3.0);
  damped.v.row(0).setConstant(9.0);
  CHECK(damped.at(0.0).row(2).sum() == Approx(-10.0));  // 1 + 0.5 x 3 on an area of 4
}

TEST_CASE("forces do not depend on the number of threads or the numbers of nodes", "[core][conditions]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1, .cells = {40, 40, 9}}).build();
  const std::string lines = condition_block("pressure", "block = block_1\nfunction = at_x") +
                            condition_block("gravity", "component = x\nfunction = at_x");
  const int n_threads = omp_get_max_threads();
  Loaded loaded(mesh, lines);
  loaded.x = bent(mesh);
  omp_set_num_threads(1);
  const Eigen::Matrix3Xd one = loaded.at(0.0);
  omp_set_num_threads(3);
  CHECK(loaded.at(0.0) == one);
  omp_set_num_threads(n_threads);

  MeshParts parts = MeshBuilder().add_hexes({.id = 1, .cells = {40, 40, 9}}).parts();
  const std::uint32_t last = mesh.n_nodes() - 1;
  parts.coordinates = parts.coordinates.rowwise().reverse().eval();
  for (NodeIndex& node : parts.blocks[0].nodes) node.value = last - node.value;
  const Mesh reversed(std::move(parts));
  Loaded turned(reversed, condition_block("pressure", "block = block_1\nfunction = at_x"));
  turned.x = bent(reversed);
  Loaded straight(mesh, condition_block("pressure", "block = block_1\nfunction = at_x"));
  straight.x = loaded.x;
  const Eigen::Matrix3Xd found = turned.at(0.0).rowwise().reverse();
  CHECK((found - straight.at(0.0)).norm() < 1e-14);
}

TEST_CASE("a prescribed moment turns its nodes and pushes none", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  ConditionDeck deck(
      mesh, condition_block("prescribed moment", "node set = edge\ncomponents = x z\nfunction = ramp"));
  const Eigen::Matrix3Xd ones = Eigen::Matrix3Xd::Ones(3, mesh.n_nodes());
  const Eigen::RowVectorXd masses = ones.row(0);
  ExternalForce external = make_external_force(deck.scope(), masses, masses);
  CHECK(deck.messages().empty());
  const Eigen::Matrix3Xd still = 0.0 * ones;
  Eigen::Matrix3Xd forces = ones, moments = ones;
  const Motion motion{0.5, 0.1, mesh.coordinates(), still};
  external.set_forces(motion, forces);
  external.set_moments(motion, moments);
  CHECK(forces == still);
  const auto n = static_cast<double>(mesh.node_sets()[*mesh.find(EntityKind::node_set, "edge")].nodes.size());
  CHECK(moments.rowwise().sum() == Eigen::Vector3d(0.5 * n, 0.0, 0.5 * n));
}

TEST_CASE("a load without a finite value ends the run at its block", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  const auto failure = [&](const std::string& lines) {
    Loaded loaded(mesh, lines);
    try {
      loaded.at(1.0);
    } catch (const SolveError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CHECK(failure(condition_block("gravity", "component = x\nfunction = bad")) ==
        "time 1: the function of the gravity at c.i:1:1 has no finite value");
  CHECK(failure(condition_block("pressure", "surface = top\nfunction = bad_at_x")) ==
        "time 1: the function of the pressure at c.i:1:1 has no finite value at node 20");
  CHECK(failure(condition_block("prescribed force", "node set = edge\ncomponent = x\nfunction = one")) == "");
}

TEST_CASE("viscous damping takes the speed that it should in a step, however large", "[core][conditions]") {
  const Mesh mesh = loaded_brick();
  Loaded loaded(mesh, condition_block("viscous damping", "block = block_1\nmass damping coefficient = 3"));
  loaded.v.setConstant(2.0);
  const Eigen::Matrix3Xd forces = loaded.at(0.0);  // over a step of 0.1
  for (std::uint32_t i = 0; i < mesh.n_nodes(); ++i) {
    const bool is_slowed = mesh.coordinates()(2, i) <= 1.0;
    const double change = forces(0, i) / loaded.mass(i) * 0.1;
    CHECK(change == Approx(is_slowed ? 2.0 * (std::exp(-0.3) - 1.0) : 0.0));
  }
}
