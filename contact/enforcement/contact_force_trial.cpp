// SPDX-License-Identifier: BSD-3-Clause
// Contact in load steps: trials of which nothing is remembered, and multipliers.
#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "contact/enforcement/contact_force.hpp"
#include "contact/enforcement/contact_springs.hpp"
#include "core/definition/contact.hpp"

namespace contactsim {

void ContactForce::begin_trials(const Motion& motion) {
  if (mobility_.update(motion.time)) {
    kinematics_.hold(mobility_.free_directions());
    limit_stiffness(kinematics_of_mesh(contact_mesh_, *setup_.model.mesh));
  }
  rules_.activate(motion.time, times_.is_active(motion.time));
  kinematics_.move_nodes(motion);
  update_candidates(motion);
  depths_.begin_step(contact_mesh_);
  detection_.begin_step();
  if (!trial_)
    trial_ = std::make_unique<ContactTrial>(contact_mesh_, kinematics_, setup_.contact.pairs.size(),
                                            !assembler_.moments().empty());
  stabilization_.begin_step(kinematics_, motion);
  trial_->offsets = kinematics_.offsets();
  trial_->multipliers = multipliers_;
}

/// Moves the contact nodes to where a trial has them, and searches if that is too far off.
void ContactForce::move_to_trial(const Motion& motion) {
  kinematics_.set_offsets(trial_->offsets);
  kinematics_.step(motion);
  if (!detection_.is_due(kinematics_)) return kinematics_.bound_watched();
  detection_.undo_begin_step();
  detection_.find_candidates(motion, kinematics_);
  detection_.begin_step();
}

ContactStepContext ContactForce::static_context(double dt, bool is_trial) const {
  ContactStepContext context{kinematics_, rules_, constrained_, dt};
  context.depths = &depths_;
  context.is_static = true;
  context.is_trial = is_trial;
  context.multipliers = &multipliers_;
  context.held_slips = &held_slips_;
  context.weighted_gaps = &weighted_gaps_;
  if (is_trial && !trial_->slip_pressures.empty()) context.slip_pressures = &trial_->slip_pressures;
  return context;
}

void ContactForce::try_forces(const Motion& motion, Eigen::Matrix3Xd& forces, Eigen::Matrix3Xd* moments) {
  ContactTrial& trial = *trial_;
  move_to_trial(motion);
  trial.dt = motion.dt;
  const ContactStepContext context = static_context(motion.dt, true);
  detection_.weigh_gaps(context, weighted_gaps_);
  trial.assembler.begin_step();
  trial.points.clear();
  trial.constraints.clear();
  detection_.visit_points(context, [&](const ContactPoint& point) {
    if (point.touches()) trial.points.push_back(point);
  });
  for (const ContactPoint& point : trial.points) trial.assembler.add(point);
  detection_.detect_constraints(context, constrained_, trial.constraints);
  for (const ConstraintForces& held : trial.constraints) trial.assembler.add(held.constraint, held.forces);
  stabilization_.find_forces(kinematics_);
  stabilization_.add_to(trial.assembler);
  write_forces(trial.assembler, trial.moments, forces);
  if (moments != nullptr) trial.moments.set(setup_.model, *moments);
}

namespace {

/// What a surface node of a pair presses with.
struct MultiplierSums {
  double area = 0.0, depth_area = 0.0;  ///< [length^2] [length^3]
  double force = 0.0, stiffness = 0.0;  ///< [force] [force/length]

  void add(const ContactPoint& point) {
    area += point.area;
    depth_area -= point.area * point.open_gap();
    force += point.force;
    stiffness += point.stiffness;
  }
  ///   begin_gap  at which the pressure begins [length]
  void add(const WeightedNode& node, double begin_gap) {
    area += node.area;
    depth_area -= node.area * (node.gap + begin_gap);
    force += node.area * node.pressure;
    stiffness += node.area * node.slope;
  }
};

/// Whether weighted gaps of faces press a point of a load step.
bool is_of_weighted_gaps(const ContactPoint& point) {
  return !point.first.is_node() && !point.is_of_edges && !point.is_held_apart && !point.pulls;
}

}  // namespace

bool ContactForce::hold_slip_limits(bool does) {
  if (!does) {
    trial_->slip_pressures.set({});
    return false;
  }
  std::vector<SlipPressures::Entry> pressures;
  std::map<std::pair<PairIndex, SurfaceNodeIndex>, MultiplierSums> nodes;
  for (const ContactPoint& point : trial_->points) {
    const bool has_friction = point.is_of_node_and_face() && rules_.of(point).friction > 0.0;
    if (has_friction && point.force > 0.0) nodes[{point.pair, point.row()}].add(point);
  }
  for (const auto& [key, sum] : nodes) pressures.push_back({key.first, key.second, sum.force / sum.area});
  for (const WeightedNode& node : weighted_gaps_.nodes()) {
    if (node.has_friction()) pressures.push_back({node.pair, node.row, node.pressure});
  }
  trial_->slip_pressures.set(std::move(pressures));
  return !trial_->slip_pressures.empty();
}

void ContactForce::visit_springs(const std::function<void(const ContactSpring&)>& take) const {
  const ContactSprings springs(setup_.model, kinematics_, rules_);
  const auto motions = detection_.node_motions(static_context(trial_->dt, true));
  for (auto begin = motions.begin(), end = begin; begin != motions.end(); begin = end) {
    end =
        std::find_if(begin, motions.end(), [&](const auto& other) { return other.number != begin->number; });
    take(springs.spring_of(weighted_gaps_.nodes()[begin->number], {begin, end}));
  }
  const std::span<const ContactPoint> points = trial_->points;
  for (const ContactPoint& point : points) {
    if (!is_of_weighted_gaps(point)) take(springs.spring_of(point));
  }
  for (const ContactPoint& point : points) {
    if (is_of_weighted_gaps(point)) continue;
    if (const auto spring = springs.friction_spring_of(point, trial_->dt, !trial_->slip_pressures.empty()))
      take(*spring);
  }
  const auto ties = detection_.ties();
  for (const ConstraintForces& held : trial_->constraints) {
    const bool is_tie = held.index < ties.size() && ties[held.index].nodes == held.constraint.nodes;
    take(is_tie ? springs.spring_of(ties[held.index]) : springs.spring_of(held.constraint));
  }
  stabilization_.visit_springs(springs, take);
}

namespace {

/// Whether the penalty alone presses what touches, which may part.
bool has_multipliers(const PairRule& rule) {
  return rule.pair->enforcement == Enforcement::augmented_lagrange && !rule.acts_apart() &&
         rule.pair->separates;
}

}  // namespace

MultiplierChange ContactForce::update_multipliers(double tolerance) {
  std::map<std::pair<PairIndex, SurfaceNodeIndex>, MultiplierSums> sums;
  // A node beyond a rim that no more than this share of its area lies before would hold the sliver by any
  // pressure: the penalty presses there.
  constexpr double sliver = 0.05;
  for (const WeightedNode& node : weighted_gaps_.nodes()) {
    if (!(node.area > sliver * contact_mesh_.surface_nodes[node.row].area)) continue;
    if (has_multipliers(rules_[node.pair]))
      sums[{node.pair, node.row}].add(node, rules_[node.pair].begin_gap);
  }
  for (const ContactPoint& point : trial_->points) {
    const bool is_free = !point.is_of_edges && !point.pulls && point.area > 0.0;
    if (is_of_weighted_gaps(point) || !is_free || !has_multipliers(rules_.of(point))) continue;
    if (weighted_gaps_.finer_surface(point.pair) != contact_mesh_.surface_nodes[point.row()].surface)
      continue;
    sums[{point.pair, point.row()}].add(point);
  }
  MultiplierChange change;
  std::vector<ContactMultipliers::Entry> entries;
  for (const auto& [key, sum] : sums) {
    const double before = multipliers_.value_or(key.first, key.second, 0.0);
    const double depth = std::max(0.0, before + sum.depth_area / sum.area);
    if (depth > 0.0) entries.push_back({key.first, key.second, depth});
    const double by = sum.stiffness * (depth - before);
    change.change += by * by;
    change.reference += sum.force * sum.force;
  }
  change.change = std::sqrt(change.change);
  change.reference = std::sqrt(change.reference);
  if (change.change > tolerance * change.reference) multipliers_.set(std::move(entries));
  return change;
}

Stabilization ContactForce::stabilization() const {
  Stabilization now{stabilization_.largest_share(), {}};
  for (const ContactNodeIndex node : stabilization_.nodes())
    now.nodes.push_back(contact_mesh_.mesh_nodes[node].value);
  return now;
}

/// The size of the smallest face: what comes in by that is pushed out to the side that it came from.
double ContactForce::longest_motion() const {
  double smallest = std::numeric_limits<double>::infinity();
  for (const SurfaceNode& node : contact_mesh_.surface_nodes)
    smallest = std::min(smallest, std::sqrt(node.area));
  return smallest;
}

void ContactForce::give_up_trials() {
  detection_.undo_begin_step();
  depths_.undo_begin_step();
  kinematics_.set_offsets(trial_->offsets);
  multipliers_ = trial_->multipliers;
}

ForceReport ContactForce::accept_trial(const Motion& motion, Eigen::Matrix3Xd& forces) {
  move_to_trial(motion);
  assembler_.begin_step();
  points_.clear();
  constraint_forces_.clear();
  assembler_.begin_work(kinematics_, motion.dt);
  const ContactStepContext context = static_context(motion.dt, false);
  detection_.weigh_gaps(context, weighted_gaps_);
  add_penalty_points(context);
  stabilization_.find_forces(kinematics_);
  stabilization_.add_to(assembler_);
  write_forces(assembler_, offset_moments_, forces);
  ForceReport report;
  report.stabilization_work = stabilization_.end_step(kinematics_);
  report.supplied_work = end_step(motion.time, motion.dt);
  report.friction_work = assembler_.dissipated();
  hold_slips();
  return report;
}

void ContactForce::hold_slips() {
  std::vector<HeldSlips::Entry> held;
  for (const WeightedNode& node : weighted_gaps_.nodes()) {
    if (node.has_friction()) held.push_back({node.pair, node.row, node.friction.elastic_slip});
  }
  held_slips_.set(std::move(held));
}

}  // namespace contactsim
