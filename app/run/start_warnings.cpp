// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/start_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>

#include "core/definition/contact.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// What of a side some tie holds.
struct TiedSide {
  std::size_t n_tied = 0, n_all = 0;
  bool has_nodes = false;  ///< nodes are counted, not faces

  bool is_partial() const { return n_tied < n_all; }
};

/// Counts what ties of a pair hold of one of its surfaces: of NODE_FACE its nodes, else its faces.
TiedSide count_tied(const ContactForce& force, PairIndex pair_index, const SurfacePair& pair,
                    std::uint32_t surface) {
  const ContactMesh& contact_mesh = force.contact_mesh();
  std::set<std::uint32_t> tied_faces, tied_nodes;
  force.visit_constraints([&](const InterfaceConstraint& tie) {
    if (tie.pair != pair_index) return;
    if (tie.is_node) {
      tied_nodes.insert(tie.first_entity);
    } else {
      tied_faces.insert({tie.first_entity, tie.second_entity});
    }
  });
  const auto count = [](const std::set<std::uint32_t>& tied, std::uint32_t begin, std::uint32_t end) {
    const auto first = tied.lower_bound(begin), last = tied.lower_bound(end);
    return TiedSide{static_cast<std::size_t>(std::distance(first, last)), end - begin, false};
  };
  if (pair.formulation == ConstraintFormulation::face_face)
    return count(tied_faces, contact_mesh.first_face[surface], contact_mesh.first_face[surface + 1]);
  TiedSide side = count(tied_nodes, contact_mesh.first_node[surface], contact_mesh.first_node[surface + 1]);
  side.has_nodes = true;
  return side;
}

/// Whether the deck names all that a surface has by side sets and node sets, and not the skin of a block, of
/// which a part may be meant.
bool is_of_sets(const ContactSurface& surface, const ContactDefinition& definition, const Mesh& mesh) {
  return std::ranges::any_of(definition.surface_commands, [&](const SurfaceCommand& command) {
    const auto are_sets = [&](const DeckName& name, const std::vector<DeckName>& items) {
      return fold(name.text) == fold(surface.name) && std::ranges::all_of(items, [&](const DeckName& item) {
               return mesh.find(EntityKind::side_set, item.text) ||
                      mesh.find(EntityKind::node_set, item.text);
             });
    };
    if (const auto* line = std::get_if<ContactSurfaceLine>(&command))
      return are_sets(line->name, line->items);
    if (const auto* line = std::get_if<ContactNodeSetLine>(&command))
      return are_sets(line->name, line->items);
    return false;
  });
}

std::string names_of(const SurfacePair& pair, const ContactModel& contact) {
  const auto& surfaces = contact.surfaces.surfaces;
  return fmt::format("{} to {}", surfaces[pair.first].name, surfaces[pair.second].name);
}

}  // namespace

IndexedVector<PairIndex, TiedArea> tied_areas(const ContactForce& force, const ContactModel& contact) {
  IndexedVector<PairIndex, TiedArea> areas(contact.pairs.size());
  force.visit_constraints([&](const InterfaceConstraint& tie) {
    ++areas[tie.pair].n_ties;
    areas[tie.pair].area += tie.area;
  });
  return areas;
}

void warn_of_empty_ties(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings) {
  const auto areas = tied_areas(force, contact);
  for (const PairIndex i : indices(areas)) {
    const SurfacePair& pair = contact.pairs[i];
    if (!row_of(*pair.law).holds_at_start || areas[i].n_ties > 0) continue;
    warnings.add_warning("tie-empty", pair.location,
                         fmt::format("{}: nothing is near enough to be tied", names_of(pair, contact)),
                         "the pair table has the smallest gap; CAPTURE TOLERANCE says how far ties reach");
  }
}

void warn_of_partial_ties(const ContactForce& force, const ContactModel& contact,
                          const ContactDefinition& definition, const Mesh& mesh, Diagnostics& warnings) {
  const auto areas = tied_areas(force, contact);
  for (const PairIndex i : indices(areas)) {
    const SurfacePair& pair = contact.pairs[i];
    if (!row_of(*pair.law).holds_at_start || areas[i].n_ties == 0) continue;
    std::optional<TiedSide> least;  // untied; a side that is tied as a whole is as the deck wants it
    bool is_whole = false;
    std::uint32_t of = pair.first;
    for (const std::uint32_t surface : {pair.second, pair.first}) {
      const bool gives_ties = surface == pair.second || !pair.is_one_sided;
      if (!gives_ties || !is_of_sets(contact.surfaces.surfaces[surface], definition, mesh)) continue;
      const TiedSide side = count_tied(force, i, pair, surface);
      is_whole |= !side.is_partial();
      if (least && least->n_all - least->n_tied <= side.n_all - side.n_tied) continue;
      least = side;
      of = surface;
    }
    if (is_whole || !least) continue;
    warnings.add_warning(
        "tie-partial", pair.location,
        fmt::format("{}: {} of the {} {} of '{}' are not tied", names_of(pair, contact),
                    least->n_all - least->n_tied, least->n_all, least->has_nodes ? "nodes" : "faces",
                    contact.surfaces.surfaces[of].name),
        "CAPTURE TOLERANCE says how far ties reach");
  }
}

void warn_of_idle_settings(const ContactModel& contact, Diagnostics& warnings) {
  std::set<std::string> reported;
  for (const SurfacePair& pair : contact.pairs) {
    if (pair.enforcement == Enforcement::penalty) continue;
    if (pair.penalty_scale == 1.0 && pair.damping_fraction == 0.0) continue;
    if (!reported.insert(to_string(pair.location)).second) continue;
    const bool is_scale = pair.penalty_scale != 1.0;
    warnings.add_warning("penalty-without-effect", pair.location,
                         fmt::format("{} has no effect where momentum is balanced",
                                     is_scale ? "PENALTY SCALE" : "CONTACT DAMPING FRACTION"),
                         "ENFORCEMENT = PENALTY pushes by elastic penalties");
  }
}

void warn_of_gaps(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings) {
  std::set<std::string> reported;
  const auto warn = [&](const SurfacePair& pair, const char* id, const std::string& text, const char* hint) {
    if (reported.insert(id + to_string(pair.location)).second)
      warnings.add_warning(id, pair.location, text, hint);
  };
  for (const PairIndex i : indices(contact.pairs)) {
    const SurfacePair& pair = contact.pairs[i];
    if (pair.gap == GapSettings{}) continue;
    if (force.rules()[i].only_ties()) {
      warn(
          pair, "gap-without-effect",
          fmt::format("{}: ties keep the gap that they find, whatever it counts as", names_of(pair, contact)),
          "GAP CLOSURE TOLERANCE moves the nodes before the tie is made");
      continue;
    }
    if (!pair.gap.initial_clearance) continue;
    const StartGapSummary start = force.rules().gap_offsets().summarize_start(i);
    if (start.n == 0 && !pair.is_from_defaults)
      warn(pair, "clearance-empty",
           fmt::format("{}: nothing is near enough to have the INITIAL CLEARANCE", names_of(pair, contact)),
           "the pair table has the smallest gap; NORMAL TOLERANCE says how far the search reaches");
    if (start.n_far > 0)
      warn(pair, "clearance-far",
           fmt::format("{}: {:.3g} counts as a gap of up to {:.3g}, more than faces are wide there",
                       names_of(pair, contact), *pair.gap.initial_clearance, start.widest),
           "a smaller NORMAL TOLERANCE leaves sides out that are far apart");
  }
}

void warn_of_edges(const ContactForce& force, const ContactModel& contact, Diagnostics& warnings) {
  std::vector<std::uint8_t> has_edges(contact.surfaces.surfaces.size(), 0);
  for (const ContactEdge& edge : force.contact_mesh().edges) {
    if (!edge.is_particle() && !edge.is_sharp()) has_edges[edge.surface] = 1;
  }
  for (const PairIndex i : indices(contact.pairs)) {
    const SurfacePair& pair = contact.pairs[i];
    if (has_edges[pair.first] == 0 || has_edges[pair.second] == 0) continue;
    bool only_pushes = true, ties = false;
    force.rules()[i].model.visit_models([&](const InterfaceLaw& law) {
      only_pushes = only_pushes && law.only_pushes();
      ties = ties || law.law == ContactLaw::tied;
    });
    if (only_pushes) continue;
    warnings.add_warning(
        "edges-without-law", pair.location,
        fmt::format("{}: where beams or trusses meet each other the law '{}' does not act: {}",
                    names_of(pair, contact), describe_law(*pair.law),
                    ties ? "they are neither tied nor kept apart where it ties"
                         : "they only push each other apart, with its friction"),
        "faces and nodes of the pair have the law; EDGE CONTACT = OFF takes edges out");
  }
}

}  // namespace contactsim
