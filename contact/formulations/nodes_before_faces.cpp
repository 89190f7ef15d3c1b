// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/nodes_before_faces.hpp"

#include "contact/formulations/near_pairs.hpp"
#include "contact/mesh/contact_model.hpp"

namespace contactsim {

namespace {

/// A node that stands beside a face by this share of its size counts as over it.
constexpr double beside_face = 0.02;

}  // namespace

void visit_nodes_before_faces(ContactSearch& search, const ContactKinematics& kinematics,
                              const PairRules& rules, const Motion& motion,
                              const std::function<void(const NodeBeforeFace&)>& take) {
  const ContactMesh& contact_mesh = kinematics.contact_mesh();
  FacePairLists face_partners;
  NodeFaceLists node_faces;
  search.find_face_pairs(kinematics, motion, {}, face_partners);
  search.find_node_faces(kinematics, motion, {}, node_faces);
  const auto look_at = [&](SurfaceNodeIndex row, FaceIndex face_index, double offset) {
    const SurfaceNode& node = contact_mesh.surface_nodes[row];
    const ContactFace& face = contact_mesh.faces[face_index];
    const OptionalIndex<PairIndex> pair = rules.find(node.surface, face.surface);
    if (!pair || !rules[*pair].is_active) return;
    const SurfacePair& of = *rules[*pair].pair;
    if (!search.takes_part(of, node) || !search.takes_part(of, face)) return;
    const MovingFace moving = kinematics.face(face_index);
    const SmoothFace* round = contact_mesh.smooth_faces.find(of.smoothing, face_index);
    const auto point =
        project_sphere(moving.x, moving.is_triangle, round, kinematics.x(node.node), node.radius);
    if (!point || point->beyond > beside_face * kinematics.bound(face_index).radius()) return;
    if (!is_facing(kinematics, node, point->normal)) return;
    take({*pair, row, face_index, *point, point->gap - offset});
  };
  const auto add_corners = [&](FaceIndex of, FaceIndex before) {
    const ContactFace& face = contact_mesh.faces[of];
    const PairIndex pair = *rules.find(face.surface, contact_mesh.faces[before].surface);
    const double offset = rules.gap_offsets().of_faces(pair, of, before);
    for (const ContactNodeIndex corner : face.corners) {
      const auto row = contact_mesh.find_row(corner, face.surface);
      if (row) look_at(*row, before, offset);
    }
  };
  for (const FaceIndex first : face_partners.rows()) {
    for (const FaceIndex second : face_partners.of(first)) {
      add_corners(first, second);
      add_corners(second, first);
    }
  }
  for (const SurfaceNodeIndex row : node_faces.rows()) {
    for (const FaceIndex face : node_faces.of(row)) {
      const PairIndex pair =
          *rules.find(contact_mesh.surface_nodes[row].surface, contact_mesh.faces[face].surface);
      look_at(row, face, rules.gap_offsets().of_node(pair, row));
    }
  }
}

}  // namespace contactsim
