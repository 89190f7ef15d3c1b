// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/model.hpp"

#include <algorithm>

#include "core/definition/simulation.hpp"
#include "core/dynamics/make_rigid_bodies.hpp"
#include "core/dynamics/mass_scaling.hpp"
#include "core/elements/block_maker.hpp"
#include "core/elements/element_table.hpp"
#include "core/mesh/block_names.hpp"
#include "core/mesh/mesh_warnings.hpp"

namespace contactsim {

namespace {

/// An element gives each of its nodes its share of what it has.
///   element_values  [n_batches]
void add_shares(const ModelBlock& block, const Mesh& mesh, std::span<const Lanes> element_values,
                Eigen::RowVectorXd& sums) {
  const ElementBlock& source = mesh.blocks()[block.mesh_block];
  for (std::uint32_t element = 0; element < source.n_elements; ++element) {
    const double element_value = element_values[element / n_lanes](element % n_lanes);
    const auto nodes = source.element_nodes(element);
    const auto& shares = block.element->mass_shares;
    for (std::size_t i = 0; i < nodes.size(); ++i)
      sums(nodes[i].value) +=
          shares.empty() ? element_value / static_cast<double>(nodes.size()) : element_value * shares[i];
  }
}

}  // namespace

Eigen::RowVectorXd lumped_mass(const Mesh& mesh, std::span<const ModelBlock> blocks) {
  Eigen::RowVectorXd mass = Eigen::RowVectorXd::Zero(mesh.n_nodes());
  for (const ModelBlock& block : blocks) add_shares(block, mesh, block.mass, mass);
  return mass.cwiseMax(minimum_nodal_mass);
}

Eigen::RowVectorXd lumped_inertia(const Mesh& mesh, std::span<const ModelBlock> blocks) {
  const auto turns = [](const ModelBlock& block) { return block.element->has_rotations; };
  if (std::none_of(blocks.begin(), blocks.end(), turns)) return {};
  Eigen::RowVectorXd inertia = Eigen::RowVectorXd::Zero(mesh.n_nodes());
  for (const ModelBlock& block : blocks) {
    if (turns(block)) add_shares(block, mesh, block.inertia, inertia);
  }
  return inertia.cwiseMax(minimum_nodal_mass);
}

Model make_model(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
                 Diagnostics& diagnostics) {
  Model model;
  model.mesh = &mesh;
  const FiniteElementModel* elements = find_finite_element_model(definition, region);
  if (elements == nullptr) {
    diagnostics.add_error(region.name.location, "the region has no finite element model",
                          "without one --tables alone can be asked for");
    return model;
  }
  BlockMaker maker(definition, *elements, mesh, diagnostics);
  const auto names = find_block_names(mesh, elements->aliases);
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    if (mesh.blocks()[i].n_elements > 0) maker.add(i, names[i], model.blocks);
  }
  warn_of_mesh(mesh, elements->name.location, diagnostics);
  scale_masses({definition, region, {}, mesh, diagnostics}, model.blocks);
  model.mass = lumped_mass(mesh, model.blocks);
  model.inertia = lumped_inertia(mesh, model.blocks);
  make_rigid_bodies(definition, region, model, diagnostics);
  return model;
}

}  // namespace contactsim
