// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/tied/make_ties.hpp"

#include "contact/formulations/penalty.hpp"

namespace contactsim {

double tie_stiffness(const ContactStepContext& context, const InterfaceConstraint& tie) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  const PenaltyProperties& first = tie.is_node ? contact_mesh.surface_nodes[tie.row()].penalty_properties
                                               : contact_mesh.faces[tie.first_face()].penalty_properties;
  const PenaltyProperties& second = contact_mesh.faces[tie.second].penalty_properties;
  return make_pair_penalty(first, &second, *context.rules[tie.pair].pair).stiffness;
}

std::optional<Tie> make_face_tie(const ContactStepContext& context, FaceIndex first, FaceIndex second,
                                 double tolerance) {
  Tie tie{constraint_of_faces(context, first, second)};
  if (!tie_faces(context.kinematics.face(first), context.kinematics.face(second), tie_stiffness(context, tie),
                 tolerance, tie))
    return std::nullopt;
  return tie;
}

std::optional<Tie> make_node_tie(const ContactStepContext& context, const NearPair& near_pair) {
  const auto point = find_closest_point(context, near_pair.row(), near_pair.second, near_pair.tolerance);
  if (!point) return std::nullopt;
  const SurfaceNode& node = context.kinematics.contact_mesh().surface_nodes[near_pair.row()];
  const MovingFace moving = context.kinematics.face(near_pair.second);
  Tie tie{constraint_of_node(context, near_pair.row(), near_pair.second)};
  tie.share = near_pair.share;
  tie.area = near_pair.share * context.kinematics.area_against(node, point->normal);
  tie_node(context.kinematics.x(node.node), moving, corner_weights(point->xi, point->eta, moving.is_triangle),
           tie_stiffness(context, tie) * tie.area, tie);
  return tie;
}

std::vector<Tie> make_ties(const ContactStepContext& context, const FacePairLists& face_partners,
                           const NodeFaceLists& node_faces, double size_share, const HoldsPair& holds) {
  std::vector<Tie> ties;
  for (const NearPair& near_pair : find_near_pairs(context, face_partners, node_faces, size_share, holds)) {
    const auto tie = near_pair.is_node ? make_node_tie(context, near_pair)
                                       : make_face_tie(context, near_pair.first_face(), near_pair.second,
                                                       near_pair.tolerance);
    if (tie) ties.push_back(*tie);
  }
  return ties;
}

}  // namespace contactsim
