// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_distance.hpp"

#include <algorithm>
#include <limits>
#include <span>

#include "contact/geometry/edge_edge.hpp"

namespace contactsim {

namespace {

using Triangle = Eigen::Matrix3d;  // corners as columns

/// The triangles of a face, of a quadrilateral on both sides of a diagonal.
struct Triangles {
  std::array<Triangle, 2> both;
  std::size_t n;

  explicit Triangles(const FaceCorners& x) : n(x.col(2) == x.col(3) ? 1 : 2) {
    both[0] << x.col(0), x.col(1), x.col(2);
    both[1] << x.col(0), x.col(2), x.col(3);
  }
  std::span<const Triangle> all() const { return {both.data(), n}; }
};

double distance_of_segments(const Segment& a, const Segment& b) {
  const EdgePairPoint nearest = nearest_points(a, b);
  return (a.col(0) + nearest.s * (a.col(1) - a.col(0)) - b.col(0) - nearest.t * (b.col(1) - b.col(0))).norm();
}

Segment edge_of(const Triangle& x, Eigen::Index k) {
  Segment edge;
  edge << x.col(k), x.col((k + 1) % 3);
  return edge;
}

/// Whether a point of the triangle's plane is within all its edges.
bool is_inside(const Triangle& x, const Eigen::Vector3d& normal, const Eigen::Vector3d& point) {
  for (Eigen::Index k = 0; k < 3; ++k) {
    const Segment edge = edge_of(x, k);
    if ((edge.col(1) - edge.col(0)).cross(point - edge.col(0)).dot(normal) < 0.0) return false;
  }
  return true;
}

Eigen::Vector3d normal_of(const Triangle& x) {
  return (x.col(1) - x.col(0)).cross(x.col(2) - x.col(0)).normalized();
}

double distance_to_triangle(const Eigen::Vector3d& point, const Triangle& x) {
  const Eigen::Vector3d normal = normal_of(x);
  const double height = normal.dot(point - x.col(0));
  if (is_inside(x, normal, point - height * normal)) return std::abs(height);
  Segment at;
  at << point, point;
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < 3; ++k) least = std::min(least, distance_of_segments(at, edge_of(x, k)));
  return least;
}

/// Whether an edge goes through a triangle.
bool pierces(const Segment& edge, const Triangle& x) {
  const Eigen::Vector3d normal = normal_of(x);
  const double from = normal.dot(edge.col(0) - x.col(0)), to = normal.dot(edge.col(1) - x.col(0));
  if (!(from * to < 0.0)) return false;
  return is_inside(x, normal, edge.col(0) + from / (from - to) * (edge.col(1) - edge.col(0)));
}

double triangle_distance(const Triangle& a, const Triangle& b) {
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index k = 0; k < 3; ++k) {
    if (pierces(edge_of(a, k), b) || pierces(edge_of(b, k), a)) return 0.0;
    least = std::min({least, distance_to_triangle(a.col(k), b), distance_to_triangle(b.col(k), a)});
    for (Eigen::Index j = 0; j < 3; ++j)
      least = std::min(least, distance_of_segments(edge_of(a, k), edge_of(b, j)));
  }
  return least;
}

}  // namespace

double distance_to_face(const Eigen::Vector3d& point, const FaceCorners& x) {
  double least = std::numeric_limits<double>::infinity();
  const Triangles triangles(x);
  for (const Triangle& triangle : triangles.all())
    least = std::min(least, distance_to_triangle(point, triangle));
  return least;
}

double face_distance(const FaceCorners& first, const FaceCorners& second) {
  double least = std::numeric_limits<double>::infinity();
  const Triangles triangles_1(first), triangles_2(second);
  for (const Triangle& a : triangles_1.all()) {
    for (const Triangle& b : triangles_2.all()) least = std::min(least, triangle_distance(a, b));
  }
  return least;
}

}  // namespace contactsim
