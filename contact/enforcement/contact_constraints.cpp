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

/// What passes leave of a penetration, because a light part between heavier ones answers to each a little
/// only, is made up for in the next step; at most by this share of what the force of the point itself closes:
/// more would throw apart what folds hold in.
constexpr double max_recovery = 0.1;

/// How far a point may penetrate at the end of a step [length].
double left_penetration(double gap, double thickness) {
  return std::max({0.0, -(1.0 - gap_recovery) * gap, -gap - fastest_recovery * thickness});
}

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
  arms_.clear();
  grips_.clear();
}

/// Calls visit(group, row) for each point, in their order.
template <class Visit>
void ContactConstraints::visit_rows(const Visit& visit) const {
  for (const Group& group : groups_) {
    for (std::uint32_t row = group.first_row; row < group.first_row + group.n_rows; ++row) visit(group, row);
  }
}

/// Finds a point's shares of plain carriers, beside those that its group has. Returns whether that is all.
bool ContactConstraints::find_plain_terms(const ContactPoint& contact_point, Group& group, Weights& weights) {
  const auto find_side = [&](const ContactPointSide& side, double sign, std::uint8_t first_corner) {
    for (std::uint8_t k = 0; k < 4; ++k) {
      const double weight = side.weights[k];
      if (weight == 0.0) continue;
      const auto corner = static_cast<std::uint8_t>(first_corner + k);
      std::size_t term = 0;
      while (term < group.n_terms && group.corners[term] != corner) ++term;
      if (term == group.n_terms) {
        const std::optional<std::uint32_t> carrier = mobility_.plain_carrier(side.nodes[k]);
        if (!carrier) return false;
        group.corners[term] = corner;
        group.carriers[term] = *carrier;
        ++group.n_terms;
      }
      weights[term] = sign * weight;
    }
    return true;
  };
  return find_side(contact_point.first, 1.0, 0) && find_side(contact_point.second, -1.0, 4);
}

void ContactConstraints::find_general_terms(const ContactPoint& contact_point, Group& group,
                                            Weights& weights) {
  group.n_terms = 0;
  group.first_arm = static_cast<std::uint32_t>(arms_.size());
  const auto add_side = [&](const ContactPointSide& side, double sign) {
    carriers_.clear();
    const Eigen::Vector3d beside = -sign * side.radius * contact_point.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) mobility_.add_terms(side.nodes[k], sign * weight, beside, carriers_);
    }
    for (const CarrierTerm& term : carriers_) {
      group.carriers[group.n_terms] = term.carrier;
      weights[group.n_terms++] = term.weight;
      arms_.push_back(term.weight * term.arm);
    }
  };
  add_side(contact_point.first, 1.0);
  add_side(contact_point.second, -1.0);
}

/// Whether a point is between the entities of the last row, and seen along the same normal.
bool ContactConstraints::is_of_last_group(const ContactPoint& contact_point) const {
  if (rows_.empty() || groups_.back().first_arm) return false;
  const ContactPoint& last = points_[rows_.back().point];
  return contact_point.first.nodes == last.first.nodes && contact_point.second.nodes == last.second.nodes &&
         contact_point.normal == last.normal;
}

void ContactConstraints::add_friction(const ContactPoint& contact_point, const PairRule& rule, Row& row) {
  row.grip = static_cast<std::uint32_t>(grips_.size());
  Grip& grip = grips_.emplace_back();
  grip.rule = &rule;
  grip.limit_per_force = rule.interface_law == nullptr ? rule.friction : -1.0;
  grip.slip = dt_ * in_plane(relative_velocity(contact_point, false), contact_point.normal);
}

/// Begins with a share of the forces of the step before.
void ContactConstraints::take_over(const ContactPoint& contact_point, double allowed, Row& row) {
  ContactHistory::Entry known;
  if (!history_.recall(contact_point, known)) return;
  row.start -= std::min(known.left, allowed);
  const double share = taken_over * contact_point.area;
  Eigen::Vector3d force = share * known.pressure * contact_point.normal;
  if (row.grip) {
    force += share * in_plane(known.traction, contact_point.normal);
    grips_[*row.grip].held = in_plane(known.held, contact_point.normal);
  }
  row.force = node_vector(force);
}

void ContactConstraints::add(const ContactPoint& contact_point, const PairRule& rule, double thickness) {
  const bool is_constraint = contact_point.is_balanced && contact_point.area > 0.0;
  const bool is_of_last = is_constraint && is_of_last_group(contact_point);
  points_.push_back(contact_point);
  if (!is_constraint && !contact_point.touches()) return;
  Weights weights{};
  Group alone;
  Group* group = is_of_last ? &groups_.back() : &alone;
  if (!find_plain_terms(contact_point, *group, weights)) {
    group = &alone;
    weights = {};
    find_general_terms(contact_point, alone, weights);
  }
  if (contact_point.touches()) push(*group, weights, node_vector(contact_point.force_on_first()));
  if (!is_constraint) return;
  Row row;
  row.point = static_cast<std::uint32_t>(points_.size() - 1);
  const double allowed = left_penetration(contact_point.gap, thickness);
  row.start = contact_point.gap - contact_point.closing + allowed;
  if (rule.friction > 0.0) add_friction(contact_point, rule, row);
  take_over(contact_point, allowed, row);
  if (group == &alone) {
    alone.normal = node_vector(contact_point.normal);
    alone.first_row = static_cast<std::uint32_t>(rows_.size());
    groups_.push_back(alone);
  }
  ++groups_.back().n_rows;
  rows_.push_back(row);
  weights_.push_back(weights);
}

/// How far a force of 1 turns the carrier of a term with an arm, at the point and as a square root.
double ContactConstraints::turn_size(const Group& group, const Row& row, std::size_t term) const {
  const std::uint32_t carrier = group.carriers[term];
  const Eigen::Vector3d& arm = arms_[*group.first_arm + term];
  if (row.grip) return mobility_.turn_bound(carrier) * arm.norm();
  return mobility_.turn_root(carrier, arm.cross(Eigen::Vector3d(group.normal.head<3>())));
}

void ContactConstraints::add_areas(LeaningAreas& areas) const {
  visit_rows([&](const Group& group, std::uint32_t row) {
    const double area = points_[rows_[row].point].area;
    for (std::size_t i = 0; i < group.n_terms; ++i)
      areas[group.carriers[i]][0] += area * std::abs(weights_[row][i]);
    if (!group.first_arm) return;
    for (std::size_t i = 0; i < group.n_terms; ++i)
      areas[group.carriers[i]][1] += area * turn_size(group, rows_[row], i);
  });
}

/// What a carrier adds to the softness of a point, times its area over the step.
double ContactConstraints::share(const Group& group, std::uint32_t row, std::size_t term,
                                 const LeaningAreas& areas) const {
  const std::uint32_t carrier = group.carriers[term];
  const double moves =
      mobility_.translation_bound(carrier) * std::abs(weights_[row][term]) * areas[carrier][0];
  if (!group.first_arm) return moves;
  return moves + turn_size(group, rows_[row], term) * areas[carrier][1];
}

void ContactConstraints::add_loads(const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const {
  visit_rows([&](const Group& group, std::uint32_t row) {
    const double area = points_[rows_[row].point].area;
    const auto side = [&](std::size_t term) { return weights_[row][term] > 0.0 ? 0 : 1; };
    std::array<double, 2> sides{};
    for (std::size_t i = 0; i < group.n_terms; ++i) sides[side(i)] += share(group, row, i, areas);
    for (std::size_t i = 0; i < group.n_terms; ++i) {
      CarrierLoad& load = loads[group.carriers[i]];
      load.own += sides[side(i)];
      load.others += sides[1 - side(i)];
      load.area += area * std::abs(weights_[row][i]);
    }
  });
}

double ContactConstraints::softness(const Group& group, std::uint32_t row, const LeaningAreas& areas,
                                    const LightCarriers& light, double least) const {
  const double area = points_[rows_[row].point].area;
  double gap = 0.0;
  bool has_light = false;
  for (std::size_t i = 0; i < group.n_terms; ++i) {
    const bool is_light = light.is_light(group.carriers[i]);
    has_light = has_light || is_light;
    if (!is_light) gap += share(group, row, i, areas);
  }
  if (has_light) gap = std::max(gap, least * area);
  return dt_ * gap / area;
}

/// Slip per tangential force, that of light carriers, too: what friction holds is not found with their
/// motion.
double ContactConstraints::slip_softness(const Group& group, std::uint32_t row,
                                         const LeaningAreas& areas) const {
  double slip = 0.0;
  for (std::size_t i = 0; i < group.n_terms; ++i) slip += share(group, row, i, areas);
  return dt_ * slip / points_[rows_[row].point].area;
}

void ContactConstraints::set_softness(const LeaningAreas& areas, const LightCarriers& light, double least) {
  std::uint32_t n_kept = 0;
  for (Group& group : groups_) {
    const std::uint32_t first = group.first_row, end = first + group.n_rows;
    group.first_row = n_kept;
    for (std::uint32_t i = first; i < end; ++i) {
      Row& row = rows_[i];
      row.softness = softness(group, i, areas, light, least);
      if (!(row.softness > 0.0)) continue;
      if (row.grip)
        grips_[*row.grip].softness = light.empty() ? row.softness : slip_softness(group, i, areas);
      rows_[n_kept] = row;
      weights_[n_kept++] = weights_[i];
    }
    group.n_rows = n_kept - group.first_row;
  }
  rows_.resize(n_kept);
  weights_.resize(n_kept);
  std::erase_if(groups_, [](const Group& group) { return group.n_rows == 0; });
}

void ContactConstraints::add_rows(LightCarriers& light) {
  std::array<LightShare, max_terms> shares;
  light_points_.clear();
  visit_rows([&](const Group& group, std::uint32_t row) {
    std::size_t n = 0;
    for (std::size_t i = 0; i < group.n_terms; ++i) {
      const double weight = weights_[row][i];
      if (weight == 0.0 || !light.is_light(group.carriers[i])) continue;
      LightShare& share = shares[n++];
      share = {light.of(group.carriers[i]), weight * Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()};
      if (group.first_arm) share.arm = arms_[*group.first_arm + i] / weight;
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
  const NodeVector changed = dt_ * (change(group, weights_[r]) + node_vector(velocity));
  const NodeVector force = next_force(group.normal, row, changed);
  const double rate = dt_ * (1.0 - constraint_compliance) / row.softness;
  LightAnswer answer{force.head<3>(), (force - row.ahead).head<3>(), Eigen::Matrix3d::Zero(), rate};
  const Eigen::Vector3d normal = group.normal.head<3>();
  if (group.normal.dot(force) > 0.0) answer.rate = rate * normal * normal.transpose();
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

/// Change of the first side's velocity against the second's by the forces of the last pass [length/time].
NodeVector ContactConstraints::change(const Group& group, const Weights& weights) const {
  NodeVector sum = NodeVector::Zero();
  for (std::size_t i = 0; i < group.n_terms; ++i) sum += weights[i] * mobility_.change(group.carriers[i]);
  if (!group.first_arm) return sum;
  for (std::size_t i = 0; i < group.n_terms; ++i)
    sum.head<3>() += mobility_.turning(group.carriers[i]).cross(arms_[*group.first_arm + i]);
  return sum;
}

void ContactConstraints::push(const Group& group, const Weights& weights, const NodeVector& force) {
  if (force.isZero(0.0)) return;
  if (!group.first_arm) {
    for (std::size_t i = 0; i < group.n_terms; ++i)
      mobility_.push_plain(group.carriers[i], weights[i] * force);
    return;
  }
  const Eigen::Vector3d whole = force.head<3>();
  for (std::size_t i = 0; i < group.n_terms; ++i)
    mobility_.push(group.carriers[i], weights[i] * whole, arms_[*group.first_arm + i].cross(whole));
}

void ContactConstraints::push_forces() {
  visit_rows([this](const Group& group, std::uint32_t i) {
    rows_[i].ahead = rows_[i].force;
    push(group, weights_[i], rows_[i].ahead);
  });
}

double ContactConstraints::slip_limit(const Row& row, const NodeVector& changed, double normal_force) const {
  const Grip& grip = grips_[*row.grip];
  if (grip.limit_per_force >= 0.0) return grip.limit_per_force * normal_force;
  ContactPoint contact_point = points_[row.point];
  contact_point.force = normal_force;
  contact_point.slip = grip.slip + in_plane(changed.head<3>(), contact_point.normal);
  return grip.rule->slip_limit(contact_point, dt_);
}

/// Closes the gap: max(0, force - gap / softness), and the slip likewise, back on the cone. On light carriers
/// that is the cone of the normal force that the pass looks at: that of the force to be found would leave no
/// potential, without which forces and motion need not fit together.
///   changed  by which the forces of the last pass change the gap and the slip [length]
NodeVector ContactConstraints::next_force(const NodeVector& normal, const Row& row,
                                          const NodeVector& changed) const {
  const double now = normal.dot(row.ahead), rate = (1.0 - constraint_compliance) / row.softness;
  const double gap = row.start + normal.dot(changed) + constraint_compliance * row.softness * now;
  const double force = std::max(0.0, now - rate * gap);
  if (!row.grip) return force * normal;
  Eigen::Vector3d tangential = trial_traction(normal.head<3>(), row, changed);
  const double limit = slip_limit(row, changed, row.light ? std::max(0.0, now) : force),
               size = tangential.norm();
  if (size > limit) tangential *= limit / size;
  return force * normal + node_vector(tangential);
}

ConstraintPass ContactConstraints::pass(double momentum, const LightCarriers& light) {
  ConstraintPass sums;
  visit_rows([&](const Group& group, std::uint32_t i) {
    Row& row = rows_[i];
    NodeVector velocity = change(group, weights_[i]);
    if (row.light) velocity += node_vector(light.velocity(*row.light));
    sums.take(row, next_force(group.normal, row, dt_ * velocity), momentum);
    push(group, weights_[i], row.ahead);
  });
  return sums;
}

/// The velocity of the first side against the second, in the step before or in the coming one without these
/// forces [length/time].
Eigen::Vector3d ContactConstraints::relative_velocity(const ContactPoint& contact_point,
                                                      bool is_before) const {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  const auto add_side = [&](const ContactPointSide& side, double sign) {
    const Eigen::Vector3d beside = -sign * side.radius * contact_point.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = sign * side.weights[static_cast<Eigen::Index>(k)];
      if (weight == 0.0) continue;
      velocity += weight * (is_before ? kinematics_->last_velocity_beside(side.nodes[k], beside)
                                      : kinematics_->velocity_beside(side.nodes[k], beside));
    }
  };
  add_side(contact_point.first, 1.0);
  add_side(contact_point.second, -1.0);
  return velocity;
}

ContactLoss ContactConstraints::finish() {
  ContactLoss loss;
  history_.begin();
  visit_rows([&](const Group& group, std::uint32_t i) {
    finish(rows_[i], rows_[i].force.dot(group.normal), dt_ * change(group, weights_[i]), loss);
  });
  history_.end();
  return loss;
}

/// What a force loses in half of the step before. Before the first step the leapfrog stands mirrored.
///   before   way of the first side along the second in the step before [length]
///   changed  by which all forces change that of the coming step [length]
double ContactConstraints::lost_before(const Eigen::Vector3d& force, const ContactPoint& point,
                                       const Eigen::Vector3d& before, const Eigen::Vector3d& changed) const {
  if (dt_before_ > 0.0) return -0.5 * force.dot(before);
  const Eigen::Vector3d begun = relative_velocity(point, false) - relative_velocity(point, true);
  return 0.25 * force.dot(2.0 * dt_ * begun + changed);
}

void ContactConstraints::finish(const Row& row, double force, const NodeVector& change, ContactLoss& loss) {
  if (!(force > 0.0)) return;
  ContactPoint& point = points_[row.point];
  const Eigen::Vector3d before = dt_before_ * relative_velocity(point, true), changed = change.head<3>();
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
  entry.left = std::clamp(left, 0.0, max_recovery * force * row.softness);
  if (row.grip) {
    Grip& grip = grips_[*row.grip];
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
  history_.remember(point, entry);
}

}  // namespace contactsim
