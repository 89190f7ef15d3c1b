// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_contact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "app/run/energy_watch.hpp"
#include "app/run/interpenetration_warnings.hpp"
#include "app/run/reach_warnings.hpp"
#include "app/run/simulation.hpp"
#include "app/run/smoothing_warnings.hpp"
#include "app/run/start_overlap.hpp"
#include "app/run/start_warnings.hpp"
#include "app/run/surface_sets.hpp"
#include "contact/output/surface_drawing.hpp"
#include "core/base/errors.hpp"
#include "core/base/pluralize.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/state_motion.hpp"
#include "core/interface_laws/interface_law_table.hpp"
#include "io/exodus/surface_writer.hpp"
#include "io/files/write_text.hpp"

namespace contactsim {

namespace {

/// Energy that contact makes is worth a warning when it is this share of the largest term.
constexpr double worrying_energy_share = 0.01;

/// Energy from nowhere that exceeds what was put in for so many steps will not go away.
constexpr int longest_runaway = 20;

/// What contact has given out that nothing had put into it [energy].
double made_by_contact(const ContactForce& force, const Energies& energies) {
  const double stored = force.stored() - force.stored_at_start();
  return stored + energies.friction + energies.contact_damping + energies.stabilization +
         std::max(energies.impact, 0.0) - energies.contact;
}

/// The pair that has made the most energy; the first without any pairs.
PairIndex find_culprit(IndexedSpan<PairIndex, const PairHistory> histories) {
  const auto most = std::ranges::max_element(histories, {}, &PairHistory::made);
  return index_of(histories, most);
}

/// The nodes of all parts, ascending.
std::vector<NodeIndex> untied_nodes(std::span<const UntiedPart> parts) {
  std::set<NodeIndex> nodes;
  for (const UntiedPart& part : parts) nodes.insert(part.nodes.begin(), part.nodes.end());
  return {nodes.begin(), nodes.end()};
}

}  // namespace

RunContact::RunContact(const RunInput& input, const Model& model)
    : input_(input),
      model_(model),
      mesh_(input.mesh),
      contact_(*input.contact),
      untied_(find_untied_parts(contact_, mesh_, input.region.contact->dash)),
      offset_overlaps_(find_offset_overlaps(input)),
      force_(ContactSetup{*input.region.contact, contact_, model,
                          input.procedure.time_control->time_stepping_blocks, input.definition.functions}),
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
  free_nodes_.emplace(living_->rules(), faces, std::move(erodes));
}

SurfaceChanges RunContact::update_for_deaths(const State& state, std::span<const ElementIndex> dead,
                                             std::span<const std::uint8_t> alive) {
  SurfaceChanges changes = living_->update_for_deaths(dead, contact_.surfaces);
  const auto has_lost_lofts = [](const SurfaceChange& change) { return change.lofted_lost > 0; };
  if (std::ranges::any_of(changes, has_lost_lofts)) {
    Diagnostics discarded;
    make_lofts(input_.definition, input_.region, mesh_, contact_, discarded);
  }
  free_nodes_->add(dead, alive);
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

void RunContact::watch(const State& state) {
  // A look costs up to a step of a large model; load steps cost more than any look.
  constexpr int steps_between_looks = 10;
  watch_.step(moment_of(state, force_.kinematics()), input_.procedure.implicit_by ? 1 : steps_between_looks);
}

void RunContact::archive(const State& state, StateArchive& saved) {
  force_.archive(motion_of(state), saved);
  watch_.archive(saved);
  saved.numbers("contact/made", made_.energy, made_.by_culprit, made_.culprit.value);
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

double RunContact::given_out_by_overlaps() const {
  double sum = 0.0;
  const auto histories = force_.histories();
  for (const PairIndex i : indices(histories)) {
    if (!force_.rules()[i].is_balanced) continue;
    const double made = std::max(0.0, histories[i].made());
    sum += begins_pressed_ ? made : std::min(made, force_.recovery_energy().of_overlaps(i));
  }
  return sum;
}

void RunContact::warn_of_energy(const Energies& energies, Diagnostics& warnings) const {
  if (made_.energy <= worrying_energy_share * energies.largest) return;
  warnings.add_warning(
      "contact-energy", contact_.pairs[made_.culprit].location,
      fmt::format("contact has given out up to {:.3g} of energy that nothing put in ({:.2g} % of the "
                  "largest term), most of it between {}: {:.3g}",
                  made_.energy, 100.0 * made_.energy / energies.largest, names_of(contact_, made_.culprit),
                  made_.by_culprit),
      "finer faces where corners meet, NODE_FACE or a CONTACT DAMPING FRACTION help");
}

void RunContact::warn_of_penetration(Diagnostics& warnings) const {
  constexpr double worrying = 0.1;  // of the thickness
  const auto histories = force_.histories();
  for (const PairIndex i : indices(histories)) {
    if (!(histories[i].deepest_share > worrying)) continue;
    const SurfacePair& pair = contact_.pairs[i];
    const bool is_penalty = pair.enforcement == Enforcement::penalty,
               is_soft = row_of(*pair.law).has_pressure;
    warnings.add_warning(
        "contact-penetration", pair.location,
        fmt::format("{} have penetrated each other by {:.3g}, {:.0f} % of the thickness behind them",
                    names_of(contact_, i), histories[i].deepest, 100.0 * histories[i].deepest_share),
        is_soft      ? "the pressure of its friction model lets them"
        : is_penalty ? "ENFORCEMENT = MOMENTUM_BALANCE lets nothing through"
                     : "");
  }
}

void RunContact::warn_of_lost(Diagnostics& warnings) const {
  const auto histories = force_.histories();
  for (const PairIndex i : indices(histories)) {
    const PairHistory& history = histories[i];
    if (history.n_lost == 0) continue;
    const SurfacePair& pair = contact_.pairs[i];
    const auto name = [&](SurfaceIndex surface) { return contact_.surfaces.surfaces[surface].name; };
    const NodeIndex node{history.lost_node};
    warnings.add_warning(
        "contact-lost", {},
        fmt::format(
            "contact of {} and {} ended at time {:.6g} at node {}, {:.3g} deep: one side has got past "
            "the other ({} in the run)",
            name(pair.first), name(pair.second), history.lost_time, mesh_.node_id(node), history.lost_depth,
            pluralize(history.n_lost, "place")));
  }
}

void RunContact::warn_of_small_sliding(Diagnostics& warnings) const {
  constexpr double worth_telling = 0.5;  // of a face
  const auto histories = force_.histories();
  const auto id = [&](std::uint32_t node) { return mesh_.node_id(NodeIndex{node}); };
  for (const PairIndex i : indices(histories)) {
    const PairHistory& history = histories[i];
    const SurfacePair& pair = contact_.pairs[i];
    if (history.slid_share > worth_telling)
      warnings.add_warning(
          "slid-off-partner", pair.location,
          fmt::format(
              "{} have slid off their faces of the start, at node {} by {:.2g} of a face; the plane of "
              "that face goes on there",
              names_of(contact_, i), id(history.slid_node), history.slid_share),
          "INTERACTION BEHAVIOR = SLIDING follows the surface");
    if (history.n_released > 0)
      warnings.add_warning(
          "start-face-lost", pair.location,
          fmt::format(
              "{}: {} lost their faces of the start to element death, the first at node {}; they slide "
              "since",
              names_of(contact_, i), pluralize(history.n_released, "place"), id(history.released_node)),
          "");
  }
}

void RunContact::stop_at_runaway(const State& state) {
  const Energies& e = state.energies;
  const double made = made_by_contact(force_, e) - given_out_by_overlaps();
  if (made > made_.energy) {
    made_ = {made, find_culprit(force_.histories())};
    made_.by_culprit = force_.histories()[made_.culprit].made();
  }
  const double put_in = std::max(0.0, e.start) + std::max(0.0, e.external) + std::max(0.0, -e.internal) +
                        force_.stored_at_start();
  // What comes out of overlaps by itself is not worth a word: all of the mass at a millionth of the model's
  // size in a step.
  constexpr double of_round_off = 1e-6 / std::numeric_limits<double>::epsilon();
  const double negligible = of_round_off * of_round_off * energy_of_round_off(model_, state.dt);
  const bool runs_away = made > std::max(put_in, negligible);
  n_runaway_steps_ = runs_away ? n_runaway_steps_ + 1 : 0;
  if (n_runaway_steps_ < longest_runaway || contact_.pairs.empty()) return;
  const PairIndex culprit = find_culprit(force_.histories());
  throw SolveError(
      state.time, fmt::format("contact between {} runs away: it has given out {:.3g} of energy from nowhere, "
                              "and all contact {:.3g}, more than all that was put into the model, {:.3g}",
                              names_of(contact_, culprit), force_.histories()[culprit].made(), made, put_in));
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
  ContactKinematics now = force_.kinematics();
  now.move_nodes(motion_of(state));
  watch_.look(moment_of(state, now));
  if (!input_.procedure.implicit_by && state.energies.largest > energy_of_round_off(model_, state.dt))
    warn_of_energy(state.energies, warnings);
  warn_of_lost(warnings);
  warn_of_penetration(warnings);
  warn_of_interpenetration(force_, contact_, mesh_, watch_.all(), warnings);
  warn_of_strain(force_, contact_, mesh_, state, warnings);
  warn_of_small_sliding(warnings);
}

}  // namespace contactsim
