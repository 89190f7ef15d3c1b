// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/free_directions.hpp"

#include "core/dynamics/model.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

PrescribedMotion held(std::vector<NodeIndex> nodes, const Direction& direction, double until) {
  PrescribedMotion motion;
  motion.nodes = std::move(nodes);
  motion.direction = direction;
  motion.times = ActiveTimes(std::vector{ActiveTimes::Interval{.end = until}});
  return motion;
}

/// A cube with a model whose conditions a test sets.
struct HeldModel {
  Mesh mesh = test::MeshBuilder().add_hexes({.id = 1}).build();
  Model model;
  HeldModel() { model.mesh = &mesh; }
};

}  // namespace

TEST_CASE("nodes have the directions that conditions leave free, others none", "[contact][free_directions]") {
  HeldModel cube;
  cube.model.kinematic_constraints =
      KinematicConstraints(cube.mesh, {held({{2}, {5}}, Components{{false, true, false}}, 10.0),
                                       held({{5}}, Components{{false, false, true}}, 10.0)});
  ModelFreeDirections free;
  CHECK(free.of_node(NodeIndex{2}) == nullptr);  // before the first step nothing is known
  CHECK(free.update(cube.model, 0.0));
  REQUIRE(free.of_node(NodeIndex{2}) != nullptr);
  CHECK((*free.of_node(NodeIndex{2}) - Matrix3d(Vector3d(1, 0, 1).asDiagonal())).norm() < 1e-14);
  REQUIRE(free.of_node(NodeIndex{5}) != nullptr);
  CHECK((*free.of_node(NodeIndex{5}) - Matrix3d(Vector3d(1, 0, 0).asDiagonal())).norm() < 1e-14);
  for (const std::uint32_t node : {0u, 1u, 3u, 4u, 6u, 7u}) CHECK(free.of_node(NodeIndex{node}) == nullptr);
  CHECK(free.of_turns(NodeIndex{2}) == nullptr);
  CHECK(free.of_body(2) == nullptr);
}

TEST_CASE("a change is told where other conditions act than before, whichever they are of",
          "[contact][free_directions]") {
  const int which = GENERATE(0, 1, 2, 3);
  HeldModel cube;
  const KinematicConstraints constraints(cube.mesh, {held({{1}}, Components{{true, true, true}}, 2.0)});
  Model& model = cube.model;
  (which == 0   ? model.kinematic_constraints
   : which == 1 ? model.rotation_constraints
   : which == 2 ? model.rigid.kinematic_constraints
                : model.rigid.rotation_constraints) = constraints;
  ModelFreeDirections free;
  const auto found = [&] {
    return std::array{free.of_node(NodeIndex{1}), free.of_turns(NodeIndex{1}), free.of_body(1),
                      free.of_body_turns(1)};
  };
  CHECK(free.update(model, 0.0));
  for (int i = 0; i < 4; ++i) CHECK((found()[static_cast<std::size_t>(i)] != nullptr) == (i == which));
  CHECK(found()[static_cast<std::size_t>(which)]->isZero(1e-14));
  CHECK_FALSE(free.update(model, 1.0));
  CHECK(found()[static_cast<std::size_t>(which)] != nullptr);
  CHECK(free.update(model, 2.0));
  REQUIRE(found()[static_cast<std::size_t>(which)] != nullptr);  // of a condition that acts no more
  CHECK((*found()[static_cast<std::size_t>(which)] - Matrix3d::Identity()).norm() < 1e-14);
  CHECK_FALSE(free.update(model, 3.0));
}

TEST_CASE("a model without conditions leaves everything free and never changes",
          "[contact][free_directions]") {
  HeldModel cube;
  ModelFreeDirections free;
  CHECK_FALSE(free.update(cube.model, 0.0));
  CHECK_FALSE(free.update(cube.model, 1.0));
  CHECK(free.of_node(NodeIndex{0}) == nullptr);
}
