// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <functional>

#include "contact/geometry/projected_pair.hpp"
#include "contact/smoothing/smooth_overlap.hpp"

namespace contactsim {

/// A point of the plane between two faces, and what it sees on both of their surfaces.
struct SurfacePairPoint {
  double u = 0.0, v = 0.0;                                  ///< in the plane [length]
  double xi_1 = 0.0, eta_1 = 0.0, xi_2 = 0.0, eta_2 = 0.0;  ///< [1]
  double gap = 0.0;         ///< of the first surface over the second, along the normal [length]
  double coming_gap = 0.0;  ///< the same at the end of the time ahead [length]
  double spread = 1.0;      ///< area of the surfaces over that of the plane [1]
  Eigen::Vector3d normal;   ///< unit, from the second surface to the first [1]
  Eigen::Vector3d middle;   ///< of both surfaces [length]
};

/// Which part of an overlap is taken: that of gaps within bounds [length].
struct GapBounds {
  double least, most;
};

/// A convex polygon of the plane between two faces, anticlockwise about its normal.
struct PlanePolygon {
  static constexpr std::size_t max_corners = 20;

  std::size_t n = 0;
  std::array<Eigen::Vector2d, max_corners> corners;

  void add(const Eigen::Vector2d& corner) {
    if (n < max_corners) corners[n++] = corner;
  }
  std::size_t next(std::size_t i) const { return i + 1 < n ? i + 1 : 0; }
  double area() const;               ///< [length^2]
  Eigen::Vector2d centroid() const;  ///< [length]
};

/// The overlap of two surfaces. Gaps are curved, so that the part within bounds is found by cutting triangles
/// in four until each is inside, outside, or as good as flat.
class SmoothOverlap {
 public:
  ///   ahead  bounds are of the gaps after this time [time]
  SmoothOverlap(const SmoothSides& sides, double ahead);

  /// Whether the faces overlap, seen along the plane's normal.
  bool has_area() const { return polygon_.n > 2; }
  const CommonPlane& plane() const { return plane_; }
  /// Whether some gap may be within bounds.
  bool may_hold(const GapBounds& bounds) const { return min_gap_ <= bounds.most && max_gap_ >= bounds.least; }
  using Visit = std::function<void(double area, const SurfacePairPoint& point)>;
  /// Calls visit for points of integration over the part within bounds, with the area of the surfaces that
  /// each stands for [length^2].
  void visit_part(const GapBounds& bounds, const Visit& visit) const;

 private:
  using Triangle = std::array<SurfacePairPoint, 3>;

  PlanePolygon outline(const SmoothPatch& patch, const FaceCorners& projected, bool is_reversed) const;
  SurfacePairPoint at(double u, double v, const SurfacePairPoint& near) const;
  SurfacePairPoint between(const SurfacePairPoint& a, const SurfacePairPoint& b) const;
  bool locate(const SmoothPatch& patch, double u, double v, double& xi, double& eta) const;
  void visit_triangle(const Triangle& corners, const GapBounds& bounds, int n_cuts, const Visit& visit) const;
  void visit_flat(const Triangle& corners, const GapBounds& bounds, const Visit& visit) const;

  const SmoothPatch &first_, &second_;
  double offset_, ahead_;  // [length] [time]
  CommonPlane plane_;
  PlanePolygon polygon_;
  double min_gap_ = 0.0, max_gap_ = 0.0;  // bounds of the coming ones [length]
};

}  // namespace contactsim
