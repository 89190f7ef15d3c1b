// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "app/run/energy_watch.hpp"
#include "app/run/interpenetration_warnings.hpp"
#include "app/run/pair_history_warnings.hpp"
#include "app/run/reach_warnings.hpp"
#include "app/run/simulation.hpp"
#include "app/run/smoothing_warnings.hpp"
#include "app/run/start_overlap.hpp"
#include "app/run/start_warnings.hpp"
#include "app/run/surface_sets.hpp"
#include "contact/output/surface_drawing.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/state_motion.hpp"
#include "io/exodus/surface_writer.hpp"
#include "io/files/write_text.hpp"

namespace contactsim {

namespace {

/// The nodes of all parts, ascending.
std::vector<NodeIndex> untied_nodes(std::span<const UntiedPart> parts) {
  std::set<NodeIndex> nodes;
  for (const UntiedPart& part : parts) nodes.insert(part.nodes.begin(), part.nodes.end());
  return {nodes.begin(), nodes.end()};
}

}  // namespace

RunContact::RunContact(const RunInput& input, const Model& model, Ranks& ranks)
    : input_(input),
      model_(model),
      mesh_(input.mesh),
      contact_(*input.contact),
      untied_(find_untied_parts(contact_, mesh_, input.region.contact->dash)),
      offset_overlaps_(find_offset_overlaps(input)),
      force_(ContactSetup{*input.region.contact, contact_, model,
                          input.procedure.time_control->time_stepping_blocks, input.definition.functions,
                          ranks}),
      begins_pressed_(input.earlier != nullptr && !input.procedure.transfers.empty() &&
                      input.earlier->contact_force() != nullptr),
      output_(force_, contact_, model),
      watch_(contact_, mesh_, input.overlaps),
      debug_(contact_debug_files(input.definition, input.region.contact->debug)) {}

void RunContact::add_to(OutputSettings& settings) {
  settings.variables = output_.variables();
  settings.other_names = contact_output_names();
  std::set<std::string> given;
  // A mesh that was written as results has such names already.
  const auto free_name = [&](const std::string& surface) {
    const auto is_taken = [&](const std::string& name) {
      return mesh_.find(EntityKind::side_set, name) || mesh_.find(EntityKind::node_set, name) ||
             given.contains(fold(name));
    };
    std::string name = "contact_" + surface;
    for (int i = 2; is_taken(name); ++i) name = fmt::format("contact_{}_{}", surface, i);
    given.insert(fold(name));
    return name;
  };
  for (const ContactSurface& surface : contact_.surfaces.surfaces) {
    if (auto sides = sides_of_surface(surface, mesh_); !sides.empty())
      settings.side_sets.push_back({0, free_name(surface.name), std::move(sides), {}});
    if (auto nodes = nodes_of_surface(surface, mesh_); !nodes.empty())
      settings.node_sets.push_back({0, free_name(surface.name), std::move(nodes), {}});
  }
  if (std::vector<NodeIndex> nodes = untied_nodes(untied_); !nodes.empty())
    settings.node_sets.push_back({0, free_name("untied"), std::move(nodes), {}});
}

void RunContact::follow_deaths(const FaceGroups& faces, std::vector<std::uint8_t> erodes,
                               bool makes_new_edges) {
  makes_new_edges_ = makes_new_edges;
  Diagnostics discarded;  // reported when the model was made
  OwnershipRules rules(find_surface_requests(input_.definition, input_.region, mesh_, discarded), mesh_,
                       input_.region.contact->subdomain);
  living_.emplace(std::move(rules), faces, erodes);
  free_nodes_.emplace(faces, std::move(erodes));
}

SurfaceChanges RunContact::update_for_deaths(const State& state, std::span<const ElementIndex> dead,
                                             std::span<const std::uint8_t> alive) {
  SurfaceChanges changes = living_->update_for_deaths(dead, contact_.surfaces);
  const auto has_lost_lofts = [](const SurfaceChange& change) { return change.lofted_lost > 0; };
  if (std::ranges::any_of(changes, has_lost_lofts)) {
    Diagnostics discarded;
    make_lofts(input_.definition, input_.region, mesh_, contact_, discarded);
  }
  free_nodes_->add(living_->rules(), dead, alive);
  alive_ = alive;
  force_.rebuild_surfaces(motion_of(state), free_nodes_->nodes(), makes_new_edges_);
  output_.renew();
  watch_.renumber();
  return changes;
}

RunContactCheckpoint RunContact::checkpoint(const State& state) {
  return {contact_.surfaces, *living_, *free_nodes_, force_.checkpoint(motion_of(state))};
}

void RunContact::restore(const State& state, const RunContactCheckpoint& checkpoint) {
  contact_.surfaces = checkpoint.surfaces;
  Diagnostics discarded;
  make_lofts(input_.definition, input_.region, mesh_, contact_, discarded);
  living_.emplace(checkpoint.living);
  free_nodes_.emplace(checkpoint.free_nodes);
  force_.restore(motion_of(state), checkpoint.force);
  output_.renew();
  watch_.renumber();
}

ContactMoment RunContact::moment_of(const State& state, const ContactKinematics& kinematics) const {
  return {kinematics, force_.rules(), state.coordinates, alive_, state.time};
}

void RunContact::watch(const State& state, const std::function<void()>& complete_coordinates) {
  // A look costs up to a step of a large model; load steps cost more than any look.
  constexpr int steps_between_looks = 10;
  const ContactMoment moment = moment_of(state, force_.kinematics());
  if (!watch_.is_look_due(moment, input_.procedure.implicit_by ? 1 : steps_between_looks)) return;
  complete_coordinates();
  watch_.look(moment);
}

void RunContact::archive(const State& state, StateArchive& saved) {
  force_.archive(motion_of(state), saved);
  watch_.archive(saved);
  energy_.archive(saved);
}

void RunContact::write_debug_files() {
  if (!debug_.facets.empty())
    write_facet_mesh(debug_.facets, draw_surfaces(contact_, mesh_, force_.contact_mesh()), "contact facets");
  if (!debug_.places.empty()) write_text(debug_.places, format_places_csv(force_, contact_, mesh_));
}

void RunContact::add_suffix(const std::string& suffix) {
  for (std::string* path : {&debug_.facets, &debug_.places}) {
    if (!path->empty()) *path += suffix;
  }
}

void RunContact::warn_of_start(Diagnostics& warnings) const {
  warn_of_empty_ties(force_, contact_, warnings);
  warn_of_edges(force_, contact_, warnings);
  warn_of_idle_settings(contact_, warnings);
  warn_of_reach(force_, contact_, *input_.region.contact, warnings);
  warn_of_gaps(force_, contact_, warnings);
  warn_of_smoothings(force_, contact_, mesh_, warnings);
  warn_of_sides(force_, contact_, mesh_, warnings);
  warn_of_partial_ties(force_, {contact_, *input_.region.contact, mesh_, untied_}, warnings);
  IndexedVector<PairIndex, double> stored;
  for (const PairStep& pair : force_.pair_steps()) stored.push_back(pair.stored);
  warn_of_overlaps(input_, input_.overlaps, stored, warnings);
  warn_of_offsets(contact_, offset_overlaps_, stored, warnings);
}

void RunContact::warn_of_end(const State& state, Diagnostics& warnings) {
  // Contact may have seen a trial last that is not the state.
  const Motion motion = motion_of(state);
  std::optional<ContactKinematics> now;
  if (watch_.has_several_bodies()) now.emplace(force_.kinematics().at(motion));
  watch_.look(moment_of(state, now ? *now : force_.kinematics()));
  if (!input_.procedure.implicit_by && state.energies.largest > energy_of_round_off(model_, state.dt))
    energy_.warn(contact_, state.energies, warnings);
  warn_of_depths(force_.histories(), contact_, mesh_, warnings);
  warn_of_interpenetration(force_, contact_, mesh_, watch_.all(), warnings);
  warn_of_strain(force_, contact_, mesh_, state, warnings);
  warn_of_small_sliding(force_.histories(), contact_, mesh_, warnings);
}

}  // namespace contactsim
