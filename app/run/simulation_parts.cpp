// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/simulation_parts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "app/run/refusals.hpp"
#include "app/run/run_outputs.hpp"
#include "app/run/run_share.hpp"
#include "app/run/stop_on_errors.hpp"
#include "app/run/subcycle_refusals.hpp"
#include "app/run/transfer_refusals.hpp"
#include "contact/interface_laws/refuse_laws.hpp"
#include "core/base/memory_error.hpp"
#include "core/base/memory_pages.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/state_motion.hpp"
#include "core/interface_laws/interface_law_table.hpp"
#include "core/parallel/on_root.hpp"

namespace contactsim {

namespace {

/// Throws DeckError for what cannot be run.
Setup set_up_or_stop(const RunInput& input, Diagnostics& diagnostics) {
  refuse_what_is_missing(input, diagnostics);
  if (input.contact != nullptr) {
    const auto& control = input.procedure.time_control;
    const LawScope laws{
        input.region.contact->friction_models, input.definition.functions,
        control ? std::span(control->time_stepping_blocks) : std::span<const TimeSteppingBlock>{}};
    refuse_laws(input.contact->pairs, input.contact->surfaces.surfaces, laws, diagnostics);
  }
  stop_on_errors(diagnostics);
  const std::string doing = fmt::format("making a model of {} elements", input.mesh.n_elements());
  Setup setup = tell_lack_of_memory(doing, [&] { return set_up(input, diagnostics); });
  stop_on_errors(diagnostics);
  return setup;
}

std::unique_ptr<RunContact> make_contact(const RunInput& input, const Model& model, Ranks& ranks) {
  if (input.contact == nullptr) return nullptr;
  return tell_lack_of_memory("making contact faces and their search",
                             [&] { return std::make_unique<RunContact>(input, model, ranks); });
}

std::unique_ptr<RunDeath> make_death(const ConditionScope& scope, Setup& setup, const OutputPlan& outputs,
                                     RunContact* contact) {
  if (scope.region.element_deaths.empty()) return nullptr;
  return std::make_unique<RunDeath>(scope, setup.death_sets, outputs.variables(),
                                    DeathParts{setup.external, contact});
}

/// Has the last two steps be of equal size, so that none vanishes, and end at a time.
StepTarget make_last_target(double time) {
  const double round_off = 1e-12 * std::abs(time);
  return {[=](double now) { return time - now > round_off ? std::optional(time) : std::nullopt; }, 2};
}

}  // namespace

Simulation::Parts::Parts(const RunInput& run_input, RunSettings run_settings, Diagnostics& run_diagnostics)
    : input(run_input),
      settings(std::move(run_settings)),
      diagnostics(run_diagnostics),
      setup(set_up_or_stop(input, diagnostics)),
      scope{input.definition, input.region, input.procedure.time_control->time_stepping_blocks, input.mesh,
            diagnostics},
      contact(make_contact(input, setup.model, settings.ranks)),
      outputs(scope, setup.model,
              output_settings(input, settings, setup.model, contact.get(), [this] { complete_state(); })),
      death(make_death(scope, setup, outputs, contact.get())),
      restart(input, settings.ranks, diagnostics),
      marks(restart.stores() ? find_run_marks(input, setup.model) : std::vector<RunMark>{}),
      state(make_state(input.mesh.coordinates(), setup.model.blocks, setup.control.start_time(),
                       std::exchange(setup.initial.velocity, Eigen::Matrix3Xd(3, 0)),
                       setup.load_schedule || !setup.external.is_empty())),
      share(make_share(settings.ranks, input, setup, contact.get())),
      internal(setup.model, state, share.get()),
      shared_internal(make_shared_elements(setup, internal, share.get())),
      timed_internal(shared_internal ? static_cast<ForceTerm&>(*shared_internal) : internal),
      timed_external(setup.external),
      energy_warnings(setup.model, diagnostics, share.get()),
      load_step_warnings(diagnostics) {
  if (!setup.model.subcycles.empty()) {
    if (contact) refuse_subcycled_contact(scope, setup.model, contact->force().contact_mesh(), diagnostics);
    subcycler.emplace(setup.model, state);
  }
  stop_on_errors(diagnostics);
  if (share != nullptr && !setup.load_schedule) {
    outputs.share_among(*share);
    setup.external.follow(share->followed());
    if (death) death->share_among(*share, [this] { complete_state(); });
  }
  // A value of every node: not to be kept.
  set_initial_state(std::exchange(setup.initial, {}), setup.model.blocks, state);
  if (death) death->begin(state);
  if (contact) {
    timed_contact.emplace(contact->force());
    state.forces.contact.resize(3, input.mesh.n_nodes());
    set_zero_without_memory(state.forces.contact);  // few nodes are in contact
  }
  warn_of_new_contact();
  refuse_held_anew();
  if (!setup.load_schedule) return;
  const SolverSettings solver = input.region.solver.value_or(SolverSettings{});
  load_steps.emplace(setup.model, terms(), contact ? &contact->force() : nullptr, solver,
                     *setup.load_schedule, state);
  if (death) load_steps->follow_deaths(*death);
  load_step_warnings.begin(*load_steps, solver, death != nullptr);
}

Checkpoint Simulation::Parts::checkpoint() {
  const auto shifted_to = restart.shifts() ? std::optional(setup.control.start_time()) : std::nullopt;
  return {setup.model, state,   contact.get(), load_steps ? &*load_steps : nullptr,
          death.get(), outputs, shifted_to,    marks};
}

void Simulation::Parts::prepare_files() {
  outputs.add_suffix(restart.suffix());
  if (contact) contact->add_suffix(restart.suffix());
  check_files();
  if (settings.writes_pieces) warn_of_results_beside_pieces(outputs.paths(), diagnostics);
  for (StepTarget& target : outputs.step_targets()) setup.control.add_target(std::move(target));
  if (auto target = restart.step_target()) setup.control.add_target(std::move(*target));
  if (settings.ends_on_time) setup.control.add_target(make_last_target(setup.control.termination_time()));
}

void Simulation::Parts::check_files() const {
  std::vector<std::string> paths = outputs.paths();
  if (contact) std::ranges::copy(contact->paths(), std::back_inserter(paths));
  on_root(settings.ranks, [&] { check_output_paths(settings.kept_files, paths); });
}

std::optional<EarlyEnd> Simulation::Parts::find_end() {
  const auto found = outputs.check_termination(state);
  const bool removes_overlap_alone = contact && input.region.contact->overlap_removal.is_all_there_is;
  return removes_overlap_alone ? EarlyEnd{"OVERLAP REMOVAL ONLY"} : found;
}

/// Warns of contact that the procedure takes over nothing of, or not all.
void Simulation::Parts::warn_of_new_contact() {
  const ContactForce* earlier = setup.transfer ? std::as_const(*input.earlier).contact_force() : nullptr;
  if (earlier == nullptr) return;
  takes_over_contact = contact && setup.transfer->is_whole() && contact->force().is_like(*earlier);
  const auto warn = [&](std::string text) {
    diagnostics.add_warning("contact-begins-anew", input.procedure.transfers.front().name.location,
                            std::move(text));
  };
  if (!contact) {
    warn("contact of the procedure before is over: this one has none");
  } else if (!takes_over_contact) {
    warn(
        "contact begins anew in what touches: it has other surfaces or pairs than in the procedure before, "
        "or not all blocks are taken over, so that nothing holds or presses as it did there");
  }
}

bool Simulation::Parts::is_settling() const {
  return takes_over_contact && contact->force().preload_forces().is_settling();
}

/// Warns of contact of load steps that explicit contact does not press with by itself.
void Simulation::Parts::warn_of_preload() {
  constexpr double least_share = 0.01;
  const PreloadForces& preload = contact->force().preload_forces();
  if (!(preload.share_of_before() > least_share)) return;
  const auto is_elastic = [](const SurfacePair& pair) {
    return pair.enforcement == Enforcement::penalty && row_of(*pair.law).holding == ContactLaw::sliding;
  };
  const bool has_elastic = std::ranges::any_of(contact->model().pairs, is_elastic);
  diagnostics.add_warning(
      "contact-held", input.procedure.transfers.front().name.location,
      fmt::format(
          "{:.1f} % of the contact forces of the procedure before are not those of contact here; they "
          "are held and let go evenly until t = {:.6g}, the end of the first time stepping block",
          100.0 * preload.share_of_before(), preload.ends()),
      has_elastic
          ? "ENFORCEMENT = PENALTY presses by its overlaps alone, which multipliers of load steps have "
            "closed; ENFORCEMENT = MOMENTUM_BALANCE begins with the forces of the procedure before"
          : "a time stepping block of its own says how long that takes");
}

/// Refuses contact that holds what is near at the start where what has held it is not taken over.
void Simulation::Parts::refuse_held_anew() {
  if (!setup.transfer || !contact || takes_over_contact) return;
  refuse_held_without_transfer(contact->model().pairs, diagnostics);
  stop_on_errors(diagnostics);
}

void Simulation::Parts::take_over() {
  if (!setup.transfer) return;
  contactsim::take_over(*setup.transfer, input.earlier->model(), input.earlier->state(), setup.model, state);
  if (death) death->begin(state);
  if (!contact) return;
  // Not where deaths have left other surfaces.
  if (takes_over_contact && contact->force().is_like(*input.earlier->contact_force()))
    return contact->force().take_over(*input.earlier->contact_force(), motion_of(input.earlier->state(), 0.0),
                                      motion_of(state), setup.control.end_of_period(state.time));
  overlaps = find_start_overlaps(contact->model(), input.mesh.with_coordinates(state.coordinates),
                                 *input.region.contact);
  input.overlaps = overlaps;
}

bool Simulation::Parts::advance() {
  if (load_steps) return load_steps->advance();
  const bool was_settling = is_settling();
  contactsim::advance(setup.model, terms(), setup.control, state, share.get());
  if (was_settling && !is_settling()) warn_of_preload();
  return true;
}

void Simulation::Parts::complete_state() {
  if (share == nullptr || load_steps || complete_step == state.step) return;
  share->complete(state);
  complete_step = state.step;
}

void Simulation::Parts::complete_coordinates() {
  if (share != nullptr && !load_steps) share->gather_nodes(state.coordinates);
}

void Simulation::Parts::let_die() {
  const bool has_any = death->step(state);
  if (!load_steps || !has_any) return;
  load_steps->note_deaths();
  if (load_steps->report().has_deaths_left) load_step_warnings.note_deaths_left(state);
}

void Simulation::Parts::start_anew() {
  if (load_steps) return load_steps->start(setup.transfer.has_value());
  at_start = start(setup.model, terms(), setup.control, state, share.get());
  if (takes_over_contact) {
    // Contact has held before: it gives out nothing as the run begins, and counts from here on.
    Energies& energies = state.energies;
    energies.start += energies.error - energies.contact;
    energies.error = energies.contact = 0.0;
    if (!is_settling()) warn_of_preload();
  }
  if (contact) contact->warn_of_start(diagnostics);
  // The step of rigid bodies alone is a proposal; contact makes its stiffness after it.
  const bool is_bound = at_start.critical_element || contact;
  if (!is_bound || state.next_dt <= at_start.stable_step) return;
  diagnostics.add_warning("user-time-step", {},
                          fmt::format("the user time step {:.4g} is larger than the stable one, {:.4g}",
                                      state.next_dt, at_start.stable_step));
}

std::vector<PartTime> Simulation::Parts::times() const {
  // Trials of load steps ask contact for forces among all else that finds equilibrium.
  const bool has_own_contact = contact && !load_steps;
  const double of_contact = has_own_contact ? timed_contact->seconds() : 0.0;
  const double of_death = death ? death->seconds() : 0.0;
  const double of_subcycles = subcycler ? subcycler->seconds() : 0.0;
  const double known = timed_internal.seconds() + timed_external.seconds() + of_contact + output_seconds +
                       restart_seconds + of_death + of_subcycles;
  const char* rest = !load_steps ? "nodes" : contact ? "contact and equations" : "equations";
  std::vector<PartTime> parts{{"elements", timed_internal.seconds()},
                              {"loads", timed_external.seconds()},
                              {rest, whole_seconds - known},
                              {"log and files", output_seconds}};
  if (subcycler) parts.insert(parts.begin() + 1, {"elements, subcycled", of_subcycles});
  if (restart.stores()) parts.push_back({"restart files", restart_seconds});
  if (death) parts.push_back({"element death", of_death});
  if (has_own_contact) parts.insert(parts.begin() + 1, {"contact", of_contact});
  return parts;
}

}  // namespace contactsim
