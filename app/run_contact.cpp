// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_contact.hpp"

#include <algorithm>

#include "app/contact_report.hpp"
#include "app/pair_report.hpp"
#include "contact/surface_drawing.hpp"
#include "io/surface_writer.hpp"
#include "io/write_text.hpp"

namespace contactsim {

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
  living_.emplace(std::move(rules), faces, std::span<const std::uint8_t>{}, contact_.surfaces);
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
  Motion motion{state.time, state.dt, state.coordinates, state.velocity};
  if (state.rotations.exist()) motion.angular_velocity = &state.rotations.velocity;
  force_.take_surfaces(motion, free_nodes_->nodes(), makes_new_edges_);
  output_.renew();
  return changes;
}

void RunContact::write_debug_files(const State& state) {
  if (!debug_.facets.empty())
    write_facet_mesh(debug_.facets, draw_surfaces(contact_, mesh_), "contact facets");
  if (!debug_.places.empty()) write_text(debug_.places, format_places_csv(force_, contact_, mesh_, state));
}

std::string RunContact::start_report(Diagnostics& warnings) const {
  warn_of_empty_ties(force_, contact_, warnings);
  return format_contact_start(force_, contact_);
}

std::string RunContact::report() const {
  return format_pair_histories(contact_, force_.histories()) + format_contact(force_);
}

}  // namespace contactsim
