// SPDX-License-Identifier: BSD-3-Clause
// Which of the faces that a node is near to it touches.
#include <algorithm>
#include <cmath>

#include "contact/formulations/node_face/near_faces.hpp"

namespace contactsim {

/// A node right behind an edge or a corner projects inside all its faces alike. Choosing one would push it
/// aside, and which one it is would be chance: they share the node. Faces that lie in one plane need not,
/// where both push alike. Returns how many faces, the first ones, share it.
std::size_t NodeFaceContacts::share_at_edge(double thickness, NearFaces& near_faces) {
  constexpr double alike = 1e-6, alike_over_thickness = 1e-4, one_plane = 1.0 - 1e-13;
  const ClosestPoint& first = near_faces.all[0].point;
  const double stiffness = near_faces.all[0].penalty.stiffness;
  const double farthest = (1.0 + alike) * near_faces.all[0].distance + alike_over_thickness * thickness;
  std::size_t n = 1;
  for (std::size_t i = 1; i < near_faces.n; ++i) {
    const ClosestPoint& point = near_faces.all[i].point;
    const double cosine = first.normal.dot(point.normal);
    const bool is_farther = near_faces.all[i].distance > farthest;
    const bool push_alike =
        cosine > one_plane && std::abs(near_faces.all[i].penalty.stiffness - stiffness) <= alike * stiffness;
    if (cosine < NodeHistory::same_wall || push_alike || is_farther) continue;
    std::swap(near_faces.all[i], near_faces.all[n++]);
  }
  for (std::size_t i = 0; i < n; ++i) near_faces.all[i].share = 1.0 / static_cast<double>(n);
  return n;
}

void NodeFaceContacts::choose(const ContactStepContext& context, SurfaceNodeIndex row,
                              const NodeHistory& node_history, NearFaces& near_faces) const {
  const bool is_sphere = contact_mesh_.surface_nodes[row].radius > 0.0f;
  const auto went_in_here = [&](const NearFace& near_face) {
    return node_history.knows(near_face.point.normal);
  };
  // Faces on the side of the last step first, then the nearest, then those over which the node stands.
  std::stable_sort(near_faces.begin(), near_faces.end(), [&](const NearFace& a, const NearFace& b) {
    const bool a_in = went_in_here(a), b_in = went_in_here(b);
    if (a_in != b_in) return a_in;
    return a.distance < b.distance;
  });
  std::size_t n_chosen =
      share_at_edge(contact_mesh_.faces[near_faces.all[0].face].penalty_properties.thickness, near_faces);
  for (std::size_t i = n_chosen, n_walls = 1; i < near_faces.n && n_walls < max_walls; ++i) {
    const NearFace& near_face = near_faces.all[i];
    const auto is_other_wall = [&](const NearFace& chosen) {
      const FaceBound &wall = context.kinematics.bound(chosen.face),
                      &other = context.kinematics.bound(near_face.face);
      const double cosine = chosen.point.normal.dot(near_face.point.normal);
      // Of a hollow: each wall stands in front of the other. A sphere fills a narrow one, too.
      return cosine < NodeHistory::same_wall && (is_sphere || cosine > -NodeHistory::same_wall) &&
             wall.is_in_front(other.centre()) && other.is_in_front(wall.centre());
    };
    if (std::all_of(near_faces.begin(), near_faces.begin() + static_cast<std::ptrdiff_t>(n_chosen),
                    is_other_wall))
      near_faces.all[n_chosen++] = near_face, ++n_walls;
  }
  near_faces.n = n_chosen;
}

}  // namespace contactsim
