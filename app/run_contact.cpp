// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_contact.hpp"

#include "app/contact_report.hpp"
#include "app/pair_report.hpp"
#include "contact/surface_drawing.hpp"
#include "io/surface_writer.hpp"
#include "io/write_text.hpp"

namespace contactsim {

RunContact::RunContact(const RunInput& input, const Model& model)
    : contact_(*input.contact),
      mesh_(input.mesh),
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

void RunContact::write_debug_files(const State& state) {
  if (!debug_.facets.empty())
    write_facet_mesh(debug_.facets, draw_surfaces(contact_, mesh_), "contact facets");
  if (!debug_.places.empty()) write_text(debug_.places, format_places_csv(force_, contact_, mesh_, state));
}

void RunContact::add_suffix(const std::string& suffix) {
  for (std::string* path : {&debug_.facets, &debug_.places}) {
    if (!path->empty()) *path += suffix;
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
