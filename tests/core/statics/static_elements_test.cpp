// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/static_elements.hpp"

#include "core/dynamics/model.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("load steps have nothing that resists rates, and shells that resist drilling", "[core][statics]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_shells({.id = 2, .origin = {3, 0, 0}})
                        .add_shells({.id = 3, .origin = {5, 0, 0}})
                        .add_shells({.id = 4, .origin = {7, 0, 0}})
                        .build();
  ElementProperties properties{ElasticLaw{{3.0, 2.0}}, 5.0};
  properties.linear_bulk_viscosity = properties.quadratic_bulk_viscosity = properties.hourglass_viscosity =
      0.7;
  properties.hourglass_stiffness = 0.3;
  const double thickness = 0.1;
  ShellSettings drilled;
  drilled.drilling = 0.02;
  Model model;
  model.mesh = &mesh;
  model.blocks.push_back(make_solid_block(mesh, 0, hex8_mean_quadrature, properties));
  model.blocks.push_back(make_shell_block(mesh, 1, shell4_bt_shell, properties, {}, {&thickness, 1}));
  model.blocks.push_back(make_shell_block(mesh, 2, shell4_bt_shell, properties, drilled, {&thickness, 1}));
  model.blocks.push_back(make_shell_block(mesh, 3, shell4_membrane, properties, {}, {&thickness, 1}));
  std::vector<std::size_t> sizes;
  for (const ModelBlock& block : model.blocks) sizes.push_back(block.layout.size());
  make_static(model);
  for (const ModelBlock& block : model.blocks) {
    CHECK(block.properties.linear_bulk_viscosity == 0.0);
    CHECK(block.properties.quadratic_bulk_viscosity == 0.0);
    CHECK(block.properties.hourglass_viscosity == 0.0);
    CHECK(block.properties.hourglass_stiffness == 0.3);
    CHECK(block.properties.density == 5.0);
  }
  CHECK(model.blocks[1].shell.drilling == 1e-3);
  CHECK(model.blocks[1].layout.size() == sizes[1] + 4);  // a number of each node
  CHECK(model.blocks[2].shell.drilling == 0.02);
  CHECK(model.blocks[2].layout.size() == sizes[2]);
  CHECK(sizes[2] == sizes[1] + 4);
  CHECK(model.blocks[3].shell.drilling == 0.0);  // membranes do not turn
  CHECK(model.blocks[3].layout.size() == sizes[3]);
  make_static(model);  // once is enough
  CHECK(model.blocks[1].layout.size() == sizes[1] + 4);
}
