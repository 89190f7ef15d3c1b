// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/start_overlaps.hpp"

namespace contactsim {

class StateArchive;

/// Where the bodies of a pair lie in each other, or have gone through each other, whatever contact knows of.
struct Interpenetration {
  double start_depth = 0.0;  ///< of the deepest node at the start [length]
  double depth = 0.0;        ///< of the deepest node since, beyond that of the start [length]
  double share = 0.0;        ///< the same over the thickness of the thinner side there [1]
  double time = std::numeric_limits<double>::quiet_NaN();  ///< of that [time]
  std::uint32_t node = 0;                                  ///< of the mesh, that lies so deep
  std::uint64_t n_nodes = 0;                               ///< that lay in the other side at that time
  std::uint64_t n_crossed = 0;     ///< times that a node has gone through the mid surface of a shell
  std::uint32_t crossed_node = 0;  ///< of the mesh, the first of them
  double crossed_time = std::numeric_limits<double>::quiet_NaN();  ///< by when it had [time]
};

/// Contact and bodies at one moment.
struct ContactMoment {
  const ContactKinematics& kinematics;
  const PairRules& rules;
  const Eigen::Matrix3Xd& coordinates;  ///< [3 x n_nodes] of the mesh [length]
  std::span<const std::uint8_t> alive;  ///< [n_elements] 0 of dead elements; empty: all live
  double time = 0.0;                    ///< [time]
};

/// Looks from time to time whether bodies that should touch lie in each other: by point in element, and by
/// the ways of nodes through shells, independent of what contact's own search holds. It changes nothing.
class InterpenetrationWatch {
 public:
  /// Model and mesh must outlive this.
  ///   overlaps  of the start
  InterpenetrationWatch(const ContactModel& model, const Mesh& mesh, std::span<const StartOverlap> overlaps);

  /// To be called after every step: whether some node may have gone by a quarter of the least thickness
  /// since the last look, as seen from the mean of all. Of the coordinates it reads those of contact nodes.
  ///   n_steps  that pass at least between two looks
  bool is_look_due(const ContactMoment& moment, int n_steps);
  /// Reads the coordinates of all nodes where there are several bodies, which could lie in each other.
  void look(const ContactMoment& moment);
  bool has_several_bodies() const { return has_several_bodies_; }
  /// Contact nodes have other numbers from now on: ways begin anew.
  void renumber() { before_.clear(); }

  IndexedSpan<PairIndex, const Interpenetration> all() const { return of_pair_; }
  void archive(StateArchive& saved);

 private:
  void find_deep(const ContactMoment& moment);
  bool has_moved_far(const ContactMoment& moment) const;

  const ContactModel& model_;
  const Mesh& mesh_;
  bool has_several_bodies_ = false;
  IndexedVector<PairIndex, Interpenetration> of_pair_;
  IndexedVector<ContactNodeIndex, Eigen::Vector3d>
      before_;       // [n_contact_nodes] mesh nodes of contact nodes, at the last look
  int n_since_ = 0;  // steps since then
};

}  // namespace contactsim
