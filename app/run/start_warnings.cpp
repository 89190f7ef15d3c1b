// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/start_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

#include "app/run/idle_defaults.hpp"
#include "core/base/pluralize.hpp"
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
                    SurfaceIndex surface) {
  const ContactMesh& contact_mesh = force.contact_mesh();
  std::set<FaceIndex> tied_faces;
  std::set<SurfaceNodeIndex> tied_rows;
  force.visit_constraints([&](const InterfaceConstraint& tie) {
    if (tie.pair != pair_index) return;
    if (tie.is_node) {
      tied_rows.insert(tie.row());
    } else {
      tied_faces.insert({tie.first_face(), tie.second});
    }
  });
  const auto count = [](const auto& tied, const auto& range) {
    const auto first = tied.lower_bound(*range.begin()), last = tied.lower_bound(*range.end());
    return TiedSide{static_cast<std::size_t>(std::distance(first, last)), range.size(), false};
  };
  if (pair.formulation == ConstraintFormulation::face_face)
    return count(tied_faces, contact_mesh.faces_of(surface));
  TiedSide side = count(tied_rows, contact_mesh.rows_of(surface));
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

}  // namespace

std::string names_of(const SurfacePair& pair, const ContactModel& contact) {
  const auto& surfaces = contact.surfaces.surfaces;
  return fmt::format("{} to {}", surfaces[pair.first].name, surfaces[pair.second].name);
}

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
    if (!force.rules()[i].is_active) {
      warnings.add_warning("tie-empty", pair.location,
                           fmt::format("{}: ties are made at the start, when this interaction is not active",
                                       names_of(pair, contact)),
                           "a TIME VARIANT MODEL ties in later periods");
      continue;
    }
    warnings.add_warning(
        "tie-empty", pair.location,
        fmt::format("{}: nothing is near enough to be tied", names_of(pair, contact)),
        pair.search_distance
            ? "the pair table has the smallest gap; ties reach no farther than CAPTURE "
              "TOLERANCE and SEARCH DISTANCE say"
            : "the pair table has the smallest gap; CAPTURE TOLERANCE says how far ties reach");
  }
}

namespace {

/// The side of sets of a pair of which most is free; nothing when a side is tied as a whole, as the deck
/// wants it, or none is of sets.
std::optional<std::pair<SurfaceIndex, TiedSide>> find_free_side(const ContactForce& force,
                                                                const TiedContact& tied, PairIndex i) {
  const SurfacePair& pair = tied.contact.pairs[i];
  std::optional<std::pair<SurfaceIndex, TiedSide>> least;
  for (const SurfaceIndex surface : {pair.second, pair.first}) {
    const bool gives_ties = surface == pair.second || !pair.is_one_sided;
    if (!gives_ties || !is_of_sets(tied.contact.surfaces.surfaces[surface], tied.definition, tied.mesh))
      continue;
    const TiedSide side = count_tied(force, i, pair, surface);
    if (!side.is_partial()) return std::nullopt;
    if (!least || least->second.n_all - least->second.n_tied > side.n_all - side.n_tied)
      least = std::pair(surface, side);
  }
  return least;
}

}  // namespace

void warn_of_partial_ties(const ContactForce& force, const TiedContact& tied, Diagnostics& warnings) {
  const auto areas = tied_areas(force, tied.contact);
  const auto& surfaces = tied.contact.surfaces.surfaces;
  constexpr const char* hint = "CAPTURE TOLERANCE says how far ties reach";
  for (const PairIndex i : indices(areas)) {
    const SurfacePair& pair = tied.contact.pairs[i];
    if (!row_of(*pair.law).holds_at_start || areas[i].n_ties == 0) continue;
    const UntiedPart& part = tied.untied[i];
    if (part.is_partial()) {
      warnings.add_warning(
          "tie-partial", pair.location,
          fmt::format("{}: {:.4g} of the area of {:.4g} of '{}' before the other side is tied; {} not, over "
                      "gaps up to {:.3g}",
                      names_of(pair, tied.contact), part.tied, part.tied + part.untied,
                      surfaces[part.surface].name, pluralize(part.nodes.size(), "node is", "nodes are"),
                      part.widest_gap),
          hint);
      continue;
    }
    const auto free = find_free_side(force, tied, i);
    if (!free) continue;
    const TiedSide& side = free->second;
    warnings.add_warning("tie-partial", pair.location,
                         fmt::format("{}: {} of the {} {} of '{}' are not tied", names_of(pair, tied.contact),
                                     side.n_all - side.n_tied, side.n_all, side.has_nodes ? "nodes" : "faces",
                                     surfaces[free->first].name),
                         hint);
  }
}

namespace {

bool has_friction(const FrictionLaw& law) { return law.values.real("friction coefficient") > 0.0; }

/// Whether a surface has sides of shells, by lofts or by side sets.
bool has_shells(const ContactForce& force, const Mesh& mesh, SurfaceIndex surface) {
  const ContactMesh& contact_mesh = force.contact_mesh();
  return std::ranges::any_of(contact_mesh.faces_of(surface), [&](FaceIndex face) {
    const ElementIndex element = contact_mesh.faces[face].side.element();
    return topology(mesh.blocks()[mesh.block_of(element)].shape).family == Family::shell;
  });
}

/// Whether SIDES of a pair names a side that some shell of it has.
bool is_polar_of_shells(const ContactForce& force, const Mesh& mesh, const SurfacePair& pair) {
  return (pair.sides[0] != ShellSides::both && has_shells(force, mesh, pair.first)) ||
         (pair.sides[1] != ShellSides::both && has_shells(force, mesh, pair.second));
}

}  // namespace

void warn_of_sides(const ContactForce& force, const ContactModel& contact, const Mesh& mesh,
                   Diagnostics& warnings) {
  std::set<std::string> reported;
  for (const PairIndex i : indices(contact.pairs)) {
    const SurfacePair& pair = contact.pairs[i];
    const auto warn = [&](const char* id, const char* text, const char* hint) {
      if (reported.insert(id + to_string(pair.location)).second)
        warnings.add_warning(id, pair.location, fmt::format("{}: {}", names_of(pair, contact), text), hint);
    };
    if (!pair.separates && force.rules()[i].only_ties())
      warn("separation-without-effect", "SEPARATION = OFF has no effect on ties, which do not part",
           "it is for what touches and slides");
    if (pair.is_polar() && !is_polar_of_shells(force, mesh, pair) && !pair.is_from_defaults)
      warn("sides-without-shells", "SIDES has no effect: no shell has the side that it names",
           "with SIDE A and SIDE B it is of SIDE A");
  }
  const SurfacePair* idle = find_idle_default(
      contact, [](const SurfacePair& pair) { return pair.is_polar(); },
      [&](PairIndex i) { return is_polar_of_shells(force, mesh, contact.pairs[i]); });
  if (idle != nullptr)
    warnings.add_warning("sides-without-shells", idle->location,
                         "SIDES has no effect: no pair of the defaults has a shell", "");
}

void warn_of_idle_settings(const ContactModel& contact, Diagnostics& warnings) {
  std::set<std::string> reported;
  for (const SurfacePair& pair : contact.pairs) {
    if (row_of(*pair.law).has_pressure && !has_friction(*pair.law) &&
        (pair.penalty_stiffness || pair.penalty_scale != 1.0)) {
      if (!reported.insert(to_string(pair.location)).second) continue;
      warnings.add_warning("penalty-without-effect", pair.location,
                           fmt::format("{} has no effect beside the law '{}', which presses by itself",
                                       pair.penalty_stiffness ? "PENALTY STIFFNESS" : "PENALTY SCALE",
                                       describe_law(*pair.law)),
                           "with friction it would be the spring along the surface");
    }
    if (pair.enforcement != Enforcement::momentum_balance) continue;
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
  IndexedVector<SurfaceIndex, std::uint8_t> has_edges(contact.surfaces.surfaces.size(), 0);
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
