// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_face_constraints.hpp"

#include <algorithm>
#include <cmath>

#include "contact/geometry/facets.hpp"
#include "contact/geometry/projected_pair.hpp"

namespace contactsim {

namespace {

/// Part of an overlap from which on it has a point for each corner of the smaller face, and below which it
/// has none, over that face's area.
constexpr double large = 0.5, negligible_share = 1e-6;

/// Numbers of the points of one overlap: corners of the first face, of the second, all of it.
constexpr std::uint8_t first_corners = 0, second_corners = 4, whole_overlap = 8, n_parts = 9;

/// The shape functions of a face's corners.
std::span<const FaceFunction> shape_functions(bool is_triangle) {
  static constexpr std::array<FaceFunction, 3> triangle{{{1, -1, -1, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  static constexpr std::array<FaceFunction, 4> quadrilateral{{{0.25, -0.25, -0.25, 0.25},
                                                              {0.25, 0.25, -0.25, -0.25},
                                                              {0.25, 0.25, 0.25, 0.25},
                                                              {0.25, -0.25, 0.25, -0.25}}};
  if (is_triangle) return triangle;
  return quadrilateral;
}

/// The part of an overlap that a corner has, by its shape function on one of the faces; all of it without
/// one.
OverlapShare share_of(const ProjectedPair& pair, const OverlapPoints& points, const FaceFunction* shape,
                      bool is_of_first) {
  FaceMoments on_first{}, on_second{};
  for (const OverlapBatch& batch : points.batches()) {
    Lanes f = batch.weight;
    if (shape != nullptr)
      f *=
          is_of_first ? evaluate(*shape, batch.xi_1, batch.eta_1) : evaluate(*shape, batch.xi_2, batch.eta_2);
    add_moments(f, batch.xi_1, batch.eta_1, on_first);
    add_moments(f, batch.xi_2, batch.eta_2, on_second);
  }
  return {on_first[0],
          pair.plane.normal,
          corner_shares(on_first, pair.map_1.is_triangle) / on_first[0],
          corner_shares(on_second, pair.map_2.is_triangle) / on_first[0],
          whole_overlap,
          0.0};
}

/// The points of two faces whose heights over the plane are, or count as, linear between their corners.
void add_points(const MovingFace& first, const MovingFace& second, const ConstraintActivation& activation,
                ProjectedPair& pair, FaceFaceConstraints& found) {
  make_maps(first, second, pair);
  OverlapPolygon whole = overlap_of(pair);
  if (!whole.has_area()) return;
  const double area_1 = std::abs(area_vector(first.x).dot(pair.plane.normal)),
               area_2 = std::abs(area_vector(second.x).dot(pair.plane.normal));
  const double smaller = std::min(area_1, area_2);
  std::array<OverlapPolygon, 2> scratch;
  const OverlapPolygon* part = &whole;
  if (!is_whole_near(pair, activation)) {
    set_gaps(pair.map_1, pair.map_2, whole);
    part = &part_between(-activation.depth, activation.margin, whole, scratch);
    if (!(part->area() > 0.0) && activation.near > activation.margin)
      part = &part_between(-activation.depth, activation.near, whole, scratch);
  }
  const double area = part->area();
  if (!(area > negligible_share * smaller)) return;
  OverlapPoints points;
  place_points(*part, pair.map_1, pair.map_2, points);
  points.spread(pair.plane.spread);
  if (area < large * smaller) return found.add(share_of(pair, points, nullptr, true));
  const bool is_of_first = area_1 <= area_2;
  const auto shapes = shape_functions(is_of_first ? first.is_triangle : second.is_triangle);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    OverlapShare share = share_of(pair, points, &shapes[k], is_of_first);
    share.part = static_cast<std::uint8_t>((is_of_first ? first_corners : second_corners) + k);
    if (share.area > negligible_share * points.area) found.add(share);
  }
}

}  // namespace

FaceFaceConstraints find_face_face_constraints(const MovingFace& first, const MovingFace& second,
                                               const ConstraintActivation& activation) {
  FaceFaceConstraints found;
  auto pair = project_pair(first, second, activation.ahead);
  if (!pair || !is_near(*pair, std::max(activation.near, activation.margin), activation.depth)) return found;
  if (is_whole_near(*pair, activation) ||
      !(is_warped(first, activation.flat) || is_warped(second, activation.flat))) {
    add_points(first, second, activation, *pair, found);
    return found;
  }
  const Facets facets_1(first, activation.flat), facets_2(second, activation.flat);
  for (const Facet& a : facets_1.all()) {
    for (const Facet& b : facets_2.all()) {
      const std::size_t part = n_parts * (Facet::n_numbers * a.number + b.number);
      auto facets = project_pair(a.face, b.face, activation.ahead);
      if (!facets || !is_near(*facets, std::max(activation.near, activation.margin), activation.depth))
        continue;
      const std::size_t n_before = found.n;
      add_points(a.face, b.face, activation, *facets, found);
      for (OverlapShare& point : std::span(found.points).subspan(n_before, found.n - n_before)) {
        point.weights_1 = a.to_face(point.weights_1);
        point.weights_2 = b.to_face(point.weights_2);
        point.part = static_cast<std::uint8_t>(part + point.part);
      }
    }
  }
  return found;
}

double gap_of(const OverlapShare& share, const MovingFace& first, const MovingFace& second) {
  const Eigen::Vector3d origin = second.x.col(0);  // large coordinates would cost digits
  return share.normal.dot((first.x.colwise() - origin) * share.weights_1 -
                          (second.x.colwise() - origin) * share.weights_2) +
         share.rise;
}

CornerShares find_corner_shares(const MovingFace& first, const MovingFace& second, bool is_of_first) {
  CornerShares found;
  auto pair = project_pair(first, second);
  if (!pair || !boxes_meet(pair->first, pair->second)) return found;
  make_maps(first, second, *pair);
  const OverlapPolygon whole = overlap_of(*pair);
  if (!whole.has_area()) return found;
  OverlapPoints points;
  place_points_for_products(whole, pair->map_1, pair->map_2, points);
  points.spread(pair->plane.spread);
  const auto shapes = shape_functions(is_of_first ? first.is_triangle : second.is_triangle);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    OverlapShare share = share_of(*pair, points, &shapes[k], is_of_first);
    share.part = static_cast<std::uint8_t>(k);
    if (share.area > negligible_share * points.area) found.add(share);
  }
  return found;
}

}  // namespace contactsim
