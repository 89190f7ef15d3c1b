// SPDX-License-Identifier: BSD-3-Clause
#include "contact/face_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// A convex polygon of the plane. Two quadrilaterals meet in eight corners at most.
struct Polygon {
  static constexpr int max_corners = 8;

  std::array<double, max_corners + 2> u{}, v{};
  int n = 0;

  void add(double pu, double pv) {
    if (n >= max_corners) return;  // round-off alone makes more
    u[static_cast<std::size_t>(n)] = pu;
    v[static_cast<std::size_t>(n)] = pv;
    ++n;
  }
};

/// Corners of a face anticlockwise about the plane's normal.
Polygon make_polygon(const FaceCorners& face, bool is_triangle, bool is_reversed) {
  Polygon polygon;
  const int n = is_triangle ? 3 : 4;
  for (int i = 0; i < n; ++i) {
    const int k = is_reversed ? n - 1 - i : i;
    polygon.add(face(0, k), face(1, k));
  }
  return polygon;
}

/// Keeps what lies to the left of the line from a to b. Source: Sutherland and Hodgman, Commun. ACM 17
/// (1974).
void cut(Polygon& polygon, double au, double av, double bu, double bv) {
  const double du = bu - au, dv = bv - av;
  std::array<double, Polygon::max_corners + 2> side;
  bool is_all_in = true;
  for (int i = 0; i < polygon.n; ++i) {
    const auto k = static_cast<std::size_t>(i);
    side[k] = du * (polygon.v[k] - av) - dv * (polygon.u[k] - au);
    is_all_in &= side[k] >= 0.0;
  }
  if (is_all_in) return;
  Polygon kept;
  for (int i = 0; i < polygon.n; ++i) {
    const auto k = static_cast<std::size_t>(i),
               next = static_cast<std::size_t>(i + 1 < polygon.n ? i + 1 : 0);
    if (side[k] >= 0.0) kept.add(polygon.u[k], polygon.v[k]);
    if ((side[k] >= 0.0) == (side[next] >= 0.0)) continue;
    const double t = side[k] / (side[k] - side[next]);
    kept.add(polygon.u[k] + t * (polygon.u[next] - polygon.u[k]),
             polygon.v[k] + t * (polygon.v[next] - polygon.v[k]));
  }
  polygon = kept;
}

Polygon intersect(Polygon polygon, const Polygon& window) {
  for (int i = 0; i < window.n && polygon.n > 2; ++i) {
    const auto k = static_cast<std::size_t>(i), next = static_cast<std::size_t>(i + 1 < window.n ? i + 1 : 0);
    cut(polygon, window.u[k], window.v[k], window.u[next], window.v[next]);
  }
  return polygon;
}

/// Points of the plane with weights.
struct PlanePoints {
  std::array<Lanes, OverlapPoints::max_batches> u, v;
};

/// Splits the polygon into triangles around its mean corner; each gives a third of its area to the middles of
/// its edges, which is exact for quadratic polynomials.
PlanePoints place_points(const Polygon& polygon, OverlapPoints& points) {
  PlanePoints placed;
  double mu = 0.0, mv = 0.0;
  for (int i = 0; i < polygon.n; ++i) {
    mu += polygon.u[static_cast<std::size_t>(i)];
    mv += polygon.v[static_cast<std::size_t>(i)];
  }
  mu /= polygon.n;
  mv /= polygon.n;
  points.n_batches = (2 * polygon.n + n_lanes - 1) / n_lanes;
  for (int b = 0; b < points.n_batches; ++b) {
    const auto k = static_cast<std::size_t>(b);
    placed.u[k].setConstant(mu);
    placed.v[k].setConstant(mv);
    points.weight[k].setZero();
  }
  const auto lane_of = [](int i) { return std::pair(static_cast<std::size_t>(i / n_lanes), i % n_lanes); };
  for (int i = 0; i < polygon.n; ++i) {
    const int j = i + 1 < polygon.n ? i + 1 : 0;
    const auto k = static_cast<std::size_t>(i), next = static_cast<std::size_t>(j);
    const double third =
        ((polygon.u[k] - mu) * (polygon.v[next] - mv) - (polygon.v[k] - mv) * (polygon.u[next] - mu)) / 6.0;
    const auto [spoke_batch, spoke] = lane_of(2 * i);
    const auto [rim_batch, rim] = lane_of(2 * i + 1);
    const auto [next_batch, next_spoke] = lane_of(2 * j);
    placed.u[spoke_batch](spoke) = 0.5 * (mu + polygon.u[k]);
    placed.v[spoke_batch](spoke) = 0.5 * (mv + polygon.v[k]);
    placed.u[rim_batch](rim) = 0.5 * (polygon.u[k] + polygon.u[next]);
    placed.v[rim_batch](rim) = 0.5 * (polygon.v[k] + polygon.v[next]);
    points.weight[spoke_batch](spoke) += third;
    points.weight[rim_batch](rim) += third;
    points.weight[next_batch](next_spoke) += third;
    points.area += 3.0 * third;
  }
  return placed;
}

double cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a[0] * b[1] - a[1] * b[0]; }

/// Finds where points of the plane lie on a face. With d the way from c0 to the point, d - c2 eta is parallel
/// to c1 + c3 eta: a quadratic equation for eta, of which the root is taken that stays when the face is
/// straightened.
void locate(const FaceMap& map, const Lanes& u, const Lanes& v, Lanes& xi, Lanes& eta) {
  const auto& c = map.c;
  const Lanes du = u - c[0][0], dv = v - c[0][1];
  const double area = cross(c[1], c[2]), a = -cross(c[2], c[3]);
  const Lanes b = area + du * c[3][1] - dv * c[3][0];
  const Lanes e = du * c[1][1] - dv * c[1][0];
  const Lanes root = (b * b - (4.0 * a) * e).max(0.0).sqrt();
  eta = -2.0 * e / (b + (area < 0.0 ? Lanes(-root) : root));
  const Lanes pu = c[1][0] + c[3][0] * eta, pv = c[1][1] + c[3][1] * eta;
  xi = ((du - c[2][0] * eta) * pu + (dv - c[2][1] * eta) * pv) / (pu * pu + pv * pv);
}

}  // namespace

std::optional<CommonPlane> make_common_plane(const FaceCorners& first, const Eigen::Vector3d& normal_1,
                                             const Eigen::Vector3d& normal_2) {
  // Faces round a convex corner of 110 degrees or less stand beside each other, not opposite.
  constexpr double most_aside = -0.3;
  if (!(normal_1.dot(normal_2) < most_aside)) return std::nullopt;
  CommonPlane plane;
  plane.normal = (normal_2 - normal_1).normalized();
  plane.origin = first.col(0);
  // In the plane any direction will do; one that turns with the faces makes results turn with them.
  const Eigen::Vector3d diagonal = first.col(2) - first.col(0);
  plane.across = (diagonal - plane.normal.dot(diagonal) * plane.normal).normalized();
  plane.along = plane.normal.cross(plane.across);
  return plane;
}

FaceCorners project(const FaceCorners& face, const CommonPlane& plane) {
  const FaceCorners moved = face.colwise() - plane.origin;
  FaceCorners projected;
  projected.row(0) = plane.across.transpose() * moved;
  projected.row(1) = plane.along.transpose() * moved;
  projected.row(2) = plane.normal.transpose() * moved;
  return projected;
}

OverlapPoints find_overlap(const FaceCorners& first, const FaceMap& map_1, const FaceCorners& second,
                           const FaceMap& map_2) {
  OverlapPoints points;
  const Polygon polygon =
      intersect(make_polygon(first, map_1.is_triangle, true), make_polygon(second, map_2.is_triangle, false));
  if (polygon.n < 3) return points;
  const PlanePoints placed = place_points(polygon, points);
  for (int b = 0; b < points.n_batches; ++b) {
    const auto k = static_cast<std::size_t>(b);
    locate(map_1, placed.u[k], placed.v[k], points.xi_1[k], points.eta_1[k]);
    locate(map_2, placed.u[k], placed.v[k], points.xi_2[k], points.eta_2[k]);
  }
  return points;
}

}  // namespace contactsim
