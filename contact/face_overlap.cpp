// SPDX-License-Identifier: BSD-3-Clause
#include "contact/face_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// A convex polygon of the plane. Two quadrilaterals meet in eight corners at most. Left without values: most
/// of it is never used, and filling it would take as long as the rest.
struct Polygon {
  static constexpr int max_corners = 8;

  int n;
  double u[max_corners + 2], v[max_corners + 2];  // room for what round-off may add

  void add(double pu, double pv) {
    u[n] = pu;
    v[n] = pv;
    ++n;
  }
};

/// Corners of a face anticlockwise about the plane's normal.
void set_corners(const FaceCorners& face, bool is_triangle, bool is_reversed, Polygon& polygon) {
  const int n = is_triangle ? 3 : 4;
  polygon.n = 0;
  for (int i = 0; i < n; ++i) {
    const int k = is_reversed ? n - 1 - i : i;
    polygon.add(face(0, k), face(1, k));
  }
}

/// A line through a point; what lies to its left is kept.
struct CutLine {
  double u, v, du, dv;
};

/// Puts what is left of a polygon into `kept`; returns false, and leaves `kept` alone, when that is all of
/// it. Source: Sutherland and Hodgman, Commun. ACM 17 (1974) 32-42.
bool cut(const Polygon& polygon, const CutLine& line, Polygon& kept) {
  double side[Polygon::max_corners + 2];
  double least = 0.0;
  for (int i = 0; i < polygon.n; ++i) {
    side[i] = line.du * (polygon.v[i] - line.v) - line.dv * (polygon.u[i] - line.u);
    least = std::min(least, side[i]);
  }
  if (least >= 0.0) return false;
  kept.n = 0;
  for (int i = 0; i < polygon.n; ++i) {
    const int next = i + 1 < polygon.n ? i + 1 : 0;
    if (side[i] >= 0.0) kept.add(polygon.u[i], polygon.v[i]);
    if ((side[i] >= 0.0) == (side[next] >= 0.0)) continue;
    const double t = side[i] / (side[i] - side[next]);
    kept.add(polygon.u[i] + t * (polygon.u[next] - polygon.u[i]),
             polygon.v[i] + t * (polygon.v[next] - polygon.v[i]));
    if (kept.n >= Polygon::max_corners) break;
  }
  kept.n = std::min(kept.n, Polygon::max_corners);
  return true;
}

/// Cuts a polygon by all edges of another; the result is in one of two places.
const Polygon& intersect(const Polygon& window, Polygon& polygon, Polygon& other) {
  Polygon *now = &polygon, *next = &other;
  for (int i = 0; i < window.n && now->n > 2; ++i) {
    const int k = i + 1 < window.n ? i + 1 : 0;
    const CutLine line{window.u[i], window.v[i], window.u[k] - window.u[i], window.v[k] - window.v[i]};
    if (cut(*now, line, *next)) std::swap(now, next);
  }
  return *now;
}

/// Points of the plane.
struct PlanePoints {
  std::array<Lanes, OverlapPoints::max_batches> u, v;
};

/// Splits the polygon into triangles around its mean corner; each gives a third of its area to the middles of
/// its edges, which is exact for quadratic polynomials. Points stand corner by corner: on the spoke, on the
/// rim.
void place_points(const Polygon& polygon, PlanePoints& placed, OverlapPoints& points) {
  double mu = 0.0, mv = 0.0;
  for (int i = 0; i < polygon.n; ++i) {
    mu += polygon.u[i];
    mv += polygon.v[i];
  }
  mu /= polygon.n;
  mv /= polygon.n;
  points.n_batches = (2 * polygon.n + n_lanes - 1) / n_lanes;
  double *u = placed.u[0].data(), *v = placed.v[0].data(), *weight = points.weight[0].data();
  double last = 0.0;
  for (int i = 0; i < polygon.n; ++i) {
    const int next = i + 1 < polygon.n ? i + 1 : 0;
    const double third =
        ((polygon.u[i] - mu) * (polygon.v[next] - mv) - (polygon.v[i] - mv) * (polygon.u[next] - mu)) / 6.0;
    u[2 * i] = 0.5 * (mu + polygon.u[i]);
    v[2 * i] = 0.5 * (mv + polygon.v[i]);
    u[2 * i + 1] = 0.5 * (polygon.u[i] + polygon.u[next]);
    v[2 * i + 1] = 0.5 * (polygon.v[i] + polygon.v[next]);
    weight[2 * i] = last + third;
    weight[2 * i + 1] = third;
    last = third;
    points.area += 3.0 * third;
  }
  weight[0] += last;
  for (int i = 2 * polygon.n; i < points.n_batches * n_lanes; ++i) {
    u[i] = mu;
    v[i] = mv;
    weight[i] = 0.0;
  }
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

std::optional<CommonPlane> make_common_plane(const FaceCorners& first, const Eigen::Vector3d& area_1,
                                             const Eigen::Vector3d& area_2) {
  const double size_1 = area_1.norm(), size_2 = area_2.norm();
  if (!(area_1.dot(area_2) < most_aside * size_1 * size_2)) return std::nullopt;
  CommonPlane plane;
  plane.normal = (size_1 * area_2 - size_2 * area_1).normalized();
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
  Polygon window, polygon, other;
  set_corners(second, map_2.is_triangle, false, window);
  set_corners(first, map_1.is_triangle, true, polygon);
  const Polygon& common = intersect(window, polygon, other);
  if (common.n < 3) return points;
  PlanePoints placed;
  place_points(common, placed, points);
  for (int b = 0; b < points.n_batches; ++b) {
    const auto k = static_cast<std::size_t>(b);
    locate(map_1, placed.u[k], placed.v[k], points.xi_1[k], points.eta_1[k]);
    locate(map_2, placed.u[k], placed.v[k], points.xi_2[k], points.eta_2[k]);
  }
  return points;
}

}  // namespace contactsim
