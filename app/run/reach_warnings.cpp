// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/reach_warnings.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>
#include <vector>

#include "app/run/idle_defaults.hpp"
#include "app/run/start_warnings.hpp"
#include "core/definition/contact.hpp"
#include "core/interface_laws/interface_law_table.hpp"

namespace contactsim {

namespace {

/// Whether something in a pair goes by its capture tolerance.
bool captures(const ContactForce& force, const SurfacePair& pair, PairIndex index) {
  const PairRule& rule = force.rules()[index];
  bool holds = row_of(*pair.law).holds_at_start || rule.far;
  rule.model.visit_models([&](const InterfaceLaw& law) {
    holds = holds || law.bond_law || law.law == ContactLaw::tied || law.law == ContactLaw::welded;
  });
  return holds;
}

/// The first pair of each interaction of which none goes by its capture tolerance.
std::vector<const SurfacePair*> find_idle_captures(const ContactForce& force, const ContactModel& contact) {
  std::map<std::string, std::pair<const SurfacePair*, bool>> by_place;
  for (const PairIndex i : indices(contact.pairs)) {
    const SurfacePair& pair = contact.pairs[i];
    if (!pair.capture_tolerance) continue;
    auto& found = by_place.try_emplace(to_string(pair.location), &pair, false).first->second;
    found.second = found.second || captures(force, pair, i);
  }
  std::vector<const SurfacePair*> idle;
  for (const auto& [place, found] : by_place) {
    if (!found.second) idle.push_back(found.first);
  }
  return idle;
}

/// Whether faces of a pair, or nodes and faces, meet the partners of the start alone.
bool keeps_partners(const ContactForce& force, const ContactModel& contact, PairIndex index) {
  const SurfacePair& pair = contact.pairs[index];
  if (pair.behavior != InteractionBehavior::infinitesimal_sliding || force.rules()[index].only_ties())
    return false;
  const auto has_faces = [&](SurfaceIndex surface) {
    return force.contact_mesh().faces_of(surface).size() > 0;
  };
  const auto has_plane = [&](SurfaceIndex surface) {
    return !contact.surfaces.surfaces[surface].analytic_planes.empty();
  };
  return (has_faces(pair.first) || has_faces(pair.second)) && !has_plane(pair.first) &&
         !has_plane(pair.second);
}

/// Whether the nodes that keep their faces are those of the larger side.
bool slides_by_larger_side(const ContactForce& force, const SurfacePair& pair) {
  if (pair.behavior != InteractionBehavior::infinitesimal_sliding || !pair.is_one_sided) return false;
  const ContactMesh& contact_mesh = force.contact_mesh();
  const auto area = [&](SurfaceIndex surface) {
    double sum = 0.0;
    for (const SurfaceNodeIndex row : contact_mesh.rows_of(surface))
      sum += contact_mesh.surface_nodes[row].area;
    return sum;
  };
  const bool has_faces = contact_mesh.faces_of(pair.first).size() > 0;
  return has_faces && area(pair.second) > area(pair.first);
}

}  // namespace

void warn_of_reach(const ContactForce& force, const ContactModel& contact,
                   const ContactDefinition& definition, Diagnostics& warnings) {
  const bool is_shared = definition.search.tolerance == SearchOptions::Tolerance::user_defined &&
                         definition.search.capture_tolerance;
  const bool any_captures = [&] {
    for (const PairIndex i : indices(contact.pairs)) {
      if (captures(force, contact.pairs[i], i)) return true;
    }
    return false;
  }();
  for (const SurfacePair* pair : find_idle_captures(force, contact)) {
    // One of SEARCH OPTIONS is for those that hold.
    const bool is_of_all = is_shared && pair->capture_tolerance == definition.search.capture_tolerance;
    if (is_of_all && any_captures) continue;
    warnings.add_warning(
        "capture-without-effect", pair->location,
        fmt::format("CAPTURE TOLERANCE has no effect: the law '{}' holds nothing at the start",
                    describe_law(*pair->law)),
        "GAP CLOSURE TOLERANCE moves nodes onto the other side");
  }
  for (const PairIndex i : indices(contact.pairs)) {
    const SurfacePair& pair = contact.pairs[i];
    if (pair.is_from_defaults) continue;
    if (slides_by_larger_side(force, pair))
      warnings.add_warning(
          "small-sliding-sides", pair.location,
          fmt::format("{}: the nodes of SIDE B keep their faces under INFINITESIMAL_SLIDING, "
                      "and SIDE B is the larger: what slides over it leaves its nodes behind",
                      names_of(pair, contact)),
          "name the side that slides SIDE B");
    if (pair.search_distance && !force.rules().start_reach().has_any(i)) {
      warnings.add_warning("search-distance-empty", pair.location,
                           fmt::format("{}: nothing is within the SEARCH DISTANCE of {:.4g}, so that they "
                                       "never meet",
                                       names_of(pair, contact), force.rules().start_reach().distance(i)),
                           "the pair table has the smallest gap");
    } else if (keeps_partners(force, contact, i) && !force.search().has_first_partners(i)) {
      warnings.add_warning("no-start-partner", pair.location,
                           fmt::format("{}: nothing stands before the other side at the start, so that they "
                                       "never meet under INFINITESIMAL_SLIDING",
                                       names_of(pair, contact)),
                           "SEARCH DISTANCE says how far apart partners may be");
    }
  }
  const SurfacePair* idle = find_idle_default(
      contact, [](const SurfacePair& pair) { return pair.search_distance.has_value(); },
      [&](PairIndex i) { return force.rules().start_reach().has_any(i); });
  if (idle != nullptr)
    warnings.add_warning("search-distance-empty", idle->location,
                         "nothing of any pair is within the SEARCH DISTANCE, so that none of them ever meets",
                         "the pair table has the smallest gaps");
}

}  // namespace contactsim
