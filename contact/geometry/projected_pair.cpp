// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/projected_pair.hpp"

namespace contactsim {

bool boxes_meet(const FaceCorners& first, const FaceCorners& second) {
  for (int i = 0; i < 2; ++i) {
    if (first.row(i).maxCoeff() <= second.row(i).minCoeff()) return false;
    if (second.row(i).maxCoeff() <= first.row(i).minCoeff()) return false;
  }
  return true;
}

std::optional<ProjectedPair> project_pair(const MovingFace& first, const MovingFace& second, double ahead) {
  const auto plane = make_common_plane(first.x, first.look(), second.look());
  if (!plane) return std::nullopt;
  ProjectedPair pair{*plane, project(first.x, *plane), project(second.x, *plane), 0.0, 0.0, {}, {}};
  if (ahead > 0.0) {
    pair.first.row(2) += ahead * (plane->normal.transpose() * first.v);
    pair.second.row(2) += ahead * (plane->normal.transpose() * second.v);
  }
  const auto z1 = pair.first.row(2), z2 = pair.second.row(2);
  pair.min_gap = z1.minCoeff() - z2.maxCoeff();
  pair.max_gap = z1.maxCoeff() - z2.minCoeff();
  return pair;
}

}  // namespace contactsim
