// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "contact/lofting/loft.hpp"

/// Measures lofted bodies as surfaces in space, without a look at how they were made.
namespace contactsim::test {

/// Corners of a facet, 3 x 4; a triangle repeats its last.
inline Eigen::Matrix<double, 3, 4> corners_of(const LoftGeometry& loft, const LoftFacet& facet) {
  Eigen::Matrix<double, 3, 4> corners;
  for (int i = 0; i < 4; ++i) corners.col(i) = loft.vertices.col(facet.vertices[static_cast<std::size_t>(i)]);
  return corners;
}

/// Unit normal of a flat facet, by the right-hand order of its corners.
inline Eigen::Vector3d normal_of(const LoftGeometry& loft, const LoftFacet& facet) {
  const auto x = corners_of(loft, facet);
  return Eigen::Vector3d(x.col(1) - x.col(0)).cross(Eigen::Vector3d(x.col(2) - x.col(0))).normalized();
}

/// Volume that the facets enclose, by the divergence theorem: the sum of x . n dA / 3 over two triangles
/// each. Negative when the facets look inwards.
inline double enclosed_volume(const LoftGeometry& loft) {
  double six_volumes = 0.0;
  for (const LoftFacet& facet : loft.facets) {
    const auto x = corners_of(loft, facet);
    const Eigen::Vector3d a = x.col(0), b = x.col(1), c = x.col(2), d = x.col(3);
    six_volumes += a.dot(b.cross(c)) + a.dot(c.cross(d));
  }
  return six_volumes / 6.0;
}

/// Whether the facets close up: every edge, by the places of its ends, is run through as often in one
/// direction as in the other. Places nearer than 1e-9 are one.
inline bool is_closed(const LoftGeometry& loft) {
  using Place = std::array<long long, 3>;
  const auto place = [&](std::uint32_t vertex) {
    const Eigen::Vector3d x = loft.vertices.col(vertex) * 1e9;
    return Place{std::llround(x.x()), std::llround(x.y()), std::llround(x.z())};
  };
  std::map<std::pair<Place, Place>, int> balance;
  for (const LoftFacet& facet : loft.facets) {
    for (std::size_t i = 0; i < 4; ++i) {
      const Place from = place(facet.vertices[i]), to = place(facet.vertices[(i + 1) % 4]);
      if (from < to) ++balance[{from, to}];
      if (to < from) --balance[{to, from}];
    }
  }
  for (const auto& [edge, n] : balance) {
    if (n != 0) return false;
  }
  return true;
}

/// Lofts elements with one size, at the mesh's coordinates.
inline LoftGeometry loft_of(const Mesh& mesh, const std::vector<ElementIndex>& elements,
                            const LoftSize& size) {
  const std::vector<LoftSize> sizes(elements.size(), size);
  return make_loft(mesh, mesh.coordinates(), elements, sizes);
}

/// The same of all elements.
inline LoftGeometry loft_of(const Mesh& mesh, const LoftSize& size) {
  std::vector<ElementIndex> elements;
  for (std::uint32_t e = 0; e < mesh.n_elements(); ++e) elements.push_back({e});
  return loft_of(mesh, elements, size);
}

/// Number of facets that are this part of their bodies.
inline std::size_t count_parts(const LoftGeometry& loft, LoftPart part) {
  std::size_t n = 0;
  for (const LoftFacet& facet : loft.facets) n += facet.part == part ? 1 : 0;
  return n;
}

}  // namespace contactsim::test
