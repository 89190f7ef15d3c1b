// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <span>

#include "contact/geometry/moving_face.hpp"

namespace contactsim {

/// A face, or of a warped quadrilateral the triangle between two of its corners and the mean of all.
struct Facet {
  static constexpr std::size_t n_numbers = 5;

  MovingFace face;
  std::size_t number = 0;  ///< from 1 in a quadrilateral; 0 of a whole face

  /// The shares that the corners of the face have of those of the facet's [1].
  Eigen::Vector4d to_face(const Eigen::Vector4d& shares) const;
};

/// The facets of a face: four of a warped quadrilateral that is split, else the face itself. Each of the four
/// has a normal of its own: that in the middle of the quadrilateral is not square to its edges, so that what
/// slides along an edge would sink in; and gaps between two of them are linear, so that what rises between
/// the corners of another face is found.
class Facets {
 public:
  Facets(const MovingFace& face, bool is_split);

  std::span<const Facet> all() const { return {facets_.data(), n_}; }

 private:
  std::size_t n_ = 1;
  std::array<Facet, 4> facets_;
};

/// A quadrilateral whose corners are out of its plane by less than this share of an element's thickness is
/// flat.
inline constexpr double flat_share = 0.02;
/// What counts as flat where no quadrilateral is to be split [length].
inline constexpr double never_split = std::numeric_limits<double>::infinity();

}  // namespace contactsim
