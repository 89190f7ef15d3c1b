// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/make_rigid_bodies.hpp"
#include "core/definition/simulation.hpp"

#include "support/catch.hpp"
#include "support/material_model.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

DeckName named(const std::string& text) { return {text, {}}; }

/// A rigid brick of 2 x 1 x 1 and density 3 from the origin on; block_2 is a soft cube beside it that shares
/// four nodes.
struct Bodies {
  Bodies() {
    MeshBuilder builder;
    builder.add_hexes({.id = 1, .cells = {2, 1, 1}, .size = {2, 1, 1}});
    builder.add_hexes({.id = 2, .origin = {2, 0, 0}});
    mesh = builder.build();
    definition.materials.push_back(
        {named("steel"),
         3.0,
         {material_model("elastic", {{"youngs modulus", 1.0}, {"poissons ratio", 0.3}})}});
    definition.sections.push_back({named("stiff"), named("Rb"), SolidSection{}});
    for (const char* block : {"block_1", "block_2"}) {
      BlockParameters parameters;
      parameters.names = {named(block)};
      parameters.material = named("steel");
      parameters.model = named("elastic");
      if (definition.finite_element_models.empty()) {
        parameters.section = named("stiff");
        definition.finite_element_models.push_back({named("fem"), {}, {}, {parameters}, {}});
      } else {
        definition.finite_element_models[0].block_parameters.push_back(parameters);
      }
    }
    body.name = named("rb");
  }

  Model make() {
    definition.rigid_bodies = {body};
    return make_model(definition, {}, mesh, diagnostics);
  }

  Mesh mesh;
  SimulationDefinition definition;
  RigidBodyDefinition body;
  Diagnostics diagnostics;
};

Eigen::Vector3d centre_of_nodes(const Model& model, const RigidBody& body) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const NodeIndex node : body.nodes)
    sum += model.mass(node.value) * model.mesh->coordinates().col(node.value);
  return sum / body.mass;
}

}  // namespace

TEST_CASE("a rigid body has the mass of its elements and of what neighbours give its nodes",
          "[core][rigid]") {
  Bodies bodies;
  const Model model = bodies.make();
  REQUIRE(bodies.diagnostics.empty());
  REQUIRE(model.rigid.bodies.size() == 1);
  const RigidBody& body = model.rigid.bodies[0];
  CHECK(body.nodes.size() == 12);
  CHECK(body.mass == Approx(6.0 + 1.5));
  CHECK(body.centre.x() == Approx((6.0 * 1.0 + 1.5 * 2.0) / 7.5));
  const double about_x = 6.0 / 12.0 * 2.0 + 1.5 * 0.5;
  CHECK(body.inertia(0, 0) == Approx(about_x));
  CHECK(model.rigid.free_mass.sum() == Approx(1.5));
  CHECK(model.blocks[0].is_rigid);
  CHECK_FALSE(model.blocks[1].is_rigid);
  CHECK(model.rigid.nodes.body_of[body.nodes[0].value] == 0);
}

TEST_CASE("given masses and point masses move the centre, and the nodes' weight with it", "[core][rigid]") {
  Bodies bodies;
  bodies.body.mass = 15.0;
  bodies.body.point_masses = {{5.0, {1.2, 0.5, 1.5}}};
  const Model model = bodies.make();
  REQUIRE(bodies.diagnostics.empty());
  const RigidBody& body = model.rigid.bodies[0];
  CHECK(body.mass == Approx(20.0));
  CHECK((body.centre - Eigen::Vector3d(1.2, 0.5, 0.75)).norm() < 1e-12);
  CHECK((centre_of_nodes(model, body) - body.centre).norm() < 1e-12);
  CHECK(body.arms.col(0).isApprox(model.mesh->coordinates().col(body.nodes[0].value) - body.centre));
}

TEST_CASE("a reference beside the centre is refused unless mass and inertia come with it", "[core][rigid]") {
  Bodies bodies;
  bodies.body.reference_location = Eigen::Vector3d(1.0, 0.5, 0.4);
  bodies.make();
  REQUIRE(bodies.diagnostics.error_count() == 1);
  CHECK(bodies.diagnostics.all()[0].text ==
        "the reference location of 'rb' is not its centre of mass, (1.2, 0.5, 0.5), which is not supported");
  Bodies given;
  given.body = bodies.body;
  given.body.mass = 2.0;
  given.body.inertia = {1.0, 2.0, 3.0, 0.1, 0.2, 0.3};
  const Model model = given.make();
  REQUIRE(given.diagnostics.empty());
  CHECK(model.rigid.bodies[0].centre == Eigen::Vector3d(1.0, 0.5, 0.4));
  CHECK(model.rigid.bodies[0].inertia(1, 2) == 0.2);
  CHECK((centre_of_nodes(model, model.rigid.bodies[0]) - Eigen::Vector3d(1.0, 0.5, 0.4)).norm() < 1e-12);
}
