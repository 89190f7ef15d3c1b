// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/face_face_constraints.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "contact/geometry/facets.hpp"
#include "contact/geometry/overlap_polygons.hpp"

namespace contactsim {

namespace {

/// Part of an overlap from which on it has a point for each corner of the smaller face, and below which it
/// has none, over that face's area.
constexpr double large = 0.5, negligible_share = 1e-6;

/// Numbers of the points of one overlap: corners of the first face, of the second, all of it.
constexpr std::size_t first_corners = 0, second_corners = 4, whole_overlap = 8, n_parts = 9;

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

/// The part of an overlap with such moments on both faces.
OverlapShare make_share(const Eigen::Vector3d& normal, const FaceMoments& on_first, bool is_triangle_1,
                        const FaceMoments& on_second, bool is_triangle_2, std::size_t part) {
  return {on_first[0],
          normal,
          corner_shares(on_first, is_triangle_1) / on_first[0],
          corner_shares(on_second, is_triangle_2) / on_first[0],
          static_cast<std::uint8_t>(part),
          0.0};
}

/// What of pairs closes in the coming step, else what may close soon.
///   is_whole  all of it counts
OverlapPolygons closing_overlaps(const ProjectedPairs& pairs, const Lanes& margin, const Lanes& near,
                                 const Lanes& depth, const LaneMask& wanted, const LaneMask& is_whole) {
  OverlapPolygons polygons(pairs, wanted);
  const LaneMask is_cut = wanted && !is_whole && polygons.area() > 0.0;
  if (!is_cut.any()) return polygons;
  polygons.set_gaps(pairs);
  OverlapPolygons parts = polygons.part_between(-depth, margin);
  const LaneMask is_open = is_cut && near > margin && !(parts.area() > 0.0);
  if (is_open.any()) parts.set_where(is_open, polygons.part_between(-depth, near));
  polygons.set_where(is_cut, parts);
  return polygons;
}

/// Sums over the points of overlaps, for all of each or by the shape functions of one of the faces.
class ShareSums {
 public:
  ///   has_corners  the overlap is shared out
  ///   is_of_first  among the corners of the first face, else of the second
  ShareSums(const ProjectedPairs& pairs, const OverlapPolygons& polygons, const LaneMask& has_corners,
            const LaneMask& is_of_first)
      : pairs_(pairs),
        has_corners_(has_corners),
        is_of_first_(is_of_first),
        are_triangles_((is_of_first && pairs.are_triangles_1) || (!is_of_first && pairs.are_triangles_2)) {
    polygons.visit_points(
        [&](const Lanes& u, const Lanes& v, const Lanes& area) { add(u, v, area * pairs.planes.spread); });
  }

  void add_shares(Eigen::Index lane, FaceFaceConstraints& found) const {
    const std::size_t n = !has_corners_(lane) ? 1 : are_triangles_(lane) ? 3 : 4;
    const std::size_t begin = is_of_first_(lane) ? first_corners : second_corners;
    for (std::size_t k = 0; k < n; ++k) {
      const FaceMoments on_first = moments_in(on_first_[k], lane);
      if (!(on_first[0] > negligible_share * area_(lane))) continue;
      found.add(make_share(vector_in(pairs_.planes.normal, lane), on_first, pairs_.are_triangles_1(lane),
                           moments_in(on_second_[k], lane), pairs_.are_triangles_2(lane),
                           has_corners_(lane) ? begin + k : whole_overlap));
    }
  }

 private:
  void add(const Lanes& u, const Lanes& v, const Lanes& area) {
    const OverlapBatch at = locate_on_both(pairs_.maps_1, pairs_.maps_2, u, v);
    area_ += area;
    if (!has_corners_.any()) return add_moments(area, at, 0);
    const Lanes xi = is_of_first_.select(at.xi_1, at.xi_2), eta = is_of_first_.select(at.eta_1, at.eta_2);
    for (std::size_t k = 0; k < 4; ++k) {
      Lanes shape = evaluate(shape_functions(false)[k], xi, eta);
      if (k < 3 && are_triangles_.any())
        shape = are_triangles_.select(evaluate(shape_functions(true)[k], xi, eta), shape);
      add_moments(has_corners_.select(area * shape, k == 0 ? area : Lanes(0.0)), at, k);
    }
  }
  void add_moments(const Lanes& f, const OverlapBatch& at, std::size_t k) {
    contactsim::add_moments(f, at.xi_1, at.eta_1, on_first_[k]);
    contactsim::add_moments(f, at.xi_2, at.eta_2, on_second_[k]);
  }

  const ProjectedPairs& pairs_;
  LaneMask has_corners_, is_of_first_, are_triangles_;
  std::array<MomentsOfFaces, 4> on_first_{}, on_second_{};
  Lanes area_ = 0.0;
};

/// [length^2]
Lanes area_in_plane(const CornersOfFaces& x) {
  const DoubleVectors a = x[2] - x[0], b = x[3] - x[1];
  return (0.5 * (a.x * b.y - a.y * b.x)).abs();
}

void add_points_of_facets(const ConstrainedFaces& faces, bool is_split_1, bool is_split_2,
                          FaceFaceConstraints& found) {
  const Facets facets_1(faces.first, is_split_1), facets_2(faces.second, is_split_2);
  ConstraintActivation activation = faces.activation;
  activation.flat = never_split;
  std::vector<ConstrainedFaces> pairs;
  std::array<FaceFaceConstraints, 4> of_facets;
  for (const Facet& a : facets_1.all()) {
    pairs.clear();
    for (const Facet& b : facets_2.all()) pairs.push_back({a.face, b.face, activation});
    find_face_face_constraints(pairs, of_facets);
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const Facet& b = facets_2.all()[i];
      const std::size_t part = n_parts * (Facet::n_numbers * a.number + b.number);
      for (OverlapShare point : of_facets[i].all()) {
        point.weights_1 = a.to_face(point.weights_1);
        point.weights_2 = b.to_face(point.weights_2);
        point.part = static_cast<std::uint8_t>(part + point.part);
        found.add(point);
      }
    }
  }
}

}  // namespace

void find_face_face_constraints(std::span<const ConstrainedFaces> pairs,
                                std::span<FaceFaceConstraints> found) {
  const ProjectedPairs projected = project_pairs(pairs, pairs[0].activation.ahead);
  Lanes margin = 0.0, near = 0.0, depth = 0.0, flat = never_split;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto lane = static_cast<Eigen::Index>(i);
    const ConstraintActivation& activation = pairs[i].activation;
    margin(lane) = activation.margin;
    near(lane) = activation.near;
    depth(lane) = activation.depth;
    flat(lane) = activation.flat;
    found[i].n = 0;
  }
  const LaneMask is_near = first_lanes(pairs.size()) && projected.are_near(near.max(margin), depth);
  if (!is_near.any()) return;
  // No gap is beyond what counts as closed, nor deeper than what is another wall.
  const LaneMask is_whole = projected.min_gap >= -depth && projected.max_gap <= margin;
  const LaneMask is_warped_1 = is_near && !is_whole && projected.are_warped_1(flat),
                 is_warped_2 = is_near && !is_whole && projected.are_warped_2(flat);
  const LaneMask is_split = is_warped_1 || is_warped_2, is_one = is_near && !is_split;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto lane = static_cast<Eigen::Index>(i);
    if (is_split(lane)) add_points_of_facets(pairs[i], is_warped_1(lane), is_warped_2(lane), found[i]);
  }
  if (!is_one.any()) return;
  const OverlapPolygons polygons = closing_overlaps(projected, margin, near, depth, is_one, is_whole);
  const Lanes area = polygons.area(), area_1 = area_in_plane(projected.first),
              area_2 = area_in_plane(projected.second), smaller = area_1.min(area_2);
  const LaneMask counts = is_one && area > 0.0 && area > negligible_share * smaller;
  if (!counts.any()) return;
  const ShareSums sums(projected, polygons, area >= large * smaller, area_1 <= area_2);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto lane = static_cast<Eigen::Index>(i);
    if (counts(lane)) sums.add_shares(lane, found[i]);
  }
}

FaceFaceConstraints find_face_face_constraints(const MovingFace& first, const MovingFace& second,
                                               const ConstraintActivation& activation) {
  FaceFaceConstraints found;
  const ConstrainedFaces faces{first, second, activation};
  find_face_face_constraints({&faces, 1}, {&found, 1});
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
  const auto overlap = find_whole_overlap(first, second);
  if (!overlap) return found;
  const ProjectedPair pair = overlap->pair.of(0);
  OverlapPoints points;
  place_points_for_products(overlap->polygon.of(0), pair.map_1, pair.map_2, points);
  points.spread(pair.plane.spread);
  const auto shapes = shape_functions(is_of_first ? first.is_triangle : second.is_triangle);
  for (std::size_t k = 0; k < shapes.size(); ++k) {
    FaceMoments on_first{}, on_second{};
    for (const OverlapBatch& at : points.batches()) {
      const Lanes f = at.weight * (is_of_first ? evaluate(shapes[k], at.xi_1, at.eta_1)
                                               : evaluate(shapes[k], at.xi_2, at.eta_2));
      add_moments(f, at.xi_1, at.eta_1, on_first);
      add_moments(f, at.xi_2, at.eta_2, on_second);
    }
    if (on_first[0] > negligible_share * points.area) {
      found.add(make_share(pair.plane.normal, on_first, first.is_triangle, on_second, second.is_triangle, k));
    }
  }
  return found;
}

}  // namespace contactsim
