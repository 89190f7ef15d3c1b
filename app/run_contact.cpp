// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_contact.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "app/contact_report.hpp"
#include "app/counted.hpp"
#include "app/pair_report.hpp"
#include "contact/surface_drawing.hpp"
#include "core/state_motion.hpp"
#include "io/surface_writer.hpp"
#include "io/write_text.hpp"

namespace contactsim {

namespace {

/// Energy that contact makes is worth a warning when it is this share of the largest term.
constexpr double worrying_share = 0.02;

}  // namespace

RunContact::RunContact(const RunInput& input, const Model& model)
    : input_(input),
      mesh_(input.mesh),
      contact_(*input.contact),
      force_(ContactSetup{*input.region.contact, contact_, model, input.procedure.time_control->blocks,
                          input.definition.functions}),
      output_(force_, contact_, model),
      debug_(contact_debug_files(input.definition, input.region.contact->debug)) {}

void RunContact::add_to(OutputSettings& settings) {
  settings.variables = output_.variables();
  for (const ContactSurface& surface : contact_.surfaces.surfaces) {
    if (!surface.faces.empty())
      settings.side_sets.push_back({0, "contact_" + surface.name, surface.faces, {}});
  }
}

void RunContact::follow_deaths(const FaceGroups& faces, std::vector<std::uint8_t> erodes,
                               bool makes_new_edges) {
  makes_new_edges_ = makes_new_edges;
  Diagnostics told;  // when the model was made
  ClaimRules rules(find_surface_requests(input_.definition, input_.region, mesh_, told), mesh_,
                   input_.region.contact->subdomain);
  living_.emplace(std::move(rules), faces, std::span<const std::uint8_t>{}, contact_.surfaces, erodes);
  free_nodes_.emplace(living_->rules(), faces, std::move(erodes));
}

std::vector<SurfaceChange> RunContact::bury(const State& state, std::span<const ElementIndex> dead,
                                            std::span<const std::uint8_t> alive) {
  std::vector<SurfaceChange> changes = living_->bury(dead, contact_.surfaces);
  const auto has_lost_lofts = [](const SurfaceChange& change) { return change.lofted_lost > 0; };
  if (std::ranges::any_of(changes, has_lost_lofts)) {
    Diagnostics told;
    make_lofts(input_.definition, input_.region, mesh_, contact_, told);
  }
  free_nodes_->add(dead, alive);
  force_.take_surfaces(motion_of(state), free_nodes_->nodes(), makes_new_edges_);
  output_.renew();
  return changes;
}

void RunContact::write_debug_files() {
  if (!debug_.facets.empty())
    write_facet_mesh(debug_.facets, draw_surfaces(contact_, mesh_), "contact facets");
  if (!debug_.places.empty()) write_text(debug_.places, format_places_csv(force_, contact_, mesh_));
}

void RunContact::add_suffix(const std::string& suffix) {
  for (std::string* path : {&debug_.facets, &debug_.places}) {
    if (!path->empty()) *path += suffix;
  }
}

void RunContact::warn_of_energy(const Energies& energies, Diagnostics& warnings) const {
  const double stored = force_.stored() - force_.stored_at_start();
  const double made = stored + energies.friction + energies.contact_damping - energies.contact;
  if (made <= worrying_share * energies.largest) return;
  warnings.add_warning(
      "contact-energy", {},
      fmt::format("contact has given out {:.3g} of energy that nothing put in ({:.2g} % of the "
                  "largest term)",
                  made, 100.0 * made / energies.largest),
      "finer faces where corners meet, NODE_FACE or a CONTACT DAMPING FRACTION help");
}

void RunContact::warn_of_lost(Diagnostics& warnings) const {
  const auto histories = force_.histories();
  for (std::size_t i = 0; i < histories.size(); ++i) {
    const PairHistory& history = histories[i];
    if (history.n_lost == 0) continue;
    const SurfacePair& pair = contact_.pairs[i];
    const auto name = [&](std::uint32_t surface) { return contact_.surfaces.surfaces[surface].name; };
    const NodeIndex node{history.lost_node};
    warnings.add_warning(
        "contact-lost", {},
        fmt::format(
            "contact of {} and {} ended at time {:.6g} at node {}, {:.3g} deep: one side has got past "
            "the other ({} in the run)",
            name(pair.first), name(pair.second), history.lost_time, mesh_.node_id(node), history.lost_depth,
            counted(history.n_lost, "place")));
  }
}

std::string RunContact::start_report(Diagnostics& warnings) const {
  warn_of_empty_ties(force_, contact_, warnings);
  return format_contact_start(force_, contact_);
}

std::string RunContact::report() const {
  return format_pair_histories(contact_, force_.histories()) + format_contact(force_);
}

}  // namespace contactsim
