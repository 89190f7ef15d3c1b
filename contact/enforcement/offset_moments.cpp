// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/offset_moments.hpp"

#include <Eigen/Geometry>

#include "core/dynamics/model.hpp"
#include "core/elements/minimum_nodal_mass.hpp"

namespace contactsim {

/// Calls visit(node of the mesh, moment) for each.
template <class Visit>
void OffsetMoments::visit(const Visit& visit) const {
  const std::size_t n_mesh_points = contact_mesh_.n_mesh_points();
  const auto on_points = assembler_.nodes().subspan(n_mesh_points);
  for (std::size_t i = 0; i < on_points.size(); ++i) {
    const Eigen::Vector3d offset = kinematics_.offsets().col(static_cast<Eigen::Index>(i));
    visit(contact_mesh_.loft.node(i), Eigen::Vector3d(offset.cross(on_points[i].head<3>())));
  }
  const auto of_spheres = assembler_.moments();
  for (const ContactNodeIndex i : indices(of_spheres)) visit(contact_mesh_.mesh_nodes[i], of_spheres[i]);
}

void OffsetMoments::add_forces(Eigen::Matrix3Xd& forces) {
  const LoftSpins& spins = kinematics_.spins();
  of_spins_.assign(spins.size(), Eigen::Vector3d::Zero());
  visit([&](NodeIndex node, const Eigen::Vector3d& moment) {
    if (const OptionalIndex<std::uint32_t> spin = spins.find(node)) of_spins_[*spin] += moment;
  });
  for (std::size_t i = 0; i < spins.size(); ++i) {
    if (of_spins_[i].isZero(0.0)) continue;
    const auto around = spins.neighbours(i);
    forces.col(spins.node(i).value) += spins.spread(
        i, of_spins_[i],
        [&](std::size_t k, const Eigen::Vector3d& force) { forces.col(around[k].value) += force; });
  }
}

void OffsetMoments::set(const Model& model, Eigen::Matrix3Xd& moments) const {
  moments.setZero();
  const LoftSpins& spins = kinematics_.spins();
  visit([&](NodeIndex node, const Eigen::Vector3d& moment) {
    const OptionalIndex<std::uint32_t> spin = spins.find(node);
    if (!(model.inertia(node.value) > minimum_nodal_mass)) return;
    moments.col(node.value) += spin ? spins.own_share(*spin, moment) : moment;
  });
}

}  // namespace contactsim
