// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_face_contacts.hpp"

#include <algorithm>
#include <cmath>

#include "contact/formulations/cohesive_traction.hpp"
#include "contact/formulations/contact_multipliers.hpp"
#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/flush_rims.hpp"
#include "contact/formulations/near_pairs.hpp"
#include "contact/formulations/node_face/near_faces.hpp"
#include "contact/formulations/node_share.hpp"
#include "contact/formulations/penalty.hpp"
#include "contact/geometry/node_face.hpp"
#include "contact/interface_laws/friction.hpp"
#include "contact/smoothing/smooth_face.hpp"

namespace contactsim {

namespace {

/// Nodes that stand this share of an element's thickness beyond an edge project inside it.
constexpr double just_beyond = 1e-6;

double allowed_beyond(const SurfacePair& pair, const FaceBound& face) {
  return pair.tangential_tolerance.value_or(automatic_beyond * face.radius());
}

/// How a node and a face close.
struct Closing {
  double thinner = 0.0;  // of both [length]
  double closed = 0.0;   // in the last step, in the mean [length]
  double soon = 0.0;     // within the time that is looked ahead, at most [length]
  double margin = 0.0;   // gaps up to it are balanced however slow both are [length]
};

Closing find_closing(const ContactStepContext& context, const SurfaceNode& node, const ContactFace& face,
                     const FaceBound& bound) {
  const Eigen::Vector3f closing = bound.velocity() - context.kinematics.v(node.node).cast<float>();
  const float mean = closing.dot(bound.normal());
  const double thinner = std::min(face.penalty_properties.thickness, node.penalty_properties.thickness);
  return {thinner, above_zero(mean) * context.dt,
          above_zero(mean + bound.normal_velocity_spread()) * context.ahead(),
          context.balances ? closed_share * thinner : 0.0};
}

/// By what presses, or by the pressure that is held in trials of load steps.
double slip_limit(const ContactStepContext& context, const PairRule& rule, ContactPoint point) {
  if (context.slip_pressures != nullptr)
    point.force = point.area * context.slip_pressures->of(point.pair, point.row(), point.force / point.area);
  return rule.slip_limit(point, context.dt);
}

}  // namespace

void NodeFaceContacts::add_points(const ContactStepContext& context, SurfaceNodeIndex row,
                                  const NodeHistory& node_history, NearFaces& near_faces,
                                  std::vector<ContactPoint>& points) const {
  if (!start_partners_.empty()) choose_planes(near_faces);
  if (near_faces.n > 1) choose(context, row, node_history, near_faces);
  for (NearFace& near_face : near_faces) {
    const PairRule& rule = context.rules.of_node(near_face.pair, row);
    if (context.dt == 0.0 && near_face.point.gap > near_face.near && !rule.acts_apart()) continue;
    near_face.share *= share_of(context, row, near_face);
    ContactPoint& point = points.emplace_back(make_contact_point(context, row, near_face));
    if (rule.acts_apart()) {
      point.elastic_slip = node_history.elastic_slip(point.normal);
      add_node_traction(*rule.interface_law, make_push(context, row, near_face, point), point);
    }
    if (!point.is_met() || !(rule.friction > 0.0) || point.is_balanced) continue;
    point.elastic_slip = node_history.elastic_slip(point.normal);
    const double share = context.is_static ? static_slip_share : 1.0;
    add_friction(share * near_face.penalty.stiffness * point.area, slip_limit(context, rule, point), point);
  }
}

std::optional<ClosestPoint> NodeFaceContacts::find_closest_point(
    const ContactStepContext& context, const FaceInReach& in_reach,
    const std::optional<ClosestPoint>& flat) const {
  const SurfaceNode& node = contact_mesh_.surface_nodes[in_reach.row];
  const SmoothFace* round = contact_mesh_.smooth_faces.find(in_reach.rule->pair->smoothing, in_reach.face);
  if (round == nullptr && node.radius == 0.0f) return flat;
  const FaceCorners corners = context.kinematics.face_corners(in_reach.face);
  const bool is_triangle = contact_mesh_.faces[in_reach.face].is_triangle();
  const Eigen::Vector3d x = context.kinematics.x(node.node);
  if (round != nullptr) return project_sphere(corners, is_triangle, round, x, node.radius);
  return project_sphere(corners, is_triangle, x, node.radius, flat);
}

void NodeFaceContacts::add_near_face(const ContactStepContext& context, const FaceInReach& in_reach,
                                     const std::optional<ClosestPoint>& flat, NearFaces& near_faces) const {
  const FaceIndex face_index = in_reach.face;
  const PairRule& rule = *in_reach.rule;
  const NodeHistory& node_history = in_reach.node_history;
  const SurfaceNode& node = contact_mesh_.surface_nodes[in_reach.row];
  const ContactFace& face = contact_mesh_.faces[face_index];
  const FaceBound& bound = context.kinematics.bound(face_index);
  const Eigen::Vector3d x = context.kinematics.x(node.node);
  const Closing closing = find_closing(context, node, face, bound);
  NearFace near_face;
  near_face.face = face_index;
  near_face.pair = in_reach.pair;
  near_face.near = std::max(closing.soon, closing.margin);
  near_face.deeper = in_reach.deeper;
  near_face.is_plane = in_reach.keeps_plane && !(flat && !flat->edge);
  if (near_face.is_plane) {
    stand_on_plane(context.kinematics.face(face_index), x, node.radius, near_face);
  } else {
    const auto point = find_closest_point(context, in_reach, flat);
    if (!point) return;
    near_face.point = *point;
    near_face.distance = std::abs(point->gap + node.radius) + point->beyond;
    near_face.weights = corner_weights(point->xi, point->eta, face.is_triangle());
  }
  near_face.point.gap -= in_reach.offset;
  const double held = node_history.face_histories.empty() ? 0.0 : rule.pair->held_gap(closing.thinner);
  near_face.pulls = near_face.point.gap <= held && held > 0.0 &&
                    node_history.touched(near_face.pair, near_face.point.normal);
  const double from_afar = std::max({rule.activation_distance, near_face.near,
                                     context.dt > 0.0 ? 0.0 : static_cast<double>(bound.radius())});
  if (near_face.point.gap > from_afar && !near_face.pulls) return;
  // As projects_inside(), which takes longer behind the face.
  if (near_face.point.gap >= 0.0 && near_face.point.beyond > allowed_beyond(*rule.pair, bound)) return;
  near_face.penalty = make_pair_penalty(node.penalty_properties, &face.penalty_properties, rule);
  if (context.is_static) near_face.penalty.law = {};  // multipliers press what is deep
  const bool is_known = node_history.knows(near_face.point.normal);
  near_face.penalty.depth =
      is_known ? any_depth
               : std::max(near_face.penalty.depth, 1.5 * closing.closed) + std::max(in_reach.offset, 0.0);
  if (-near_face.point.gap > near_face.penalty.depth) return;
  if (!comes_from_outside(context, node, near_face, node_history.depth(near_face.point.normal))) return;
  if (!is_facing(context, node, near_face.point.normal) || !projects_inside(context, face_index, near_face))
    return;
  const bool may_hang_over =
      near_face.is_plane || (near_face.point.edge && rule.pair->tangential_tolerance.has_value());
  if ((near_face.point.gap < 0.0 || context.balances) && node.radius == 0.0f && !may_hang_over &&
      is_at_flush_rim(context, in_reach.row, face_index, near_face.point.normal))
    return;
  near_faces.add(near_face);
}

bool NodeFaceContacts::comes_from_outside(const ContactStepContext& context, const SurfaceNode& node,
                                          const NearFace& near_face, double depth) const {
  if (near_face.point.gap >= 0.0 || !must_come_from_outside(context, context.rules[near_face.pair]))
    return true;
  const double approach = (context.kinematics.face_velocities(near_face.face) * near_face.weights -
                           context.kinematics.v(node.node))
                              .dot(near_face.point.normal) *
                          context.dt;
  // What comes up behind the one side of a shell that takes part leaves through it.
  if (context.rules[near_face.pair].pair->is_polar() && !(approach > 0.0) && depth == 0.0) return false;
  // Beyond the edge of a face it may be outside the body: there it has to come from in front. A spring that
  // holds the node already does not end there, for its force would come and go with all of its depth.
  const bool is_beyond =
      near_face.point.edge && near_face.point.beyond > just_beyond * node.penalty_properties.thickness;
  const double held = context.balances && is_beyond ? 0.0 : known_depth * depth;
  const double shallow = is_beyond ? just_beyond * node.penalty_properties.thickness
                                   : std::max(shallow_depth * node.penalty_properties.thickness,
                                              flush_width(context, near_face.face));
  return near_face.point.gap + approach > -std::max(shallow, held);
}

bool NodeFaceContacts::is_facing(const ContactStepContext& context, const SurfaceNode& node,
                                 const Eigen::Vector3d& normal) const {
  // Where nothing may go through, a node at an edge that only leans over the face counts too.
  const auto limit = [&](FaceIndex own) {
    return context.balances ? max_facing_cosine_of_blade : facing_limit(contact_mesh_.faces[own].sharpness);
  };
  bool has_faces = false;
  for (const FaceIndex own : contact_mesh_.faces_of_node.of(node.node)) {
    if (contact_mesh_.faces[own].surface != node.surface) continue;
    if (context.kinematics.bound(own).normal().dot(normal.cast<float>()) < static_cast<float>(limit(own)))
      return true;
    has_faces = true;
  }
  return !has_faces;
}

bool NodeFaceContacts::projects_inside(const ContactStepContext& context, FaceIndex face_index,
                                       const NearFace& near_face) const {
  if (!near_face.point.edge) return true;
  const FaceBound& bound = context.kinematics.bound(face_index);
  double allowed = allowed_beyond(*context.rules[near_face.pair].pair, bound);
  if (near_face.point.beyond <= allowed) return true;
  const ContactFace& face = contact_mesh_.faces[face_index];
  // Behind the edge of a hollow there is a wedge that no face projects inside.
  const std::size_t n = face.is_triangle() ? 3 : 4, k = *near_face.point.edge;
  const ContactNodeIndex a = face.corners[k], b = face.corners[(k + 1) % n];
  for (const FaceIndex other : contact_mesh_.faces_of_node.of(a)) {
    if (other == face_index || !has_corner(contact_mesh_.faces[other], b)) continue;
    if (bound.is_in_front(context.kinematics.bound(other).centre()))
      allowed += std::max(0.0, -near_face.point.gap);
  }
  return near_face.point.beyond <= allowed;
}

/// The node's share in what both ways of the pair do together. To forces along the gap that only the sum of
/// both ways matters to, half will do; a pull has the traction that its law says on all of the area. A node
/// that is inside is pushed out as without a pull, also one whose faces lie beside the other side.
double NodeFaceContacts::share_of(const ContactStepContext& context, SurfaceNodeIndex row,
                                  const NearFace& near_face) const {
  if (contact_mesh_.surface_nodes[row].radius > 0.0f) return 1.0;  // no face's nodes meet spheres in turn
  const PairRule& rule = context.rules.of_node(near_face.pair, row);
  if (!rule.acts_apart()) return rule.pair->node_share();
  const NearPair near_pair{row.value, near_face.face, near_face.pair, true,
                           std::max(rule.activation_distance, near_face.penalty.depth)};
  const double of_pull = node_share(context, candidates_, near_pair, near_face.weights);
  return near_face.point.gap < 0.0 ? std::max(of_pull, rule.pair->node_share()) : of_pull;
}

ContactPoint NodeFaceContacts::make_contact_point(const ContactStepContext& context, SurfaceNodeIndex row,
                                                  const NearFace& near_face) const {
  const SurfaceNode& node = contact_mesh_.surface_nodes[row];
  const ContactFace& face = contact_mesh_.faces[near_face.face];
  const PairRule& rule = context.rules[near_face.pair];
  ContactPoint contact_point;
  contact_point.pair = near_face.pair;
  contact_point.is_swapped = node.surface != rule.pair->first;
  contact_point.first_entity = row.value;
  contact_point.second_entity = near_face.face.value;
  contact_point.first.nodes.fill(node.node);
  contact_point.first.weights = Eigen::Vector4d::UnitX();
  contact_point.first.radius = node.radius;
  contact_point.second = {face.corners, near_face.weights};
  contact_point.normal = near_face.point.normal;
  contact_point.gap = near_face.point.gap;
  contact_point.pulls = near_face.pulls;
  contact_point.begin_gap = context.rules.of_node(near_face.pair, row).begin_gap + near_face.deeper;
  push_node(make_push(context, row, near_face, contact_point), contact_point);
  return contact_point;
}

NodePenaltyInput NodeFaceContacts::make_push(const ContactStepContext& context, SurfaceNodeIndex row,
                                             const NearFace& near_face,
                                             const ContactPoint& contact_point) const {
  const SurfaceNode& node = contact_mesh_.surface_nodes[row];
  const SurfacePair& pair = *context.rules[near_face.pair].pair;
  const double area =
      near_face.share * context.kinematics.area_against(node, near_face.point.normal, pair.smoothing);
  const Eigen::Vector3d arm = -static_cast<double>(node.radius) * near_face.point.normal;
  FaceCorners velocities;
  for (Eigen::Index k = 0; k < 4; ++k)
    velocities.col(k) = context.kinematics.v(contact_point.second.nodes[static_cast<std::size_t>(k)]);
  const Eigen::Vector3d relative =
      context.kinematics.velocity_beside(node.node, arm) - velocities * contact_point.second.weights;
  Eigen::Vector3d last = Eigen::Vector3d::Zero();  // for laws across a gap alone
  if (context.rules.of_node(near_face.pair, row).acts_apart())
    last = context.kinematics.last_velocity_beside(node.node, arm) -
           context.kinematics.last_face(near_face.face).v * contact_point.second.weights;
  return {near_face.penalty, pair.damping_fraction, area, relative,
          context.dt,        context.coming_dt,     last, context.is_static};
}

}  // namespace contactsim
