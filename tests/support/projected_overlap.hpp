// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/geometry/overlap_polygons.hpp"

namespace contactsim::test {

/// One pair of faces as a batch of its own.
inline ProjectedPairs project_one(const MovingFace& first, const MovingFace& second) {
  const FacePair pair{&first, &second};
  return ProjectedPairs({&pair, 1});
}

/// Two faces on their common plane with what they have in common.
struct ProjectedOverlap {
  ProjectedPairs pairs;
  ProjectedPair pair;
  OverlapPolygons polygons;
  OverlapPoints points;

  ProjectedOverlap(const MovingFace& a, const MovingFace& b)
      : pairs(project_one(a, b)), pair(pairs.of(0)), polygons(pairs, first_lanes(1)) {
    if (!(area() > 0.0)) return;
    polygons.visit_points([&](const Lanes& u, const Lanes& v, const Lanes& share) {
      points.add(locate_on_both(pairs.maps_1, pairs.maps_2, u, v), share(0));
    });
  }

  double area() const { return polygons.area()(0); }
  /// The sum of a function of the places on both faces over the points.
  template <class F>
  double sum(const F& f) const {
    double total = 0.0;
    for (const OverlapBatch& batch : points.batches()) {
      for (int lane = 0; lane < n_lanes; ++lane) {
        total += batch.weight(lane) * f(pair.map_1.at(batch.xi_1(lane), batch.eta_1(lane)),
                                        pair.map_2.at(batch.xi_2(lane), batch.eta_2(lane)));
      }
    }
    return total;
  }
};

}  // namespace contactsim::test
