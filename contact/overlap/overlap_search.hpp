// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "contact/mesh/adjacent_faces.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/overlap_parts.hpp"
#include "contact/search/broad_phase.hpp"
#include "contact/search/contact_search.hpp"

namespace contactsim {

/// Two things that may lie in each other.
template <class Entity, class Partner>
struct OverlapCandidate {
  Entity entity;
  Partner partner;
};
using NodeFaceCandidate = OverlapCandidate<SurfaceNodeIndex, FaceIndex>;
using NodePlaneCandidate = OverlapCandidate<SurfaceNodeIndex, std::uint32_t>;  ///< with a plane of the region
using EdgePairCandidate = OverlapCandidate<EdgeIndex, EdgeIndex>;
using FacePairCandidate = OverlapCandidate<FaceIndex, FaceIndex>;

/// Where to look for nodes behind something.
struct OverlapSites {
  std::vector<NodeFaceCandidate> faces;    ///< ascending by node, then by face
  std::vector<NodePlaneCandidate> planes;  ///< of every node with every plane
};

/// Where a pair of surfaces has to be looked at.
struct PairSites {
  OverlapSites meshed;                   ///< neither side is lofted
  OverlapSites lofted;                   ///< one of them is: a point or a face of a brick, a sphere
  std::vector<EdgePairCandidate> edges;  ///< capsules and spheres with each other and with sharp edges
  std::vector<FacePairCandidate> rims;   ///< faces, one of them lofted, whose edges may cross

  bool has_lofts() const {
    return !lofted.faces.empty() || !lofted.planes.empty() || !edges.empty() || !rims.empty();
  }
};

/// Finds what is near to what in the pairs of a model. A node never meets a face of an element that it is
/// part of, and lofts never what the mesh joins to them within their thickness.
class OverlapSearch {
 public:
  /// All must outlive this.
  ///   definition  of the model
  ///   mesh        as the lofts are joined in it
  OverlapSearch(const ContactModel& model, const ContactDefinition& definition, const Mesh& mesh,
                const OverlapParts& parts);
  OverlapSearch(const OverlapSearch&) = delete;
  OverlapSearch& operator=(const OverlapSearch&) = delete;

  /// Has nodes found that are this far in front of a face, or behind it [length].
  void widen(double reach) { deepest_ = std::max(deepest_, reach); }
  /// Fills in all sites of the pairs.
  void find(const ContactKinematics& kinematics);
  /// Fills in those of lofts again where something has moved too far for the last time: thick bodies may push
  /// thin ones far.
  void renew_lofts(const ContactKinematics& kinematics);

  const IndexedVector<PairIndex, PairSites>& sites() const { return sites_; }
  const AdjacentFaces& joined() const { return adjacent_; }

 private:
  void add_planes();
  void add_faces(const ContactKinematics& kinematics, bool is_of_lofts_only);
  void add_edges(const ContactKinematics& kinematics);
  void add_rims(const ContactKinematics& kinematics);
  /// Whether a contact node has moved by more than the spare way since faces were searched.
  bool is_due(const ContactKinematics& kinematics) const;
  void note_positions(const ContactKinematics& kinematics);
  Box box_of_node(const ContactKinematics& kinematics, SurfaceNodeIndex row) const;
  Box box_of_face(const ContactKinematics& kinematics, FaceIndex face) const;
  bool may_meet(SurfaceNodeIndex row, FaceIndex face) const;
  bool may_cross(const ContactKinematics& kinematics, FaceIndex first, FaceIndex second) const;
  bool is_lofted(SurfaceNodeIndex row, FaceIndex face) const {
    return parts_.is_lofted(parts_.contact_mesh.surface_nodes[row]) ||
           parts_.contact_mesh.is_lofted(parts_.contact_mesh.faces[face]);
  }

  const ContactModel& model_;
  const Mesh& mesh_;
  const OverlapParts& parts_;
  PairRules rules_;
  AdjacentFaces adjacent_;
  bool has_lofts_ = false;
  double deepest_ = 0.0;          // that a pair allows [length]
  double spare_ = 0.0;            // way that each side may go between two searches of faces [length]
  Eigen::Matrix3Xd searched_at_;  // of the contact nodes, if there are lofts [length]
  BroadPhase nodes_, faces_;
  std::optional<ContactSearch> edges_;  // where there are edges
  IndexedVector<PairIndex, PairSites> sites_;
};

}  // namespace contactsim
