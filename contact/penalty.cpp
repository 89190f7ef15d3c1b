// SPDX-License-Identifier: BSD-3-Clause
#include "contact/penalty.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// What is left of two things in series, such as springs; an absent one is rigid.
double in_series(double a, const double* b) { return b != nullptr ? a * *b / (a + *b) : a; }

}  // namespace

void limit_stiffness(double stable_step, ContactFaces& faces) {
  std::vector<double> area(faces.n_nodes(), 0.0), most(faces.n_nodes());
  for (const SurfaceNode& node : faces.surface_nodes) area[node.node] += node.area;
  for (std::size_t i = 0; i < most.size(); ++i)
    most[i] = 4.0 * penalty_share * faces.mass[i] / (area[i] * stable_step * stable_step);
  for (SurfaceNode& node : faces.surface_nodes)
    node.backing.stiffness = std::min(node.backing.stiffness, most[node.node]);
  for (ContactFace& face : faces.faces) {
    for (const std::uint32_t corner : face.corners)
      face.backing.stiffness = std::min(face.backing.stiffness, most[corner]);
  }
}

PairPenalty make_pair_penalty(const Backing& first, const Backing* second, const SurfacePair& pair) {
  constexpr double deep = 0.5;  // of the thinner element
  PairPenalty penalty;
  penalty.stiffness =
      pair.penalty_stiffness.value_or(in_series(first.stiffness, second ? &second->stiffness : nullptr)) *
      pair.penalty_scale;
  const double mass = in_series(first.mass_per_area, second ? &second->mass_per_area : nullptr);
  penalty.damping = 2.0 * pair.damping_fraction * std::sqrt(penalty.stiffness * mass);
  const double thickness = second ? std::min(first.thickness, second->thickness) : first.thickness;
  penalty.depth = pair.normal_tolerance.value_or(deep * thickness);
  return penalty;
}

}  // namespace contactsim
