// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/decaying_constraints.hpp"

#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

/// The work that forces do on the nodes in the step [energy].
double work_of(const ContactStepContext& context, const InterfaceConstraint& constraint,
               const CornerVectors& forces) {
  double power = 0.0;
  for (std::size_t k = 0; k < 8; ++k)
    power += forces.col(static_cast<Eigen::Index>(k)).dot(context.kinematics.v(constraint.nodes[k]));
  return power * context.dt;
}

void visit_decaying(DecayingConstraint& constraint, RowNumbers& row) {
  visit_constraint(constraint, row);
  row(constraint.forces, constraint.stored, constraint.n_steps, constraint.n_done);
}

}  // namespace

DecayingConstraint make_decaying(const InterfaceConstraint& constraint, const CornerForces& at_failure,
                                 const CornerVectors& x, std::int64_t n_steps) {
  DecayingConstraint fading;
  static_cast<InterfaceConstraint&>(fading) = constraint;
  fading.forces = axes_of(x.rightCols<4>()).transpose() * at_failure.forces;
  fading.stored = at_failure.stored;
  fading.n_steps = n_steps;
  return fading;
}

CornerForces find_decaying_forces(const DecayingConstraint& constraint, const CornerVectors& x) {
  const double left = 1.0 - static_cast<double>(constraint.n_done) / static_cast<double>(constraint.n_steps);
  const Eigen::Matrix3d axes = axes_of(x.rightCols<4>());
  const Eigen::Vector3d origin = x.col(0);
  CornerForces found;
  found.forces = left * (axes * constraint.forces);
  balance(x.colwise() - origin, found.forces);
  found.normal = axes.col(2);
  found.stored = left * constraint.stored;
  return found;
}

void DecayingConstraints::add(const ContactStepContext& context, const ConstraintForces& failed) {
  constraints_.push_back(make_decaying(failed.constraint, failed.forces,
                                       corners_of(context, failed.constraint),
                                       rule_of(context, failed.constraint).interface_law->decay_cycles));
}

void DecayingConstraints::step(const ContactStepContext& context, std::vector<ConstraintForces>& found) {
  // They act besides momentum balance, once in a step.
  if (context.balances || context.dt == 0.0) return;
  for (std::size_t i = 0; i < constraints_.size(); ++i) {
    DecayingConstraint& constraint = constraints_[i];
    const CornerVectors x = corners_of(context, constraint);
    const CornerForces before = find_decaying_forces(constraint, x);
    ++constraint.n_done;
    CornerForces now = find_decaying_forces(constraint, x);
    now.dissipated =
        before.stored - now.stored - work_of(context, constraint, 0.5 * (before.forces + now.forces));
    found.push_back({constraint, now, i, constraint.is_over()});
  }
  std::erase_if(constraints_, [](const DecayingConstraint& constraint) { return constraint.is_over(); });
}

void DecayingConstraints::end_changed(const PairRules& rules) {
  std::erase_if(constraints_,
                [&](const DecayingConstraint& constraint) { return rules[constraint.pair].has_changed; });
}

void DecayingConstraints::archive(StateArchive& saved) {
  saved.rows("contact/fading", constraints_, visit_decaying);
}

}  // namespace contactsim
