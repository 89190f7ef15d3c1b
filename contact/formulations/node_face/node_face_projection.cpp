// SPDX-License-Identifier: BSD-3-Clause
// Which faces nodes are projected onto, eight at a time.
#include <algorithm>
#include <limits>

#include "contact/formulations/node_face/near_faces.hpp"
#include "core/base/prefetch.hpp"

namespace contactsim {

/// Faces in reach, row by row, of which eight are projected onto together, whichever nodes they are of. The
/// contact points of a node follow once all of its faces are known.
class NodeFaceContacts::Projection {
 public:
  Projection(const NodeFaceContacts& contacts, const ContactStepContext& context,
             std::vector<ContactPoint>& points)
      : contacts_(contacts), context_(context), points_(points) {}

  /// Adds a face that the node may touch as far as its reach tells. What is known of the face is fetched
  /// before it is looked at, some faces later.
  void add(const FaceInReach& in_reach, const NodeReach::Limits& limits) {
    Fetched& fetched = fetched_[n_added_ % fetched_.size()];
    if (n_added_ >= fetched_.size()) look_at(fetched);
    fetched = {in_reach, limits};
    prefetch(context_.kinematics.bound(in_reach.face));
    prefetch(contacts_.contact_mesh_.faces[in_reach.face].corners);
    ++n_added_;
  }
  void finish() {
    const std::size_t n = fetched_.size();
    for (std::size_t i = n_added_ - std::min(n_added_, n); i < n_added_; ++i) look_at(fetched_[i % n]);
    n_added_ = 0;
    if (lanes_.size() > 0) project();
    finish_node();
  }

 private:
  struct Fetched {
    FaceInReach in_reach;
    NodeReach::Limits limits;
  };

  void look_at(const Fetched& fetched) {
    const FaceInReach& in_reach = fetched.in_reach;
    if (!contacts_.may_touch(context_, in_reach, fetched.limits)) return;
    const ContactKinematics& kinematics = context_.kinematics;
    const ContactMesh& contact_mesh = contacts_.contact_mesh_;
    waiting_[lanes_.size()] = in_reach;
    lanes_.add(kinematics.face_corners(in_reach.face), contact_mesh.faces[in_reach.face].is_triangle(),
               kinematics.x(contact_mesh.surface_nodes[in_reach.row].node));
    if (lanes_.are_full()) project();
  }
  void project() {
    const auto closest = lanes_.project();
    for (std::size_t lane = 0; lane < lanes_.size(); ++lane) {
      const FaceInReach& in_reach = waiting_[lane];
      if (near_faces_.n > 0 && in_reach.row != row_) finish_node();
      row_ = in_reach.row;
      node_history_ = in_reach.node_history;
      contacts_.add_near_face(context_, in_reach, closest[lane], near_faces_);
    }
    lanes_.clear();
  }
  void finish_node() {
    if (near_faces_.n > 0) contacts_.add_points(context_, row_, node_history_, near_faces_, points_);
    near_faces_.n = 0;
  }

  const NodeFaceContacts& contacts_;
  const ContactStepContext& context_;
  std::vector<ContactPoint>& points_;
  std::array<Fetched, 8> fetched_;
  std::size_t n_added_ = 0;
  ProjectionLanes lanes_;
  std::array<FaceInReach, n_lanes> waiting_;
  // Of the node whose faces come now.
  SurfaceNodeIndex row_;
  NodeHistory node_history_;
  NearFaces near_faces_;
};

void NodeFaceContacts::detect(const ContactStepContext& context, CandidateRows rows,
                              std::vector<ContactPoint>& points) const {
  Projection projection(*this, context, points);
  for (const SurfaceNodeIndex row : rows.indices<SurfaceNodeIndex>()) {
    const SurfaceNodeIndex next{row.value + 1};
    if (next.value < rows.end) {
      for (const FaceIndex face : candidates_.of(next)) prefetch(bounds_[face]);
    }
    if (!candidates_.of(row).empty()) find_faces_in_reach(context, row, projection);
  }
  projection.finish();
}

void NodeFaceContacts::find_faces_in_reach(const ContactStepContext& context, SurfaceNodeIndex row,
                                           Projection& projection) const {
  const NodeHistory node_history = history_.of(row);
  const bool is_known = !node_history.face_histories.empty();
  std::optional<NodeReach> reach;
  NodeReach::Faces faces;
  const auto add_faces = [&] {
    for (std::uint32_t left = reach->find(bounds_, faces); left != 0; left &= left - 1) {
      const std::size_t lane = first_lane(left);
      const FaceIndex face = faces.face(lane);
      const PairRule& rule = reach->rule();
      const bool keeps_plane =
          rule.pair->behavior == InteractionBehavior::infinitesimal_sliding && start_partners_.has(row, face);
      const FaceInReach in_reach{
          row, face, reach->pair(), &rule, node_history, reach->offset(), reach->deeper(), keeps_plane};
      projection.add(in_reach, faces.limits(lane));
    }
    faces.clear();
  };
  std::optional<SurfaceIndex> surface;  // that the reach is for
  for (const FaceIndex face : candidates_.of(row)) {
    const ReachBounds::Bound& bound = bounds_[face];
    if (surface && (surface != bound.surface || faces.are_full())) add_faces();
    if (surface != bound.surface) reach.emplace(context, bounds_, row, bound.surface, is_known);
    surface = bound.surface;
    if (reach->rule().is_balanced == context.balances) faces.add(face);
  }
  if (surface) add_faces();
}

bool NodeFaceContacts::may_touch(const ContactStepContext& context, const FaceInReach& in_reach,
                                 const NodeReach::Limits& limits) const {
  const ContactNodeIndex node = contact_mesh_.surface_nodes[in_reach.row].node;
  const PairRule& rule = *in_reach.rule;
  const double beyond =
      in_reach.keeps_plane ? std::numeric_limits<float>::max() : static_cast<double>(limits.beyond);
  if (!may_project_inside(context.kinematics.x(node), context.kinematics.bound(in_reach.face), limits.above,
                          limits.below, beyond) ||
      has_corner(contact_mesh_.faces[in_reach.face], node))
    return false;
  if (!rule.is_active || rule.law == ContactLaw::tied) return false;
  return rule.law == ContactLaw::sliding || !context.constrained.holds_node(in_reach.row, in_reach.pair);
}

}  // namespace contactsim
