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

/// Candidates row by row, faces of one surface at a time, as many as fit into lanes.
template <class Take>
class NodeFaceContacts::Reaching {
 public:
  /// All must outlive it.
  ///   take  takes this
  Reaching(const NodeFaceContacts& contacts, const ContactStepContext& context, const Take& take)
      : contacts_(contacts), context_(context), take_(take) {}

  void add(SurfaceNodeIndex row, std::size_t position) {
    const FaceIndex face = contacts_.candidates_.partner(position);
    const SurfaceIndex surface = contacts_.bounds_[face].surface;
    if (!reach_ || row != row_ || surface != surface_) {
      take();
      if (!reach_ || row != row_) history_ = contacts_.history_.of(row);
      reach_.emplace(context_, contacts_.bounds_, row, surface, !history_.face_histories.empty());
      row_ = row;
      surface_ = surface;
    } else if (faces_.are_full()) {
      take();
    }
    positions_[faces_.size()] = position;
    faces_.add(face);
  }
  /// Has those that are left taken.
  void take() {
    if (faces_.size() > 0) take_(*this);
    faces_.clear();
  }

  const NodeReach& reach() const { return *reach_; }
  SurfaceNodeIndex row() const { return row_; }
  const NodeHistory& history() const { return history_; }
  /// Among the candidates.
  std::size_t position(std::size_t lane) const { return positions_[lane]; }
  NodeReach::Faces& faces() { return faces_; }

 private:
  const NodeFaceContacts& contacts_;
  const ContactStepContext& context_;
  const Take& take_;
  std::optional<NodeReach> reach_;
  SurfaceNodeIndex row_;
  SurfaceIndex surface_;
  NodeHistory history_;
  NodeReach::Faces faces_;
  std::array<std::size_t, n_float_lanes> positions_;
};

void NodeFaceContacts::begin_detection(const ContactStepContext& context) {
  if (n_candidates() == 0) return;
  bounds_.update(context);
  if (use(context) != CandidateUse::renew_close) return;
  bounds_.find_turns(context.kinematics, context.close_range.motion);
  close_.renew(candidates_, [&](CandidateRows rows, const auto& take) {
    const auto take_close = [&](auto& reaching) {
      for (std::uint32_t left = reaching.reach().find_close(bounds_, reaching.faces(), context.close_range);
           left != 0; left &= left - 1)
        take(reaching.row(), reaching.position(first_lane(left)));
    };
    Reaching reaching(*this, context, take_close);
    close_.visit(
        candidates_, rows, CandidateUse::all, [](FaceIndex) {},
        [&](SurfaceNodeIndex row, std::size_t k) { reaching.add(row, k); });
    reaching.take();
  });
}

void NodeFaceContacts::detect(const ContactStepContext& context, CandidateRows rows,
                              std::vector<ContactPoint>& points) const {
  Projection projection(*this, context, points);
  const auto take_reached = [&](auto& reaching) {
    const NodeReach& reach = reaching.reach();
    const PairRule& rule = reach.rule();
    if (rule.is_balanced != context.balances) return;
    for (std::uint32_t left = reach.find(bounds_, reaching.faces()); left != 0; left &= left - 1) {
      const std::size_t lane = first_lane(left);
      const FaceIndex face = reaching.faces().face(lane);
      const bool keeps_plane = rule.pair->behavior == InteractionBehavior::infinitesimal_sliding &&
                               start_partners_.has(reaching.row(), face);
      projection.add({reaching.row(), face, reach.pair(), &rule, reaching.history(), reach.offset(),
                      reach.deeper(), keeps_plane},
                     reaching.faces().limits(lane));
    }
  };
  Reaching reaching(*this, context, take_reached);
  close_.visit(
      candidates_, rows, use(context), [&](FaceIndex face) { prefetch(bounds_[face]); },
      [&](SurfaceNodeIndex row, std::size_t k) { reaching.add(row, k); });
  reaching.take();
  projection.finish();
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
