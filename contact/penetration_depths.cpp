// SPDX-License-Identifier: BSD-3-Clause
#include "contact/penetration_depths.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "contact/common_plane.hpp"
#include "core/state_archive.hpp"

namespace contactsim {

void PenetrationDepths::begin_step(std::size_t n_faces) {
  std::swap(last_, next_);
  last_.resize(n_faces, 0.0);
  next_.assign(n_faces, 0.0);
}

void PenetrationDepths::note(const MovingSurface& surface, const ContactRecord& record) {
  const bool touches = record.gap < 0.0 || record.force > 0.0 || record.is_balanced;
  if (!touches || record.is_of_edges) return;
  const ContactFaces& faces = surface.faces();
  const double depth = std::max(-record.gap, std::numeric_limits<double>::min());
  const auto deepen = [&](std::uint32_t face) { next_[face] = std::max(next_[face], depth); };
  const bool has_second_face = !record.second.weights.isZero(0.0);
  if (has_second_face) deepen(record.second_place);
  if (!record.first.is_node()) return deepen(record.first_place);
  const SurfaceNode& node = faces.surface_nodes[record.first_place];
  for (const std::uint32_t own : faces.faces_of_node.of(node.node)) {
    if (faces.faces[own].surface != node.surface) continue;
    if (surface.bound(own).normal().cast<double>().dot(record.normal) < most_aside) deepen(own);
  }
}

void PenetrationDepths::renumber(const ContactRenumbering& places) {
  carry(places.faces, places.n_faces_after, 0.0, last_);
  carry(places.faces, places.n_faces_after, 0.0, next_);
}

void PenetrationDepths::archive(StateArchive& saved) {
  // What is known between steps; begin_step() makes it that of the last one.
  saved.list("contact/faces/penetration", next_);
}

}  // namespace contactsim
