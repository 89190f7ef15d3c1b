// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/contact_formulation.hpp"

namespace contactsim {

/// The nodes that meet analytic planes. A plane is rigid, does not move and has no end: whatever is behind it
/// is pushed out along its normal. Source: Sierra/SM 5.22, analytic objects.
/// A PointFormulation.
class NodePlaneContacts {
 public:
  explicit NodePlaneContacts(const FormulationSetup& setup) : setup_(setup) { add_pairs(); }

  /// A node and a plane are always candidates.
  void find_candidates(ContactSearch& /*search*/, const ContactKinematics& /*kinematics*/,
                       const Motion& /*motion*/) {}
  std::size_t n_rows() const { return node_plane_pairs_.size(); }
  std::size_t n_candidates() const { return node_plane_pairs_.size(); }
  void watch(IndexedVector<FaceIndex, std::uint8_t>& /*is_watched*/) const {}

  void begin_step() {}
  void undo_begin_step() {}
  void detect(const ContactStepContext& context, CandidateRows rows, std::vector<ContactPoint>& points) const;
  void update(const ContactStepContext& context, CandidateRows rows, std::span<const ContactPoint> points);
  /// None: a plane has no far side.
  void find_lost(const PairRules& /*rules*/, std::vector<LostContact>& /*lost*/) const {}
  /// Appends the gaps before the first step of nodes of pairs that have to know them.
  void add_start_gaps(const ContactStepContext& context, FoundStartGaps& gaps) const;

  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  /// A node and a plane.
  struct NodePlanePair {
    SurfaceNodeIndex row;
    PairIndex pair;
    std::uint32_t plane;  ///< of the region
    Eigen::Vector3d normal, origin;
    Eigen::Vector3d elastic_slip;  ///< slip that the tangential spring holds [length]
    bool touched = false;          ///< in the last step
  };
  void add_pairs();
  void add_pairs(SurfaceIndex surface, PairIndex pair, std::uint32_t plane);
  double gap_of(const ContactKinematics& kinematics, const NodePlanePair& candidate) const;
  void detect_one(const ContactStepContext& context, const NodePlanePair& candidate, const PairRule& rule,
                  std::vector<ContactPoint>& points) const;

  FormulationSetup setup_;
  std::vector<NodePlanePair> node_plane_pairs_;
};

}  // namespace contactsim
