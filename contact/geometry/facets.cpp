// SPDX-License-Identifier: BSD-3-Clause
#include "contact/geometry/facets.hpp"

namespace contactsim {

namespace {

Facet make_facet(const MovingFace& face, Eigen::Index corner) {
  const Eigen::Index next = (corner + 1) % 4;
  const auto part = [&](const FaceCorners& all) {
    const Eigen::Vector3d mean = all.rowwise().mean();
    FaceCorners of_facet;
    of_facet << all.col(corner), all.col(next), mean, mean;
    return of_facet;
  };
  return {{part(face.x), part(face.v), true, face.sharpness}, static_cast<std::size_t>(corner) + 1};
}

}  // namespace

Eigen::Vector4d Facet::to_face(const Eigen::Vector4d& shares) const {
  if (number == 0) return shares;
  Eigen::Vector4d of_face = Eigen::Vector4d::Constant(0.25 * shares[2]);
  of_face[static_cast<Eigen::Index>(number - 1)] += shares[0];
  of_face[static_cast<Eigen::Index>(number % 4)] += shares[1];
  return of_face;
}

Facets::Facets(const MovingFace& face, bool is_split) {
  if (!is_split) {
    facets_[0].face = face;
    return;
  }
  n_ = 4;
  for (Eigen::Index k = 0; k < 4; ++k) facets_[static_cast<std::size_t>(k)] = make_facet(face, k);
}

}  // namespace contactsim
