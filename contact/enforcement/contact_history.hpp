// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "contact/geometry/contact_point.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "core/base/threads.hpp"

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
  };

  /// What is known of a contact point. A new one takes over the mean over area of what is known of its pair
  /// of entities, or else of its first entity. Quick where points are asked for in ascending order. Returns
  /// false when nothing is known.
  bool recall(const ContactPoint& point, Entry& found);

  /// The normal force of all that is known between the two entities of a point [force].
  double force_between(const ContactPoint& point) const;

  /// Forgets all, and remembers the points that follow.
  void begin() { entries_.clear(); }
  void remember(const ContactPoint& point, const Entry& entry);
  void end(int n_threads = 1);
  /// Forgets all, and remembers the points of some rows, on several threads.
  ///   entries   of each row, none of those that are forgotten
  ///   point_of  point_of(row) is the contact point of a row
  template <class PointOf>
  void remember_rows(std::span<const std::optional<Entry>> entries, int n_threads, const PointOf& point_of);

  /// Goes over to other faces and nodes.
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  /// Where a contact point is. Kinds: faces, a node and a face, edges, a rigid plane.
  struct PointId {
    std::uint32_t kind = 0, first = 0, second = 0, part = 0;

    using Key = std::pair<std::uint64_t, std::uint64_t>;
    Key key() const { return {std::uint64_t{kind} << 32 | first, std::uint64_t{second} << 32 | part}; }
  };
  struct KnownPoint : PointId, Entry {};

  static PointId id_of(const ContactPoint& point);
  template <class IsWanted>
  bool find_mean(const IsWanted& is_wanted, Entry& found) const;

  std::vector<KnownPoint> entries_;  // ascending by key
  std::size_t cursor_ = 0;           // first one that is not before what was asked for last
};

template <class PointOf>
void ContactHistory::remember_rows(std::span<const std::optional<Entry>> entries, int n_threads,
                                   const PointOf& point_of) {
  constexpr std::size_t rows_a_part = 512;
  std::vector<std::size_t> places((entries.size() + rows_a_part - 1) / rows_a_part);
  const auto of_chunk = [&](std::size_t chunk) {
    const std::size_t begin = chunk * rows_a_part;
    return entries.subspan(begin, std::min(rows_a_part, entries.size() - begin));
  };
  parallel_for(places.size(), n_threads, [&](std::size_t chunk) {
    const auto rows = of_chunk(chunk);
    places[chunk] = static_cast<std::size_t>(
        std::ranges::count_if(rows, [](const std::optional<Entry>& entry) { return entry.has_value(); }));
  });
  std::size_t n_kept = 0;
  for (std::size_t& place : places) n_kept += std::exchange(place, n_kept);
  entries_.resize(n_kept);
  parallel_for(places.size(), n_threads, [&](std::size_t chunk) {
    const auto rows = of_chunk(chunk);
    std::size_t place = places[chunk];
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (rows[i]) entries_[place++] = {id_of(point_of(chunk * rows_a_part + i)), *rows[i]};
    }
  });
  end(n_threads);
}

}  // namespace contactsim
