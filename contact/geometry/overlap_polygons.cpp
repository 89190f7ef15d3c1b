// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/overlap_polygons.hpp"

#include <utility>

namespace contactsim {

/// Which lanes have the corner that a lane's next one takes is not known beforehand: all places that it may
/// have are written to, each where it is the lane's.
template <bool has_gaps>
void OverlapPolygons::add(const LaneMask& where, const DoubleVectors& added) {
  if (!where.any()) return;
  for (int i = 0; i < most_; ++i) {
    const LaneMask here = where && n_ == Lanes(i);
    DoubleVectors& place = corner(i);
    place.x = here.select(added.x, place.x);
    place.y = here.select(added.y, place.y);
    if constexpr (has_gaps) place.z = here.select(added.z, place.z);
  }
  if (most_ < max_corners && (where && n_ == Lanes(most_)).any()) corner(most_++) = added;
  n_ = (n_ + where.select(1.0, 0.0)).min(max_corners);
}

/// The parts where a function, linear from corner to corner, is not negative; false when that is all of them.
/// What is outside by a negligible share counts as inside: lines that coincide but for round-off would cross
/// anywhere.
///   side_of  a corner -> Lanes
/// Source: Sutherland and Hodgman, Commun. ACM 17 (1974) 32-42.
template <bool has_gaps, class SideOf>
bool OverlapPolygons::cut(const SideOf& side_of, OverlapPolygons& kept) const {
  constexpr double negligible = 1e-9;
  std::array<Lanes, max_corners> sides;
  const auto side = [&](int i) -> Lanes& { return sides[static_cast<std::size_t>(i)]; };
  Lanes least = 0.0, most = 0.0;
  for (int i = 0; i < most_; ++i) {
    side(i) = side_of(corner(i));
    const Lanes of_corner = has_corner(i).select(side(i), 0.0);
    least = least.min(of_corner);
    most = most.max(of_corner);
  }
  const Lanes outside = -negligible * most;
  if (!(least < outside).any()) return false;
  for (int i = 0; i < most_; ++i) side(i) = (side(i) < outside).select(side(i), side(i).max(0.0));
  kept.n_ = 0.0;
  kept.most_ = 0;
  for (int i = 0; i < most_; ++i) {
    const LaneMask exists = has_corner(i);
    const Lanes next_side = i + 1 < most_ ? has_corner(i + 1).select(side(i + 1), side(0)) : side(0);
    const LaneMask is_inside = side(i) >= 0.0, is_next_inside = next_side >= 0.0;
    kept.add<has_gaps>(exists && is_inside, corner(i));
    const LaneMask crosses = exists && ((is_inside && !is_next_inside) || (!is_inside && is_next_inside));
    if (!crosses.any()) continue;
    const Lanes share = side(i) / (side(i) - next_side);
    kept.add<has_gaps>(crosses, corner(i) + share * (corner_after(i) - corner(i)));
  }
  return true;
}

OverlapPolygons::OverlapPolygons(const ProjectedPairs& pairs, const LaneMask& wanted) {
  const LaneMask& are_triangles = pairs.are_triangles_1;
  const CornersOfFaces &first = pairs.first, &window = pairs.second;
  // The first faces look the other way: their corners are taken from last to first.
  n_ = wanted.select(are_triangles.select(3.0, 4.0), 0.0);
  most_ = 4;
  corner(0) = first[3];
  corner(1) = select(are_triangles, first[1], first[2]);
  corner(2) = select(are_triangles, first[0], first[1]);
  corner(3) = first[0];
  OverlapPolygons other;
  OverlapPolygons *now = this, *next = &other;
  for (std::size_t i = 0; i < 4; ++i) {
    const DoubleVectors &from = window[i], &to = window[(i + 1) % 4];
    const Lanes du = to.x - from.x, dv = to.y - from.y;
    const auto inwards = [&](const DoubleVectors& at) { return du * (at.y - from.y) - dv * (at.x - from.x); };
    if (!now->cut<false>(inwards, *next)) continue;
    next->n_ = (next->n_ > 2.0).select(next->n_, 0.0);
    next->most_ = static_cast<int>(next->n_.maxCoeff());
    std::swap(now, next);
  }
  if (now != this) *this = *now;
}

OverlapPolygons::OverlapPolygons(const std::array<DoubleVectors, 3>& corners) : n_(3.0), most_(3) {
  for (int i = 0; i < 3; ++i) corner(i) = corners[static_cast<std::size_t>(i)];
}

void OverlapPolygons::set_gaps(const ProjectedPairs& pairs) {
  for (int i = 0; i < most_; ++i) {
    DoubleVectors& at = corner(i);
    at.z = locate_on_both(pairs.maps_1, pairs.maps_2, at.x, at.y).gap;
  }
}

OverlapPolygons OverlapPolygons::part_between(const Lanes& least, const Lanes& most) const {
  OverlapPolygons low, part;
  const bool is_cut = cut<true>([&](const DoubleVectors& at) { return most - at.z; }, low);
  const OverlapPolygons& rest = is_cut ? low : *this;
  return rest.cut<true>([&](const DoubleVectors& at) { return at.z - least; }, part) ? part : rest;
}

Lanes OverlapPolygons::area() const {
  Lanes twice = 0.0;
  for (int i = 1; i + 1 < most_; ++i) {
    const DoubleVectors a = corner(i) - corner(0), b = corner(i + 1) - corner(0);
    twice += has_corner(i + 1).select(a.x * b.y - a.y * b.x, 0.0);
  }
  return 0.5 * twice;
}

DoubleVectors OverlapPolygons::centroid() const {
  Lanes twice = 0.0, to_u = 0.0, to_v = 0.0;
  for (int i = 1; i + 1 < most_; ++i) {
    const DoubleVectors a = corner(i) - corner(0), b = corner(i + 1) - corner(0);
    const Lanes part = has_corner(i + 1).select(a.x * b.y - a.y * b.x, 0.0);
    twice += part;
    to_u += has_corner(i + 1).select(part * (a.x + b.x), 0.0);
    to_v += has_corner(i + 1).select(part * (a.y + b.y), 0.0);
  }
  const LaneMask has_area = twice > 0.0;
  return {corner(0).x + has_area.select(to_u / (3.0 * twice), 0.0),
          corner(0).y + has_area.select(to_v / (3.0 * twice), 0.0), 0.0};
}

void OverlapPolygons::set_where(const LaneMask& holds, const OverlapPolygons& others) {
  n_ = holds.select(others.n_, n_);
  most_ = static_cast<int>(n_.maxCoeff());
  for (int i = 0; i < most_; ++i) corner(i) = select(holds, others.corner(i), corner(i));
}

OverlapPolygon OverlapPolygons::of(Eigen::Index lane) const {
  OverlapPolygon polygon;
  polygon.n = static_cast<int>(n_(lane));
  for (int i = 0; i < polygon.n; ++i) {
    polygon.u[i] = corner(i).x(lane);
    polygon.v[i] = corner(i).y(lane);
  }
  return polygon;
}

std::optional<WholeOverlap> find_whole_overlap(const MovingFace& first, const MovingFace& second) {
  const FacePair faces{&first, &second};
  const ProjectedPairs pairs({&faces, 1});
  if (!(pairs.planes.exist && pairs.boxes_meet())(0)) return std::nullopt;
  const OverlapPolygons polygons(pairs, first_lanes(1));
  if (!(polygons.area()(0) > 0.0)) return std::nullopt;
  return WholeOverlap{pairs, polygons};
}

}  // namespace contactsim
