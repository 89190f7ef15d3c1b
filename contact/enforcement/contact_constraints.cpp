// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_constraints.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// The share of a penetration that comes out in a step, the most over the thickness, and the share of a slip
/// held by friction. All of a penetration at once would throw bodies out: it is the error of some step.
constexpr double gap_recovery = 0.2, fastest_recovery = 2e-4, slip_recovery = 0.1;

/// How far a point may penetrate at the end of a step [length].
double left_penetration(double gap, double thickness) {
  return std::max({0.0, -(1.0 - gap_recovery) * gap, -gap - fastest_recovery * thickness});
}

Eigen::Vector3d in_plane(const Eigen::Vector3d& vector, const Eigen::Vector3d& normal) {
  return vector - normal.dot(vector) * normal;
}

NodeVector node_vector(const Eigen::Vector3d& vector) { return {vector.x(), vector.y(), vector.z(), 0.0}; }

}  // namespace

void ContactConstraints::begin(const MovingSurface& surface, double dt_before, double dt) {
  surface_ = &surface;
  dt_before_ = dt_before;
  dt_ = dt;
  points_.clear();
  rows_.clear();
  terms_.clear();
  arms_.clear();
  grips_.clear();
}

void ContactConstraints::add_terms(const ContactRecord& record, Row& row) {
  row.first_term = static_cast<std::uint32_t>(terms_.size());
  bool is_plain = true;
  const auto first_arm = static_cast<std::uint32_t>(arms_.size());
  const auto add_side = [&](const RecordSide& side, double sign) {
    carriers_.clear();
    const Eigen::Vector3d beside = -sign * side.radius * record.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) mobility_.add_terms(side.nodes[k], sign * weight, beside, carriers_);
    }
    for (const CarrierTerm& term : carriers_) {
      terms_.push_back({term.carrier, term.weight});
      arms_.push_back(term.weight * term.arm);
      is_plain = is_plain && mobility_.is_plain(term.carrier);
    }
  };
  add_side(record.first, 1.0);
  add_side(record.second, -1.0);
  row.n_terms = static_cast<std::uint32_t>(terms_.size()) - row.first_term;
  if (is_plain) {
    arms_.resize(first_arm);
  } else {
    row.first_arm = first_arm;
  }
}

/// A law that acts besides: its force is known.
void ContactConstraints::push_law(const ContactRecord& record, const Row& row) {
  const Eigen::Vector3d force = record.force_on_first();
  std::uint32_t arm = row.first_arm;
  for (const Term& term : terms_of(row)) {
    const Eigen::Vector3d own = arm == none ? Eigen::Vector3d::Zero() : arms_[arm++];
    mobility_.push(term.carrier, term.weight * force, own.cross(force));
  }
}

void ContactConstraints::add_friction(const ContactRecord& record, const PairRule& rule, Row& row) {
  row.grip = static_cast<std::uint32_t>(grips_.size());
  Grip& grip = grips_.emplace_back();
  grip.rule = &rule;
  grip.limit_per_force = rule.place == nullptr ? rule.friction : -1.0;
  grip.slip = dt_ * in_plane(relative_velocity(record, false), record.normal);
}

void ContactConstraints::add(const ContactRecord& record, const PairRule& rule, double thickness) {
  Row row;
  row.point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(record);
  const bool is_constraint = record.is_balanced && record.area > 0.0;
  if (!is_constraint && !record.touches()) return;
  add_terms(record, row);
  if (record.touches()) push_law(record, row);
  if (!is_constraint) return;
  row.normal = node_vector(record.normal);
  row.start = record.gap - record.closing + left_penetration(record.gap, thickness);
  if (rule.friction > 0.0) add_friction(record, rule, row);
  ContactMemory::Entry known;
  if (memory_.recall(record, known)) {
    const double share = taken_over * record.area;
    row.force = share * known.pressure * row.normal;
    if (row.grip != none) {
      row.force += node_vector(share * in_plane(known.traction, record.normal));
      grips_[row.grip].held = in_plane(known.held, record.normal);
    }
  }
  rows_.push_back(row);
}

/// How far a force of 1 turns the carrier of a term with an arm, at the point and as a square root.
double ContactConstraints::turn_size(const Row& row, std::size_t term) const {
  const std::uint32_t carrier = terms_[row.first_term + term].carrier;
  const Eigen::Vector3d& arm = arms_[row.first_arm + term];
  if (row.grip != none) return mobility_.turn_bound(carrier) * arm.norm();
  return mobility_.turn_root(carrier, arm.cross(Eigen::Vector3d(row.normal.head<3>())));
}

void ContactConstraints::add_areas(LeaningAreas& areas) const {
  for (const Row& row : rows_) {
    const double area = points_[row.point].area;
    for (const Term& term : terms_of(row)) areas[term.carrier][0] += area * std::abs(term.weight);
    if (row.first_arm == none) continue;
    for (std::size_t i = 0; i < row.n_terms; ++i)
      areas[terms_[row.first_term + i].carrier][1] += area * turn_size(row, i);
  }
}

void ContactConstraints::set_softness(const LeaningAreas& areas) {
  for (Row& row : rows_) {
    double gap = 0.0;
    for (const Term& term : terms_of(row))
      gap += mobility_.translation_bound(term.carrier) * std::abs(term.weight) * areas[term.carrier][0];
    if (row.first_arm != none) {
      for (std::size_t i = 0; i < row.n_terms; ++i)
        gap += turn_size(row, i) * areas[terms_[row.first_term + i].carrier][1];
    }
    row.softness = dt_ * gap / points_[row.point].area;
  }
  std::erase_if(rows_, [](const Row& row) { return !(row.softness > 0.0); });
}

NodeVector ContactConstraints::plain_change(const Row& row) const {
  NodeVector sum = NodeVector::Zero();
  for (const Term& term : terms_of(row)) sum += term.weight * mobility_.change(term.carrier);
  return sum;
}

/// Change of the first side's velocity against the second's by the forces of the last pass [length/time].
Eigen::Vector3d ContactConstraints::change(const Row& row) const {
  Eigen::Vector3d changed = plain_change(row).head<3>();
  if (row.first_arm == none) return changed;
  for (std::size_t i = 0; i < row.n_terms; ++i)
    changed += mobility_.turning(terms_[row.first_term + i].carrier).cross(arms_[row.first_arm + i]);
  return changed;
}

void ContactConstraints::push(const Row& row) {
  if (row.ahead.isZero(0.0)) return;
  if (row.first_arm == none) {
    for (const Term& term : terms_of(row)) mobility_.push_plain(term.carrier, term.weight * row.ahead);
    return;
  }
  const Eigen::Vector3d force = row.ahead.head<3>();
  for (std::size_t i = 0; i < row.n_terms; ++i) {
    const Term& term = terms_[row.first_term + i];
    mobility_.push(term.carrier, term.weight * force, arms_[row.first_arm + i].cross(force));
  }
}

void ContactConstraints::push_forces() {
  for (Row& row : rows_) {
    row.ahead = row.force;
    push(row);
  }
}

double ContactConstraints::slip_limit(const Row& row, double normal_force) const {
  const Grip& grip = grips_[row.grip];
  if (grip.limit_per_force >= 0.0) return grip.limit_per_force * normal_force;
  ContactRecord record = points_[row.point];
  record.force = normal_force;
  record.slip = grip.slip + dt_ * in_plane(change(row), record.normal);
  return grip.rule->slip_limit(record, dt_);
}

/// Closes the gap: max(0, force - gap / softness), and the slip likewise, back on the cone.
NodeVector ContactConstraints::next_force(const Row& row) const {
  const NodeVector changed = dt_ * (row.first_arm == none ? plain_change(row) : node_vector(change(row)));
  const double now = row.normal.dot(row.ahead), rate = (1.0 - constraint_compliance) / row.softness;
  const double gap = row.start + row.normal.dot(changed) + constraint_compliance * row.softness * now;
  const double force = std::max(0.0, now - rate * gap);
  if (row.grip == none) return force * row.normal;
  const Grip& grip = grips_[row.grip];
  const Eigen::Vector3d normal = row.normal.head<3>();
  const Eigen::Vector3d slip = slip_recovery * grip.held + grip.slip + in_plane(changed.head<3>(), normal);
  Eigen::Vector3d tangential = in_plane(row.ahead.head<3>(), normal) - rate * slip;
  const double limit = slip_limit(row, force), size = tangential.norm();
  if (size > limit) tangential *= limit / size;
  return force * row.normal + node_vector(tangential);
}

ConstraintPass ContactConstraints::pass(double momentum) {
  return pass_over(
      rows_, momentum, [this](const Row& row) { return next_force(row); },
      [this](const Row& row) { push(row); });
}

/// The velocity of the first side against the second, in the step before or in the coming one without these
/// forces [length/time].
Eigen::Vector3d ContactConstraints::relative_velocity(const ContactRecord& record, bool is_before) const {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  const auto add_side = [&](const RecordSide& side, double sign) {
    const Eigen::Vector3d beside = -sign * side.radius * record.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = sign * side.weights[static_cast<Eigen::Index>(k)];
      if (weight == 0.0) continue;
      velocity += weight * (is_before ? surface_->last_velocity_beside(side.nodes[k], beside)
                                      : surface_->velocity_beside(side.nodes[k], beside));
    }
  };
  add_side(record.first, 1.0);
  add_side(record.second, -1.0);
  return velocity;
}

ContactLoss ContactConstraints::finish() {
  ContactLoss loss;
  memory_.begin();
  for (const Row& row : rows_) finish(row, loss);
  memory_.end();
  return loss;
}

void ContactConstraints::finish(const Row& row, ContactLoss& loss) {
  const double force = row.normal.dot(row.force);
  if (!(force > 0.0)) return;
  ContactRecord& point = points_[row.point];
  const Eigen::Vector3d before = dt_before_ * relative_velocity(point, true), changed = dt_ * change(row);
  const double impact_before = -0.5 * force * point.normal.dot(before),
               impact_after = 0.5 * force * (point.closing - point.normal.dot(changed));
  loss.impact_before += impact_before;
  loss.impact_after += impact_after;
  point.impact = impact_before + impact_after;
  point.knows_work = !point.touches();
  point.work_before = impact_before;
  point.work_after = impact_after;
  point.force += force;
  ContactMemory::Entry entry{force / point.area};
  if (row.grip != none) {
    Grip& grip = grips_[row.grip];
    const Eigen::Vector3d slip = grip.slip + in_plane(changed, point.normal);
    const Eigen::Vector3d tangential = in_plane(row.force.head<3>(), point.normal);
    const double friction_before = -0.5 * tangential.dot(before),
                 friction_after = -0.5 * tangential.dot(slip);
    loss.friction_before += friction_before;
    loss.friction_after += friction_after;
    point.dissipated = friction_before + friction_after;
    point.work_before += friction_before;
    point.work_after += friction_after;
    point.tangential += tangential;
    const bool slides = tangential.norm() >= (1.0 - 1e-9) * slip_limit(row, force);
    if (slides) point.slip = slip;
    point.elastic = slides ? Eigen::Vector3d::Zero() : Eigen::Vector3d(grip.held + slip);
    entry.traction = tangential / point.area;
    entry.held = point.elastic;
  }
  memory_.remember(point, entry);
}

}  // namespace contactsim
