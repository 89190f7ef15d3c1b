// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/enforcement/contact_assembler.hpp"
#include "core/dynamics/model.hpp"

namespace contactsim {

/// The moments of contact forces on points that stand off the nodes of the mesh: points of lofts by their
/// offset vectors, surfaces of spheres and capsules by their radii. A point of a loft turns with the mid
/// surface about its node (LoftSpins), so its moment M = offset x F goes to the nodes around as forces that
/// do the same work; what no neighbour can take, and all other moments, turn the node itself.
class OffsetMoments {
 public:
  /// All must outlive this.
  OffsetMoments(const ContactMesh& contact_mesh, const ContactKinematics& kinematics,
                const ContactAssembler& assembler)
      : contact_mesh_(contact_mesh), kinematics_(kinematics), assembler_(assembler) {}

  /// Gives the moments on lofted shells to the nodes around.
  ///   forces  3 x n_nodes of the mesh [force], added to
  void add_forces(Eigen::Matrix3Xd& forces);
  /// Sets the moments that turn nodes. Particles and the nodes of trusses do not turn: the moment of friction
  /// on them is lost.
  ///   moments  3 x n_nodes of the mesh [force length]
  void set(const Model& model, Eigen::Matrix3Xd& moments) const;

 private:
  template <class Visit>
  void visit(const Visit& visit) const;

  const ContactMesh& contact_mesh_;
  const ContactKinematics& kinematics_;
  const ContactAssembler& assembler_;
  std::vector<Eigen::Vector3d> of_spins_;  // scratch, about nodes of lofted shells [force length]
};

}  // namespace contactsim
