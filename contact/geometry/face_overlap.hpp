// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "contact/geometry/face_map.hpp"
#include "core/base/lanes.hpp"

namespace contactsim {

/// A convex polygon of a common plane. Two quadrilaterals meet in eight corners at most, and two more lines
/// may each cut one off. Left without values: most of it is never used, and filling it would take as long as
/// the rest.
struct OverlapPolygon {
  static constexpr int max_corners = 10;

  int n;
  double u[max_corners + 2], v[max_corners + 2], gap[max_corners + 2];  // room for what round-off may add

  void add(double pu, double pv, double its_gap = 0.0) {
    u[n] = pu;
    v[n] = pv;
    gap[n] = its_gap;
    ++n;
  }
  bool has_area() const { return area() > 0.0; }
  double area() const;                     ///< of corners that stand anticlockwise [length^2]
  std::array<double, 2> centroid() const;  ///< u and v [length]
};

/// What two faces have in common, seen along the normal.
///   first, second  in the coordinates of the plane
OverlapPolygon intersect(const FaceCorners& first, bool is_triangle_1, const FaceCorners& second,
                         bool is_triangle_2);

/// Sets the gaps of a polygon that intersect() made: the height of the first face over the second, as they
/// are.
void set_gaps(const FaceMap& map_1, const FaceMap& map_2, OverlapPolygon& polygon);

/// The part of a polygon where gaps, linear from corner to corner, are within bounds [length]: the polygon
/// itself when that is all of it, else one in the scratch.
const OverlapPolygon& part_between(double least, double most, const OverlapPolygon& polygon,
                                   std::array<OverlapPolygon, 2>& scratch);

/// Eight points at which pressure is integrated over the overlap of two faces, and where they lie on both.
struct OverlapBatch {
  Lanes weight;                    ///< area that each point stands for, 0 of lanes not used [length^2]
  Lanes xi_1, eta_1, xi_2, eta_2;  ///< [1]
  Lanes gap;                       ///< height of the first face over the second [length]
};

/// All points of an overlap.
struct OverlapPoints {
  static constexpr std::size_t max_batches = 6;

  std::size_t n_batches = 0;
  double area = 0.0;  ///< of all points [length^2]
  std::array<OverlapBatch, max_batches> all;

  std::span<const OverlapBatch> batches() const { return {all.data(), n_batches}; }
  /// Makes each point stand for more area.
  void spread(double factor) {
    area *= factor;
    for (std::size_t k = 0; k < n_batches; ++k) all[k].weight *= factor;
  }
};

/// Sets the points of a quadrature over a polygon of at least three corners that is exact for quadratic
/// polynomials.
///   maps  of the faces in the coordinates of the plane
void place_points(const OverlapPolygon& polygon, const FaceMap& map_1, const FaceMap& map_2,
                  OverlapPoints& points);

/// The same, exact for polynomials of the fourth degree, such as products of two bilinear functions: where
/// lines of two meshes lie on each other, their crossings and with them the polygon's corners move by the
/// size of a face with the least motion, which what is integrated must not show. Source: Cowper, Int. J.
/// Numer. Methods Eng. 7 (1973) 405-408, six points in a triangle.
void place_points_for_products(const OverlapPolygon& polygon, const FaceMap& map_1, const FaceMap& map_2,
                               OverlapPoints& points);

}  // namespace contactsim
