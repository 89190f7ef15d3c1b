// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/penetration_depths.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "contact/geometry/common_plane.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

void PenetrationDepths::begin_step(const ContactMesh& contact_mesh) {
  const std::size_t n_faces = contact_mesh.faces.size();
  std::swap(last_, next_);
  last_.resize(n_faces, 0.0);
  next_.assign(n_faces, 0.0);
  has_touched_.assign(contact_mesh.n_nodes(), 0);
  for (const FaceIndex face : indices(last_)) {
    if (!(last_[face] > 0.0)) continue;
    for (const ContactNodeIndex corner : contact_mesh.faces[face].corners) has_touched_[corner] = 1;
  }
}

void PenetrationDepths::note(const ContactKinematics& kinematics, const ContactPoint& point) {
  const bool touches = point.gap < 0.0 || point.force > 0.0 || point.is_balanced;
  if (!touches || point.is_of_edges) return;
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  const double depth = std::max(-point.gap, std::numeric_limits<double>::min());
  const auto deepen = [&](FaceIndex face) { next_[face] = std::max(next_[face], depth); };
  const bool has_second_face = !point.second.weights.isZero(0.0);
  if (has_second_face) deepen(point.second_face());
  if (!point.first.is_node()) return deepen(point.first_face());
  const SurfaceNode& node = contact_mesh.surface_nodes[point.row()];
  for (const FaceIndex own : contact_mesh.faces_of_node.of(node.node)) {
    if (contact_mesh.faces[own].surface != node.surface) continue;
    const double facing = facing_limit(contact_mesh.faces[own].sharpness);
    if (kinematics.bound(own).normal().cast<double>().dot(point.normal) < facing) deepen(own);
  }
}

void PenetrationDepths::remap(const ContactRemap& remap) {
  transfer(remap.faces, remap.n_faces_after, 0.0, last_);
  transfer(remap.faces, remap.n_faces_after, 0.0, next_);
}

void PenetrationDepths::archive(StateArchive& saved) {
  // What is known between steps; begin_step() makes it that of the last one.
  saved.list("contact/faces/penetration", next_);
}

}  // namespace contactsim
