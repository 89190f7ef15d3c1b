// SPDX-License-Identifier: BSD-3-Clause
// A steel cube flies into another: definition and mesh are made in code, an observer looks at every step.
#include <contactsim/contact/mesh/contact_model.hpp>
#include <contactsim/core/definition/simulation.hpp>
#include <contactsim/core/materials/material_table.hpp>
#include <contactsim/core/mesh/mesh.hpp>
#include <contactsim/simulation.hpp>
#include <contactsim/version.hpp>

#include <cmath>
#include <cstdio>

using namespace contactsim;

constexpr double density = 7800.0, speed = 10.0;  // SI

/// Adds a block of one hexahedron, a cube of side 1 whose lowest corner is at height z.
void add_cube(MeshParts& parts, const std::string& name, double z) {
  const auto first = static_cast<std::uint32_t>(parts.coordinates.cols());
  parts.coordinates.conservativeResize(3, first + 8);
  parts.coordinates.rightCols(8) << 0, 1, 1, 0, 0, 1, 1, 0,  //
      0, 0, 1, 1, 0, 0, 1, 1,                                //
      z, z, z, z, z + 1, z + 1, z + 1, z + 1;
  ElementBlock block;
  block.id = static_cast<std::int64_t>(parts.blocks.size()) + 1;
  block.name = name;
  block.type_name = "HEX8";
  block.shape = Shape::hex8;
  block.n_elements = 1;
  block.nodes_per_element = 8;
  for (std::uint32_t i = 0; i < 8; ++i) block.nodes.push_back({first + i});
  parts.blocks.push_back(block);
}

Region make_region() {
  Region region;
  region.name = {"r"};
  InitialVelocity fall;
  fall.set.blocks = {{"upper"}};
  fall.direction.components = {false, false, true};
  fall.magnitude = -speed;
  region.initial_velocities = {fall};
  ContactDefinition& contact = region.contact.emplace();
  contact.surface_commands = {SkinAllBlocks{}};
  contact.interaction_defaults.emplace().general_contact = true;
  return region;
}

SimulationDefinition make_definition() {
  SimulationDefinition definition;
  ParameterValues elastic(find_material_row("elastic")->parameters);
  elastic.set("youngs modulus", 200e9);
  elastic.set("poissons ratio", 0.3);
  definition.materials = {{{"steel"}, density, {{{"elastic"}, elastic}}}};
  BlockParameters parameters;
  parameters.includes_all_blocks = true;
  parameters.material = {"steel"};
  parameters.model = {"elastic"};
  definition.finite_element_models = {{{"cubes"}, {}, {}, {parameters}}};
  TimeSteppingBlock period;
  period.start_time = 0.0;
  Procedure& procedure = definition.procedures.emplace_back();
  procedure.time_control = {{"t"}, {period}, 1e-3};
  procedure.regions = {make_region()};
  return definition;
}

int main() {
  MeshParts parts{.coordinates = Eigen::Matrix3Xd(3, 0)};
  add_cube(parts, "lower", 0.0);
  add_cube(parts, "upper", 1.001);
  const Mesh mesh(parts);
  const SimulationDefinition definition = make_definition();
  const Procedure& procedure = definition.procedures.front();
  const Region& region = procedure.regions.front();

  Diagnostics diagnostics;
  const ContactModel contact = make_contact_model(definition, region, mesh, diagnostics);
  Simulation simulation({definition, procedure, region, mesh, &contact}, {}, diagnostics);
  double peak = 0.0;  // of the force on the lower cube
  simulation.observe([&](RunEvent event, const Simulation& run) {
    if (event == RunEvent::step) peak = std::max(peak, -run.state().forces.contact.row(2).head(8).sum());
  });
  simulation.begin();
  while (!simulation.is_over()) simulation.step();
  simulation.finish();

  const State& state = simulation.state();
  const double momentum = -density * speed;  // of the upper cube at the start, and of both at any time
  std::printf("contactsim %s: %d steps, momentum %.6g, peak force %.6g\n", version,
              static_cast<int>(state.step), state.momentum[2], peak);
  return std::abs(state.momentum[2] - momentum) < 1e-9 * std::abs(momentum) && peak > 0.0 ? 0 : 1;
}
