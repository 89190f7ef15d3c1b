// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/contact_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/run/start_warnings.hpp"
#include "core/base/pluralize.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

std::string format_contact_start(const ContactForce& force, const ContactModel& contact) {
  std::string text;
  const auto areas = tied_areas(force, contact);
  const auto& surfaces = contact.surfaces.surfaces;
  for (const PairIndex i : indices(areas)) {
    const SurfacePair& pair = contact.pairs[i];
    if (!row_of(*pair.law).holds_at_start) continue;
    text += fmt::format("  {}: {} to {}, {} over an area of {:.6g}\n", describe_law(*pair.law),
                        surfaces[pair.first].name, surfaces[pair.second].name,
                        pluralize(areas[i].n_ties, "tie"), areas[i].area);
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

std::string format_contact(const ContactForce& contact) {
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
  text += fmt::format("  contact lowers the stable time step by {:.3g} % at most",
                      100.0 * contact.step_share().share);
  return text + "\n";
}

}  // namespace contactsim
