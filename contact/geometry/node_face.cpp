// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/node_face.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace contactsim {

namespace {

/// Tangents of a face at one of its points.
struct Tangents {
  Eigen::Vector3d xi, eta;
};

Tangents tangents_at(const FaceMap& map, double xi, double eta) {
  return {map.c[1] + eta * map.c[3], map.c[2] + xi * map.c[3]};
}

/// The coordinates at which the vector to the point stands upright on the face.
bool find_closest_point(const FaceMap& map, const Eigen::Vector3d& point, double& xi, double& eta) {
  constexpr int max_iterations = 20;
  constexpr double accuracy =
      1e-8;  // of the coordinates, which are of order one: the next step would be its square
  constexpr double far_away = 10.0;  // such points project inside other faces
  for (int i = 0; i < max_iterations; ++i) {
    const auto [a, b] = tangents_at(map, xi, eta);
    const Eigen::Vector3d away = point - map.at(xi, eta);
    const double aa = a.squaredNorm(), bb = b.squaredNorm(), ab = a.dot(b) - away.dot(map.c[3]);
    const double ra = away.dot(a), rb = away.dot(b), det = aa * bb - ab * ab;
    if (!(det > 0.0)) return false;
    const double d_xi = (ra * bb - rb * ab) / det, d_eta = (rb * aa - ra * ab) / det;
    xi += d_xi;
    eta += d_eta;
    if (!(std::abs(xi) < far_away && std::abs(eta) < far_away)) return false;
    if (std::abs(d_xi) + std::abs(d_eta) < accuracy) return true;
  }
  return true;
}

/// An edge that a point is beyond by so much, if it is.
OptionalIndex<std::uint32_t> edge_beyond(std::ptrdiff_t edge, double beyond) {
  if (!(beyond > 0.0)) return std::nullopt;
  return static_cast<std::uint32_t>(edge);
}

}  // namespace

OptionalIndex<std::uint32_t> move_inside(bool is_triangle, double& xi, double& eta) {
  const double x = xi, y = eta;
  if (is_triangle) {
    const std::array<double, 3> beyond{-y, x + y - 1.0, -x};
    const auto most = std::max_element(beyond.begin(), beyond.end());
    xi = std::max(xi, 0.0);
    eta = std::max(eta, 0.0);
    if (const double sum = xi + eta; sum > 1.0) {
      // Along the normal of the third edge in these coordinates, then onto its ends.
      xi = std::clamp(xi - 0.5 * (sum - 1.0), 0.0, 1.0);
      eta = 1.0 - xi;
    }
    return edge_beyond(most - beyond.begin(), *most);
  }
  const std::array<double, 4> beyond{-1.0 - y, x - 1.0, y - 1.0, -1.0 - x};
  const auto most = std::max_element(beyond.begin(), beyond.end());
  xi = std::clamp(xi, -1.0, 1.0);
  eta = std::clamp(eta, -1.0, 1.0);
  return edge_beyond(most - beyond.begin(), *most);
}

std::optional<ClosestPoint> project_onto_face(const FaceCorners& x, bool is_triangle,
                                              const Eigen::Vector3d& point) {
  const FaceMap map = make_face_map(x, is_triangle);
  ClosestPoint found;
  if (!find_closest_point(map, point, found.xi, found.eta)) return std::nullopt;
  const Eigen::Vector3d closest = map.at(found.xi, found.eta);
  const auto [a, b] = tangents_at(map, found.xi, found.eta);
  found.normal = a.cross(b).normalized();
  found.gap = (point - closest).dot(found.normal);
  double xi = found.xi, eta = found.eta;
  found.edge = move_inside(is_triangle, xi, eta);
  if (found.edge) found.beyond = (closest - map.at(xi, eta)).norm();
  return found;
}

std::optional<ClosestPoint> project_sphere(const FaceCorners& x, bool is_triangle,
                                           const Eigen::Vector3d& centre, double radius) {
  auto flat = project_onto_face(x, is_triangle, centre);
  if (!flat || radius == 0.0) return flat;
  ClosestPoint found = *flat;
  found.gap -= radius;
  if (!flat->edge) return found;
  if (flat->gap < 0.0) return std::nullopt;
  static constexpr std::array<std::array<double, 2>, 3> triangle{{{0, 0}, {1, 0}, {0, 1}}};
  static constexpr std::array<std::array<double, 2>, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  const std::span<const std::array<double, 2>> corners =
      is_triangle ? std::span<const std::array<double, 2>>(triangle) : square;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::size_t next = (k + 1) % corners.size();
    const Eigen::Vector3d from = x.col(static_cast<Eigen::Index>(k));
    const Eigen::Vector3d edge = x.col(static_cast<Eigen::Index>(next)) - from;
    const double share = std::clamp(edge.dot(centre - from) / edge.squaredNorm(), 0.0, 1.0);
    const Eigen::Vector3d away = centre - from - share * edge;
    const double distance = away.norm();
    if (!(distance < least) || distance == 0.0) continue;
    least = distance;
    found.xi = corners[k][0] + share * (corners[next][0] - corners[k][0]);
    found.eta = corners[k][1] + share * (corners[next][1] - corners[k][1]);
    found.normal = away / distance;
    found.gap = distance - radius;
  }
  found.beyond = 0.0;
  found.edge = std::nullopt;
  return found;
}

}  // namespace contactsim
