// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/surface_summary.hpp"

#include <algorithm>
#include <numbers>
#include <tuple>

#include "contact/mesh/contact_model.hpp"
#include "core/mesh/face_geometry.hpp"

namespace contactsim {

namespace {

double sphere_area(const LoftSphere& sphere) {
  return 4.0 * std::numbers::pi * sphere.radius * sphere.radius;
}

bool is_triangle(const std::array<NodeIndex, 4>& nodes) {
  for (std::size_t i = 0; i < 4; ++i) {
    if (nodes[i] == nodes[(i + 1) % 4]) return true;
  }
  return false;
}

/// Faces, and the nodes of faces and lofted elements; lofts are counted apart. A face of an element counts
/// once, by its corners, however many facets its midside nodes make of it.
SurfaceSummary summarize_mesh_parts(const ContactSurface& surface, const Mesh& mesh) {
  SurfaceSummary summary;
  std::vector<NodeIndex> nodes = surface.nodes;
  for (const ElementSide face : surface.faces) {
    const auto corners = mesh.side_nodes(face);
    ++(is_triangle(corners) ? summary.triangles : summary.quadrilaterals);
    for (const auto& facet : mesh.side_facets(face)) nodes.insert(nodes.end(), facet.begin(), facet.end());
    summary.area += face_area(mesh, face);
  }
  for (const ElementIndex element : surface.lofted_elements) {
    const Topology& shape = topology(mesh.blocks()[mesh.block_of(element)].shape);
    const auto corners = mesh.element_nodes(element).first(shape.n_corners);
    nodes.insert(nodes.end(), corners.begin(), corners.end());
  }
  std::sort(nodes.begin(), nodes.end());
  summary.nodes = static_cast<std::uint32_t>(std::unique(nodes.begin(), nodes.end()) - nodes.begin());
  summary.owned = static_cast<std::uint32_t>(surface.faces.size());
  summary.claimed = summary.owned;
  for (const LostClaims& lost : surface.lost_to) summary.claimed += lost.faces;
  summary.lofted_elements = static_cast<std::uint32_t>(surface.lofted_elements.size());
  return summary;
}

void add_loft_parts(const ContactModel& model, SurfaceSummaries& summaries) {
  for (std::size_t i = 0; i < model.loft.facets.size(); ++i) {
    const LoftFacet& facet = model.loft.facets[i];
    SurfaceSummary& summary = summaries[model.surface_of_facet[i]];
    summary.area += facet_area(model.loft, facet);
    const bool is_new_prism = i == 0 || model.loft.facets[i - 1].element != facet.element;
    switch (facet.part) {
      case LoftPart::top:
        ++summary.top;
        break;
      case LoftPart::bottom:
        ++summary.bottom;
        break;
      case LoftPart::side:
        ++summary.side;
        break;
      case LoftPart::joint:
        break;
      case LoftPart::prism:
        summary.prisms += is_new_prism ? 1 : 0;
        break;
    }
  }
  for (std::size_t i = 0; i < model.loft.spheres.size(); ++i) {
    SurfaceSummary& summary = summaries[model.surface_of_sphere[i]];
    ++summary.spheres;
    summary.area += sphere_area(model.loft.spheres[i]);
  }
}

std::string_view kind_of(LoftPart part) {
  switch (part) {
    case LoftPart::top:
      return "top";
    case LoftPart::bottom:
      return "bottom";
    case LoftPart::side:
      return "side";
    case LoftPart::joint:
      return "joint";
    case LoftPart::prism:
      return "prism";
  }
  return "";
}

/// A row and what it is sorted by: positions in the mesh, which deck and file fix.
struct PlacedRow {
  std::uint32_t block = 0;
  FacetRow row;

  auto key() const { return std::tie(row.surface, block, row.element, row.side); }
};

class FacetLister {
 public:
  FacetLister(const ContactModel& model, const Mesh& mesh) : model_(model), mesh_(mesh) {}

  std::vector<FacetRow> list() {
    for (const SurfaceIndex surface : indices(model_.surfaces.surfaces)) add_mesh_parts(surface);
    add_lofts();
    std::stable_sort(rows_.begin(), rows_.end(),
                     [](const auto& a, const auto& b) { return a.key() < b.key(); });
    std::vector<FacetRow> rows;
    for (PlacedRow& placed : rows_) rows.push_back(std::move(placed.row));
    return rows;
  }

 private:
  void add(SurfaceIndex surface, ElementIndex element, int side, std::string_view kind, double area) {
    const std::uint32_t block = mesh_.block_of(element);
    rows_.push_back(
        {block,
         {surface, mesh_.name({EntityKind::block, block}), mesh_.element_id(element), side, kind, area}});
  }

  void add_mesh_parts(SurfaceIndex index) {
    const ContactSurface& surface = model_.surfaces.surfaces[index];
    for (const ElementSide face : surface.faces) {
      add(index, face.element(), face.side(), "face", face_area(mesh_, face));
    }
    for (const NodeIndex node : surface.nodes)
      rows_.push_back({0, {index, "", mesh_.node_id(node), 0, "node", 0.0}});
    for (const std::uint32_t plane : surface.analytic_planes) {
      rows_.push_back({0, {index, model_.planes[plane].name.text, 0, 0, "analytic", 0.0}});
    }
  }

  void add_lofts() {
    for (std::size_t i = 0; i < model_.loft.facets.size(); ++i) {
      const LoftFacet& facet = model_.loft.facets[i];
      const double area = facet_area(model_.loft, facet);
      const bool continues_prism =
          facet.part == LoftPart::prism && i > 0 && model_.loft.facets[i - 1].element == facet.element;
      if (continues_prism) {
        rows_.back().row.area += area;
      } else {
        add(model_.surface_of_facet[i], facet.element, facet.side, kind_of(facet.part), area);
      }
    }
    for (std::size_t i = 0; i < model_.loft.spheres.size(); ++i) {
      const LoftSphere& sphere = model_.loft.spheres[i];
      add(model_.surface_of_sphere[i], sphere.element, 1, "sphere", sphere_area(sphere));
    }
  }

  const ContactModel& model_;
  const Mesh& mesh_;
  std::vector<PlacedRow> rows_;
};

}  // namespace

SurfaceSummaries summarize(const ContactModel& model, const Mesh& mesh) {
  SurfaceSummaries summaries;
  for (const ContactSurface& surface : model.surfaces.surfaces) {
    summaries.push_back(summarize_mesh_parts(surface, mesh));
  }
  add_loft_parts(model, summaries);
  return summaries;
}

std::vector<FacetRow> list_facets(const ContactModel& model, const Mesh& mesh) {
  return FacetLister(model, mesh).list();
}

}  // namespace contactsim
