// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_step_limit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/state_archive.hpp"

namespace contactsim {

/// Bounds the eigenvalues of contact's stiffness over mass. Each contact point is a spring of stiffness k
/// with the share w of it at each of its nodes; with s the sum of k w at a node, a contact point may have the
/// share k w / s of the node's mass, which bounds all eigenvalues by the largest one of a single contact
/// point: the mean of s / m over its first side and that over its second. The largest s / m of two surfaces
/// take the place of the means. Points of lofts that hang on one node add up there, as do the nodes of a
/// rigid body.
double ContactStepLimit::largest_eigenvalue(const StepSprings& springs, ContactMobility& mobility) {
  if (springs.points.empty() && springs.held.empty()) return 0.0;
  const ContactMesh& contact_mesh = springs.kinematics.contact_mesh();
  slips_.assign(springs.rules.rules().size(), 0);
  surface_rates_.assign(contact_mesh.n_surfaces(), 0.0);
  for (const PairIndex i : indices(slips_)) {
    const PairRule& rule = springs.rules[i];
    const bool has_law = rule.interface_law != nullptr && !rule.interface_law->only_presses();
    slips_[i] = rule.friction > 0.0 || has_law || rule.far ? 1 : 0;
  }
  const auto node_rates = mobility.find_rates(springs.kinematics, springs.points, springs.held, slips_);
  for (const SurfaceNode& node : contact_mesh.surface_nodes) {
    double& rate = surface_rates_[node.surface];
    rate = std::max(rate, node_rates[node.node]);
  }
  double largest = 0.0;
  for (const PairIndex i : indices(springs.pairs)) {
    const SurfacePair& pair = *springs.rules[i].pair;
    if (springs.pairs[i].is_near)
      largest = std::max(largest, surface_rates_[pair.first] + surface_rates_[pair.second]);
  }
  return largest;
}

/// Eigenvalues of stiffness over mass add up at most: that of the elements, 4 / dt^2, and contact's; that of
/// laws that pull where momentum is balanced is of the step before. A bounce off a penalty must last three
/// steps at least, or it gains energy by where its first step falls.
double ContactStepLimit::find(double stable_step, const StepSprings& springs, ContactMobility& mobility) {
  const double eigenvalue = std::max(largest_eigenvalue(springs, mobility), pull_eigenvalue_);
  if (!(eigenvalue > 0.0)) return std::numeric_limits<double>::infinity();
  const double of_elements = 4.0 / (stable_step * stable_step);
  const double left = std::min(2.0 / std::sqrt(of_elements + eigenvalue), 1.0 / std::sqrt(eigenvalue));
  lost_share_ = std::max(lost_share_, 1.0 - left / stable_step);
  return left;
}

void ContactStepLimit::archive(StateArchive& saved) {
  saved.numbers("contact/step_share", lost_share_);
  saved.numbers("contact/pull_eigenvalue", pull_eigenvalue_);
}

}  // namespace contactsim
