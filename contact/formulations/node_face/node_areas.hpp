// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/formulations/contact_step_context.hpp"

namespace contactsim {

/// Shares out the area of contact among the nodes of both sides where pairs go both ways. Every node that
/// meets a face gets a force from its own contact point and from those of the nodes that meet its faces;
/// under one pressure both together have to be the node's area times the pressure, or the patch test fails
/// and the resistance of a body depends on how many nodes of a finer mesh happen to be under it. Nodes whose
/// own faces are not in contact as a whole may have any.
class NodeAreas {
 public:
  /// Multiplies what goes with the area of contact points of nodes: area, force, stiffness, energies.
  ///   contact_points  contact points of nodes with faces, as NodeFaceContacts finds them, of all rows
  /// Source: the two-pass idea of Taylor and Papadopoulos (1991) as a problem of matrix scaling: weights that
  /// are products of factors, found by multiplicative iteration (Lucy, Astron. J. 79 (1974) 745-754).
  void share_out(const ContactStepContext& context, std::span<ContactPoint> contact_points);

 private:
  bool is_covered(const ContactStepContext& context, const ContactPoint& contact_point) const;
  void sum_areas(std::span<const ContactPoint> contact_points);
  void set_first_areas(const ContactStepContext& context, std::span<const ContactPoint> contact_points);
  void correct(std::span<const ContactPoint> contact_points);

  std::vector<std::uint32_t> both_ways_;  // positions of contact points
  std::vector<double> areas_;             // of these [length^2]
  IndexedVector<ContactNodeIndex, double> wanted_,
      found_;  // [n_contact_nodes] 0 of nodes without a contact point [length^2]
  IndexedVector<ContactNodeIndex, std::uint8_t> is_covered_;  // [n_contact_nodes]
};

}  // namespace contactsim
