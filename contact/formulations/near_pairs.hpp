// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "contact/formulations/interface_constraint.hpp"
#include "contact/geometry/face_face.hpp"
#include "contact/geometry/node_face.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// What may be near each other.
struct NearCandidates {
  const FacePairLists& face_partners;
  const NodeFaceLists& node_faces;
  double size_share = 0.0;  ///< automatic tolerance over the square root of a face's area [1]
};

/// Whether a rule asks for something to hold its pairs.
using HoldsPair = std::function<bool(const PairRule&)>;

/// Two faces that may be, or a node and a face that are near enough to be held together.
struct NearPair {
  std::uint32_t first = 0;  ///< face, or surface node
  FaceIndex second;
  PairIndex pair;
  bool is_node = false;
  double tolerance = 0.0;  ///< of the gap either way [length]
  double share = 1.0;      ///< of nodes that are held as share_of_node() [1]
  bool is_facing = true;   ///< of a node: one of its own faces is turned towards the face

  FaceIndex first_face() const { return {first}; }
  SurfaceNodeIndex row() const { return {first}; }
};

/// A node that stands this share of a face's size beyond its edge counts as over it: bodies whose edges lie
/// over each other keep touching when they spread by different strains.
inline constexpr double automatic_beyond = 0.02;

/// How far from a face something is held to it at the start: by the pair's capture tolerance, else its normal
/// tolerance, else a share of the size that a square of the face's radius has [length].
double capture_tolerance_of(const SurfacePair& pair, const FaceBound& face, double size_share);

/// The candidates of active pairs that something holds, over a gap or an overlap: by the pair's capture
/// tolerance, else its normal tolerance, else a share of the face's size. Of a node the nearest face that it
/// projects inside; faces need not overlap within the tolerance yet. In the order of the candidates.
///   face_partners, node_faces  candidates of a search
///   size_share                 of the square root of a face's area [1]
std::vector<NearPair> find_near_pairs(const ContactStepContext& context, const FacePairLists& face_partners,
                                      const NodeFaceLists& node_faces, double size_share,
                                      const HoldsPair& holds);

/// Whether a rule has one model for what is close at the start and another for the rest: HYBRID MODEL.
inline bool is_hybrid(const PairRule& rule) { return rule.model.far != nullptr; }

/// What ties and bonds of two faces, or of a surface node and a face, have in common.
InterfaceConstraint constraint_of_faces(const ContactStepContext& context, FaceIndex first, FaceIndex second);
InterfaceConstraint constraint_of_node(const ContactStepContext& context, SurfaceNodeIndex row,
                                       FaceIndex face);

/// Where a surface node projects inside a face; nothing when it does not, or the gap is beyond the tolerance.
/// The gap of a sphere counts from its surface.
std::optional<ClosestPoint> find_closest_point(const ContactStepContext& context, SurfaceNodeIndex row,
                                               FaceIndex face, double tolerance);

/// Whether one of a node's own faces is turned towards a normal. Nodes without faces look all round.
bool is_facing(const ContactKinematics& kinematics, const SurfaceNode& node, const Eigen::Vector3d& normal);

/// What a surface node that is held counts for where it meets a face [1]. Pairs that go one way meet
/// everything once: 1. In those that go both ways nodes of the face count too, as far as they project inside
/// the node's surface: from 1, when no corner of the face does, down to 1/2, when all do, of what of the
/// node's area lies before the other surface.
///   node_faces  candidates of a search
///   near_pair   of the node; its tolerance holds for the corners' gaps as well
///   weights     of the face's corners at the node's closest point, sum 1 [1]
double share_of_node(const ContactStepContext& context, const NodeFaceLists& node_faces,
                     const NearPair& near_pair, const Eigen::Vector4d& weights);

/// The means over what of two faces lies over each other.
struct MeanOverlap {
  double area = 0.0;                                    ///< [length^2]
  Eigen::Vector4d weights_1 = Eigen::Vector4d::Zero();  ///< of the first face's corners, sum 1 [1]
  Eigen::Vector4d weights_2 = Eigen::Vector4d::Zero();  ///< of the second face's [1]
};

/// The middles of two faces' overlap where its gaps are within the tolerance either way; nothing where they
/// do not overlap.
std::optional<MeanOverlap> find_mean_overlap(const MovingFace& first, const MovingFace& second,
                                             double tolerance);

}  // namespace contactsim
