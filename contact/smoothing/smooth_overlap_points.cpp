// SPDX-License-Identifier: BSD-3-Clause
#include "contact/smoothing/smooth_overlap_points.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/overlap_polygons.hpp"

namespace contactsim {

namespace {

/// So often a triangle of an overlap is cut in four at most: down to a sixteenth of its width.
constexpr int max_cuts = 4;

/// A gap that bends by less than this share of what it differs by counts as flat.
constexpr double flat = 0.02;

/// As one does that bends by less than this share of the triangle's width.
constexpr double negligible = 1e-6;

/// The middle of an edge that is this much beside it, over its length, is on it; an overlap of this share of
/// a face has no area.
constexpr double straight = 1e-6, no_area = 1e-12;

/// Surfaces that lean on the plane by more than this cosine have no more area.
constexpr double least_lean_cosine = 0.2;

double area_of(const SurfacePairPoint& a, const SurfacePairPoint& b, const SurfacePairPoint& c) {
  return 0.5 * ((b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u));
}

/// The normal between two surfaces, as that of a common plane.
Eigen::Vector3d normal_between(const Eigen::Vector3d& first, const Eigen::Vector3d& second,
                               double sharpness_1, double sharpness_2) {
  const auto shares = shares_of_normals(-first.dot(second), sharpness_1, sharpness_2);
  return (shares[1](0) * second - shares[0](0) * first).normalized();
}

/// By which a point is to the left of the way from one corner to another, times its length.
double left_of(const Eigen::Vector2d& from, const Eigen::Vector2d& to, const Eigen::Vector2d& point) {
  const Eigen::Vector2d along = to - from, away = point - from;
  return along.x() * away.y() - along.y() * away.x();
}

/// The part of a polygon that is inside a convex one. Source: Sutherland and Hodgman, Commun. ACM 17 (1974)
/// 32-42.
PlanePolygon intersect(PlanePolygon polygon, const PlanePolygon& window) {
  for (std::size_t i = 0; i < window.n && polygon.n > 2; ++i) {
    const Eigen::Vector2d &from = window.corners[i], &to = window.corners[window.next(i)];
    PlanePolygon kept;
    for (std::size_t k = 0; k < polygon.n; ++k) {
      const Eigen::Vector2d &a = polygon.corners[k], &b = polygon.corners[polygon.next(k)];
      const double side_a = left_of(from, to, a), side_b = left_of(from, to, b);
      if (side_a >= 0.0) kept.add(a);
      if ((side_a > 0.0 && side_b < 0.0) || (side_a < 0.0 && side_b > 0.0))
        kept.add(a + side_a / (side_a - side_b) * (b - a));
    }
    polygon = kept;
  }
  return polygon;
}

/// Coordinates of a face's corner.
std::array<double, 2> corner_of(std::size_t k, bool is_triangle) {
  static constexpr std::array<std::array<double, 2>, 3> triangle{{{0, 0}, {1, 0}, {0, 1}}};
  static constexpr std::array<std::array<double, 2>, 4> square{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
  return is_triangle ? triangle[k] : square[k];
}

}  // namespace

double PlanePolygon::area() const {
  double twice = 0.0;
  for (std::size_t i = 1; i + 1 < n; ++i) twice += left_of(corners[0], corners[i], corners[i + 1]);
  return 0.5 * twice;
}

Eigen::Vector2d PlanePolygon::centroid() const {
  double twice = 0.0;
  Eigen::Vector2d sum = Eigen::Vector2d::Zero();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double part = left_of(corners[0], corners[i], corners[i + 1]);
    twice += part;
    sum += part * (corners[i] - corners[0] + corners[i + 1] - corners[0]);
  }
  return corners[0] + sum / (3.0 * twice);
}

SmoothOverlap::SmoothOverlap(const SmoothSides& sides, double ahead)
    : first_(sides.first), second_(sides.second), offset_(sides.offset), ahead_(ahead) {
  auto pair = project_pair(first_.face(), second_.face(), ahead);
  if (!pair) return;
  plane_ = pair->plane;
  const double height = first_.height() + second_.height();
  min_gap_ = pair->min_gap - height - offset_;
  max_gap_ = pair->max_gap + height - offset_;
  const PlanePolygon polygon =
      intersect(outline(first_, pair->first, true), outline(second_, pair->second, false));
  const double size = (pair->first.col(2) - pair->first.col(0)).squaredNorm();
  if (polygon.n > 2 && polygon.area() > no_area * size) polygon_ = polygon;
}

/// The corners of a face, and the middles of those edges over which the surface bends out of its sides.
PlanePolygon SmoothOverlap::outline(const SmoothPatch& patch, const FaceCorners& projected,
                                    bool is_reversed) const {
  const std::size_t n = patch.is_triangle() ? 3 : 4;
  PlanePolygon outline;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t a = is_reversed ? n - 1 - i : i, b = is_reversed ? (a + n - 1) % n : (a + 1) % n;
    const Eigen::Vector2d from = projected.col(static_cast<Eigen::Index>(a)).head<2>(),
                          to = projected.col(static_cast<Eigen::Index>(b)).head<2>();
    outline.add(from);
    if (patch.height() == 0.0) continue;
    const auto p = corner_of(a, patch.is_triangle()), q = corner_of(b, patch.is_triangle());
    const Eigen::Vector3d away = patch.at(0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1])).x - plane_.origin;
    const Eigen::Vector2d middle(away.dot(plane_.across), away.dot(plane_.along));
    if (left_of(from, to, middle) < -straight * (to - from).squaredNorm()) outline.add(middle);
  }
  return outline;
}

/// Newton's method from where the coordinates are.
bool SmoothOverlap::locate(const SmoothPatch& patch, double u, double v, double& xi, double& eta) const {
  constexpr int max_iterations = 12;
  constexpr double accuracy = 1e-5;  // of the step, of which the error left is the square
  constexpr double far_away = 3.0;
  for (int i = 0; i < max_iterations; ++i) {
    const SmoothPatch::Point point = patch.at(xi, eta);
    const Eigen::Vector3d away = point.x - plane_.origin;
    const double du = u - away.dot(plane_.across), dv = v - away.dot(plane_.along);
    const double a = point.along_xi.dot(plane_.across), b = point.along_eta.dot(plane_.across),
                 c = point.along_xi.dot(plane_.along), d = point.along_eta.dot(plane_.along);
    const double det = a * d - b * c;
    if (det == 0.0) return false;
    const double d_xi = (d * du - b * dv) / det, d_eta = (a * dv - c * du) / det;
    xi = std::clamp(xi + d_xi, -far_away, far_away);
    eta = std::clamp(eta + d_eta, -far_away, far_away);
    if (std::abs(d_xi) + std::abs(d_eta) < accuracy) return true;
  }
  return true;
}

SurfacePairPoint SmoothOverlap::at(double u, double v, const SurfacePairPoint& near) const {
  SurfacePairPoint found = near;
  found.u = u;
  found.v = v;
  locate(first_, u, v, found.xi_1, found.eta_1);
  locate(second_, u, v, found.xi_2, found.eta_2);
  const SmoothPatch::Point a = first_.at(found.xi_1, found.eta_1), b = second_.at(found.xi_2, found.eta_2);
  found.normal = normal_between(a.normal(), b.normal(), first_.sharpness(), second_.sharpness());
  const double cosine = std::max(found.normal.dot(plane_.normal), least_lean_cosine);
  found.spread = 1.0 / cosine;
  found.gap = cosine * plane_.normal.dot(a.x - b.x) - offset_;
  found.coming_gap = found.gap;
  if (ahead_ > 0.0) {
    const Eigen::Vector3d apart =
        first_.velocity_at(found.xi_1, found.eta_1) - second_.velocity_at(found.xi_2, found.eta_2);
    found.coming_gap += ahead_ * cosine * plane_.normal.dot(apart);
  }
  found.middle = 0.5 * (a.x + b.x);
  return found;
}

SurfacePairPoint SmoothOverlap::between(const SurfacePairPoint& a, const SurfacePairPoint& b) const {
  SurfacePairPoint near = a;
  near.xi_1 = 0.5 * (a.xi_1 + b.xi_1);
  near.eta_1 = 0.5 * (a.eta_1 + b.eta_1);
  near.xi_2 = 0.5 * (a.xi_2 + b.xi_2);
  near.eta_2 = 0.5 * (a.eta_2 + b.eta_2);
  return at(0.5 * (a.u + b.u), 0.5 * (a.v + b.v), near);
}

void SmoothOverlap::visit_part(const GapBounds& bounds, const Visit& visit) const {
  if (!has_area()) return;
  const Eigen::Vector2d centroid = polygon_.centroid();
  SurfacePairPoint start;
  if (first_.is_triangle()) start.xi_1 = start.eta_1 = 1.0 / 3.0;
  if (second_.is_triangle()) start.xi_2 = start.eta_2 = 1.0 / 3.0;
  const SurfacePairPoint middle = at(centroid.x(), centroid.y(), start);
  std::array<SurfacePairPoint, PlanePolygon::max_corners> corners;
  for (std::size_t i = 0; i < polygon_.n; ++i)
    corners[i] = at(polygon_.corners[i].x(), polygon_.corners[i].y(), middle);
  for (std::size_t i = 0; i < polygon_.n; ++i)
    visit_triangle({middle, corners[i], corners[polygon_.next(i)]}, bounds, max_cuts, visit);
}

void SmoothOverlap::visit_triangle(const Triangle& corners, const GapBounds& bounds, int n_cuts,
                                   const Visit& visit) const {
  Triangle middles;  // opposite the corners
  double least = corners[0].coming_gap, most = least, bend = 0.0;
  for (std::size_t k = 0; k < 3; ++k) {
    const SurfacePairPoint &a = corners[(k + 1) % 3], &b = corners[(k + 2) % 3];
    middles[k] = between(a, b);
    bend = std::max(bend, std::abs(middles[k].coming_gap - 0.5 * (a.coming_gap + b.coming_gap)));
    for (const double gap : {middles[k].coming_gap, corners[k].coming_gap}) {
      least = std::min(least, gap);
      most = std::max(most, gap);
    }
  }
  // No gap between is beyond the least or the most by more than they bend.
  if (least - bend > bounds.most || most + bend < bounds.least) return;
  if (most + bend <= bounds.most && least - bend >= bounds.least) {
    const double third = area_of(corners[0], corners[1], corners[2]) / 3.0;
    for (const SurfacePairPoint& point : middles) visit(third * point.spread, point);
    return;
  }
  const double width = std::sqrt(area_of(corners[0], corners[1], corners[2]));
  if (n_cuts == 0 || bend <= flat * (most - least) || !(bend > negligible * width))
    return visit_flat(corners, bounds, visit);
  for (std::size_t k = 0; k < 3; ++k)
    visit_triangle({corners[k], middles[(k + 2) % 3], middles[(k + 1) % 3]}, bounds, n_cuts - 1, visit);
  visit_triangle(middles, bounds, n_cuts - 1, visit);
}

void SmoothOverlap::visit_flat(const Triangle& corners, const GapBounds& bounds, const Visit& visit) const {
  std::array<DoubleVectors, 3> whole;
  for (std::size_t k = 0; k < 3; ++k) whole[k] = {corners[k].u, corners[k].v, corners[k].coming_gap};
  const OverlapPolygon part = OverlapPolygons(whole).part_between(bounds.least, bounds.most).of(0);
  for (int i = 1; i + 1 < part.n; ++i) {
    const auto corner = [&](int k) {
      SurfacePairPoint point;
      point.u = part.u[k];
      point.v = part.v[k];
      return point;
    };
    const Triangle piece{corner(0), corner(i), corner(i + 1)};
    const double third = area_of(piece[0], piece[1], piece[2]) / 3.0;
    if (!(third > 0.0)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const SurfacePairPoint &a = piece[k], &b = piece[(k + 1) % 3];
      const SurfacePairPoint point = at(0.5 * (a.u + b.u), 0.5 * (a.v + b.v), corners[0]);
      visit(third * point.spread, point);
    }
  }
}

}  // namespace contactsim
