// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_constraints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "contact/enforcement/gap_recovery.hpp"
#include "contact/enforcement/relative_velocity.hpp"

namespace contactsim {

namespace {

/// The share of a slip held by friction that comes back in a step.
constexpr double slip_recovery = 0.1;

/// What passes leave of a penetration, because a light part between heavier ones answers to each a little
/// only, is made up for in the next step; at most by this share of what the force of the point itself closes:
/// more would throw apart what folds hold in.
constexpr double max_recovery = 0.1;

/// What load steps have pressed just touches as it is, up to this gap over the thickness: their gaps are
/// closed in the mean of a node's surroundings, and not at every point of facets that do not fit. What is
/// wider open is beside it.
constexpr double pressed_gap = 1e-3;

Eigen::Vector3d in_plane(const Eigen::Vector3d& vector, const Eigen::Vector3d& normal) {
  return vector - normal.dot(vector) * normal;
}

NodeVector node_vector(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z(), 0.0}; }

}  // namespace

void ContactConstraints::begin(const ContactKinematics& kinematics, double dt_before, double dt) {
  kinematics_ = &kinematics;
  dt_before_ = dt_before;
  dt_ = dt;
  points_.clear();
  groups_.clear();
  rows_.clear();
  weights_.clear();
  grips_.clear();
  carriers_.begin();
}

/// Whether a point is between the entities of the last row, and seen along the same normal.
bool ContactConstraints::is_of_last_group(const ContactPoint& contact_point) const {
  if (rows_.empty() || groups_.back().terms.first_arm) return false;
  const ContactPoint& last = points_[rows_.back().point];
  return contact_point.first.nodes == last.first.nodes && contact_point.second.nodes == last.second.nodes &&
         contact_point.normal == last.normal;
}

void ContactConstraints::add_friction(const ContactPoint& contact_point, const PairRule& rule, Row& row) {
  row.grip = static_cast<std::uint32_t>(grips_.size());
  Grip& grip = grips_.emplace_back();
  grip.rule = &rule;
  grip.limit_per_force = rule.interface_law == nullptr ? rule.friction : -1.0;
  grip.slip = dt_ * in_plane(relative_velocity(*kinematics_, contact_point, false), contact_point.normal);
}

/// Begins with a share of the forces of the step before, with all of those of load steps.
void ContactConstraints::take_over(const ContactPoint& contact_point, const ContactHistory::Entry& known,
                                   double allowed, Row& row) {
  if (allowed > 0.0) row.start -= std::min(known.left, allowed);
  const double share = (begins_pressed_ ? 1.0 : taken_over) * contact_point.area;
  Eigen::Vector3d force = share * known.pressure * contact_point.normal;
  if (row.grip) {
    force += share * in_plane(known.traction, contact_point.normal);
    grips_[*row.grip].held = in_plane(known.held, contact_point.normal);
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

void ContactConstraints::add(const ContactPoint& contact_point, const PairRule& rule, double thickness) {
  const bool is_constraint = contact_point.is_balanced && contact_point.area > 0.0;
  const bool is_of_last = is_constraint && is_of_last_group(contact_point);
  points_.push_back(contact_point);
  if (!is_constraint && !contact_point.touches()) return;
  Weights weights{};
  Group alone;
  Group* group = is_of_last ? &groups_.back() : &alone;
  if (!carriers_.find_plain(contact_point, group->terms, weights)) {
    group = &alone;
    weights = {};
    carriers_.find_general(contact_point, alone.terms, weights);
  }
  if (contact_point.touches())
    carriers_.push(group->terms, weights, node_vector(contact_point.force_on_first()));
  if (!is_constraint) return;
  Row row;
  row.point = static_cast<std::uint32_t>(points_.size() - 1);
  std::optional<ContactHistory::Entry> known = recall(contact_point);
  if (begins_pressed_) begin_where_it_is(contact_point, thickness, known);
  ContactPoint measured = contact_point;
  if (known) measured.gap -= known->zero_gap;
  row.zero_gap = known ? known->zero_gap : 0.0;
  const double allowed = -left_gap(measured, thickness);
  row.start = measured.gap - contact_point.closing + allowed;
  row.recovery = std::max(0.0, -measured.gap - allowed);
  row.pulls = contact_point.pulls;
  if (rule.friction > 0.0) add_friction(contact_point, rule, row);
  if (known) take_over(contact_point, *known, allowed, row);
  if (group == &alone) {
    alone.normal = node_vector(contact_point.normal);
    alone.first_row = static_cast<std::uint32_t>(rows_.size());
    groups_.push_back(alone);
  }
  ++groups_.back().n_rows;
  rows_.push_back(row);
  weights_.push_back(weights);
}

void ContactConstraints::add_rows(LightCarriers& light) {
  std::array<LightShare, PointCarriers::max_terms> shares;
  light_points_.clear();
  visit_rows([&](const Group& group, std::uint32_t row) {
    std::size_t n = 0;
    const Terms& terms = group.terms;
    for (std::size_t i = 0; i < terms.n_terms; ++i) {
      const double weight = weights_[row][i];
      if (weight == 0.0 || !light.is_light(terms.carriers[i])) continue;
      LightShare& share = shares[n++];
      share = {light.of(terms.carriers[i]), weight * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
      if (terms.first_arm) share.arm = carriers_.arm(terms, i) / weight;
    }
    if (n == 0) return;
    rows_[row].light = light.add_row({shares.data(), n});
    light_points_.push_back({&group, row});
  });
}

/// The tangential force that would hold a point, before the cone.
Eigen::Vector3d ContactConstraints::trial_traction(const Eigen::Vector3d& normal, const Row& row,
                                                   const NodeVector& changed) const {
  const Grip& grip = grips_[*row.grip];
  const Eigen::Vector3d slip = slip_recovery * grip.held + grip.slip + in_plane(changed.head<3>(), normal);
  return in_plane(row.ahead.head<3>(), normal) - (1.0 - constraint_compliance) / grip.softness * slip;
}

LightAnswer ContactConstraints::answer(std::uint32_t light_point, const Eigen::Vector3d& velocity) const {
  const auto [place, r] = light_points_[light_point];
  const Group& group = *place;
  const Row& row = rows_[r];
  const NodeVector changed = dt_ * (carriers_.change(group.terms, weights_[r]) + node_vector(velocity));
  const NodeVector force = next_force(group.normal, row, changed);
  const double rate = dt_ * (1.0 - constraint_compliance) / row.softness;
  LightAnswer answer{force.head<3>(), (force - row.ahead).head<3>(), Eigen::Matrix3d::Zero(), rate};
  const Eigen::Vector3d normal = group.normal.head<3>();
  if (row.pulls || pressing(group.normal, row, changed) > 0.0)
    answer.rate = rate * normal * normal.transpose();
  if (!row.grip) return answer;
  const Eigen::Vector3d trial = trial_traction(normal, row, changed);
  constexpr double round_off = 1e-9;
  const double size = trial.norm(), held = in_plane(force.head<3>(), normal).norm();
  const Eigen::Matrix3d plane = Eigen::Matrix3d::Identity() - normal * normal.transpose();
  const double of_slip = dt_ * (1.0 - constraint_compliance) / grips_[*row.grip].softness;
  if (held >= (1.0 - round_off) * size) {
    answer.rate += of_slip * plane;
  } else if (size > 0.0) {
    const Eigen::Vector3d way = trial / size;
    answer.rate += of_slip * held / size * (plane - way * way.transpose());
  }
  return answer;
}

/// Sums of visit(group, row, sums) over all points, by chunks: the same bits for any number of threads.
template <class Sums, class Visit>
Sums ContactConstraints::sum_rows(int n_threads, const Visit& visit) const {
  const std::size_t n_chunks = (groups_.size() + groups_per_chunk - 1) / groups_per_chunk;
  std::vector<Sums> parts(n_chunks);
  parallel_for(n_chunks, n_threads, [&](std::size_t i) {
    const std::size_t begin = i * groups_per_chunk;
    const std::size_t n = std::min(groups_per_chunk, groups_.size() - begin);
    visit_rows(std::span(groups_).subspan(begin, n),
               [&](const Group& group, std::uint32_t row) { visit(group, row, parts[i]); });
  });
  Sums sums;
  for (const Sums& part : parts) sums += part;
  return sums;
}

void ContactConstraints::begin_passes() {
  if (threads() == 1) return;
  pushes_.make(carriers_.n_carriers(), [this](const auto& take) {
    visit_rows([&](const Group& group, std::uint32_t row) {
      carriers_.visit_pushes(group.terms, weights_[row], row, take);
    });
  });
}

/// Gives each point the force that it is to push with, find_force(group, row, sums), and pushes the carriers.
/// One thread pushes point by point, several carrier by carrier: each carrier's pushes come in the same
/// order.
template <class FindForce>
ConstraintPass ContactConstraints::push_rows(const FindForce& find_force) {
  const int n_threads = threads();
  if (n_threads == 1) {
    return sum_rows<ConstraintPass>(1, [&](const Group& group, std::uint32_t i, ConstraintPass& sums) {
      find_force(group, i, sums);
      carriers_.push(group.terms, weights_[i], rows_[i].ahead);
    });
  }
  // By themselves, so that what carriers take fits into a cache.
  pushing_.resize(rows_.size());
  const ConstraintPass sums =
      sum_rows<ConstraintPass>(n_threads, [&](const Group& group, std::uint32_t i, ConstraintPass& of_chunk) {
        find_force(group, i, of_chunk);
        pushing_[i] = rows_[i].ahead;
      });
  parallel_for(pushes_.n_carriers(), n_threads, [&](std::size_t carrier) {
    carriers_.push(static_cast<std::uint32_t>(carrier), pushes_.of(carrier), pushing_);
  });
  return sums;
}

void ContactConstraints::push_forces() {
  push_rows([this](const Group&, std::uint32_t i, ConstraintPass&) { rows_[i].ahead = rows_[i].force; });
}

double ContactConstraints::slip_limit(const Row& row, const NodeVector& changed, double normal_force) const {
  const Grip& grip = grips_[*row.grip];
  normal_force = std::max(0.0, normal_force);
  if (grip.limit_per_force >= 0.0) return grip.limit_per_force * normal_force;
  ContactPoint contact_point = points_[row.point];
  contact_point.force = normal_force;
  contact_point.slip = grip.slip + in_plane(changed.head<3>(), contact_point.normal);
  return grip.rule->slip_limit(contact_point, dt_);
}

/// The normal force that closes the gap, force - gap / softness: < 0 where the sides part.
double ContactConstraints::pressing(const NodeVector& normal, const Row& row,
                                    const NodeVector& changed) const {
  const double now = normal.dot(row.ahead), rate = (1.0 - constraint_compliance) / row.softness;
  const double gap = row.start + normal.dot(changed) + constraint_compliance * row.softness * now;
  return now - rate * gap;
}

/// Closes the gap: max(0, force - gap / softness), and the slip likewise, back on the cone. On light carriers
/// that is the cone of the normal force that the pass looks at: that of the force to be found would leave no
/// potential, without which forces and motion need not fit together.
///   changed  by which the forces of the last pass change the gap and the slip [length]
NodeVector ContactConstraints::next_force(const NodeVector& normal, const Row& row,
                                          const NodeVector& changed) const {
  const double closing = pressing(normal, row, changed);
  const double force = row.pulls ? closing : std::max(0.0, closing);
  if (!row.grip) return force * normal;
  Eigen::Vector3d tangential = trial_traction(normal.head<3>(), row, changed);
  const double limit = slip_limit(row, changed, row.light ? std::max(0.0, normal.dot(row.ahead)) : force),
               size = tangential.norm();
  if (size > limit) tangential *= limit / size;
  return force * normal + node_vector(tangential);
}

ConstraintPass ContactConstraints::pass(double momentum, const LightCarriers& light) {
  return push_rows([&](const Group& group, std::uint32_t i, ConstraintPass& sums) {
    Row& row = rows_[i];
    NodeVector velocity = carriers_.change(group.terms, weights_[i]);
    if (row.light) velocity += node_vector(light.velocity(*row.light));
    sums.take(row, next_force(group.normal, row, dt_ * velocity), momentum);
  });
}

ContactLoss ContactConstraints::finish() {
  std::vector<std::optional<ContactHistory::Entry>> entries(rows_.size());
  const auto loss =
      sum_rows<ContactLoss>(threads(), [&](const Group& group, std::uint32_t i, ContactLoss& sums) {
        entries[i] = finish(rows_[i], rows_[i].force.dot(group.normal),
                            dt_ * carriers_.change(group.terms, weights_[i]), sums);
      });
  history_.begin();
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    if (entries[i]) history_.remember(points_[rows_[i].point], *entries[i]);
  }
  history_.end();
  begins_pressed_ = goes_on_ = false;
  return loss;
}

/// What a force loses in half of the step before. Before the first step the leapfrog stands mirrored, unless
/// a procedure before had pressed already.
///   before   way of the first side along the second in the step before [length]
///   changed  by which all forces change that of the coming step [length]
double ContactConstraints::lost_before(const Eigen::Vector3d& force, const ContactPoint& point,
                                       const Eigen::Vector3d& before, const Eigen::Vector3d& changed) const {
  if (dt_before_ > 0.0 || begins_pressed_ || goes_on_) return -0.5 * force.dot(before);
  const Eigen::Vector3d begun =
      relative_velocity(*kinematics_, point, false) - relative_velocity(*kinematics_, point, true);
  return 0.25 * force.dot(2.0 * dt_ * begun + changed);
}

/// The part of finish() that is friction's.
///   before  as of lost_before
void ContactConstraints::finish_friction(const Row& row, double force, const NodeVector& change,
                                         const Eigen::Vector3d& before, ContactHistory::Entry& entry,
                                         ContactLoss& loss) {
  ContactPoint& point = points_[row.point];
  const Grip& grip = grips_[*row.grip];
  const Eigen::Vector3d changed = change.head<3>();
  const Eigen::Vector3d slip = grip.slip + in_plane(changed, point.normal);
  const Eigen::Vector3d tangential = in_plane(row.force.head<3>(), point.normal);
  const double friction_before = lost_before(tangential, point, before, changed),
               friction_after = -0.5 * tangential.dot(slip);
  loss.friction_before += friction_before;
  loss.friction_after += friction_after;
  point.dissipated = friction_before + friction_after;
  point.work_before += friction_before;
  point.work_after += friction_after;
  point.tangential += tangential;
  const bool slides = tangential.norm() >= (1.0 - 1e-9) * slip_limit(row, change, force);
  if (slides) point.slip = slip;
  point.elastic_slip = slides ? Eigen::Vector3d::Zero() : Eigen::Vector3d(grip.held + slip);
  entry.traction = tangential / point.area;
  entry.held = point.elastic_slip;
}

/// Gives the point of a row its force, and what it loses. Returns what is to be known of it in the next step.
std::optional<ContactHistory::Entry> ContactConstraints::finish(const Row& row, double force,
                                                                const NodeVector& change, ContactLoss& loss) {
  ContactPoint& point = points_[row.point];
  if (!(row.pulls ? force != 0.0 : force > 0.0)) {
    if (!(row.zero_gap < 0.0)) return std::nullopt;
    ContactHistory::Entry begun;
    begun.area = point.area;
    begun.zero_gap = row.zero_gap;
    return begun;
  }
  const Eigen::Vector3d before = dt_before_ * relative_velocity(*kinematics_, point, true),
                        changed = change.head<3>();
  const double impact_before = lost_before(force * point.normal, point, before, changed),
               impact_after = 0.5 * force * (point.closing - point.normal.dot(changed));
  loss.impact_before += impact_before;
  loss.impact_after += impact_after;
  point.impact = impact_before + impact_after;
  point.knows_work = !point.touches();
  point.work_before = impact_before;
  point.work_after = impact_after;
  point.force += force;
  ContactHistory::Entry entry{force / point.area};
  const double left = -(row.start + point.normal.dot(changed));
  entry.area = point.area;
  entry.zero_gap = row.zero_gap;
  entry.left = std::clamp(left, 0.0, std::max(0.0, max_recovery * force * row.softness));
  if (row.grip) finish_friction(row, force, change, before, entry, loss);
  return entry;
}

}  // namespace contactsim
