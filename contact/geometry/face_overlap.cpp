// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_overlap.hpp"

#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// Points of the plane, and the area that each stands for; beyond the last one stand points of no area.
struct PlanePoints {
  int n_batches;
  std::array<Lanes, OverlapPoints::max_batches> u, v, weight;
};

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

Lanes cross(const DoubleVectors& a, const DoubleVectors& b) { return a.x * b.y - a.y * b.x; }

/// A face that folds over itself, seen along the normal, has places without coordinates: its middle stands
/// for them.
Lanes within_face(const Lanes& coordinate) {
  constexpr double beyond = 2.0;
  return (coordinate.abs() <= beyond).select(coordinate, 0.0);
}

/// Finds where points of planes lie on faces. With d the way from c0 to the point, d - c2 eta is parallel to
/// c1 + c3 eta: a quadratic equation for eta, of which the root is taken that stays when the face is
/// straightened.
void locate(const MapsOfFaces& c, const Lanes& u, const Lanes& v, Lanes& xi, Lanes& eta) {
  const Lanes du = u - c[0].x, dv = v - c[0].y;
  const Lanes area = cross(c[1], c[2]), a = -cross(c[2], c[3]);
  const Lanes b = area + du * c[3].y - dv * c[3].x;
  const Lanes e = du * c[1].y - dv * c[1].x;
  const Lanes root = (b * b - (4.0 * a) * e).max(0.0).sqrt();
  eta = within_face(-2.0 * e / (b + (area < 0.0).select(-root, root)));
  const Lanes pu = c[1].x + c[3].x * eta, pv = c[1].y + c[3].y * eta;
  xi = within_face(((du - c[2].x * eta) * pu + (dv - c[2].y * eta) * pv) / (pu * pu + pv * pv));
}

/// Height over the plane at points of faces.
Lanes height_at(const MapsOfFaces& c, const Lanes& xi, const Lanes& eta) {
  return c[0].z + c[1].z * xi + (c[2].z + c[3].z * xi) * eta;
}

}  // namespace

OverlapBatch locate_on_both(const MapsOfFaces& maps_1, const MapsOfFaces& maps_2, const Lanes& u,
                            const Lanes& v) {
  OverlapBatch batch;
  locate(maps_1, u, v, batch.xi_1, batch.eta_1);
  locate(maps_2, u, v, batch.xi_2, batch.eta_2);
  batch.gap = height_at(maps_1, batch.xi_1, batch.eta_1) - height_at(maps_2, batch.xi_2, batch.eta_2);
  return batch;
}

void OverlapPoints::add(const OverlapBatch& point, double weight) {
  const auto lane = static_cast<Eigen::Index>(n_points++ % n_lanes);
  if (lane == 0) all[n_batches++] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  OverlapBatch& batch = all[n_batches - 1];
  batch.weight(lane) = weight;
  batch.xi_1(lane) = point.xi_1(0);
  batch.eta_1(lane) = point.eta_1(0);
  batch.xi_2(lane) = point.xi_2(0);
  batch.eta_2(lane) = point.eta_2(0);
  batch.gap(lane) = point.gap(0);
  area += weight;
}

void place_points_for_products(const OverlapPolygon& polygon, const FaceMap& map_1, const FaceMap& map_2,
                               OverlapPoints& points) {
  const PlanePoints placed = spread_in_triangles(polygon);
  points.n_batches = static_cast<std::size_t>(placed.n_batches);
  points.area = 0.0;
  const MapsOfFaces maps_1 = all_lanes(map_1), maps_2 = all_lanes(map_2);
  for (std::size_t k = 0; k < points.n_batches; ++k) {
    OverlapBatch& batch = points.all[k];
    batch = locate_on_both(maps_1, maps_2, placed.u[k], placed.v[k]);
    batch.weight = placed.weight[k];
    points.area += batch.weight.sum();
  }
}

}  // namespace contactsim
