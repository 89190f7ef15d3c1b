// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "contact/geometry/face_overlap.hpp"
#include "contact/geometry/projected_pair.hpp"

namespace contactsim {

/// What the faces of eight pairs have in common, seen along their normals: a convex polygon in each lane.
/// Corners stand anticlockwise; those from a lane's number on mean nothing.
class OverlapPolygons {
 public:
  OverlapPolygons() = default;
  /// Clips the first faces by the second ones. Gaps are unknown then.
  ///   wanted  elsewhere there is no polygon
  OverlapPolygons(const ProjectedPairs& pairs, const LaneMask& wanted);
  /// Triangles: across, along, gap [length].
  explicit OverlapPolygons(const std::array<DoubleVectors, 3>& corners);

  /// [length^2]
  Lanes area() const;
  OverlapPolygon of(Eigen::Index lane) const;
  /// Finds the gaps of the corners: the height of the first face over the second, as they are.
  void set_gaps(const ProjectedPairs& pairs);
  /// The parts where gaps, linear from corner to corner, are within bounds [length]. Precondition: gaps are
  /// set.
  OverlapPolygons part_between(const Lanes& least, const Lanes& most) const;
  /// Takes others over where something holds.
  void set_where(const LaneMask& holds, const OverlapPolygons& others);
  /// Calls visit(u, v, area) for points of a quadrature that is exact for quadratic polynomials, each with
  /// the area that it stands for. A polygon is split into triangles around its centroid, which does not jump
  /// when a corner is cut off; each gives a third of its area to the middles of its edges. Points stand
  /// corner by corner: on the spoke, on the rim. Those beyond a lane's last have no area.
  template <class Visit>
  void visit_points(const Visit& visit) const;

 private:
  static constexpr int max_corners = OverlapPolygon::max_corners;

  LaneMask has_corner(int i) const { return Lanes(i) < n_; }
  const DoubleVectors& corner(int i) const { return corners_[static_cast<std::size_t>(i)]; }
  DoubleVectors& corner(int i) { return corners_[static_cast<std::size_t>(i)]; }
  DoubleVectors corner_after(int i) const {
    return i + 1 < most_ ? select(has_corner(i + 1), corner(i + 1), corner(0)) : corner(0);
  }
  DoubleVectors centroid() const;
  template <bool has_gaps, class SideOf>
  bool cut(const SideOf& side_of, OverlapPolygons& kept) const;
  template <bool has_gaps>
  void add(const LaneMask& where, const DoubleVectors& corner);

  Lanes n_ = 0.0;                                   // corners of each
  int most_ = 0;                                    // corners of any
  std::array<DoubleVectors, max_corners> corners_;  // across, along, gap [length]
};

template <class Visit>
void OverlapPolygons::visit_points(const Visit& visit) const {
  const DoubleVectors middle = centroid();
  std::array<Lanes, max_corners> thirds;
  Lanes before = 0.0;
  for (int i = 0; i < most_; ++i) {
    const DoubleVectors a = corner(i) - middle, b = corner_after(i) - middle;
    const Lanes third = (a.x * b.y - a.y * b.x) / 6.0;
    thirds[static_cast<std::size_t>(i)] = third;
    before = has_corner(i).select(third, before);
  }
  for (int i = 0; i < most_; ++i) {
    const LaneMask exists = has_corner(i);
    const DoubleVectors at = select(exists, corner(i), middle),
                        next = select(exists, corner_after(i), middle);
    const Lanes third = exists.select(thirds[static_cast<std::size_t>(i)], 0.0);
    visit(0.5 * (middle.x + at.x), 0.5 * (middle.y + at.y), exists.select(before + third, 0.0));
    visit(0.5 * (at.x + next.x), 0.5 * (at.y + next.y), third);
    before = third;
  }
}

/// All that two faces have in common, in the first lane.
struct WholeOverlap {
  ProjectedPairs pair;
  OverlapPolygons polygon;
};

/// Nothing when they do not face each other or do not overlap.
std::optional<WholeOverlap> find_whole_overlap(const MovingFace& first, const MovingFace& second);

}  // namespace contactsim
