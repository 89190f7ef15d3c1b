// SPDX-License-Identifier: BSD-3-Clause
#include "app/contact_report.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/counted.hpp"
#include "contact/friction_words.hpp"

namespace contactsim {

namespace {

/// Ties of a pair of surfaces.
struct TiedArea {
  std::size_t n_ties = 0;
  double area = 0.0;
};

std::vector<TiedArea> tied_areas(const ContactForce& force, const ContactModel& contact) {
  std::vector<TiedArea> areas(contact.pairs.size());
  for (std::size_t i = 0; i < force.held().size(); ++i) {
    const HeldPlace& tie = force.held()[i];
    ++areas[tie.pair].n_ties;
    areas[tie.pair].area += tie.area;
  }
  return areas;
}

bool holds_at_start(const FrictionLaw& law) {
  return std::holds_alternative<Tied>(law) || std::holds_alternative<SpringWeld>(law) ||
         std::holds_alternative<SurfaceWeld>(law) || std::holds_alternative<CohesiveZone>(law) ||
         std::holds_alternative<Threaded>(law);
}

std::string names_of(const SurfacePair& pair, const ContactModel& contact) {
  const auto& surfaces = contact.surfaces.surfaces;
  return fmt::format("{} to {}", surfaces[pair.first].name, surfaces[pair.second].name);
}

}  // namespace

std::string format_contact_start(const ContactForce& force, const ContactModel& contact) {
  std::string text;
  const auto areas = tied_areas(force, contact);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (!holds_at_start(contact.pairs[i].law)) continue;
    text += fmt::format("  {}: {}, {} over an area of {:.6g}\n", describe_law(contact.pairs[i].law),
                        names_of(contact.pairs[i], contact), counted(areas[i].n_ties, "tie"), areas[i].area);
  }
  const auto& faces = force.faces().faces;
  if (faces.empty()) return text;
  const auto by_stiffness = [](const ContactFace& a, const ContactFace& b) {
    return a.backing.stiffness < b.backing.stiffness;
  };
  const auto [least, most] = std::minmax_element(faces.begin(), faces.end(), by_stiffness);
  return text + fmt::format("  automatic penalty behind the faces from {:.6g} to {:.6g} force/length^3\n",
                            least->backing.stiffness, most->backing.stiffness);
}

void warn_of_empty_ties(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings) {
  const auto areas = tied_areas(force, contact);
  for (std::size_t i = 0; i < areas.size(); ++i) {
    const SurfacePair& pair = contact.pairs[i];
    if (!holds_at_start(pair.law) || areas[i].n_ties > 0) continue;
    warnings.add_warning("tie-empty", pair.location,
                         fmt::format("{}: nothing is near enough to be tied", names_of(pair, contact)),
                         "the pair table has the smallest gap; CAPTURE TOLERANCE says how far ties reach");
  }
}

std::string format_contact(const ContactForce& contact) {
  const ContactSearch& search = contact.search();
  const BroadPhaseCounts &faces = search.face_counts(), &nodes = search.node_counts();
  std::string text = "\nContact search\n";
  text +=
      fmt::format("  {}, {}, {}\n", counted(contact.faces().faces.size(), "contact face"),
                  counted(contact.faces().n_nodes(), "contact node"), counted(contact.held().size(), "tie"));
  text += fmt::format("  {}: trees built {} and refitted {} times, {:.6g} candidates in all, {} at the end\n",
                      counted(search.n_searches(), "global search", "global searches"),
                      faces.builds + nodes.builds, faces.refits + nodes.refits,
                      static_cast<double>(faces.candidates + nodes.candidates), contact.n_candidates());
  text += fmt::format("  contact lowers the stable time step by {:.3g} % at most",
                      100.0 * contact.step_share().share);
  return text + "\n";
}

}  // namespace contactsim
