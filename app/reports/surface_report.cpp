// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/surface_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "app/reports/interaction_report.hpp"
#include "app/reports/number.hpp"
#include "app/reports/text_table.hpp"
#include "core/base/csv_field.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

using Json = nlohmann::ordered_json;

/// Digits of an area in files: enough to compare by, few enough that round-off does not show.
constexpr int n_area_digits = 12;

double rounded(double area) { return std::stod(fmt::format("{:.{}g}", area, n_area_digits)); }

TextTable surface_table() {
  return {0,
          2,
          {{"no", 4},
           name_column("surface", 20),
           name_column("made by", 16),
           {"line", 5},
           {"claimed", 8},
           {"owned", 8},
           {"triangle", 8},
           {"quad", 8},
           {"lofted", 7},
           {"nodes", 8},
           {"area", 11}}};
}

std::string format_rows(const ContactModel& model, const SurfaceSummaries& summaries) {
  TextTable table = surface_table();
  std::string planes;
  SurfaceSummary total;
  for (const SurfaceIndex i : indices(summaries)) {
    const ContactSurface& surface = model.surfaces.surfaces[i];
    const SurfaceSummary& s = summaries[i];
    table.add(i.value + 1, surface.name, surface.command, surface.location.line, s.claimed, s.owned,
              s.triangles, s.quadrilaterals, s.lofted_elements, s.nodes, number(s.area));
    if (const std::size_t n_planes = surface.analytic_planes.size(); n_planes > 0)
      planes += fmt::format("      analytic facets of {}: {}\n", surface.name, n_planes);
    total.claimed += s.claimed;
    total.owned += s.owned;
    total.triangles += s.triangles;
    total.quadrilaterals += s.quadrilaterals;
    total.lofted_elements += s.lofted_elements;
    total.nodes += s.nodes;
    total.area += s.area;
  }
  table.add("", "total", "", "", total.claimed, total.owned, total.triangles, total.quadrilaterals,
            total.lofted_elements, total.nodes, number(total.area));
  return table.format() + planes;
}

std::string format_lost_claims(const ContactModel& model) {
  TextTable table(
      6, 2,
      {name_column("surface", 28), name_column("lost to", 28), {"faces", 9}, {"lofted", 9}, {"nodes", 9}});
  for (const ContactSurface& surface : model.surfaces.surfaces) {
    for (const LostClaims& lost : surface.lost_to) {
      table.add(surface.name, model.surfaces.surfaces[lost.winner].name, lost.faces, lost.lofted, lost.nodes);
    }
  }
  return table.empty() ? "" : "\nClaims lost to earlier surfaces\n" + table.format();
}

std::string format_warnings(const ContactModel& model) {
  if (model.surfaces.warnings.empty()) return "";
  TextTable table(6, 1, {name_column("id", 28), {"count", 9}, {"line", 6}, text_column("text")});
  for (const SurfaceWarning& warning : model.surfaces.warnings) {
    table.add(warning.id, warning.count, warning.location.line, warning.text);
  }
  return "\nWarnings about surfaces\n" + table.format();
}

Json to_json(const ContactModel& model, const ContactSurface& surface, const SurfaceSummary& s) {
  Json lost = Json::array();
  for (const LostClaims& claims : surface.lost_to) {
    lost.push_back({{"surface", model.surfaces.surfaces[claims.winner].name},
                    {"faces", claims.faces},
                    {"lofted", claims.lofted},
                    {"nodes", claims.nodes}});
  }
  Json json{{"name", surface.name},
            {"kind", surface.kind == SurfaceKind::face ? "face" : "node"},
            {"command", surface.command},
            {"line", surface.location.line},
            {"claimed", s.claimed},
            {"owned", s.owned},
            {"triangles", s.triangles},
            {"quadrilaterals", s.quadrilaterals},
            {"area", rounded(s.area)},
            {"nodes", s.nodes},
            {"lofted",
             {{"elements", s.lofted_elements},
              {"top", s.top},
              {"bottom", s.bottom},
              {"side", s.side},
              {"prisms", s.prisms},
              {"spheres", s.spheres}}}};
  if (!surface.analytic_planes.empty()) json["analytic"] = surface.analytic_planes.size();
  json["lost_to"] = std::move(lost);
  return json;
}

Json to_json(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

Json to_json(const ContactModel& model, const SurfacePair& pair) {
  const bool is_face_face = pair.formulation == ConstraintFormulation::face_face;
  const bool is_sliding = pair.behavior == InteractionBehavior::sliding;
  Json json{{"first", model.surfaces.surfaces[pair.first].name},
            {"second", model.surfaces.surfaces[pair.second].name},
            {"interaction", pair.interaction},
            {"line", pair.location.line},
            {"law", describe_law(*pair.law)},
            {"formulation", is_face_face ? "face_face" : "node_face"},
            {"one_sided", pair.is_one_sided},
            {"behavior", is_sliding ? "sliding" : "infinitesimal_sliding"},
            {"normal_tolerance", to_json(pair.normal_tolerance)},
            {"tangential_tolerance", to_json(pair.tangential_tolerance)},
            {"overlap_normal_tolerance", to_json(pair.overlap_normal_tolerance)},
            {"overlap_tangential_tolerance", to_json(pair.overlap_tangential_tolerance)},
            {"capture_tolerance", to_json(pair.capture_tolerance)},
            {"penalty_scale", pair.penalty_scale},
            {"penalty_stiffness", to_json(pair.penalty_stiffness)},
            {"damping_fraction", pair.damping_fraction}};
  if (pair.search_distance || pair.tracking_distance || pair.closes_gaps()) {
    const auto or_auto = [](const auto& line) {
      return !line ? Json(nullptr) : line->given ? Json(*line->given) : Json("auto");
    };
    json["reach"] = {
        {"search_distance", or_auto(pair.search_distance)},
        {"tracking_distance", to_json(pair.tracking_distance)},
        {"gap_closure_tolerance", or_auto(pair.gap_closure)},
        {"adjust_node_set", pair.adjusted_nodes ? Json(pair.adjusted_nodes->text) : Json(nullptr)}};
  }
  if (!pair.separates) json["separation"] = false;
  if (pair.is_polar()) json["sides"] = {name_of(pair.sides[0]), name_of(pair.sides[1])};
  if (pair.gap != GapSettings{}) {
    json["gap"] = {{"contact_offset", to_json(pair.gap.contact_offset)},
                   {"initial_clearance", to_json(pair.gap.initial_clearance)},
                   {"ignore_initial_overlap", pair.gap.ignore_initial_overlap.value_or(false)},
                   {"overlap_ramp_time", to_json(pair.gap.overlap_ramp_time)}};
  }
  if (const StabilizationSettings& own = pair.stabilization; own.is_on()) {
    json["stabilization"] = {{"scale", *own.scale},
                             {"tangential_fraction", to_json(own.tangential_fraction)},
                             {"remaining_fraction", to_json(own.remaining_fraction)},
                             {"range", to_json(own.range)}};
  }
  if (pair.smoothing) json["smoothing"] = model.smoothings[*pair.smoothing].name;
  return json;
}

}  // namespace

std::string format_surface_tables(const ContactModel& model, const SurfaceSummaries& summaries) {
  std::string text = "\nContact surfaces\n" + format_rows(model, summaries);
  if (model.surfaces.interior_faces_ignored > 0) {
    text += fmt::format("      {} faces between present blocks are no contact faces\n",
                        model.surfaces.interior_faces_ignored);
  }
  return text + format_lost_claims(model) + format_warnings(model);
}

std::string format_passed_over(const ContactModel& model, const Mesh& mesh) {
  const auto& blocks = model.surfaces.blocks_passed_over;
  if (blocks.empty()) return "";
  std::vector<std::string> names;
  for (const std::uint32_t block : blocks) names.push_back(mesh.name({EntityKind::block, block}));
  return fmt::format(
      "      passed over, as point masses, springs, dampers and cohesive elements have no surface: {}\n",
      fmt::join(names, ", "));
}

std::string format_surfaces_json(const ContactModel& model, const SurfaceSummaries& summaries) {
  Json surfaces = Json::array(), pairs = Json::array(), warnings = Json::array();
  for (const SurfaceIndex i : indices(summaries)) {
    surfaces.push_back(to_json(model, model.surfaces.surfaces[i], summaries[i]));
  }
  for (const SurfacePair& pair : model.pairs) pairs.push_back(to_json(model, pair));
  for (const SurfaceWarning& warning : model.surfaces.warnings) {
    warnings.push_back({{"id", warning.id},
                        {"line", warning.location.line},
                        {"surface", warning.surface},
                        {"count", warning.count},
                        {"text", warning.text}});
  }
  const Json json{{"schema", "contactsim-surfaces/1"},
                  {"surfaces", std::move(surfaces)},
                  {"interior_faces_ignored", model.surfaces.interior_faces_ignored},
                  {"warnings", std::move(warnings)},
                  {"pairs", std::move(pairs)}};
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string format_surfaces_csv(const ContactModel& model, std::span<const FacetRow> rows) {
  fmt::memory_buffer text;
  fmt::format_to(std::back_inserter(text), "surface,block,element,side,kind,area\n");
  for (const FacetRow& row : rows) {
    fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{:.{}g}\n",
                   csv_field(model.surfaces.surfaces[row.surface].name), csv_field(row.block), row.element,
                   row.side, row.kind, row.area, n_area_digits);
  }
  return fmt::to_string(text);
}

}  // namespace contactsim
