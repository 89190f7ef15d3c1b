// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/overlap/overlap_detection.hpp"
#include "contact/overlap/side_mover.hpp"

namespace contactsim {

/// GAP CLOSURE TOLERANCE of a pair, AUTO worked out: a share of mean_edge(), and at most its SEARCH DISTANCE,
/// beyond which nothing is looked at; 0 of a pair without one [length].
double find_closure_tolerance(const ContactKinematics& start, const SurfacePair& pair);

/// Moves nodes that stand in front of the other side onto it, along the normal of the nearest face over which
/// they stand: those that are no farther away than the pair's gap closure tolerance, and those of its node
/// set at any distance. Nodes of SIDE B go; without sides those of both, half the way each where both can.
/// Source: ADJUST of CalculiX's and Abaqus's *CONTACT PAIR, of OptiStruct's CONTACT and TIE.
class GapClosure {
 public:
  /// Takes notice of the nodes that are to go. All must outlive this.
  GapClosure(const ContactModel& model, const Mesh& mesh, const OverlapParts& parts,
             const OverlapSearch& search, const OverlapDetection& detection, const ShiftedPoints& points);

  /// Moves all of them once, half the way where the other side comes to meet them.
  ///   is_last  one by one, all of the way
  /// Returns whether anything was moved.
  bool pass(bool is_last, SideMover& mover) const;
  /// How wide the widest gap of a pair is that is to be closed, now [length].
  double widest(PairIndex pair) const;

 private:
  /// A node that is to go, and what it may go to.
  struct ClosingNode {
    PairIndex pair;
    double reach = 0.0;  ///< [length]
    std::vector<NodeFaceCandidate> faces;
    std::vector<NodePlaneCandidate> planes;
  };

  void add_near(PairIndex pair, const OverlapSites& sites, double tolerance);
  void add_set(PairIndex pair, const Mesh& mesh, std::uint32_t set);
  void add(ClosingNode node);
  bool may_go(const SurfacePair& pair, SurfaceNodeIndex row) const;
  std::optional<Overlap> find_gap(const ClosingNode& node) const;

  const ContactModel& model_;
  const OverlapParts& parts_;
  const OverlapDetection& detection_;
  const ShiftedPoints& points_;
  std::vector<ClosingNode> nodes_;  // by pair
};

}  // namespace contactsim
