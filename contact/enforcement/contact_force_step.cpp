// SPDX-License-Identifier: BSD-3-Clause
// How much contact lowers the stable step.
#include <algorithm>
#include <cmath>

#include "contact/enforcement/contact_force.hpp"

namespace contactsim {

/// Bounds the eigenvalues of contact's stiffness over mass. Each contact point is a spring of stiffness k
/// with the share w of it at each of its nodes; with s the sum of k w at a node, a contact point may have the
/// share k w / s of the node's mass, which bounds all eigenvalues by the largest one of a single contact
/// point: the mean of s / m over its first side and that over its second. The largest s / m of two surfaces
/// take the place of the means. Points of lofts that hang on one node add up there, as do the nodes of a
/// rigid body.
double ContactForce::largest_eigenvalue() {
  if (points_.empty() && constraint_forces_.empty()) return 0.0;
  slips_.assign(rules_.rules().size(), 0);
  for (const PairIndex i : indices(slips_)) {
    const PairRule& rule = rules_[i];
    const bool has_law = rule.interface_law != nullptr && !rule.interface_law->only_presses();
    slips_[i] = rule.friction > 0.0 || has_law || rule.far ? 1 : 0;
  }
  const auto node_rates = mobility_.find_rates(kinematics_, points_, constraint_forces_, slips_);
  IndexedVector<SurfaceIndex, double>& of_surface = surface_rates_;
  of_surface.assign(setup_.contact.surfaces.surfaces.size(), 0.0);
  for (const SurfaceNode& node : contact_mesh_.surface_nodes) {
    double& rate = of_surface[node.surface];
    rate = std::max(rate, node_rates[node.node]);
  }
  double largest = 0.0;
  for (const PairIndex i : indices(setup_.contact.pairs)) {
    const SurfacePair& pair = setup_.contact.pairs[i];
    if (assembler_.pairs()[i].is_near)
      largest = std::max(largest, of_surface[pair.first] + of_surface[pair.second]);
  }
  return largest;
}

/// The stable step that the penalty leaves. Eigenvalues of stiffness over mass add up at most: that of the
/// elements, 4 / dt^2, and contact's; that of laws that pull where momentum is balanced is of the step
/// before. A bounce off a penalty must last three steps at least, or it gains energy by where its first step
/// falls.
void ContactForce::limit_step(const Motion& motion, ForceReport& report) {
  const double eigenvalue = std::max(largest_eigenvalue(), pull_eigenvalue_);
  if (!(eigenvalue > 0.0)) return;
  const double of_elements = 4.0 / (motion.stable_step * motion.stable_step);
  report.stable_step = std::min(2.0 / std::sqrt(of_elements + eigenvalue), 1.0 / std::sqrt(eigenvalue));
  step_share_.share = std::max(step_share_.share, 1.0 - report.stable_step / motion.stable_step);
}

}  // namespace contactsim
