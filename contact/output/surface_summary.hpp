// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "contact/mesh/contact_model.hpp"

namespace contactsim {

/// The figures of one surface, as the ownership table shows them.
struct SurfaceSummary {
  std::uint32_t claimed = 0;  ///< owned element faces and those lost to earlier surfaces
  std::uint32_t owned = 0;    ///< element faces: triangles + quadrilaterals
  std::uint32_t triangles = 0, quadrilaterals = 0;
  std::uint32_t lofted_elements = 0;
  std::uint32_t top = 0, bottom = 0, side = 0, prisms = 0, spheres = 0;  ///< parts of the lofts
  std::uint32_t nodes = 0;  ///< distinct mesh nodes of all that is owned
  double area = 0.0;        ///< of element faces and lofts [length^2]
};

using SurfaceSummaries = IndexedVector<SurfaceIndex, SurfaceSummary>;

SurfaceSummaries summarize(const ContactModel& model, const Mesh& mesh);

/// One owned facet, as the face table shows it.
struct FacetRow {
  SurfaceIndex surface;
  std::string block;         ///< name; "" for nodes, the object's name for analytic planes
  std::int64_t element = 0;  ///< Exodus id of the element, or of the node; 0 for analytic planes
  int side = 0;           ///< Exodus side number; 1 for prisms and spheres, 0 for nodes and analytic planes
  std::string_view kind;  ///< face, top, bottom, side, prism, sphere, node, analytic
  double area = 0.0;      ///< [length^2]; 0 for nodes and analytic planes
};

/// By surface, then block, element and side. A prism is one row, whatever its facets.
std::vector<FacetRow> list_facets(const ContactModel& model, const Mesh& mesh);

}  // namespace contactsim
