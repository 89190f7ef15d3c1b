// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>

#include "contact/projected_pair.hpp"

namespace contactsim {

namespace {

/// A quadrilateral that is less out of its plane than this many times the gap that counts as closed is flat.
constexpr double flat_margins = 20.0;

/// Part of an overlap from which on it has a point for each corner of the smaller face, and below which it
/// has none, over that face's area.
constexpr double large = 0.5, negligible = 1e-6;

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

/// A face, or of a warped quadrilateral the triangle between two of its corners and the mean of all.
struct Facet {
  MovingFace face;
  std::array<Eigen::Index, 2> corners{};  ///< of the quadrilateral
  bool is_whole = true;

  /// The shares that the corners of the face have of those of the facet's.
  Eigen::Vector4d to_face(const Eigen::Vector4d& shares) const {
    if (is_whole) return shares;
    Eigen::Vector4d of_face = Eigen::Vector4d::Constant(0.25 * shares[2]);
    of_face[corners[0]] += shares[0];
    of_face[corners[1]] += shares[1];
    return of_face;
  }
};

Facet make_facet(const MovingFace& face, Eigen::Index corner) {
  const Eigen::Index next = (corner + 1) % 4;
  const auto part = [&](const FaceCorners& all) {
    const Eigen::Vector3d mean = all.rowwise().mean();
    FaceCorners of_facet;
    of_facet << all.col(corner), all.col(next), mean, mean;
    return of_facet;
  };
  return {{part(face.x), part(face.v), true, face.sharpness}, {corner, next}, false};
}

double warp_of(const MovingFace& face, const Eigen::Vector3d& normal) {
  if (face.is_triangle) return 0.0;
  return 0.25 * std::abs(normal.dot(face.x.col(0) - face.x.col(1) + face.x.col(2) - face.x.col(3)));
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
  return {on_first[0], pair.plane.normal, corner_shares(on_first, pair.map_1.is_triangle) / on_first[0],
          corner_shares(on_second, pair.map_2.is_triangle) / on_first[0], 0};
}

/// The points of two faces whose heights over the plane are, or count as, linear between their corners.
void add_points(const MovingFace& first, const MovingFace& second, const ConstraintReach& reach,
                ProjectedPair& pair, FaceFaceConstraints& found) {
  make_maps(first, second, pair);
  OverlapPolygon whole = overlap_of(pair);
  if (!whole.has_area()) return;
  const double area_1 = std::abs(area_vector(first.x).dot(pair.plane.normal)),
               area_2 = std::abs(area_vector(second.x).dot(pair.plane.normal));
  const double smaller = std::min(area_1, area_2);
  std::array<OverlapPolygon, 2> scratch;
  const OverlapPolygon* part = &whole;
  if (!is_whole_near(pair, reach)) {
    set_gaps(pair.map_1, pair.map_2, whole);
    part = &part_between(-reach.depth, reach.margin, whole, scratch);
    if (!(part->area() > 0.0) && reach.near > reach.margin)
      part = &part_between(-reach.depth, reach.near, whole, scratch);
  }
  const double area = part->area();
  if (!(area > negligible * smaller)) return;
  OverlapPoints points;
  place_points(*part, pair.map_1, pair.map_2, points);
  points.spread(pair.plane.spread);
  if (area < large * smaller) return found.add(share_of(pair, points, nullptr, true));
  const bool is_of_first = area_1 <= area_2;
  const auto shapes = shape_functions(is_of_first ? first.is_triangle : second.is_triangle);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    OverlapShare share = share_of(pair, points, &shapes[k], is_of_first);
    share.part = static_cast<std::uint8_t>(k);
    if (share.area > negligible * points.area) found.add(share);
  }
}

}  // namespace

FaceFaceConstraints find_face_face_constraints(const MovingFace& first, const MovingFace& second,
                                               const ConstraintReach& reach) {
  FaceFaceConstraints found;
  auto pair = project_pair(first, second, reach.ahead);
  if (!pair || !is_near(*pair, std::max(reach.near, reach.margin), reach.depth)) return found;
  const double flat = flat_margins * reach.margin;
  const bool is_warped_1 = warp_of(first, pair->plane.normal) > flat,
             is_warped_2 = warp_of(second, pair->plane.normal) > flat;
  if (is_whole_near(*pair, reach) || (!is_warped_1 && !is_warped_2)) {
    add_points(first, second, reach, *pair, found);
    return found;
  }
  for (Eigen::Index i = 0; i < (is_warped_1 ? 4 : 1); ++i) {
    const Facet a = is_warped_1 ? make_facet(first, i) : Facet{first};
    for (Eigen::Index k = 0; k < (is_warped_2 ? 4 : 1); ++k) {
      const Facet b = is_warped_2 ? make_facet(second, k) : Facet{second};
      auto facets = project_pair(a.face, b.face, reach.ahead);
      if (!facets || !is_near(*facets, std::max(reach.near, reach.margin), reach.depth)) continue;
      const std::size_t n_before = found.n;
      add_points(a.face, b.face, reach, *facets, found);
      for (OverlapShare& point : std::span(found.points).subspan(n_before, found.n - n_before)) {
        point.weights_1 = a.to_face(point.weights_1);
        point.weights_2 = b.to_face(point.weights_2);
        point.part = static_cast<std::uint8_t>(point.part + 4 * (1 + i + 4 * k));
      }
    }
  }
  return found;
}

}  // namespace contactsim
