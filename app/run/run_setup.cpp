// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_setup.hpp"

#include <algorithm>

#include "app/run/simulation.hpp"
#include "core/base/errors.hpp"
#include "core/death/death_sets.hpp"
#include "core/definition/procedure.hpp"
#include "core/definition/region.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/discrete_steps.hpp"
#include "core/dynamics/make_rigid_bodies.hpp"
#include "core/mesh/element_checks.hpp"
#include "core/statics/static_elements.hpp"
#include "io/exodus/exodus_variables.hpp"

namespace contactsim {

namespace {

/// Whether any condition takes its values from the mesh file.
bool reads_variables(const Region& region) {
  const auto reads = [](const auto& conditions) {
    return std::any_of(conditions.begin(), conditions.end(),
                       [](const auto& condition) { return condition.variable.variable.has_value(); });
  };
  return reads(region.prescribed_conditions) || reads(region.nodal_loads) || reads(region.pressures) ||
         std::any_of(region.initial_conditions.begin(), region.initial_conditions.end(),
                     [](const InitialCondition& c) { return c.mesh_variable.variable.has_value(); });
}

/// Positions of the blocks that have elements.
std::vector<std::uint32_t> blocks_in_use(const Mesh& mesh) {
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    if (mesh.blocks()[i].n_elements > 0) blocks.push_back(i);
  }
  return blocks;
}

/// What moves by inertia in a procedure that has none.
void refuse_inertia(const RunInput& input, const InitialState& initial, Diagnostics& diagnostics) {
  if (!input.procedure.implicit_by) return;
  const DeckLocation& location = input.procedure.implicit_by->location;
  if (!initial.velocity.isZero(0.0) || !initial.angular_velocity.isZero(0.0))
    diagnostics.add_error(location, "an initial velocity in a quasi-static procedure is not supported",
                          "an INITIAL CONDITION sets it");
}

std::optional<LoadSchedule> find_load_schedule(const RunInput& input, Diagnostics& diagnostics) {
  if (!input.procedure.implicit_by) return std::nullopt;
  return make_load_schedule(input.definition, input.procedure, input.region, diagnostics);
}

std::optional<StateTransfer> find_transfer(const RunInput& input, const ConditionScope& scope,
                                           const Model& model) {
  if (input.earlier == nullptr || input.procedure.transfers.empty()) return std::nullopt;
  const Simulation& earlier = *input.earlier;
  StateTransfer transfer = find_state_transfer(scope, input.procedure.transfers, earlier.model(), model);
  // What load steps move by in their time is no motion.
  transfer.takes_velocities = earlier.load_steps() == nullptr;
  return transfer;
}

}  // namespace

Setup set_up(const RunInput& input, Diagnostics& diagnostics) {
  check_elements(input.mesh, blocks_in_use(input.mesh));
  Model model = make_model(input.definition, input.region, input.mesh, diagnostics);
  StoredVariables stored;
  const FiniteElementModel* elements = find_finite_element_model(input.definition, input.region);
  if (reads_variables(input.region) && elements != nullptr && !elements->omitted.empty()) {
    diagnostics.add_error(elements->omitted.front().location,
                          "blocks are omitted, and a condition has READ VARIABLE",
                          "values of the mesh file are for all of its blocks: make a mesh without these");
    throw DeckError(diagnostics);
  }
  if (reads_variables(input.region)) stored = read_stored_variables(input.mesh.path(), input.mesh);
  const ConditionScope scope{
      input.definition,  input.region, input.procedure.time_control->time_stepping_blocks,
      input.mesh,        diagnostics,  &stored,
      &model.rigid.nodes};
  model.kinematic_constraints = make_kinematic_constraints(scope);
  model.rotation_constraints = make_rotation_constraints(scope, model.inertia);
  model.rigid.kinematic_constraints = make_body_constraints(scope);
  model.rigid.rotation_constraints = make_body_rotation_constraints(scope);
  set_discrete_steps(model);
  if (!input.procedure.implicit_by) set_subcycles(scope, model);
  ExternalForce external = make_external_force(scope, model.mass, model.inertia);
  TimeStepControl control = make_time_step_control(input.procedure, input.region);
  InitialState initial = make_initial_state(scope, model.blocks);
  set_rigid_velocities(scope, model.rigid, initial.velocity);
  auto death_sets = find_death_sets(scope, model);
  refuse_inertia(input, initial, diagnostics);
  auto transfer = find_transfer(input, scope, model);
  if (input.procedure.implicit_by) make_static(model);
  if (transfer) keep_drilling(*transfer, input.earlier->model(), model);
  return {std::move(model),
          std::move(external),
          std::move(initial),
          std::move(control),
          find_load_schedule(input, diagnostics),
          std::move(death_sets),
          std::move(transfer)};
}

}  // namespace contactsim
