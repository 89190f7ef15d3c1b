// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cstddef>

#include "contact/geometry/lane_vector.hpp"
#include "core/base/lanes.hpp"
#include "core/mesh/face_geometry.hpp"

namespace contactsim {

/// Positions or velocities of a face's corners [3 x 4]; a triangle repeats its last.
using FaceCorners = Eigen::Matrix<double, 3, 4>;

/// Sums over points of a face of f, f xi, f eta and f xi eta: what the corners' shares of f depend on.
using FaceMoments = std::array<double, 4>;

/// A face as a function of two coordinates: x(xi, eta) = c0 + c1 xi + c2 eta + c3 xi eta. A quadrilateral is
/// bilinear on -1 <= xi, eta <= 1, corners counted from (-1, -1) in the direction of xi first; a triangle is
/// linear on 0 <= xi, eta and xi + eta <= 1, corners at (0, 0), (1, 0), (0, 1).
struct FaceMap {
  std::array<Eigen::Vector3d, 4> c;
  bool is_triangle = false;

  Eigen::Vector3d at(double xi, double eta) const {
    return c[0] + xi * c[1] + eta * c[2] + (xi * eta) * c[3];
  }
  /// At (0, 0) of a quadrilateral, at the centroid of a triangle.
  Eigen::Vector3d centre() const { return is_triangle ? Eigen::Vector3d(c[0] + (c[1] + c[2]) / 3.0) : c[0]; }
};

/// The coefficients of the map of a quadrilateral, and of that of a triangle, from the values of the corners.
///   Value  a vector, or one of its components, of one face or in lanes
template <class Value>
std::array<Value, 4> quadrilateral_map(const Value& x0, const Value& x1, const Value& x2, const Value& x3) {
  const Value a = x0 + x2, b = x1 + x3, p = x2 - x0, q = x1 - x3;
  return {0.25 * (a + b), 0.25 * (p + q), 0.25 * (p - q), 0.25 * (a - b)};
}
template <class Value>
std::array<Value, 4> triangle_map(const Value& x0, const Value& x1, const Value& x2, const Value& zero) {
  return {x0, x1 - x0, x2 - x0, zero};
}

/// The map that takes the values of the corners.
inline FaceMap make_face_map(const FaceCorners& x, bool is_triangle) {
  using Vector = Eigen::Vector3d;
  if (is_triangle) return {triangle_map<Vector>(x.col(0), x.col(1), x.col(2), Vector::Zero()), true};
  return {quadrilateral_map<Vector>(x.col(0), x.col(1), x.col(2), x.col(3)), false};
}

/// What faces have at their corners, as functions on them; see FaceMap.
///   Value  a vector or a number, of one face or of eight
///   Mask   of as many
template <class Value, class Mask>
std::array<Value, 4> make_functions(const std::array<Value, 4>& f, const Mask& is_triangle) {
  std::array<Value, 4> c = quadrilateral_map(f[0], f[1], f[2], f[3]);
  if (!any(is_triangle)) return c;
  const std::array<Value, 4> of_triangles = triangle_map(f[0], f[1], f[2], Value{});
  for (std::size_t k = 0; k < 4; ++k) c[k] = select(is_triangle, of_triangles[k], c[k]);
  return c;
}

/// The corners of eight faces, and their maps.
using CornersOfFaces = std::array<DoubleVectors, 4>;
using MapsOfFaces = std::array<DoubleVectors, 4>;

/// The same map in all lanes.
inline MapsOfFaces all_lanes(const FaceMap& map) {
  return {DoubleVectors::all(map.c[0]), DoubleVectors::all(map.c[1]), DoubleVectors::all(map.c[2]),
          DoubleVectors::all(map.c[3])};
}

/// The map in one lane.
inline FaceMap map_in(const MapsOfFaces& maps, bool is_triangle, Eigen::Index lane) {
  return {{vector_in(maps[0], lane), vector_in(maps[1], lane), vector_in(maps[2], lane),
           vector_in(maps[3], lane)},
          is_triangle};
}

/// A number on a face as a function of its coordinates: c0 + c1 xi + c2 eta + c3 xi eta.
using FaceFunction = std::array<double, 4>;

/// One component of a face's map.
inline FaceFunction component(const FaceMap& map, int i) {
  return {map.c[0][i], map.c[1][i], map.c[2][i], map.c[3][i]};
}

/// Numbers at the corners of eight faces, and functions on them.
using CornerNumbers = std::array<Lanes, 4>;
using FunctionsOfFaces = std::array<Lanes, 4>;

/// The values of functions at points of faces.
///   Function  FaceFunction or FunctionsOfFaces
template <class Function>
Lanes evaluate(const Function& c, const Lanes& xi, const Lanes& eta) {
  return c[0] + c[1] * xi + (c[2] + c[3] * xi) * eta;
}

/// The share of each corner: the sum of f times its shape function.
inline Eigen::Vector4d corner_shares(const FaceMoments& m, bool is_triangle) {
  if (is_triangle) return {m[0] - m[1] - m[2], m[1], m[2], 0.0};
  return 0.25 * Eigen::Vector4d(m[0] - m[1] - m[2] + m[3], m[0] + m[1] - m[2] - m[3],
                                m[0] + m[1] + m[2] + m[3], m[0] - m[1] + m[2] - m[3]);
}

/// The values of the shape functions at a point.
inline Eigen::Vector4d corner_weights(double xi, double eta, bool is_triangle) {
  return corner_shares({1.0, xi, eta, xi * eta}, is_triangle);
}

}  // namespace contactsim
