// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_constraints.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "contact/enforcement/force_projection.hpp"
#include "contact/enforcement/gap_recovery.hpp"
#include "contact/enforcement/relative_velocity.hpp"

namespace contactsim {

namespace {

/// What load steps have pressed just touches as it is, up to this gap over the thickness: their gaps are
/// closed in the mean of a node's surroundings, and not at every point of facets that do not fit. What is
/// wider open is beside it.
constexpr double pressed_gap = 1e-3;

}  // namespace

void ContactConstraints::begin(const ContactKinematics& kinematics, double dt_before, double dt) {
  kinematics_ = &kinematics;
  dt_before_ = dt_before;
  dt_ = dt;
  system_.clear();
  carriers_.begin();
}

void ContactConstraints::add_friction(const ContactPoint& contact_point, const PairRule& rule, Row& row) {
  row.friction = static_cast<std::uint32_t>(system_.frictions.size());
  ConstraintFriction& friction = system_.frictions.emplace_back();
  friction.rule = &rule;
  friction.limit_per_force = rule.interface_law == nullptr ? rule.friction : -1.0;
  friction.slip = dt_ * in_plane(relative_velocity(*kinematics_, contact_point, false), contact_point.normal);
}

/// Begins with a share of the forces of the step before, with all of those of load steps.
void ContactConstraints::take_over(const ContactPoint& contact_point, const ContactHistory::Entry& known,
                                   double allowed, Row& row) {
  if (allowed > 0.0) row.start -= std::min(known.left, allowed);
  const double share = (begins_pressed_ ? 1.0 : taken_over) * contact_point.area;
  Eigen::Vector3d force = share * known.pressure * contact_point.normal;
  if (row.friction) {
    force += share * in_plane(known.traction, contact_point.normal);
    system_.frictions[*row.friction].held = in_plane(known.held, contact_point.normal);
  }
  row.force = node_vector(force);
}

/// Behind load steps a point just touches as it is: what they have pressed, and what penetrates somewhere
/// though the mean around its nodes does not.
///   known  of what they have pressed
void ContactConstraints::begin_where_it_is(const ContactPoint& contact_point, double thickness,
                                           std::optional<ContactHistory::Entry>& known) {
  if (contact_point.gap > pressed_gap * thickness) known.reset();
  if (!known && contact_point.gap < 0.0) known.emplace();
  if (known) known->zero_gap = contact_point.gap;
}

/// The gap that a row starts from, how much of it is to close, its friction, and what is known of it.
void ContactConstraints::set_start(const ContactPoint& contact_point, const PairRule& rule, double thickness,
                                   Row& row) {
  std::optional<ContactHistory::Entry> known = recall(system_.ids.back());
  if (begins_pressed_) begin_where_it_is(contact_point, thickness, known);
  row.zero_gap = known ? known->zero_gap : 0.0;
  row.pulls = contact_point.pulls;
  const double gap = contact_point.gap - row.zero_gap, allowed = -left_gap(gap, row.pulls, thickness);
  row.start = gap - contact_point.closing + allowed;
  row.recovery = std::max(0.0, -gap - allowed);
  if (rule.friction > 0.0) add_friction(contact_point, rule, row);
  if (known) take_over(contact_point, *known, allowed, row);
}

void ContactConstraints::add(const ContactPoint& contact_point, const PairRule& rule, double thickness) {
  const bool is_constraint = contact_point.is_balanced && contact_point.area > 0.0;
  const bool is_of_last = is_constraint && system_.is_of_last_group(contact_point);
  system_.points.push_back(contact_point);
  if (!is_constraint && !contact_point.touches()) return;
  Weights weights{};
  Group alone;
  Group* group = is_of_last ? &system_.groups.back() : &alone;
  if (!carriers_.find_plain(contact_point, group->terms, weights)) {
    group = &alone;
    weights = {};
    carriers_.find_general(contact_point, alone.terms, weights);
  }
  if (contact_point.touches())
    carriers_.push(group->terms, weights, node_vector(contact_point.force_on_first()));
  if (!is_constraint) return;
  Row& row = system_.rows.emplace_back();
  row.point = static_cast<std::uint32_t>(system_.points.size() - 1);
  row.area = contact_point.area;
  system_.ids.push_back(ContactHistory::id_of(contact_point));
  set_start(contact_point, rule, thickness, row);
  const bool presses = !row.friction && !group->terms.first_arm;
  if (group == &alone) {
    alone.presses = presses;
    alone.normal = node_vector(contact_point.normal);
    alone.first_row = static_cast<std::uint32_t>(system_.rows.size() - 1);
    system_.groups.push_back(alone);
  }
  if (!presses) system_.groups.back().presses = false;
  ++system_.groups.back().n_rows;
  system_.weights.push_back(weights);
}

void ContactConstraints::add_rows(LightCarriers& light) {
  std::array<LightShare, PointCarriers::max_terms> shares;
  light_points_.clear();
  system_.visit_rows([&](const Group& group, std::uint32_t row) {
    std::size_t n = 0;
    const Terms& terms = group.terms;
    for (std::size_t i = 0; i < terms.n_terms; ++i) {
      const double weight = system_.weights[row][i];
      if (weight == 0.0 || !light.is_light(terms.carriers[i])) continue;
      LightShare& share = shares[n++];
      share = {light.of(terms.carriers[i]), weight * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
      if (terms.first_arm) share.arm = carriers_.arm(terms, i) / weight;
    }
    if (n == 0) return;
    system_.rows[row].light = light.add_row({shares.data(), n});
    light_points_.push_back({&group, row});
  });
}

LightAnswer ContactConstraints::answer(std::uint32_t light_point, const Eigen::Vector3d& velocity) const {
  const auto [group, row] = light_points_[light_point];
  const NodeVector changed = carriers_.change(group->terms, system_.weights[row]) + node_vector(velocity);
  return ForceProjection(system_, dt_).answer(group->normal, system_.rows[row], dt_ * changed);
}

void ContactConstraints::list_pushes() {
  pressing_.list(system_);
  const int n_threads = system_.n_threads();
  if (n_threads == 1 || !has_others()) return;
  const auto visit = [this](std::size_t begin, std::size_t end, const auto& take) {
    const auto groups = std::span<const Group>(system_.groups).subspan(begin, end - begin);
    ConstraintSystem::visit_rows(groups, [&](const Group& group, std::uint32_t row) {
      if (!group.presses) carriers_.visit_pushes(group.terms, system_.weights[row], row, take);
    });
  };
  pushes_.make(carriers_.n_carriers(), system_.groups.size(), n_threads, visit);
}

/// Gives each point but those that press the force that it is to push with, find_force(group, row, sums), and
/// pushes the carriers. One thread pushes point by point, several carrier by carrier: each carrier's pushes
/// come in the same order.
template <class FindForce>
ConstraintPass ContactConstraints::push_rows(const FindForce& find_force) {
  if (!has_others()) return {};
  const int n_threads = system_.n_threads();
  if (n_threads == 1) {
    return system_.sum_rows<ConstraintPass>(
        1, [&](const Group& group, std::uint32_t i, ConstraintPass& sums) {
          if (group.presses) return;
          find_force(group, i, sums);
          carriers_.push(group.terms, system_.weights[i], system_.rows[i].ahead);
        });
  }
  // By themselves, so that what carriers take fits into a cache.
  pushing_.resize(system_.rows.size());
  const ConstraintPass sums = system_.sum_rows<ConstraintPass>(
      n_threads, [&](const Group& group, std::uint32_t i, ConstraintPass& of_chunk) {
        if (group.presses) return;
        find_force(group, i, of_chunk);
        pushing_[i] = system_.rows[i].ahead;
      });
  parallel_for(pushes_.n_carriers(), n_threads, [&](std::size_t carrier) {
    carriers_.push(static_cast<std::uint32_t>(carrier), pushes_.of(carrier), pushing_);
  });
  return sums;
}

void ContactConstraints::push_forces() {
  pressing_.push_forces(system_);
  push_rows([this](const Group&, std::uint32_t i, ConstraintPass&) {
    system_.rows[i].ahead = system_.rows[i].force;
  });
}

ConstraintPass ContactConstraints::pass(double momentum, const LightCarriers& light) {
  const ForceProjection projection(system_, dt_);
  ConstraintPass all = pressing_.pass(system_, dt_, momentum);
  all += push_rows([&](const Group& group, std::uint32_t i, ConstraintPass& sums) {
    Row& row = system_.rows[i];
    NodeVector velocity = carriers_.change(group.terms, system_.weights[i]);
    if (row.light) velocity += node_vector(light.velocity(*row.light));
    sums.take(row, projection.next_force(group.normal, row, dt_ * velocity), momentum);
  });
  return all;
}

ContactLoss ContactConstraints::finish() {
  const bool is_first_step = !(dt_before_ > 0.0 || begins_pressed_ || goes_on_);
  const ConstraintLosses losses{system_, *kinematics_, dt_before_, dt_, is_first_step};
  const std::span<ContactHistory::KnownPoint> known = history_.begin_points(system_.rows.size());
  ContactLoss loss = pressing_.finish(system_, losses, known);
  if (has_others())
    loss += system_.sum_rows<ContactLoss>(
        system_.n_threads(), [&](const Group& group, std::uint32_t i, ContactLoss& sums) {
          if (group.presses) return;
          const Row& row = system_.rows[i];
          known[i] = {system_.ids[i],
                      losses.finish(row, row.force.dot(group.normal),
                                    dt_ * carriers_.change(group.terms, system_.weights[i]), sums)};
        });
  history_.end(system_.n_threads());
  begins_pressed_ = goes_on_ = false;
  return loss;
}

}  // namespace contactsim
