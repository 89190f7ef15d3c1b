// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>

#include "contact/geometry/edge_edge.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/overlap_search.hpp"
#include "contact/overlap/shifted_points.hpp"

namespace contactsim {

/// Which side goes out of the other.
enum class OverlapMover : std::uint8_t {
  first,  ///< alone: nodes of the other side, where there are any, go out on their own account
  ball,   ///< the first; where it is held the second gives way
  both    ///< each half the way; where one is held the other all of it
};

/// Whether neither side of an overlap is lofted, or one is.
enum class OverlapKind : std::uint8_t { meshed, lofted };

/// One side lies in the other here.
struct Overlap {
  ContactPointSide first, second;                    ///< the second has no weights where it is a plane
  double depth = 0.0;                                ///< <= 0 is in front [length]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< unit, the first side's way out [1]
  double distance = 0.0;  ///< of the node, or a sphere's middle, from a face [length]
  OverlapMover mover = OverlapMover::first;
};

/// Finds where two surfaces overlap, each as the nodes stand when its turn comes.
class OverlapDetection {
 public:
  using Visit = std::function<void(const Overlap&)>;

  /// All must outlive this.
  ///   tolerance  overlap of lofts that is left [length]
  OverlapDetection(const ContactModel& model, const OverlapParts& parts, const OverlapSearch& search,
                   const ShiftedPoints& points, double tolerance)
      : model_(model),
        parts_(parts),
        sites_(search.sites()),
        adjacent_(search.joined()),
        points_(points),
        tolerance_(tolerance) {}

  /// All of the below.
  void visit_all(PairIndex pair, const Visit& visit) const;
  /// Nodes behind faces, then behind planes, in their order.
  void visit_nodes(PairIndex pair, OverlapKind kind, const Visit& visit) const;
  /// The way of a node onto the nearest of some faces that it is in front of, as an overlap of negative
  /// depth; nothing when it is behind one, or no nearer than the reach.
  std::optional<Overlap> find_before_faces(const SurfacePair& pair,
                                           std::span<const NodeFaceCandidate> of_node, double reach) const;
  /// The same before a plane.
  std::optional<Overlap> find_before_plane(const NodePlaneCandidate& candidate, double reach) const;
  /// Capsules, spheres and sharp edges in each other, as they stood when the points were renewed.
  void visit_edges(PairIndex pair, const Visit& visit) const;
  /// Edges of faces that cross with none of their nodes in between, as they stood then.
  void visit_rims(PairIndex pair, const Visit& visit) const;

 private:
  /// The way out of several faces is the shortest one; in front of the nearest face a node is outside.
  std::optional<Overlap> find_behind_faces(const SurfacePair& pair,
                                           std::span<const NodeFaceCandidate> of_node) const;
  /// A face that a node is near to.
  struct NearOverlap {
    FaceIndex face;
    Overlap overlap;
  };
  /// The nearest; faces that the node is joined to are none.
  std::optional<Overlap> nearest_of(SurfaceNodeIndex row, std::span<const NearOverlap> near) const;
  ///   reach  off the face, either way; absent: as deep as counts as overlap [length]
  std::optional<Overlap> find_near_face(const SurfacePair& pair, const NodeFaceCandidate& candidate,
                                        std::optional<double> reach = {}) const;
  std::optional<Overlap> find_behind_plane(const SurfacePair& pair,
                                           const NodePlaneCandidate& candidate) const;
  std::optional<Overlap> find_between(const SurfacePair& pair, const EdgePairCandidate& candidate,
                                      const EdgePairPoint& pair_point) const;
  void visit_crossings(const FacePairCandidate& faces, double deepest, const Visit& visit) const;
  /// Whether the surface of a node faces a face, so that the node is about to pass through it: by its
  /// mean normal, or where one side is lofted by one of its faces.
  bool is_facing(SurfaceNodeIndex row, const Eigen::Vector3d& normal, bool is_lofted) const;

  const ContactModel& model_;
  const OverlapParts& parts_;
  const IndexedVector<PairIndex, PairSites>& sites_;
  const AdjacentFaces& adjacent_;
  const ShiftedPoints& points_;
  double tolerance_ = 0.0;
};

}  // namespace contactsim
