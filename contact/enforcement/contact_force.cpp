// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_force.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "contact/enforcement/finer_surfaces.hpp"
#include "contact/enforcement/penalty_limits.hpp"
#include "contact/enforcement/returned_energy.hpp"
#include "contact/enforcement/side_thickness.hpp"
#include "contact/formulations/mark_start_reach.hpp"
#include "contact/formulations/node_gaps.hpp"
#include "contact/formulations/start_depths.hpp"
#include "contact/interface_laws/make_interface_laws.hpp"
#include "core/base/errors.hpp"
#include "core/base/memory_pages.hpp"
#include "core/base/prefetch.hpp"
#include "core/base/threads.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

namespace {

std::vector<ActiveTimes> active_times(const ContactSetup& setup) {
  std::vector<ActiveTimes> times;
  for (const SurfacePair& pair : setup.contact.pairs)
    times.push_back(make_active_times(pair.periods, setup.time_stepping_blocks));
  return times;
}

/// Whether there are rods or particles, whose surface is beside their nodes: as edges, or by EDGE CONTACT =
/// OFF as nodes alone.
bool has_round_bodies(const ContactMesh& mesh) {
  return std::ranges::any_of(mesh.edges, [](const ContactEdge& edge) { return !edge.is_sharp(); }) ||
         std::ranges::any_of(mesh.surface_nodes, [](const SurfaceNode& node) { return node.radius > 0.0f; });
}

/// The pairs with their friction models. That these are right has been checked before.
PairRules make_rules(const ContactSetup& setup) {
  PairRules rules(setup.contact.pairs, active_times(setup), setup.contact.surfaces.surfaces.size());
  Diagnostics problems;
  auto laws = make_pair_laws(setup.contact.pairs,
                             {setup.definition.friction_models, setup.functions, setup.time_stepping_blocks},
                             problems);
  if (problems.has_errors()) throw DeckError(problems);
  rules.set_laws(std::move(laws));
  return rules;
}

}  // namespace

ContactForce::ContactForce(const ContactSetup& setup)
    : setup_(setup),
      contact_mesh_(make_faces({})),
      times_(make_active_times(setup.definition.periods, setup.time_stepping_blocks)),
      rules_(make_rules(setup)),
      turns_(make_turns()),
      kinematics_(contact_mesh_),
      mobility_(setup.model),
      detection_(setup_, contact_mesh_, rules_),
      assembler_(contact_mesh_.n_nodes(), setup.contact.pairs.size(), rules_.has_friction(),
                 has_round_bodies(contact_mesh_)),
      offset_moments_(contact_mesh_, kinematics_, assembler_),
      histories_(setup.contact.pairs.size()),
      recovery_energy_(setup.contact.pairs.size()),
      weighted_gaps_(find_finer_surfaces(setup.contact, contact_mesh_)),
      stabilization_(setup_, rules_, kinematics_of_mesh(contact_mesh_, *setup.model.mesh)) {
  kinematics_.turn_by(make_spins());
  balances_ = std::ranges::any_of(rules_.rules(), &PairRule::is_balanced);
  has_penalty_ = !std::ranges::all_of(rules_.rules(), &PairRule::is_balanced);
  balances_pulls_ = std::ranges::any_of(
      rules_.rules(), [](const PairRule& rule) { return rule.is_balanced && rule.may_act_apart(); });
}

/// The first time that forces are asked for: only now the elements' stable step is known.
void ContactForce::begin(const Motion& motion) {
  has_begun_ = true;
  start_step_ = motion.stable_step;
  limit_stiffness(kinematics_);
  forget_start_depths(contact_mesh_);
  mark_start_reach(setup_.contact, kinematics_, rules_);
  detection_.find_start_candidates(motion, kinematics_);
  const ContactStepContext context{kinematics_, rules_, constrained_, motion.dt};
  detection_.mark_close(context, rules_);
  detection_.find_constraints(context, false, constrained_);
  if (rules_.gap_offsets().needs_start()) {
    rules_.gap_offsets().set_start(detection_.find_start_gaps(context), motion.time);
    detection_.renew_reaches();
    detection_.find_candidates(motion, kinematics_);
  }
  detection_.end_start(motion, kinematics_);
}

/// Searches where something has moved far enough, or models have changed.
void ContactForce::update_candidates(const Motion& motion) {
  if (rules_.have_changed()) {
    detection_.find_start_candidates(motion, kinematics_);
    detection_.find_constraints({kinematics_, rules_, constrained_, motion.dt}, true, constrained_);
    detection_.end_start(motion, kinematics_);
  } else if (detection_.is_due(kinematics_)) {
    detection_.find_candidates(motion, kinematics_);
  }
}

/// Adds a contact point whose forces are known to all sums.
void ContactForce::add_to_sums(const ContactPoint& point) {
  assembler_.add(point);
  if (point.open_gap() < 0.0) assembler_.note_penetration(point, thinner_side(contact_mesh_, point));
  const double ramped = rules_.gap_offsets().ramped_depth(point);
  if (ramped > 0.0) assembler_.note_ramp(point, ramped);
  if (rules_[point.pair].pair->behavior == InteractionBehavior::infinitesimal_sliding)
    histories_.note_slide(point, contact_mesh_);
  depths_.note(kinematics_, point);
}

/// Adds the forces of ties and bonds to all sums, and ties what is to be glued.
void ContactForce::add_constraints(const ContactStepContext& context, std::span<const ContactPoint> to_glue) {
  const std::size_t n_before = constraint_forces_.size();
  detection_.detect_constraints(context, constrained_, constraint_forces_);
  for (const ConstraintForces& held : std::span(constraint_forces_).subspan(n_before))
    assembler_.add(held.constraint, held.forces);
  detection_.glue(context, to_glue, constrained_);
}

/// The contact points of pairs that are enforced by penalty, and interface constraints.
void ContactForce::add_penalty_points(const ContactStepContext& context) {
  std::vector<ContactPoint> to_glue;
  if (has_penalty_) {
    to_glue = detection_.visit_points(context, [&](const ContactPoint& point) { points_.push_back(point); });
    if (context.dt > 0.0 && !context.is_static) {
      const auto energy = histories_.update_available_energy(rules_, assembler_);
      limit_returned_energy(kinematics_, assembler_.work(), {energy, histories_.min_energy()},
                            mobility_.find_accelerations(kinematics_, points_), points_);
    }
    for (const ContactPoint& point : points_) add_to_sums(point);
  }
  add_constraints(context, to_glue);
}

void ContactForce::write_forces(const ContactAssembler& assembler, OffsetMoments& moments,
                                Eigen::Matrix3Xd& forces) {
  const auto nodes = assembler.nodes();
  const auto n_mesh_points = static_cast<std::uint32_t>(contact_mesh_.n_mesh_points());
  const IndexRange<ContactNodeIndex> of_lofts({n_mesh_points}, *contact_mesh_.nodes().end());
  // Several points of lofts may hang on one node of the mesh.
  for (const ContactNodeIndex i : of_lofts) forces.col(contact_mesh_.mesh_nodes[i].value).setZero();
  parallel_for(n_mesh_points, threads_for(n_mesh_points), [&](std::uint32_t i) {
    forces.col(contact_mesh_.mesh_nodes[{i}].value) = nodes[{i}].head<3>();
  });
  for (const ContactNodeIndex i : of_lofts)
    forces.col(contact_mesh_.mesh_nodes[i].value) += nodes[i].head<3>();
  moments.add_forces(forces);
}

void ContactForce::set_moments(const Motion& /*motion*/, Eigen::Matrix3Xd& moments) {
  offset_moments_.set(setup_.model, moments);
}

void ContactForce::begin_step(const Motion& motion) {
  assembler_.begin_step();
  points_.clear();
  constraint_forces_.clear();
  assembler_.begin_work(kinematics_, motion.dt);
  depths_.begin_step(contact_mesh_);
  detection_.begin_step();
}

ForceReport ContactForce::set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) {
  const bool is_first = !has_begun_;
  // Later on only contact nodes ever have another value.
  if (is_first) set_zero_without_memory(forces);
  for (const NodeIndex node : std::exchange(left_, {})) forces.col(node.value).setZero();
  const bool have_conditions_changed = mobility_.update(motion.time);
  if (have_conditions_changed) {
    kinematics_.hold(mobility_.free_directions());
    balance_.forget_mobility();
  }
  kinematics_.step(motion);
  rules_.activate(motion.time, times_.is_active(motion.time));
  if (have_conditions_changed && !is_first)
    limit_stiffness(kinematics_of_mesh(contact_mesh_, *setup_.model.mesh));
  if (is_first) {
    begin(motion);
  } else {
    update_candidates(motion);
  }
  begin_step(motion);
  ContactStepContext context =
      setup_.is_static()
          ? static_context(motion.dt, false)
          : ContactStepContext{kinematics_, rules_, constrained_, motion.dt, motion.stable_step, &depths_};
  if (has_penalty_) detection_.begin_narrow_phase(context, kinematics_);
  if (setup_.is_static()) detection_.weigh_gaps(context, weighted_gaps_);
  add_penalty_points(context);
  if (preload_forces_.is_to_begin() && !balances_) begin_preload_forces(context, motion.time);
  const double let_go = preload_forces_.work(kinematics_, motion.time, motion.dt);
  preload_forces_.add_to(assembler_, motion.time);
  write_forces(assembler_, offset_moments_, forces);
  if (is_first) {
    set_start_depths(points_, contact_mesh_);
    stored_at_start_ = stored();
    histories_.begin(assembler_);
  }
  ForceReport report;
  report.supplied_work = let_go;
  if (!balances_) report.supplied_work += end_step(motion.time, motion.dt);
  report.friction_work = assembler_.dissipated();
  report.contact_damping_work = assembler_.damped();
  if (!setup_.is_static())
    report.stable_step = step_limit_.find(motion.stable_step, step_springs(), mobility_);
  return report;
}

double ContactForce::end_step(double time, double dt) {
  assembler_.end_step(turns_);
  const double supplied = histories_.add(assembler_, rules_.gap_offsets(), dt);
  std::vector<LostContact> lost;
  detection_.find_lost(lost);
  histories_.add_lost(lost, rules_, contact_mesh_, time);
  return supplied;
}

std::optional<ForceReport> ContactForce::balance(const State& state, Eigen::Matrix3Xd& forces) {
  if (!balances_) return std::nullopt;
  kinematics_.foresee(state);
  ContactStepContext context{kinematics_, rules_, constrained_, state.dt};
  context.depths = &depths_;
  context.balances = true;
  context.coming_dt = state.next_dt;
  detection_.begin_narrow_phase(context, kinematics_);
  balance_.begin(setup_.model, mobility_.free_directions(), kinematics_, state);
  recovery_energy_.begin_step(rules_, histories_.all());
  const auto to_glue = detection_.visit_points(context, [&](const ContactPoint& point) {
    balance_.add(point, rules_.of(point), thinner_side(contact_mesh_, point));
  });
  detection_.visit_balanced(context, [&](Tie& tie) { balance_.add(tie); });
  if (preload_forces_.is_to_begin()) {
    balance_.spread_pressed();
    begin_preload_forces(context, state.time);
    for (const PreloadForces::Entry& held : preload_forces_.entries())
      balance_.push(held.node, held.force, held.moment);
    preload_forces_.add_to(assembler_, state.time);
  }
  balance_report_ =
      balance_.solve(static_cast<int>(setup_.definition.enforcement.balance_iterations), recovery_energy_);
  const auto balanced = balance_.points();
  for (std::size_t i = 0; i < balanced.size(); ++i) {
    prefetch(balanced[std::min(i + 4, balanced.size() - 1)]);
    add_to_sums(balanced[i]);
  }
  add_constraints(context, to_glue);
  if (preload_forces_.is_settling()) preload_forces_.settle(assembler_);
  if (points_.empty()) {
    balance_.swap_points(points_);
  } else {
    points_.insert(points_.end(), balance_.points().begin(), balance_.points().end());
  }
  if (balances_pulls_) step_limit_.note_pulls(step_springs(), mobility_);
  write_forces(assembler_, offset_moments_, forces);
  ForceReport report;
  report.supplied_work = end_step(state.time, state.dt);
  report.balanced_nodes = balance_.mesh_nodes();
  const ContactLoss& loss = balance_.loss();
  report.friction_work = last_loss_.friction_after + loss.friction_before;
  report.impact_work = last_loss_.impact_after + loss.impact_before;
  last_loss_ = loss;
  return report;
}

IndexedVector<ContactNodeIndex, double> ContactForce::node_gaps(const Motion& motion) const {
  ContactKinematics now = kinematics_;
  now.bound_all();
  return find_node_gaps(now, *setup_.model.mesh, rules_, setup_.definition.dash, motion);
}

double ContactForce::stored() const {
  double sum = 0.0;
  for (const PairStep& pair : assembler_.pairs()) sum += pair.stored;
  return sum;
}

}  // namespace contactsim
