// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/cohesive_section.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/definition/finite_element_model.hpp"
#include "core/definition/region.hpp"
#include "core/definition/simulation.hpp"
#include "core/elements/cohesive/cohesive_elements.hpp"
#include "core/mesh/block_names.hpp"

namespace contactsim {

namespace {

/// The pairs of opposite nodes of one element in the mesh.
struct ElementPairs {
  double area = 0.0;                  ///< of the face halfway [length^2]
  std::array<double, 4> thickness{};  ///< of each pair [length]
  bool is_sound = false;
};

/// Faces whose nodes lie this share of the element's width beside each other are not opposite.
constexpr double allowed_offset = 1e-3;

ElementPairs find_pairs(const Eigen::Matrix3Xd& x, std::span<const NodeIndex> nodes) {
  const std::size_t n = nodes.size() / 2;
  const auto middle = [&](std::size_t a) -> Eigen::Vector3d {
    return 0.5 * (x.col(nodes[a].value) + x.col(nodes[a + n].value));
  };
  const Eigen::Vector3d p = n == 4 ? middle(2) - middle(0) : middle(1) - middle(0);
  const Eigen::Vector3d q = n == 4 ? middle(3) - middle(1) : middle(2) - middle(0);
  const Eigen::Vector3d area = 0.5 * p.cross(q);
  ElementPairs pairs{area.norm(), {}, true};
  const double width = std::sqrt(p.norm() * q.norm());
  if (!(pairs.area > allowed_offset * width * width)) return {};
  for (std::size_t a = 0; a < n; ++a) {
    const Eigen::Vector3d way = x.col(nodes[a + n].value) - x.col(nodes[a].value);
    const double along = way.dot(area) / pairs.area;
    const double beside = (way - along * area / pairs.area).norm();
    if (beside > allowed_offset * width || along < -allowed_offset * width) pairs.is_sound = false;
    pairs.thickness[a] = along;
  }
  return pairs;
}

}  // namespace

Mesh with_cohesive_blocks(const SimulationDefinition& definition, const Region& region, Mesh mesh) {
  const FiniteElementModel* model = find_finite_element_model(definition, region);
  if (model == nullptr) return mesh;
  const auto names = find_block_names(mesh, model->aliases);
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    const BlockParameters* parameters = find_block_parameters(*model, names[i]);
    const SectionDefinition* section =
        parameters != nullptr ? find_section(definition, *parameters) : nullptr;
    if (section != nullptr && std::holds_alternative<CohesiveSection>(section->properties))
      blocks.push_back(i);
  }
  if (blocks.empty()) return mesh;
  return mesh.with_cohesive_blocks(blocks);
}

std::optional<ModelBlock> make_cohesive_block(const Mesh& mesh, std::uint32_t mesh_block,
                                              const TractionLaw& law, double density,
                                              const DeckLocation& location, Diagnostics& diagnostics) {
  const ElementBlock& source = mesh.blocks()[mesh_block];
  const ElementFormulation& element = source.shape == Shape::cohesive8 ? cohesive8_pairs : cohesive6_pairs;
  const double no_size = 1.0;
  ModelBlock block = make_discrete_block(mesh, mesh_block, element, density, {&no_size, 1});
  const std::size_t n_pairs = element.n_nodes / 2;
  block.cohesive.law = law;
  block.cohesive.area.resize(block.n_batches() * n_pairs);
  block.cohesive.thickness.resize(block.n_batches() * n_pairs);
  block.cohesive.stable_step.assign(block.n_batches(),
                                    Lanes::Constant(std::numeric_limits<double>::infinity()));
  for (std::size_t i = 0; i < block.n_batches() * n_lanes; ++i) {
    const auto in_block = static_cast<std::uint32_t>(std::min(i, block.n_elements - 1));
    const ElementPairs pairs = find_pairs(mesh.coordinates(), source.element_nodes(in_block));
    if (!pairs.is_sound) {
      diagnostics.add_error(
          location,
          fmt::format("{}: the faces of the cohesive element {} do not lie opposite each other",
                      mesh.name({EntityKind::block, mesh_block}),
                      mesh.element_id({source.first_element.value + in_block})),
          n_pairs == 4 ? "its faces are nodes 1 2 3 4 and, in the same order, 5 6 7 8, which look from the "
                         "first to the second"
                       : "its faces are nodes 1 2 3 and, in the same order, 4 5 6, which look from the first "
                         "to the second");
      return std::nullopt;
    }
    const auto lane = static_cast<Eigen::Index>(i % n_lanes);
    for (std::size_t a = 0; a < n_pairs; ++a) {
      block.cohesive.area[i / n_lanes * n_pairs + a](lane) = pairs.area / static_cast<double>(n_pairs);
      block.cohesive.thickness[i / n_lanes * n_pairs + a](lane) = pairs.thickness[a];
    }
  }
  return block;
}

}  // namespace contactsim
