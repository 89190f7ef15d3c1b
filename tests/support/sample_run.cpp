// SPDX-License-Identifier: BSD-3-Clause
#include "support/sample_run.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/linear_hardening.hpp"

#include <numeric>

#include "core/elements/elements.hpp"
#include "support/mesh_builder.hpp"

namespace contactsim::test {

namespace {

Mesh make_mesh() {
  MeshBuilder builder;
  builder.add_hexes({.id = 10, .name = "soft", .cells = {9, 1, 1}, .size = {9, 1, 1}});
  builder.add_hexes({.id = 20, .name = "hard", .cells = {2, 1, 1}, .origin = {0, 0, 1}, .size = {2, 1, 1}});
  builder.add_node_set(1, "wall", [](const Eigen::Vector3d& x) { return x[0] == 0.0; });
  MeshParts parts = builder.parts();
  parts.node_ids.resize(static_cast<std::size_t>(parts.coordinates.cols()));
  std::iota(parts.node_ids.begin(), parts.node_ids.end(), 1001);
  parts.element_ids.resize(11);
  std::iota(parts.element_ids.begin(), parts.element_ids.end(), 101);
  return Mesh(std::move(parts));
}

ElementProperties make_properties(const MaterialLaw& law, double density) {
  ElementProperties properties;
  properties.law = law;
  properties.density = density;
  return properties;
}

}  // namespace

SampleRun::SampleRun() : mesh(make_mesh()) {
  model.mesh = &mesh;
  const PlasticLaw<LinearHardening> plastic{{1.0, 1.0}, {1.0, 0.0, 0.0}};
  model.blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, make_properties(ElasticLaw{}, 2.0)));
  model.blocks.push_back(make_solid_block(mesh, 1, hex8_mean_quadrature, make_properties(plastic, 3.0)));
  model.mass = lumped_mass(mesh, model.blocks);
  state = make_state(mesh.coordinates(), model.blocks, 0.0);
}

void SampleRun::deform(const Eigen::Matrix3d& f, const Eigen::Matrix3d& l) {
  state.coordinates = f * mesh.coordinates();
  state.velocity = l * state.coordinates;
}

void SampleRun::set_point_value(std::size_t block, std::size_t element, std::size_t place, double value) {
  state.blocks[block].batch(model.blocks[block].layout,
                            element / n_lanes)[place](static_cast<Eigen::Index>(element % n_lanes)) = value;
}

VariableRequest request(VariableLocation location, const std::string& name, const std::string& component,
                        const std::string& alias) {
  VariableRequest made;
  made.location = location;
  made.variable.name = {name, {}};
  made.variable.component = component;
  made.alias = alias;
  return made;
}

}  // namespace contactsim::test
