// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/rigid_part.hpp"

#include <algorithm>
#include <utility>

#include "core/base/names.hpp"
#include "core/mesh/mesh_parts.hpp"

namespace contactsim {

namespace {

Eigen::Vector3d value_of(const std::string& field, const RigidBody& body, const RigidBodyState& state) {
  const std::string name = fold(field);
  if (name == "displacement") return state.position - body.centre;
  if (name == "velocity") return state.now.velocity;
  if (name == "acceleration") return state.acceleration;
  return name == "coordinates" ? state.position : Eigen::Vector3d::Zero();
}

/// Adds ids that follow the largest.
void add_ids(std::size_t n, std::vector<std::int64_t>& ids) {
  std::int64_t largest = ids.empty() ? 0 : std::ranges::max(ids);
  for (std::size_t i = 0; i < n; ++i) ids.push_back(++largest);
}

/// A block of spheres at the nodes that follow those of the mesh.
ElementBlock make_spheres(const MeshParts& parts, std::uint32_t n) {
  ElementBlock block;
  block.name = RigidPart::name;
  block.shape = Shape::sphere;
  block.type_name = topology(Shape::sphere).name;
  block.nodes_per_element = 1;
  block.n_elements = n;
  for (const ElementBlock& other : parts.blocks) block.id = std::max(block.id, other.id);
  ++block.id;
  const auto n_nodes = static_cast<std::uint32_t>(parts.coordinates.cols());
  for (std::uint32_t i = 0; i < n; ++i) block.nodes.push_back({n_nodes + i});
  return block;
}

}  // namespace

bool RigidPart::exists() const {
  return !model_.rigid.empty() && !model_.mesh->find(EntityKind::block, std::string(name));
}

void RigidPart::add_to(MeshParts& parts) const {
  if (!exists()) return;
  const auto& bodies = model_.rigid.bodies;
  parts.blocks.push_back(make_spheres(parts, static_cast<std::uint32_t>(bodies.size())));
  const Eigen::Index n_nodes = parts.coordinates.cols();
  parts.coordinates.conservativeResize(3, n_nodes + std::ssize(bodies));
  for (std::size_t i = 0; i < bodies.size(); ++i)
    parts.coordinates.col(n_nodes + static_cast<Eigen::Index>(i)) = bodies[i].centre;
  add_ids(bodies.size(), parts.node_ids);
  add_ids(bodies.size(), parts.element_ids);
}

std::span<const double> RigidPart::extended(const OutputField& field, std::span<const double> values,
                                            const State& state) {
  if (field.location != FieldLocation::node || !exists()) return values;
  values_.assign(values.begin(), values.end());
  for (std::size_t i = 0; i < model_.rigid.bodies.size(); ++i) {
    std::vector<double> body_values(static_cast<std::size_t>(field.n_components), 0.0);
    if (field.shape == FieldShape::vector && i < state.rigid.size()) {
      const Eigen::Vector3d value = value_of(field.name, model_.rigid.bodies[i], state.rigid[i]);
      std::copy(value.begin(), value.end(), body_values.begin());
    }
    values_.insert(values_.end(), body_values.begin(), body_values.end());
  }
  return values_;
}

}  // namespace contactsim
