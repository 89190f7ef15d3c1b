// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_mobility.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "core/dynamics/model.hpp"
#include "core/elements/minimum_nodal_mass.hpp"

namespace contactsim {

namespace {

/// The share of a direction that is free; without one, 1 unless nothing is.
double free_share(const Eigen::Matrix3d* projection, const Eigen::Vector3d* direction) {
  if (projection == nullptr) return 1.0;
  if (direction == nullptr) return projection->isZero(0.0) ? 0.0 : 1.0;
  return direction->dot(*projection * *direction);
}

/// What the corners of a side count for: their weights. A point far beyond the edges of its face has a lever:
/// with the sum s of their sizes the corners count by s |w|, so that the bound of ContactForce holds.
Eigen::Vector4d with_lever(const Eigen::Vector4d& weights) {
  constexpr double hardly_beyond = 0.1;
  if (!(weights.minCoeff() < -hardly_beyond)) return weights;
  return weights.cwiseAbs().sum() * weights.cwiseAbs();
}

/// Whether contact alone may move some node: not where all have faces and no body is rigid.
bool may_move_alone(const Model& model, const ContactMesh& contact_mesh) {
  return !model.rigid.bodies.empty() || std::ranges::any_of(contact_mesh.nodes(), [&](ContactNodeIndex node) {
    return contact_mesh.faces_of_node.of(node).empty();
  });
}

}  // namespace

ContactMobility::ContactMobility(const Model& model) : model_(model) {
  for (const RigidBody& body : model.rigid.bodies)
    turn_mobilities_.push_back(body.flexible.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff());
}

Eigen::Vector3d ContactMobility::arm(const ContactKinematics& kinematics, ContactNodeIndex node) const {
  const std::size_t n_mesh_points = kinematics.contact_mesh().n_mesh_points();
  if (node.value < n_mesh_points) return Eigen::Vector3d::Zero();
  return kinematics.offsets().col(static_cast<Eigen::Index>(node.value - n_mesh_points));
}

/// n P n / m + |a x n|^2 / I for an arm a to the node of the mesh, at most 1 / m + |a|^2 / I.
double ContactMobility::mobility(const ContactKinematics& kinematics, ContactNodeIndex node,
                                 const Eigen::Vector3d* normal) const {
  if (is_of_body(kinematics.contact_mesh(), node)) return body_mobility(kinematics, node, normal);
  const NodeIndex mesh_node = kinematics.contact_mesh().mesh_nodes[node];
  const double share = free_share(free_.of_node(mesh_node), normal);
  const double mobility = share / model_.mass(mesh_node.value);
  const Eigen::Vector3d beside = arm(kinematics, node);
  const double inertia = model_.inertia.cols() > 0 ? model_.inertia(mesh_node.value) : 0.0;
  if (beside.isZero(0.0) || !(inertia > minimum_nodal_mass)) return mobility;
  if (free_share(free_.of_turns(mesh_node), nullptr) == 0.0) return mobility;
  const double lever = normal != nullptr ? beside.cross(*normal).squaredNorm() : beside.squaredNorm();
  return mobility + lever / inertia;
}

/// n P n / M + |r|^2 / I of the least moment of inertia I. Lengths from the centre are those at rest.
double ContactMobility::body_mobility(const ContactKinematics& kinematics, ContactNodeIndex node,
                                      const Eigen::Vector3d* normal) const {
  const std::uint32_t mesh_node = kinematics.contact_mesh().mesh_nodes[node].value;
  const std::uint32_t index = *model_.rigid.nodes.body_of[mesh_node];
  const RigidBody& body = model_.rigid.bodies[index];
  const double mobility = free_share(free_.of_body(index), normal) / body.mass;
  if (free_share(free_.of_body_turns(index), nullptr) == 0.0) return mobility;
  const double reach =
      (model_.mesh->coordinates().col(mesh_node) - body.centre).norm() + arm(kinematics, node).norm();
  return mobility + reach * reach * turn_mobilities_[index];
}

bool ContactMobility::is_held(const ContactKinematics& kinematics, ContactNodeIndex node,
                              const Eigen::Vector3d* normal) const {
  constexpr double next_to_nothing = 1e-6;  // of what a free node gives way
  if (is_of_body(kinematics.contact_mesh(), node)) return false;
  if (free_.of_node(kinematics.contact_mesh().mesh_nodes[node]) == nullptr) return false;
  const double mass = model_.mass(kinematics.contact_mesh().mesh_nodes[node].value);
  return mobility(kinematics, node, normal) * mass < next_to_nothing;
}

std::size_t ContactMobility::carrier(const ContactMesh& contact_mesh, ContactNodeIndex node) const {
  if (!is_of_body(contact_mesh, node)) return contact_mesh.first_alike[node].value;
  return contact_mesh.n_nodes() + *model_.rigid.nodes.body_of[contact_mesh.mesh_nodes[node].value];
}

IndexedSpan<ContactNodeIndex, const double> ContactMobility::find_rates(
    const ContactKinematics& kinematics, std::span<const ContactPoint> points,
    std::span<const ConstraintForces> held, IndexedSpan<PairIndex, const std::uint8_t> slips) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  carrier_rates_.assign(contact_mesh.n_nodes() + model_.rigid.bodies.size(), 0.0);
  const auto add = [&](ContactNodeIndex node, double stiffness, const Eigen::Vector3d* normal) {
    if (stiffness > 0.0)
      carrier_rates_[carrier(contact_mesh, node)] += stiffness * mobility(kinematics, node, normal);
  };
  for (const ContactPoint& point : points) {
    if (!(point.stiffness > 0.0)) continue;
    const Eigen::Vector3d* normal = slips[point.pair] != 0 ? nullptr : &point.normal;
    const Eigen::Vector4d of_first = with_lever(point.first.weights),
                          of_second = with_lever(point.second.weights);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      add(point.first.nodes[k], of_first[i] * point.stiffness, normal);
      add(point.second.nodes[k], of_second[i] * point.stiffness, normal);
    }
  }
  for (const ConstraintForces& one : held) {
    for (std::size_t k = 0; k < 8; ++k)
      add(one.constraint.nodes[k], one.constraint.springs[static_cast<Eigen::Index>(k)], nullptr);
  }
  rates_.resize(contact_mesh.n_nodes());
  for (const ContactNodeIndex node : contact_mesh.nodes())
    rates_[node] = carrier_rates_[carrier(contact_mesh, node)];
  return rates_;
}

bool ContactMobility::moves_alone(const ContactMesh& contact_mesh, ContactNodeIndex node) const {
  if (is_of_body(contact_mesh, node)) return true;
  if (!contact_mesh.faces_of_node.of(node).empty()) return false;
  const auto row = std::ranges::find(contact_mesh.surface_nodes, node, &SurfaceNode::node);
  if (row == contact_mesh.surface_nodes.end()) return false;
  const Mesh& mesh = *model_.mesh;
  const auto& block = mesh.blocks()[mesh.block_of(row->side.element())];
  return row->is_free || topology(block.shape).family == Family::particle;
}

Eigen::Vector3d ContactMobility::acceleration(const ContactMesh& contact_mesh, ContactNodeIndex node) const {
  if (!moves_alone(contact_mesh, node)) return Eigen::Vector3d::Zero();
  const NodeIndex mesh_node = contact_mesh.mesh_nodes[node];
  const bool is_body = is_of_body(contact_mesh, node);
  const auto body = is_body ? *model_.rigid.nodes.body_of[mesh_node.value] : 0;
  const Eigen::Matrix3d* free = is_body ? free_.of_body(body) : free_.of_node(mesh_node);
  const double mass = is_body ? model_.rigid.bodies[body].mass : model_.mass(mesh_node.value);
  const Eigen::Vector3d& force = carrier_forces_[carrier(contact_mesh, node)];
  return free != nullptr ? Eigen::Vector3d(*free * force / mass) : Eigen::Vector3d(force / mass);
}

std::span<const double> ContactMobility::find_accelerations(const ContactKinematics& kinematics,
                                                            std::span<const ContactPoint> points) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  carrier_forces_.assign(contact_mesh.n_nodes() + model_.rigid.bodies.size(), Eigen::Vector3d::Zero());
  accelerations_.assign(points.size(), 0.0);
  if (!may_move_alone(model_, contact_mesh)) return accelerations_;
  const auto visit = [&](const ContactPointSide& side, const auto& take) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) take(side.nodes[k], weight);
    }
  };
  for (const ContactPoint& point : points) {
    if (!point.touches()) continue;
    const Eigen::Vector3d force = point.force_on_first();
    const auto add = [&](double sign) {
      return [&, sign](ContactNodeIndex node, double weight) {
        carrier_forces_[carrier(contact_mesh, node)] += sign * weight * force;
      };
    };
    visit(point.first, add(1.0));
    visit(point.second, add(-1.0));
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    const auto add = [&](double sign) {
      return [&, sign](ContactNodeIndex node, double weight) {
        accelerations_[i] += sign * weight * points[i].normal.dot(acceleration(contact_mesh, node));
      };
    };
    if (!points[i].touches()) continue;
    visit(points[i].first, add(1.0));
    visit(points[i].second, add(-1.0));
  }
  return accelerations_;
}

}  // namespace contactsim
