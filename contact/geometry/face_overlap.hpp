// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <span>

#include "contact/geometry/face_map.hpp"
#include "core/base/lanes.hpp"

namespace contactsim {

/// A convex polygon of a common plane, corners anticlockwise. Two quadrilaterals meet in eight corners at
/// most, and two more lines may each cut one off. Left without values: most of it is never used, and filling
/// it would take as long as the rest.
struct OverlapPolygon {
  static constexpr int max_corners = 10;

  int n;
  double u[max_corners], v[max_corners];  // [length]
};

/// Eight points at which pressure is integrated over the overlap of two faces, and where they lie on both.
struct OverlapBatch {
  Lanes weight;                    ///< area that each point stands for, 0 of lanes not used [length^2]
  Lanes xi_1, eta_1, xi_2, eta_2;  ///< [1]
  Lanes gap;                       ///< height of the first face over the second [length]
};

/// Finds where points of common planes lie on both faces, and the gaps there; weights are left.
///   maps  of the faces in the coordinates of the planes
OverlapBatch locate_on_both(const MapsOfFaces& maps_1, const MapsOfFaces& maps_2, const Lanes& u,
                            const Lanes& v);

/// Adds f at eight points to sums over a face.
inline void add_moments(const Lanes& f, const Lanes& xi, const Lanes& eta, FaceMoments& moments) {
  const Lanes f_xi = f * xi;
  moments[0] += f.sum();
  moments[1] += f_xi.sum();
  moments[2] += (f * eta).sum();
  moments[3] += (f_xi * eta).sum();
}

/// The same sums of eight faces, and the addition of f at a point of each.
using MomentsOfFaces = std::array<Lanes, 4>;
inline void add_moments(const Lanes& f, const Lanes& xi, const Lanes& eta, MomentsOfFaces& moments) {
  const Lanes f_xi = f * xi;
  moments[0] += f;
  moments[1] += f_xi;
  moments[2] += f * eta;
  moments[3] += f_xi * eta;
}
inline FaceMoments moments_in(const MomentsOfFaces& moments, Eigen::Index lane) {
  return {moments[0](lane), moments[1](lane), moments[2](lane), moments[3](lane)};
}

/// All points of an overlap.
struct OverlapPoints {
  static constexpr std::size_t max_batches = 6;

  std::size_t n_points = 0, n_batches = 0;  // points where they are added one by one
  double area = 0.0;                        ///< of all points [length^2]
  std::array<OverlapBatch, max_batches> all;

  std::span<const OverlapBatch> batches() const { return {all.data(), n_batches}; }
  /// Appends the point in the first lane of a batch, one at a time.
  ///   weight  area that it stands for [length^2]
  void add(const OverlapBatch& point, double weight);
  /// Makes each point stand for more area.
  void spread(double factor) {
    area *= factor;
    for (std::size_t k = 0; k < n_batches; ++k) all[k].weight *= factor;
  }
};

/// Sets the points of a quadrature over a polygon of at least three corners that is exact for polynomials of
/// the fourth degree, such as products of two bilinear functions: where lines of two meshes lie on each
/// other, their crossings and with them the polygon's corners move by the size of a face with the least
/// motion, which what is integrated must not show. Source: Cowper, Int. J. Numer. Methods Eng. 7 (1973)
/// 405-408, six points in a triangle.
///   maps  of the faces in the coordinates of the plane
void place_points_for_products(const OverlapPolygon& polygon, const FaceMap& map_1, const FaceMap& map_2,
                               OverlapPoints& points);

}  // namespace contactsim
