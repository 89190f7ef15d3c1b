// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/contact_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/run/start_warnings.hpp"
#include "core/base/pluralize.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// The nodes before the other side that no tie reaches, by their ids; "" of none.
std::string format_untied(const UntiedPart& part, const ContactModel& contact, const Mesh& mesh) {
  constexpr std::size_t max_nodes = 20;
  if (part.nodes.empty() || part.tied == 0.0) return "";
  std::string ids;
  for (const NodeIndex node : std::span(part.nodes).first(std::min(max_nodes, part.nodes.size())))
    ids += fmt::format(" {}", mesh.node_id(node));
  if (part.nodes.size() > max_nodes) ids += fmt::format(" and {} more", part.nodes.size() - max_nodes);
  return fmt::format("    {} of {} before the other side, gaps up to {:.4g}, not tied:{}\n",
                     pluralize(part.nodes.size(), "node"), contact.surfaces.surfaces[part.surface].name,
                     part.widest_gap, ids);
}

/// The SEARCH DISTANCE of each pair that has one.
std::string format_reach(const ContactForce& force, const ContactModel& contact) {
  std::string text;
  const StartReach& reach = force.rules().start_reach();
  for (const PairIndex i : indices(contact.pairs)) {
    const SurfacePair& pair = contact.pairs[i];
    if (!pair.search_distance) continue;
    text +=
        fmt::format("  search distance {:.6g}: {} to {}, {}\n", reach.distance(i),
                    contact.surfaces.surfaces[pair.first].name, contact.surfaces.surfaces[pair.second].name,
                    reach.has_any(i) ? "what is as near now" : "nothing is as near");
  }
  return text;
}

}  // namespace

std::string format_contact_start(const ContactForce& force, const ContactModel& contact,
                                 IndexedSpan<PairIndex, const UntiedPart> untied, const Mesh& mesh) {
  std::string text = format_reach(force, contact);
  const auto areas = tied_areas(force, contact);
  const auto& surfaces = contact.surfaces.surfaces;
  for (const PairIndex i : indices(areas)) {
    const SurfacePair& pair = contact.pairs[i];
    if (!row_of(*pair.law).holds_at_start) continue;
    text += fmt::format("  {}: {} to {}, {} over an area of {:.6g}\n", describe_law(*pair.law),
                        surfaces[pair.first].name, surfaces[pair.second].name,
                        pluralize(areas[i].n_ties, "tie"), areas[i].area) +
            format_untied(untied[i], contact, mesh);
  }
  const auto& faces = force.contact_mesh().faces;
  if (faces.empty()) return text;
  const auto by_stiffness = [](const ContactFace& a, const ContactFace& b) {
    return a.penalty_properties.stiffness < b.penalty_properties.stiffness;
  };
  const auto [least, most] = std::minmax_element(faces.begin(), faces.end(), by_stiffness);
  return text + fmt::format("  automatic penalty behind the faces from {:.6g} to {:.6g} force/length^3\n",
                            least->penalty_properties.stiffness, most->penalty_properties.stiffness);
}

std::string format_contact(const ContactForce& contact, bool is_static) {
  const ContactSearch& search = contact.search();
  const BroadPhaseCounts &faces = search.face_counts(), &nodes = search.node_counts();
  std::size_t n_ties = 0;
  contact.visit_constraints([&](const InterfaceConstraint&) { ++n_ties; });
  std::string text = "\nContact search\n";
  text += fmt::format("  {}, {}, {}\n", pluralize(contact.contact_mesh().faces.size(), "contact face"),
                      pluralize(contact.contact_mesh().n_nodes(), "contact node"), pluralize(n_ties, "tie"));
  text += fmt::format("  {}: trees built {} and refitted {} times, {:.6g} candidates in all, {} at the end\n",
                      pluralize(search.n_searches(), "global search", "global searches"),
                      faces.builds + nodes.builds, faces.refits + nodes.refits,
                      static_cast<double>(faces.candidates + nodes.candidates), contact.n_candidates());
  if (const std::size_t n_faces = contact.contact_mesh().faces.size(); n_faces > 0)
    text +=
        fmt::format("  contact takes {} bytes, {} per face\n", contact.bytes(), contact.bytes() / n_faces);
  if (!is_static)
    text += fmt::format("  contact lowers the stable time step by {:.3g} % at most\n",
                        100.0 * contact.lost_step_share());
  return text;
}

}  // namespace contactsim
