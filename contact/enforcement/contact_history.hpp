// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_remap.hpp"

namespace contactsim {

class StateArchive;

/// What momentum balance remembers of contact points from step to step.
class ContactHistory {
 public:
  struct Entry {
    double pressure = 0.0;                               ///< normal force over area
    Eigen::Vector3d traction = Eigen::Vector3d::Zero();  ///< tangential force over area
    Eigen::Vector3d held = Eigen::Vector3d::Zero();      ///< slip that friction holds [length]
    double left = 0.0;                                   ///< penetration that the passes have left [length]
    double area = 0.0;                                   ///< [length^2]
    /// At which it just touches, of what load steps before pressed; NaN before the first step [length]
    double zero_gap = 0.0;

    /// Without area nothing is.
    bool is_known() const { return area > 0.0; }
  };

  /// Where a contact point is. Kinds: faces, a node and a face, edges, a rigid plane.
  struct PointId {
    std::uint32_t kind = 0, first = 0, second = 0, part = 0;

    using Key = std::pair<std::uint64_t, std::uint64_t>;
    Key key() const { return {std::uint64_t{kind} << 32 | first, std::uint64_t{second} << 32 | part}; }
  };
  static PointId id_of(const ContactPoint& point);
  struct KnownPoint : PointId, Entry {};

  /// What is known of a contact point. A new one takes over the mean over area of what is known of its pair
  /// of entities, or else of its first entity. Quick where points are asked for in ascending order. Returns
  /// false when nothing is known.
  bool recall(const PointId& wanted, Entry& found);

  /// The normal force of all that is known between the two entities of a point [force].
  double force_between(const ContactPoint& point) const;

  /// Forgets all, and remembers the points that follow.
  void begin() { entries_.clear(); }
  void remember(const ContactPoint& point, const Entry& entry);
  /// Ends what begin() or begin_points() began.
  void end(int n_threads = 1);
  /// Forgets all. Returns what is known of so many points, which the caller fills in before end().
  std::span<KnownPoint> begin_points(std::size_t n_points);

  /// Goes over to other faces and nodes.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  template <class IsWanted>
  bool find_mean(const IsWanted& is_wanted, Entry& found) const;

  std::vector<KnownPoint> entries_;  // ascending by key
  std::size_t cursor_ = 0;           // first one that is not before what was asked for last
};

}  // namespace contactsim
