// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_springs.hpp"

#include "contact/geometry/cross_matrix.hpp"
#include "core/elements/minimum_nodal_mass.hpp"

namespace contactsim {

/// Moves a corner by the rotation of a node, or of the mid surface around it.
void ContactSprings::add_turning(std::size_t corner, NodeIndex mesh_node, const Eigen::Vector3d& arm,
                                 ContactSpring& spring) const {
  const auto number = static_cast<std::uint8_t>(corner);
  // A rotation w moves the end of an arm r by w x r = -[r] w.
  const Eigen::Matrix3d by_rotation = -cross_matrix(arm);
  const LoftSpins& spins = kinematics_.spins();
  const OptionalIndex<std::uint32_t> spin = spins.find(mesh_node);
  if (model_.inertia.cols() > 0 && model_.inertia(mesh_node.value) > minimum_nodal_mass) {
    const Eigen::Matrix3d own = spin ? spins.own_turn(*spin) : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    if (!own.isZero(0.0)) spring.ends.push_back({mesh_node.value, true, number, by_rotation * own});
  }
  if (!spin) return;
  const auto around = spins.neighbours(*spin);
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t k = 0; k < around.size(); ++k) {
    const Eigen::Matrix3d share = by_rotation * spins.turn_by(*spin, k);
    sum += share;
    spring.ends.push_back({around[k].value, false, number, share});
  }
  spring.ends.push_back({mesh_node.value, false, number, -sum});
}

/// Fastens a corner to a contact node.
///   beside  from the node to the corner [length]
void ContactSprings::add_corner(std::size_t corner, ContactNodeIndex node, const Eigen::Vector3d& beside,
                                ContactSpring& spring) const {
  const ContactMesh& contact_mesh = kinematics_.contact_mesh();
  const NodeIndex mesh_node = contact_mesh.mesh_nodes[node];
  spring.ends.push_back(
      {mesh_node.value, false, static_cast<std::uint8_t>(corner), Eigen::Matrix3d::Identity()});
  Eigen::Vector3d arm = beside;
  if (const std::size_t n = contact_mesh.n_mesh_points(); node.value >= n)
    arm += kinematics_.offsets().col(static_cast<Eigen::Index>(node.value - n));
  if (!arm.isZero(0.0)) add_turning(corner, mesh_node, arm, spring);
}

void ContactSprings::add_corners(const ContactPoint& point, ContactSpring& spring) const {
  std::size_t corner = 0;
  for (const ContactPointSide* side : {&point.first, &point.second}) {
    const Eigen::Vector3d beside = (side == &point.first ? -side->radius : side->radius) * point.normal;
    for (std::size_t k = 0; k < 4; ++k, ++corner) {
      if (!spring.coupling.row(static_cast<Eigen::Index>(corner)).isZero(0.0))
        add_corner(corner, side->nodes[k], beside, spring);
    }
  }
}

ContactSpring ContactSprings::spring_between(const ContactPoint& point,
                                             const Eigen::Matrix3d& stiffness) const {
  ContactSpring spring;
  Eigen::Matrix<double, 8, 1> weights;
  weights << point.first.weights, -point.second.weights;
  spring.coupling = weights * weights.transpose();
  spring.stiffness = stiffness;
  add_corners(point, spring);
  return spring;
}

ContactSpring ContactSprings::spring_of(const ContactPoint& point) const {
  return spring_between(point, point.stiffness * point.normal * point.normal.transpose());
}

namespace {

/// The directions of a weighted node along the surface: that of its friction, and across.
std::array<Eigen::Vector3d, 2> slip_directions(const WeightedNode& node) {
  const Eigen::Vector3d way = node.friction.elastic_slip + node.friction.slip;
  const Eigen::Vector3d along = way.isZero(0.0) ? node.normal.unitOrthogonal() : way.normalized();
  return {along, node.normal.cross(along)};
}

}  // namespace

/// All its ends are one corner, which moves by what the gap grows by, the slip along the friction, and that
/// across it, which what slides resists by the force that friction has.
ContactSpring ContactSprings::spring_of(const WeightedNode& node,
                                        std::span<const WeightedGapMotion> motions) const {
  ContactSpring spring;
  spring.coupling.setZero();
  spring.coupling(0, 0) = 1.0;
  spring.stiffness.setZero();
  spring.stiffness(0, 0) = node.slope * node.area;
  const bool has_friction = node.has_friction();
  std::array<Eigen::Vector3d, 2> directions;
  if (has_friction) {
    directions = slip_directions(node);
    const FrictionStep& friction = node.friction;
    const bool slides = !friction.slip.isZero(0.0);
    const double way = (friction.elastic_slip + friction.slip).norm();
    spring.stiffness(1, 1) = slides ? 0.0 : node.slip_stiffness() * node.bearing;
    spring.stiffness(2, 2) = slides ? friction.force.norm() / way * node.bearing : spring.stiffness(1, 1);
    // What slides is dragged against its way by more where the gap closes.
    if (slides) spring.unsymmetric(1, 0) = -node.friction_slope * node.slope * node.bearing;
  }
  for (const WeightedGapMotion& motion : motions) {
    Eigen::Matrix3d by = Eigen::Matrix3d::Zero();
    by.row(0) = motion.opens.transpose();
    for (Eigen::Index i = 0; has_friction && i < 2; ++i)
      by.row(i + 1) = motion.slips * directions[static_cast<std::size_t>(i)].transpose();
    const std::size_t begin = spring.ends.size();
    add_corner(0, motion.node, Eigen::Vector3d::Zero(), spring);
    for (SpringEnd& end : std::span(spring.ends).subspan(begin)) end.share = (by * end.share).eval();
  }
  return spring;
}

std::optional<ContactSpring> ContactSprings::friction_spring_of(const ContactPoint& point, double dt,
                                                                bool holds_limit) const {
  const PairRule& rule = rules_.of(point);
  if (!(rule.friction > 0.0)) return std::nullopt;
  const double held = point.tangential.norm(), slips = point.slip.norm();
  const double way = point.elastic_slip.norm() + slips;
  const bool slides = slips > 0.0;
  if (!(held > 0.0) && slides) return std::nullopt;
  Eigen::Matrix3d along = Eigen::Matrix3d::Identity() - point.normal * point.normal.transpose();
  if (slides) along -= point.tangential * point.tangential.transpose() / (held * held);
  const bool is_of_node = point.is_of_node_and_face();
  const double sticking = (is_of_node ? static_slip_share : 1.0) * point.stiffness;
  ContactSpring spring = spring_between(point, (slides ? held / way : sticking) * along);
  if (slides && point.force > 0.0 && !(holds_limit && is_of_node)) {
    const double slope = rule.slip_limit_slope(point.force, point.area, dt > 0.0 ? slips / dt : 0.0);
    spring.unsymmetric = slope * point.stiffness / held * point.tangential * point.normal.transpose();
  }
  return spring;
}

ContactSpring ContactSprings::spring_of(const Tie& tie) const {
  ContactSpring spring;
  spring.coupling = tie.stiffness;
  spring.stiffness.setIdentity();
  for (std::size_t k = 0; k < tie.nodes.size(); ++k) {
    if (!tie.stiffness.row(static_cast<Eigen::Index>(k)).isZero(0.0))
      add_corner(k, tie.nodes[k], Eigen::Vector3d::Zero(), spring);
  }
  return spring;
}

ContactSpring ContactSprings::spring_of(const InterfaceConstraint& constraint) const {
  ContactSpring spring;
  spring.coupling = constraint.springs.asDiagonal();
  spring.stiffness.setIdentity();
  for (std::size_t k = 0; k < constraint.nodes.size(); ++k) {
    if (constraint.springs[static_cast<Eigen::Index>(k)] != 0.0)
      add_corner(k, constraint.nodes[k], Eigen::Vector3d::Zero(), spring);
  }
  return spring;
}

}  // namespace contactsim
