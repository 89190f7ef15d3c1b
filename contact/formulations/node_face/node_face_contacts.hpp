// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "contact/formulations/close_candidates.hpp"
#include "contact/formulations/contact_formulation.hpp"
#include "contact/formulations/node_face/node_areas.hpp"
#include "contact/formulations/node_face/node_face_history.hpp"
#include "contact/formulations/node_face/node_reach.hpp"
#include "contact/formulations/start_partners.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// The nodes that meet faces as nodes: NODE_FACE, and spheres. A node touches one face, or shares itself
/// among those of the edge or the corner right behind which it stands; only where faces form a hollow does it
/// touch more, three at most. It comes out on the side on which it went in, however deep it gets. Of pairs
/// that slide infinitesimally the plane of its face extends beyond the edges. A ContactFormulation.
class NodeFaceContacts {
 public:
  explicit NodeFaceContacts(const FormulationSetup& setup)
      : contact_mesh_(setup.contact_mesh),
        rules_(setup.rules),
        history_(setup.contact_mesh.surface_nodes.size()) {}

  void find_candidates(ContactSearch& search, const ContactKinematics& kinematics, const Motion& motion);
  /// Goes over to candidates: rows of surface nodes with faces.
  void take_candidates(NodeFaceLists candidates) {
    candidates_ = std::move(candidates);
    close_.forget();
  }
  std::size_t n_rows() const { return candidates_.n_rows(); }
  std::size_t n_candidates() const { return candidates_.partners.size(); }
  const NodeFaceLists& candidates() const { return candidates_; }
  /// Those that renew_close has found, or all where none are left out.
  std::size_t n_close() const { return leaves_out() ? close_.size() : n_candidates(); }
  void forget_close() { close_.forget(); }
  std::size_t bytes() const { return candidates_.bytes() + bounds_.bytes() + close_.bytes(); }
  /// A node needs the bounds of its own faces, too, and of those around the faces that it may touch.
  void watch(IndexedVector<FaceIndex, std::uint8_t>& is_watched) const;
  void watch_close(IndexedVector<FaceIndex, std::uint8_t>& is_watched) const;

  void begin_step() { history_.begin_step(); }
  void undo_begin_step() {}
  void begin_detection(const ContactStepContext& context);
  void detect(const ContactStepContext& context, CandidateRows rows, std::vector<ContactPoint>& points) const;
  void update(const ContactStepContext& context, CandidateRows rows, std::span<const ContactPoint> points) {
    history_.update(context, rows.begin / rows_per_chunk, points);
  }
  /// Shares out the area among the nodes of both sides.
  void complete(const ContactStepContext& context, std::span<ContactPoint> points) {
    node_areas_.share_out(context, points);
  }
  void find_lost(const PairRules& /*rules*/, std::vector<LostContact>& lost) const {
    history_.find_lost(lost);
  }
  /// How deep each node was in the last step [n_surface_nodes], 0 where it did not touch [length].
  std::vector<float> depths() const { return history_.depths(contact_mesh_.surface_nodes.size()); }
  /// Marks the nodes of HYBRID pairs that are close to the other side.
  void mark_close(const ContactStepContext& context, double size_share, PairRules& rules) const;
  /// Appends the gaps before the first step of nodes of pairs that have to know them.
  void add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const;

  void remap(const ContactRemap& remap);
  /// The surface nodes that the last remap() has released from their partners of the start.
  std::span<const ReleasedPartner<SurfaceNodeIndex>> released() const { return released_; }
  void archive(StateArchive& saved);

 private:
  static constexpr std::size_t max_walls = 3;

  struct NearFace;
  struct NearFaces;
  struct FaceInReach;
  class Projection;

  template <class Take>
  class Reaching;

  /// Whether candidates that are not close may be left out. Laws across a gap ask for all faces around what
  /// they act on, and what slides infinitesimally goes beyond the edges of its face.
  bool leaves_out() const;
  CandidateUse use(const ContactStepContext& context) const {
    return leaves_out() ? context.candidates : CandidateUse::all;
  }
  /// Marks the faces of which a node reads the bounds that may touch a face.
  void watch_around(SurfaceNodeIndex row, FaceIndex face,
                    IndexedVector<FaceIndex, std::uint8_t>& is_watched) const;
  bool may_touch(const ContactStepContext& context, const FaceInReach& in_reach,
                 const NodeReach::Limits& limits) const;
  /// Of the node's sphere, on the surface that the face stands for.
  ///   flat  of the node on the face itself
  std::optional<ClosestPoint> find_closest_point(const ContactStepContext& context,
                                                 const FaceInReach& in_reach,
                                                 const std::optional<ClosestPoint>& flat) const;
  /// Adds a face in reach if the node may touch it.
  void add_near_face(const ContactStepContext& context, const FaceInReach& in_reach,
                     const std::optional<ClosestPoint>& flat, NearFaces& near_faces) const;
  /// Adds the points of a node's near faces, which it chooses from.
  void add_points(const ContactStepContext& context, SurfaceNodeIndex row, const NodeHistory& node_history,
                  NearFaces& near_faces, std::vector<ContactPoint>& points) const;
  /// Whether one of the node's own faces is turned towards a face with this normal; of nodes without faces
  /// always.
  bool is_facing(const ContactStepContext& context, const SurfaceNode& node,
                 const Eigen::Vector3d& normal) const;
  /// Whether the node was in front of the face, or hardly behind it, or hardly deeper than behind the faces
  /// that it knows, one step ago. A node that turns up deep inside went in elsewhere; pushing it out here
  /// would make energy from nothing.
  ///   depth  of what it knows [length]
  bool comes_from_outside(const ContactStepContext& context, const SurfaceNode& node,
                          const NearFace& near_face, double depth) const;
  bool projects_inside(const ContactStepContext& context, FaceIndex face, const NearFace& near_face) const;
  static std::size_t share_at_edge(double thickness, NearFaces& near_faces);
  /// Puts a node that does not project inside a face over its plane, which counts as if it were the face.
  static void stand_on_plane(const MovingFace& face, const Eigen::Vector3d& x, double radius,
                             NearFace& near_face);
  /// Leaves the plane of a face out where the node projects inside another face of the same wall, or nearer
  /// to it.
  static void choose_planes(NearFaces& near_faces);
  void choose(const ContactStepContext& context, SurfaceNodeIndex row, const NodeHistory& node_history,
              NearFaces& near_faces) const;
  double share_of(const ContactStepContext& context, SurfaceNodeIndex row, const NearFace& near_face) const;
  ContactPoint make_contact_point(const ContactStepContext& context, SurfaceNodeIndex row,
                                  const NearFace& near_face) const;
  NodePenaltyInput make_push(const ContactStepContext& context, SurfaceNodeIndex row,
                             const NearFace& near_face, const ContactPoint& contact_point) const;

  const ContactMesh& contact_mesh_;
  const PairRules& rules_;
  NodeFaceLists candidates_;
  CloseCandidates<SurfaceNodeIndex, FaceIndex> close_;
  StartPartners<SurfaceNodeIndex> start_partners_;
  std::vector<ReleasedPartner<SurfaceNodeIndex>> released_;
  NodeFaceHistory history_;
  ReachBounds bounds_;    // of the step
  NodeAreas node_areas_;  // scratch
};

}  // namespace contactsim
