// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "app/run/run_restart.hpp"
#include "app/run/simulation.hpp"
#include "core/dynamics/integrator.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"

/// What the log says of a run. Only format_wall_times holds times of the clock: the rest of two runs can be
/// compared with diff.
namespace contactsim {

/// Blocks with elements, formulation, law and mass; totals; the stable step at the start and what sets it.
std::string format_model(const Model& model, const StepReport& at_start);

/// How ranks share the run, and what they send in a step.
///   is_static  of load steps, in each of whose trials all ranks get the forces of all nodes
std::string format_ranks(const RankTraffic& traffic, bool is_static);

/// The files that the run writes; "" when there are none.
std::string format_paths(std::span<const std::string> paths);

/// The heading of the lines of steps.
std::string step_heading();

/// Step, time, step size, energies and their error as a share of the largest.
std::string format_step(const State& state);

/// The state that the run goes on from, or that there is none yet; "" when the deck asks for none.
std::string format_restart_source(const RunRestart& restart);

/// The states that were stored; "" when there was nothing to write.
std::string format_stored_states(const RunRestart& restart);

/// What was put into a run with contact and what has become of it.
///   stored_at_start        in springs of overlaps, before the first step [energy]
///   given_out_by_overlaps  by contact without springs, to part them: booked as < 0 where sides met [energy]
///   ramped  the same of overlaps that are ramped, whose work is external [energy]
std::string format_energy_balance(const Energies& energies, double stored_at_start,
                                  double given_out_by_overlaps, double ramped);

/// Times of the parts and the whole, steps and element-steps per second.
///   whole  seconds of the clock
std::string format_wall_times(std::span<const PartTime> parts, double whole, std::int64_t n_steps,
                              std::size_t n_elements);

}  // namespace contactsim
