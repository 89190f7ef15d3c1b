// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/free_bodies.hpp"

#include "support/capped_cube.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Some nodes that are held along some axes.
struct Hold {
  std::array<bool, 3> axes;
  std::vector<std::uint32_t> nodes;
};

/// Two elastic cubes of one cell, nodes 0 to 7 and 8 to 15, and a node 16 of no element.
struct TwoCubes {
  explicit TwoCubes(const std::vector<Hold>& holds)
      : mesh(MeshBuilder()
                 .add_hexes({.id = 1})
                 .add_hexes({.id = 2, .origin = {3, 0, 0}})
                 .add_spheres(3, "", {{9, 9, 9}})
                 .build()) {
    model.mesh = &mesh;
    const ElementProperties properties{ElasticLaw{{160e9, 80e9}}, 7800.0};
    for (const std::uint32_t b : {0u, 1u})
      model.blocks.push_back(make_solid_block(mesh, b, hex8_mean_quadrature, properties));
    model.mass = Eigen::RowVectorXd::Ones(mesh.n_nodes());
    std::vector<PrescribedMotion> motions;
    for (const Hold& hold : holds) {
      PrescribedMotion& motion = motions.emplace_back();
      motion.direction = Components{hold.axes};
      for (const std::uint32_t node : hold.nodes) motion.nodes.push_back({node});
    }
    model.kinematic_constraints = KinematicConstraints(mesh, motions);
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    internal.emplace(model, state);
    problem.emplace(model, ForceTerms{*internal, nothing}, nullptr, ResidualReference::internal, state);
    problem->begin_step(1.0);
  }

  FreeBodies find(const Stabilization& stabilization = {}) const {
    const NodeGraph graph(mesh.n_nodes(), mesh, model.blocks);
    return find_free_bodies(*problem, graph, mesh.coordinates(), stabilization);
  }

  Mesh mesh;
  Model model;
  State state;
  NoLoad nothing;
  std::optional<InternalForce> internal;
  std::optional<StaticProblem> problem;
};

/// Which of the two cubes are free: "1 2", "2", ...
std::string free_cubes(const std::vector<Hold>& holds) {
  const FreeBodies free = TwoCubes(holds).find();
  const bool first = free.shares[0] > 0.0, second = free.shares[8] > 0.0;
  for (std::size_t i = 0; i < 8; ++i) {
    CHECK((free.shares[i] > 0.0) == first);
    CHECK((free.shares[8 + i] > 0.0) == second);
  }
  CHECK(free.are_any == (first || second));
  return std::string(first ? "1 " : "") + (second ? "2" : "");
}

constexpr std::array all_axes{true, true, true};

}  // namespace

TEST_CASE("a body is free while conditions leave it one rigid motion", "[core][statics]") {
  // Nodes 0 1 2 3 are at the bottom; 0 1 and 2 3 are rows along x, 0 2 along y.
  const Hold second{all_axes, {8, 9, 10, 11}};
  CHECK(free_cubes({}) == "1 2");
  CHECK(free_cubes({second}) == "1 ");
  CHECK(free_cubes({second, {all_axes, {0}}}) == "1 ");     // turns about a point
  CHECK(free_cubes({second, {all_axes, {0, 1}}}) == "1 ");  // about a line
  CHECK(free_cubes({second, {all_axes, {0, 1, 2}}}) == "");
  CHECK(free_cubes({{all_axes, {0, 1, 2}}}) == "2");
  // The least that holds a body: six directions.
  const Hold x{{true, false, false}, {0}}, y{{false, true, false}, {0, 1}},
      z{{false, false, true}, {0, 1, 2}};
  CHECK(free_cubes({second, x, y, z}) == "");
  CHECK(free_cubes({second, y, z}) == "1 ");
  CHECK(free_cubes({second, x, z}) == "1 ");
  CHECK(free_cubes({second, x, y, {{false, false, true}, {0, 1}}}) == "1 ");
  // Planes of symmetry: two leave a motion along where they meet.
  const Hold plane_x{{true, false, false}, {0, 2, 4, 6}}, plane_y{{false, true, false}, {0, 1, 4, 5}},
      plane_z{{false, false, true}, {0, 1, 2, 3}};
  CHECK(free_cubes({second, plane_x, plane_y}) == "1 ");
  CHECK(free_cubes({second, plane_x, plane_y, plane_z}) == "");
}

TEST_CASE("nodes of a free body share a hundredth of what it resists, less where it is stabilized",
          "[core][statics]") {
  const TwoCubes cubes({});
  const double each = 1e-2 / 4.0;  // of 8 nodes: 8^(-2/3)
  const FreeBodies free = cubes.find();
  REQUIRE(free.shares.size() == 17);
  for (std::size_t i = 0; i < 16; ++i) CHECK(free.shares[i] == Approx(each));
  CHECK(free.shares[16] == 0.0);
  CHECK(free.rigid.empty());
  const FreeBodies stabilized = cubes.find({1e-3, {11, 11, 16}});
  CHECK(stabilized.shares[0] == Approx(each));
  CHECK(stabilized.shares[8] == Approx(1e-3 * each));
  CHECK(cubes.find({50.0, {11}}).shares[8] == Approx(each));
  CHECK(cubes.find({0.0, {11}}).shares[8] == Approx(each));
}

TEST_CASE("rigid bodies are held by what their elements are held by", "[core][statics]") {
  CappedCube cube;
  const auto find = [&] {
    cube.problem->begin_step(1.0);
    return find_free_bodies(*cube.problem, cube.graph(), cube.problem->coordinates_at(cube.still()), {});
  };
  const FreeBodies held = find();
  CHECK_FALSE(held.are_any);
  CHECK(held.rigid.empty());
  REQUIRE(held.shares.size() == 29);
  CHECK(held.shares[0] == 0.0);
  CHECK(held.shares[27] == StaticBodies::least_share);
  CHECK(held.shares[28] == StaticBodies::least_share);
  cube.model.kinematic_constraints = KinematicConstraints();
  const FreeBodies free = find();
  CHECK(free.are_any);
  CHECK(free.rigid == std::vector<std::uint32_t>{0});
  CHECK(free.shares[0] == Approx(1e-2 * std::pow(29.0, -2.0 / 3.0)));
  CHECK(free.shares[27] == StaticBodies::ground_share);
  // The centre held and the rotation, all is.
  cube.drive();
  CHECK_FALSE(find().are_any);
}
