// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// Corners of a face anticlockwise about the plane's normal.
void set_corners(const FaceCorners& face, bool is_triangle, bool is_reversed, OverlapPolygon& polygon) {
  const int n = is_triangle ? 3 : 4;
  polygon.n = 0;
  for (int i = 0; i < n; ++i) {
    const int k = is_reversed ? n - 1 - i : i;
    polygon.add(face(0, k), face(1, k));
  }
}

/// The part of a polygon where a function, linear from corner to corner, is not negative: the polygon itself
/// when that is all of it, else `kept`. What is outside by a negligible share counts as inside: lines that
/// coincide but for round-off would cross anywhere.
///   side_of  a corner's number
/// Source: Sutherland and Hodgman, Commun. ACM 17 (1974) 32-42.
template <class Side>
const OverlapPolygon& cut(const OverlapPolygon& polygon, const Side& side_of, OverlapPolygon& kept) {
  constexpr double negligible = 1e-9;
  double side[OverlapPolygon::max_corners + 2];
  double least = 0.0, most = 0.0;
  for (int i = 0; i < polygon.n; ++i) {
    side[i] = side_of(i);
    least = std::min(least, side[i]);
    most = std::max(most, side[i]);
  }
  const double outside = -negligible * most;
  if (least >= outside) return polygon;
  for (int i = 0; i < polygon.n; ++i) side[i] = side[i] < outside ? side[i] : std::max(side[i], 0.0);
  // Corners and crossings are written wherever they may be one, and left standing where they are: which are
  // cannot be foretold, and a branch that is foretold wrongly costs more.
  kept.n = 0;
  const auto write = [&](double u, double v, double gap) {
    kept.u[kept.n] = u;
    kept.v[kept.n] = v;
    kept.gap[kept.n] = gap;
  };
  for (int i = 0; i < polygon.n; ++i) {
    const int next = i + 1 < polygon.n ? i + 1 : 0;
    const bool is_inside = side[i] >= 0.0, is_crossing = is_inside != (side[next] >= 0.0);
    write(polygon.u[i], polygon.v[i], polygon.gap[i]);
    kept.n += is_inside ? 1 : 0;
    const double t = side[i] / (side[i] - side[next]);
    write(polygon.u[i] + t * (polygon.u[next] - polygon.u[i]),
          polygon.v[i] + t * (polygon.v[next] - polygon.v[i]),
          polygon.gap[i] + t * (polygon.gap[next] - polygon.gap[i]));
    kept.n += is_crossing ? 1 : 0;
    if (kept.n >= OverlapPolygon::max_corners) break;
  }
  kept.n = std::min(kept.n, OverlapPolygon::max_corners);
  return kept;
}

/// Points of the plane, and the area that each stands for; beyond the last one stand points of no area.
struct PlanePoints {
  int n_batches;
  std::array<Lanes, OverlapPoints::max_batches> u, v, weight;
};

/// Splits the polygon into triangles around its centroid, which does not jump when a corner is cut off; each
/// gives a third of its area to the middles of its edges, which is exact for quadratic polynomials. Points
/// stand corner by corner: on the spoke, on the rim.
PlanePoints spread_points(const OverlapPolygon& polygon) {
  const auto [mu, mv] = polygon.centroid();
  PlanePoints placed;
  placed.n_batches = (2 * polygon.n + n_lanes - 1) / n_lanes;
  double *u = placed.u[0].data(), *v = placed.v[0].data(), *weight = placed.weight[0].data();
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
  }
  weight[0] += last;
  for (int i = 2 * polygon.n; i < placed.n_batches * n_lanes; ++i) {
    u[i] = mu;
    v[i] = mv;
    weight[i] = 0.0;
  }
  return placed;
}

/// Splits the polygon into triangles around its first corner, with six points in each.
PlanePoints spread_in_triangles(const OverlapPolygon& polygon) {
  struct Orbit {
    double at_corner, weight;  // barycentric coordinate of one corner, and share of the area
  };
  static constexpr std::array<Orbit, 2> orbits{
      {{0.108103018168070, 0.223381589678011}, {0.816847572980459, 0.109951743655322}}};
  PlanePoints placed;
  const int n_points = 6 * (polygon.n - 2);
  placed.n_batches = (n_points + n_lanes - 1) / n_lanes;
  double *u = placed.u[0].data(), *v = placed.v[0].data(), *weight = placed.weight[0].data();
  int n = 0;
  for (int i = 1; i + 1 < polygon.n; ++i) {
    const std::array<int, 3> corners{0, i, i + 1};
    const double u1 = polygon.u[i] - polygon.u[0], v1 = polygon.v[i] - polygon.v[0];
    const double u2 = polygon.u[i + 1] - polygon.u[0], v2 = polygon.v[i + 1] - polygon.v[0];
    const double area = 0.5 * (u1 * v2 - v1 * u2);
    for (const Orbit& orbit : orbits) {
      const double others = 0.5 * (1.0 - orbit.at_corner);
      for (const int corner : corners) {
        u[n] = v[n] = 0.0;
        for (const int other : corners) {
          const double share = other == corner ? orbit.at_corner : others;
          u[n] += share * polygon.u[other];
          v[n] += share * polygon.v[other];
        }
        weight[n++] = orbit.weight * area;
      }
    }
  }
  for (; n < placed.n_batches * n_lanes; ++n) {
    u[n] = polygon.u[0];
    v[n] = polygon.v[0];
    weight[n] = 0.0;
  }
  return placed;
}

double cross(const Eigen::Vector3d& a, const Eigen::Vector3d& b) { return a[0] * b[1] - a[1] * b[0]; }

/// A face that folds over itself, seen along the normal, has places without coordinates: its middle stands
/// for them.
Lanes within_face(const Lanes& coordinate) {
  constexpr double beyond = 2.0;
  return (coordinate.abs() <= beyond).select(coordinate, 0.0);
}

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
  eta = within_face(-2.0 * e / (b + (area < 0.0 ? Lanes(-root) : root)));
  const Lanes pu = c[1][0] + c[3][0] * eta, pv = c[1][1] + c[3][1] * eta;
  xi = within_face(((du - c[2][0] * eta) * pu + (dv - c[2][1] * eta) * pv) / (pu * pu + pv * pv));
}

/// Finds where points of the plane lie on both faces, and how high the first is over the second there.
void locate_on_both(const FaceMap& map_1, const FaceMap& map_2, const Lanes& u, const Lanes& v,
                    OverlapBatch& batch) {
  locate(map_1, u, v, batch.xi_1, batch.eta_1);
  locate(map_2, u, v, batch.xi_2, batch.eta_2);
  batch.gap = evaluate(component(map_1, 2), batch.xi_1, batch.eta_1) -
              evaluate(component(map_2, 2), batch.xi_2, batch.eta_2);
}

}  // namespace

OverlapPolygon intersect(const FaceCorners& first, bool is_triangle_1, const FaceCorners& second,
                         bool is_triangle_2) {
  OverlapPolygon window, polygon, other;
  set_corners(second, is_triangle_2, false, window);
  set_corners(first, is_triangle_1, true, polygon);
  OverlapPolygon *now = &polygon, *next = &other;
  for (int i = 0; i < window.n && now->n > 2; ++i) {
    const int k = i + 1 < window.n ? i + 1 : 0;
    const double du = window.u[k] - window.u[i], dv = window.v[k] - window.v[i];
    const auto inwards = [&](int corner) {
      return du * (now->v[corner] - window.v[i]) - dv * (now->u[corner] - window.u[i]);
    };
    if (&cut(*now, inwards, *next) == next) std::swap(now, next);
  }
  return *now;
}

void set_gaps(const FaceMap& map_1, const FaceMap& map_2, OverlapPolygon& polygon) {
  static_assert(n_lanes >= 8, "intersect() makes up to eight corners");
  Lanes u = Lanes::Constant(polygon.u[0]), v = Lanes::Constant(polygon.v[0]);
  const int n = std::min(polygon.n, n_lanes);
  for (int i = 0; i < n; ++i) u(i) = polygon.u[i], v(i) = polygon.v[i];
  OverlapBatch corners;
  locate_on_both(map_1, map_2, u, v, corners);
  for (int i = 0; i < n; ++i) polygon.gap[i] = corners.gap(i);
}

const OverlapPolygon& part_between(double least, double most, const OverlapPolygon& polygon,
                                   std::array<OverlapPolygon, 2>& scratch) {
  const auto below_most = [&](int corner) { return most - polygon.gap[corner]; };
  const OverlapPolygon& low = cut(polygon, below_most, scratch[0]);
  const auto above_least = [&](int corner) { return low.gap[corner] - least; };
  return cut(low, above_least, scratch[1]);
}

double OverlapPolygon::area() const {
  double twice = 0.0;
  for (int i = 1; i + 1 < n; ++i) {
    twice += (u[i] - u[0]) * (v[i + 1] - v[0]) - (v[i] - v[0]) * (u[i + 1] - u[0]);
  }
  return 0.5 * twice;
}

std::array<double, 2> OverlapPolygon::centroid() const {
  double area = 0.0, to_u = 0.0, to_v = 0.0;
  for (int i = 1; i + 1 < n; ++i) {
    const double u1 = u[i] - u[0], v1 = v[i] - v[0], u2 = u[i + 1] - u[0], v2 = v[i + 1] - v[0];
    const double part = u1 * v2 - v1 * u2;
    area += part;
    to_u += part * (u1 + u2);
    to_v += part * (v1 + v2);
  }
  if (!(area > 0.0)) return {u[0], v[0]};
  return {u[0] + to_u / (3.0 * area), v[0] + to_v / (3.0 * area)};
}

namespace {

void locate_points(const PlanePoints& placed, const FaceMap& map_1, const FaceMap& map_2,
                   OverlapPoints& points) {
  points.n_batches = static_cast<std::size_t>(placed.n_batches);
  points.area = 0.0;
  for (std::size_t k = 0; k < points.n_batches; ++k) {
    OverlapBatch& batch = points.all[k];
    batch.weight = placed.weight[k];
    locate_on_both(map_1, map_2, placed.u[k], placed.v[k], batch);
    points.area += batch.weight.sum();
  }
}

}  // namespace

void place_points(const OverlapPolygon& polygon, const FaceMap& map_1, const FaceMap& map_2,
                  OverlapPoints& points) {
  locate_points(spread_points(polygon), map_1, map_2, points);
}

void place_points_for_products(const OverlapPolygon& polygon, const FaceMap& map_1, const FaceMap& map_2,
                               OverlapPoints& points) {
  locate_points(spread_in_triangles(polygon), map_1, map_2, points);
}

}  // namespace contactsim
