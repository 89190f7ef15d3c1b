// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/formulations/interface_constraint.hpp"
#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/free_directions.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

/// How much contact nodes give way to springs: change of velocity per impulse [1/mass], by lumped mass and
/// rotary inertia, along the directions that conditions leave free. A node that is held or driven does not
/// give way; a node of a rigid body gives way by the body's mass and moments of inertia. Bounds the
/// frequencies of the elastic penalty.
class ContactMobility {
 public:
  /// All that the model refers to must outlive this.
  explicit ContactMobility(const Model& model);

  /// Takes over the conditions that act in the step that begins now. Returns whether nodes or bodies have
  /// become held or free since the last call.
  bool update(double time) { return free_.update(model_, time); }
  const ModelFreeDirections& free_directions() const { return free_; }

  /// Whether a contact node moves with a rigid body.
  bool is_of_body(const ContactMesh& contact_mesh, ContactNodeIndex node) const {
    return !model_.rigid.nodes.is_free(contact_mesh.mesh_nodes[node]);
  }
  /// How much a contact node gives way along a unit normal to a force along it, or along any direction where
  /// there is no normal. Of a rigid body a bound.
  double mobility(const ContactKinematics& kinematics, ContactNodeIndex node,
                  const Eigen::Vector3d* normal) const;
  /// Whether conditions keep a contact node from moving along a normal, or at all where there is none.
  bool is_held(const ContactKinematics& kinematics, ContactNodeIndex node,
               const Eigen::Vector3d* normal) const;

  /// For each contact node the sum of stiffness times mobility over all springs of its carrier, a node of the
  /// mesh or a rigid body: a bound of the square of its frequency when the other side is held
  /// [n_contact_nodes] [1/time^2].
  ///   slips  [n_pairs] whether points of a pair have springs along the surface, too
  IndexedSpan<ContactNodeIndex, const double> find_rates(const ContactKinematics& kinematics,
                                                         std::span<const ContactPoint> points,
                                                         std::span<const ConstraintForces> held,
                                                         IndexedSpan<PairIndex, const std::uint8_t> slips);
  /// The acceleration with which the forces of all points open each of them along its normal [n_points]
  /// [length/time^2]: of what they alone move, which are rigid bodies, by their translation, and masses and
  /// particles without elements that resist. What else resists does is not known here: 0.
  std::span<const double> find_accelerations(const ContactKinematics& kinematics,
                                             std::span<const ContactPoint> points);

 private:
  /// Whether contact alone moves a node.
  bool moves_alone(const ContactMesh& contact_mesh, ContactNodeIndex node) const;
  Eigen::Vector3d acceleration(const ContactMesh& contact_mesh, ContactNodeIndex node) const;
  double body_mobility(const ContactKinematics& kinematics, ContactNodeIndex node,
                       const Eigen::Vector3d* normal) const;
  Eigen::Vector3d arm(const ContactKinematics& kinematics, ContactNodeIndex node) const;
  std::size_t carrier(const ContactMesh& contact_mesh, ContactNodeIndex node) const;

  const Model& model_;
  ModelFreeDirections free_;
  std::vector<double> turn_mobilities_;            // [n_bodies] the largest [1/(mass length^2)]
  std::vector<double> carrier_rates_;              // scratch
  IndexedVector<ContactNodeIndex, double> rates_;  // scratch
  std::vector<Eigen::Vector3d> carrier_forces_;    // scratch
  std::vector<double> accelerations_;              // scratch
};

}  // namespace contactsim
