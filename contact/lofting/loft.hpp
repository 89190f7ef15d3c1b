// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/lofting/shell_loft.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The size that gives a lofted element its body.
struct LoftSize {
  double thickness = 0.0;       ///< of a shell, > 0 [length]
  double lofting_factor = 0.5;  ///< share of the thickness above the mesh surface, on its normal's side [1]
  double radius = 0.0;          ///< of a line's or particle's cross-section, > 0 [length]
};

/// Which part of a lofted body a facet is.
enum class LoftPart : std::uint8_t { top, bottom, side, joint, prism };

/// One flat facet of a lofted body, corners in outward right-hand order; a triangle repeats its last.
struct LoftFacet {
  ElementIndex element;
  LoftPart part = LoftPart::top;
  std::uint8_t side = 1;  ///< of a shell 1 top, 2 bottom, 3 to 6 its edges, 7 and 8 joints; of a prism 1
  std::array<std::uint32_t, 4> vertices{};
};

/// How a vertex of a brick stands off its node: along the mean normal of some shells.
struct LoftOffset {
  std::uint32_t first = 0, count = 0;  ///< in LoftGeometry::offset_shells; none at vertices of prisms
  double height = 0.0;                 ///< along the normal, negative below the shell [length]
  double thickness = 0.0;              ///< of the shell [length]
};

/// The sphere around a particle.
struct LoftSphere {
  ElementIndex element;
  NodeIndex centre;
  double radius = 0.0;  ///< [length]
};

/// The cylinder around a line, in which its prism is inscribed.
struct LoftCapsule {
  ElementIndex element;
  double radius = 0.0;  ///< [length]
};

/// Bodies around shells (bricks), lines (hexagonal prisms) and particles (spheres). A force on a vertex
/// belongs to the mesh node that the vertex was lofted from.
struct LoftGeometry {
  Eigen::Matrix3Xd vertices;               ///< 3 x n_vertices [length]
  std::vector<NodeIndex> node_of_vertex;   ///< [n_vertices]
  std::vector<LoftOffset> offsets;         ///< [n_vertices]
  std::vector<TurnedShell> offset_shells;  ///< their shells
  std::vector<ElementIndex> shells;        ///< that are lofted, ascending
  std::vector<LoftFacet> facets;           ///< by element, then side; then joints
  std::vector<LoftSphere> spheres;         ///< by element
  std::vector<LoftCapsule> capsules;       ///< by element
};

/// Lofts elements at the given coordinates. Shells that share a node bend the loft along their mean normal
/// there, so that smooth shells have a smooth skin; side faces stand only on edges that no other lofted shell
/// has; joints close sharp folds. A line's prism is inscribed in the cylinder of its radius, its ends closed
/// where no other lofted line continues.
///   coordinates  3 x n_nodes [length]
///   elements     ascending; shells, lines and particles
///   sizes        [n_elements] of each of them
/// Source: Sierra/SM 5.22, 8.4.8 and 8.9.1.1.
LoftGeometry make_loft(const Mesh& mesh, const Eigen::Matrix3Xd& coordinates,
                       std::span<const ElementIndex> elements, std::span<const LoftSize> sizes);

/// Area of a facet [length^2].
double facet_area(const LoftGeometry& loft, const LoftFacet& facet);

}  // namespace contactsim
