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

/// The ids of all entities, then those that follow the largest.
template <class Index, class Id>
std::vector<std::int64_t> ids_of(std::uint32_t n, std::uint32_t n_more, const Id& id) {
  std::vector<std::int64_t> ids;
  std::int64_t largest = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    ids.push_back(id(Index{i}));
    largest = std::max(largest, ids.back());
  }
  for (std::uint32_t i = 0; i < n_more; ++i) ids.push_back(++largest);
  return ids;
}

/// A block of spheres at the nodes that follow those of the mesh.
ElementBlock make_spheres(const Mesh& mesh, std::uint32_t n) {
  ElementBlock block;
  block.name = RigidPart::name;
  block.shape = Shape::sphere;
  block.type_name = topology(Shape::sphere).name;
  block.nodes_per_element = 1;
  block.n_elements = n;
  for (const ElementBlock& other : mesh.blocks()) block.id = std::max(block.id, other.id);
  ++block.id;
  for (std::uint32_t i = 0; i < n; ++i) block.nodes.push_back({mesh.n_nodes() + i});
  return block;
}

}  // namespace

bool RigidPart::exists() const {
  return !model_.rigid.empty() && !model_.mesh->find(EntityKind::block, std::string(name));
}

Mesh RigidPart::on(const Mesh& mesh) const {
  if (!exists()) return mesh;
  const auto& bodies = model_.rigid.bodies;
  const auto n = static_cast<std::uint32_t>(bodies.size());
  MeshParts parts = parts_of(mesh);
  parts.coordinates.conservativeResize(3, mesh.n_nodes() + n);
  for (std::uint32_t i = 0; i < n; ++i) parts.coordinates.col(mesh.n_nodes() + i) = bodies[i].centre;
  parts.blocks.push_back(make_spheres(mesh, n));
  parts.node_ids = ids_of<NodeIndex>(mesh.n_nodes(), n, [&](NodeIndex node) { return mesh.node_id(node); });
  parts.element_ids = ids_of<ElementIndex>(mesh.n_elements(), n,
                                           [&](ElementIndex element) { return mesh.element_id(element); });
  return Mesh(std::move(parts));
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
