// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/rigid_part.hpp"

#include <utility>

#include "core/mesh/mesh_parts.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// One hexahedron, and two bodies that are somewhere.
struct TwoBodies {
  Mesh mesh;
  Model model;
  State state;

  explicit TwoBodies(MeshBuilder builder = MeshBuilder().add_hexes({.id = 7})) : mesh(builder.build()) {
    model.mesh = &mesh;
    for (const char* name : {"a", "b"}) {
      RigidBody body;
      body.name = name;
      body.centre = Eigen::Vector3d(0.5, 0.5, name[0] == 'a' ? 0.5 : 2.5);
      model.rigid.bodies.push_back(body);
      RigidBodyState now;
      now.position = body.centre + Eigen::Vector3d(0, 3, 0);
      now.now.velocity = Eigen::Vector3d(0, 0, 4);
      state.rigid.push_back(now);
    }
  }
};

/// The mesh of the results.
Mesh with_part(const Model& model, const Mesh& mesh) {
  MeshParts parts = parts_of(mesh);
  RigidPart(model).add_to(parts);
  return Mesh(std::move(parts));
}

OutputField field_of(const std::string& name, FieldLocation location = FieldLocation::node) {
  return {name, location, FieldShape::vector, 3};
}

}  // namespace

TEST_CASE("rigid bodies get spheres at their references in results files", "[core][output]") {
  TwoBodies two;
  const Mesh mesh = with_part(two.model, two.mesh);
  REQUIRE(mesh.blocks().size() == 2);
  CHECK(mesh.n_nodes() == 10);
  CHECK(mesh.name({EntityKind::block, 1}) == "RigidBodyOutputPart");
  const ElementBlock& block = mesh.blocks()[1];
  CHECK(block.id == 8);
  CHECK(block.shape == Shape::sphere);
  CHECK(block.n_elements == 2);
  CHECK(mesh.coordinates().col(block.element_nodes(1)[0].value) == Eigen::Vector3d(0.5, 0.5, 2.5));
  CHECK(mesh.element_id({2}) == 3);
}

TEST_CASE("ids of rigid references follow the largest of the mesh", "[core][output]") {
  TwoBodies two(
      MeshBuilder().add_hexes({}).set_node_ids({10, 20, 30, 40, 50, 60, 70, 5}).set_element_ids({9}));
  const Mesh mesh = with_part(two.model, two.mesh);
  CHECK(mesh.node_id({8}) == 71);
  CHECK(mesh.node_id({9}) == 72);
  CHECK(mesh.element_id({1}) == 10);
}

TEST_CASE("nodal fields have the motion of the bodies at their references", "[core][output]") {
  TwoBodies two;
  RigidPart part(two.model);
  const std::vector<double> values(24, 1.0);
  const auto displacement = part.extended(field_of("displacement"), values, two.state);
  REQUIRE(displacement.size() == 30);
  CHECK(displacement[23] == 1.0);
  CHECK(displacement[25] == 3.0);
  CHECK(part.extended(field_of("velocity"), values, two.state)[29] == 4.0);
  CHECK(part.extended(field_of("coordinates"), values, two.state)[28] == 3.5);
  CHECK(part.extended(field_of("force_contact"), values, two.state)[25] == 0.0);
  CHECK(part.extended(field_of("stress", FieldLocation::element), values, two.state).size() == 24);
  two.state.rigid.clear();  // before the run has begun
  CHECK(part.extended(field_of("velocity"), values, two.state)[29] == 0.0);
}

TEST_CASE("a mesh without rigid bodies, or with their block, stays as it is", "[core][output]") {
  TwoBodies two;
  two.model.rigid.bodies.clear();
  const std::vector<double> values(24, 1.0);
  CHECK(with_part(two.model, two.mesh).blocks().size() == 1);
  CHECK(RigidPart(two.model).extended(field_of("velocity"), values, two.state).size() == 24);
  TwoBodies again(MeshBuilder().add_hexes({}).add_spheres(2, std::string(RigidPart::name), {{0, 0, 0}}));
  CHECK(with_part(again.model, again.mesh).blocks().size() == 2);
}
