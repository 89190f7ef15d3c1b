// SPDX-License-Identifier: BSD-3-Clause
// Contact in load steps: trials of which nothing is remembered, and multipliers.
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
  depths_.begin_step(contact_mesh_.faces.size());
  detection_.begin_step();
  if (!trial_)
    trial_ = std::make_unique<ContactTrial>(contact_mesh_, kinematics_, setup_.contact.pairs.size(),
                                            !assembler_.moments().empty());
  trial_->offsets = kinematics_.offsets();
  trial_->multipliers = multipliers_;
  trial_->has_begun = true;
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
  return context;
}

void ContactForce::try_forces(const Motion& motion, Eigen::Matrix3Xd& forces, Eigen::Matrix3Xd* moments) {
  ContactTrial& trial = *trial_;
  move_to_trial(motion);
  trial.dt = motion.dt;
  const ContactStepContext context = static_context(motion.dt, true);
  trial.assembler.begin_step();
  trial.points.clear();
  trial.constraints.clear();
  detection_.visit_points(context, [&](const ContactPoint& point) {
    if (point.touches()) trial.points.push_back(point);
  });
  for (const ContactPoint& point : trial.points) trial.assembler.add(point);
  detection_.detect_constraints(context, constrained_, trial.constraints);
  for (const ConstraintForces& held : trial.constraints) trial.assembler.add(held.constraint, held.forces);
  write_forces(trial.assembler, trial.moments, forces);
  if (moments != nullptr) trial.moments.set(setup_.model, *moments);
}

void ContactForce::visit_springs(const std::function<void(const ContactSpring&)>& take) const {
  const ContactSprings springs(setup_.model, kinematics_, rules_);
  const std::span<const ContactPoint> points = trial_->points;
  const auto is_of_faces = [](const ContactPoint& point) {
    return !point.first.is_node() && !point.is_of_edges && !point.is_held_apart && !point.pulls;
  };
  const auto others = std::ranges::find_if_not(points, is_of_faces);  // faces come first
  detection_.visit_couplings(static_context(trial_->dt, true), {points.begin(), others},
                             [&](const ContactPoint& point, const CornerCoupling& coupling) {
                               take(springs.spring_of(point, coupling));
                             });
  for (const ContactPoint& point : std::span(others, points.end())) take(springs.spring_of(point));
  for (const ContactPoint& point : points) {
    if (const auto spring = springs.friction_spring_of(point)) take(*spring);
  }
  const auto ties = detection_.ties();
  for (const ConstraintForces& held : trial_->constraints) {
    const bool is_tie = held.index < ties.size() && ties[held.index].nodes == held.constraint.nodes;
    take(is_tie ? springs.spring_of(ties[held.index]) : springs.spring_of(held.constraint));
  }
}

namespace {

/// What the contact points at a surface node of a pair come to, each by the node's share in it.
struct MultiplierSums {
  double area = 0.0, depth_area = 0.0;  ///< [length^2] [length^3]
  double force = 0.0, stiffness = 0.0;  ///< [force] [force/length]

  void add(const ContactPoint& point, double weight) {
    area += weight * point.area;
    depth_area -= weight * point.area * point.open_gap();
    force += weight * point.force;
    stiffness += weight * point.stiffness;
  }
};

}  // namespace

MultiplierChange ContactForce::update_multipliers(double tolerance) {
  IndexedVector<PairIndex, SurfaceIndex> finer;
  for (const PairRule& rule : rules_.rules()) finer.push_back(finer_surface(*rule.pair));
  std::map<std::pair<PairIndex, SurfaceNodeIndex>, MultiplierSums> sums;
  for (const ContactPoint& point : trial_->points) {
    const ContactPointSide* side = multiplier_side(point, finer[point.pair]);
    if (side == nullptr) continue;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side->weights[static_cast<Eigen::Index>(k)];
      const auto row = contact_mesh_.find_row(side->nodes[k], finer[point.pair]);
      if (weight > 0.0 && row) sums[{point.pair, *row}].add(point, weight);
    }
  }
  MultiplierChange change;
  std::vector<ContactMultipliers::Entry> entries;
  for (const auto& [key, sum] : sums) {
    const double before = multipliers_.of_node(key.first, key.second);
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

/// The surface of a pair whose nodes are closer together: multipliers stand there alone, since those of both
/// sides would be more than there is to be balanced. Of a plane or a surface of faces alone the other one.
SurfaceIndex ContactForce::finer_surface(const SurfacePair& pair) const {
  const auto size = [&](SurfaceIndex surface) {
    double area = 0.0;
    for (const SurfaceNodeIndex row : contact_mesh_.rows_of(surface))
      area += contact_mesh_.surface_nodes[row].area;
    const auto n = contact_mesh_.rows_of(surface).size();
    return n > 0 ? area / static_cast<double>(n) : std::numeric_limits<double>::infinity();
  };
  if (pair.is_one_sided) return pair.second;
  return size(pair.second) < size(pair.first) ? pair.second : pair.first;
}

/// The side of a contact point that its multipliers stand on; nothing where it has none.
///   finer  finer_surface() of its pair
const ContactPointSide* ContactForce::multiplier_side(const ContactPoint& point, SurfaceIndex finer) const {
  if (!holds_multipliers(point)) return nullptr;
  if (point.first.is_node())
    return contact_mesh_.surface_nodes[point.row()].surface == finer ? &point.first : nullptr;
  return contact_mesh_.faces[point.first_face()].surface == finer ? &point.first : &point.second;
}

/// Whether a contact point is pressed by the penalty alone, and may part.
bool ContactForce::holds_multipliers(const ContactPoint& point) const {
  const PairRule& rule = rules_.of(point);
  return rule.pair->enforcement == Enforcement::augmented_lagrange && !rule.acts_apart() &&
         !point.is_of_edges && !point.pulls && rule.pair->separates && point.area > 0.0;
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
  trial_->has_begun = false;
}

ForceReport ContactForce::accept_trial(const Motion& motion, Eigen::Matrix3Xd& forces) {
  move_to_trial(motion);
  assembler_.begin_step();
  points_.clear();
  constraint_forces_.clear();
  assembler_.begin_work(kinematics_, motion.dt);
  add_penalty_points(static_context(motion.dt, false));
  write_forces(assembler_, offset_moments_, forces);
  trial_->has_begun = false;
  ForceReport report;
  report.supplied_work = end_step(motion.time, motion.dt);
  report.friction_work = assembler_.dissipated();
  return report;
}

}  // namespace contactsim
