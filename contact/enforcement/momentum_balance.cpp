// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/momentum_balance.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "core/state_archive.hpp"

namespace contactsim {

namespace {

/// Share of a penetration that comes out in a step, and the most of it, over the thickness.
constexpr double recovery = 0.1, fastest_recovery = 1e-4;

/// Constraints give way by this share of their mobility, so that forces which move nothing stay bounded.
constexpr double compliance = 1e-6;

/// Forces that change by less in a pass, over their sum, are balanced.
constexpr double balanced = 1e-5;

Eigen::Vector3d in_plane(const Eigen::Vector3d& vector, const Eigen::Vector3d& normal) {
  return vector - normal.dot(vector) * normal;
}

}  // namespace

std::uint32_t MomentumBalance::kind_of(const ContactRecord& record) {
  if (record.is_of_edges) return 2;
  if (record.second.weights.isZero(0.0)) return 3;
  return record.first.is_node() ? 1 : 0;
}

void MomentumBalance::begin(const Model& model, const MovingSurface& surface, const State& state) {
  surface_ = &surface;
  mobility_.begin(model, surface, state);
  dt_ = state.next_dt;
  dt_before_ = state.dt;
  points_.clear();
  terms_.clear();
  plain_.clear();
  tie_terms_.clear();
  rows_.clear();
  tie_rows_.clear();
  loss_ = {};
}

std::uint32_t MomentumBalance::add_terms(const ContactRecord& record) {
  const auto first = static_cast<std::uint32_t>(terms_.size());
  std::vector<CarrierTerm> of_side;
  const auto add_side = [&](const RecordSide& side, double sign) {
    of_side.clear();
    const Eigen::Vector3d beside = -sign * side.radius * record.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) mobility_.add_terms(side.nodes[k], sign * weight, beside, of_side);
    }
    terms_.insert(terms_.end(), of_side.begin(), of_side.end());
  };
  add_side(record.first, 1.0);
  add_side(record.second, -1.0);
  for (std::size_t i = first; i < terms_.size(); ++i) {
    const CarrierTerm& term = terms_[i];
    const double mobility = mobility_.is_plain(term.carrier) ? mobility_.plain_mobility(term.carrier) : 0.0;
    plain_.push_back({term.weight, term.weight * mobility});
  }
  return first;
}

void MomentumBalance::add(const ContactRecord& record, const PairRule& rule, double thickness) {
  const auto point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(record);
  Row row;
  row.first_term = add_terms(record);
  row.n_terms = static_cast<std::uint32_t>(terms_.size()) - row.first_term;
  Eigen::Matrix3d mobility = Eigen::Matrix3d::Zero();
  for (std::uint32_t i = row.first_term; i < terms_.size(); ++i) {
    const CarrierTerm& term = terms_[i];
    row.is_plain = row.is_plain && mobility_.is_plain(term.carrier);
    mobility += term.weight * term.weight * mobility_.mobility(term.carrier, term.arm);
  }
  if (record.force != 0.0 || !record.tangential.isZero(0.0)) push(row, record.force_on_first());
  if (!record.is_balanced) return;
  row.point = point;
  row.normal = record.normal;
  row.rule = &rule;
  row.mobility = dt_ * record.normal.dot(mobility * record.normal);
  if (!(row.mobility > 0.0)) return;  // both sides are held or driven
  const double deep = std::max(0.0, -record.gap);
  const double may_be = deep > 0.0 ? record.gap + std::min(recovery * deep, fastest_recovery * thickness) : 0.0;
  row.start = record.gap - record.closing - may_be;
  row.slides_freely = !(rule.friction > 0.0);
  if (!row.slides_freely) {
    row.limit_per_force = rule.place == nullptr ? rule.friction : -1.0;
    const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity() - record.normal * record.normal.transpose();
    row.side_mobility = dt_ * (flat * mobility * flat).cwiseAbs().rowwise().sum().maxCoeff();
    row.slip = dt_ * in_plane(relative_velocity(record, false), record.normal);
  }
  recall(record, row);
  if (row.force > 0.0 || !row.tangential.isZero(0.0)) push(row, row.force * row.normal + row.tangential);
  rows_.push_back(row);
}

/// A contact point that is new takes over the mean of what its first place has remembered.
void MomentumBalance::recall(const ContactRecord& record, Row& row) const {
  const Memory wanted{kind_of(record), record.first_place, record.second_place, record.part};
  const auto found = std::ranges::lower_bound(memory_, wanted.key(), {}, &Memory::key);
  double pressure = 0.0;
  Eigen::Vector3d traction = Eigen::Vector3d::Zero(), held = Eigen::Vector3d::Zero();
  if (found != memory_.end() && found->key() == wanted.key()) {
    pressure = found->pressure;
    traction = found->traction;
    held = found->held;
  } else {
    const Memory::Key of_place{wanted.kind, wanted.first, 0, 0};
    const auto begin = std::ranges::lower_bound(memory_, of_place, {}, &Memory::key);
    int n = 0;
    for (auto of_first = begin;
         of_first != memory_.end() && of_first->kind == wanted.kind && of_first->first == wanted.first;
         ++of_first, ++n) {
      pressure += of_first->pressure;
      traction += of_first->traction;
      held += of_first->held;
    }
    if (n == 0) return;
    pressure /= n;
    traction /= n;
    held /= n;
  }
  row.force = record.area * pressure;
  if (row.slides_freely) return;
  row.tangential = record.area * in_plane(traction, row.normal);
  row.held = in_plane(held, row.normal);
}

void MomentumBalance::add(Tie& tie) {
  FaceCorners second;
  std::array<Eigen::Vector3d, 8> x;
  for (std::size_t k = 0; k < 8; ++k) x[k] = surface_->x(tie.nodes[k]);
  for (int k = 0; k < 4; ++k) second.col(k) = x[static_cast<std::size_t>(k) + 4];
  const Eigen::Matrix3d axes = axes_of(second);
  for (std::uint32_t p = 0; p < tie.n_points; ++p) {
    const TiePoint& point = tie.points[p];
    TieRow row;
    row.tie = &tie;
    row.point = p;
    row.first_term = static_cast<std::uint32_t>(tie_terms_.size());
    const Eigen::Vector3d offset = axes * point.offset;
    const auto carried = carry_point(second, point.weights_2, offset);
    Eigen::Vector3d distance = -offset, velocity = Eigen::Vector3d::Zero();
    std::vector<CarrierTerm> first_side, second_side;
    for (std::size_t k = 0; k < 8; ++k) {
      const bool is_first = k < 4;
      const Eigen::Matrix3d weight =
          is_first ? point.weights_1[static_cast<Eigen::Index>(k)] * Eigen::Matrix3d::Identity() : carried[k - 4];
      const double share = is_first ? weight(0, 0) : point.weights_2[static_cast<Eigen::Index>(k) - 4];
      distance += (is_first ? share : -share) * (x[k] - x[0]);
      velocity += (is_first ? 1.0 : -1.0) * (weight * surface_->v(tie.nodes[k]));
      if (share != 0.0)
        mobility_.add_terms(tie.nodes[k], share, Eigen::Vector3d::Zero(), is_first ? first_side : second_side);
    }
    for (const CarrierTerm& term : first_side)
      tie_terms_.push_back({term.carrier, term.weight * Eigen::Matrix3d::Identity(), term.arm});
    if (second_side.size() == 1) {
      // One carrier, such as a rigid body, carries the point as it is.
      const CarrierTerm& term = second_side.front();
      tie_terms_.push_back({term.carrier, -Eigen::Matrix3d::Identity(), term.arm + offset});
    } else {
      for (std::size_t k = 0; k < 4; ++k) {
        if (carried[k].isZero(0.0)) continue;
        second_side.clear();
        mobility_.add_terms(tie.nodes[k + 4], 1.0, Eigen::Vector3d::Zero(), second_side);
        tie_terms_.push_back({second_side[0].carrier, -carried[k], second_side[0].arm});
      }
    }
    row.n_terms = static_cast<std::uint32_t>(tie_terms_.size()) - row.first_term;
    Eigen::Matrix3d mobility = Eigen::Matrix3d::Zero();
    for (std::uint32_t i = row.first_term; i < tie_terms_.size(); ++i) {
      const TieTerm& term = tie_terms_[i];
      mobility += term.weight * mobility_.mobility(term.carrier, term.arm) * term.weight.transpose();
    }
    if (!(mobility.trace() > 0.0)) continue;
    const double softer = compliance * mobility.trace();
    row.inverse = (dt_ * (mobility + softer * Eigen::Matrix3d::Identity())).inverse();
    row.start = distance + dt_ * velocity;
    row.force = axes * point.force;
    push(row, row.force);
    tie_rows_.push_back(row);
  }
}

Eigen::Vector3d MomentumBalance::change(const Row& row) const {
  const std::uint32_t end = row.first_term + row.n_terms;
  if (!row.is_plain) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::uint32_t i = row.first_term; i < end; ++i)
      sum += terms_[i].weight * mobility_.change(terms_[i].carrier, terms_[i].arm);
    return sum;
  }
  NodeVector sum = NodeVector::Zero();
  for (std::uint32_t i = row.first_term; i < end; ++i)
    sum += plain_[i][0] * mobility_.plain_change(terms_[i].carrier);
  return sum.head<3>();
}

void MomentumBalance::push(const Row& row, const Eigen::Vector3d& force) {
  const std::uint32_t end = row.first_term + row.n_terms;
  if (!row.is_plain) {
    for (std::uint32_t i = row.first_term; i < end; ++i)
      mobility_.push(terms_[i].carrier, terms_[i].arm, terms_[i].weight * force);
    return;
  }
  NodeVector wide;
  wide << force, 0.0;
  for (std::uint32_t i = row.first_term; i < end; ++i)
    mobility_.plain_change(terms_[i].carrier) += plain_[i][1] * wide;
}

Eigen::Vector3d MomentumBalance::change(const TieRow& row) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::uint32_t i = row.first_term; i < row.first_term + row.n_terms; ++i)
    sum += tie_terms_[i].weight * mobility_.change(tie_terms_[i].carrier, tie_terms_[i].arm);
  return sum;
}

void MomentumBalance::push(const TieRow& row, const Eigen::Vector3d& force) {
  for (std::uint32_t i = row.first_term; i < row.first_term + row.n_terms; ++i)
    mobility_.push(tie_terms_[i].carrier, tie_terms_[i].arm, tie_terms_[i].weight.transpose() * force);
}

double MomentumBalance::slip_limit(const Row& row) const {
  if (row.limit_per_force >= 0.0) return row.limit_per_force * row.force;
  ContactRecord record = points_[row.point];
  record.force = row.force;
  record.slip = row.slip + dt_ * in_plane(change(row), row.normal);
  return row.rule->slip_limit(record, dt_);
}

/// Closes the gap of one point: force <- max(0, force - gap / mobility), and the slip likewise, back on the
/// cone. Returns by how much the forces have changed.
double MomentumBalance::pass(Row& row) {
  const Eigen::Vector3d moved = dt_ * change(row);
  const double gap = row.start + row.normal.dot(moved) + compliance * row.mobility * row.force;
  const double force = std::max(0.0, row.force - gap / ((1.0 + compliance) * row.mobility));
  const double by = force - row.force;
  row.force = force;
  if (row.slides_freely) {
    if (by != 0.0) push(row, by * row.normal);
    return std::abs(by);
  }
  const Eigen::Vector3d slip = recovery * row.held + row.slip + in_plane(moved, row.normal) +
                               compliance * row.side_mobility * row.tangential;
  Eigen::Vector3d tangential = row.tangential - slip / ((1.0 + compliance) * row.side_mobility);
  const double limit = slip_limit(row), size = tangential.norm();
  if (size > limit) tangential *= limit / size;
  const Eigen::Vector3d aside = tangential - row.tangential;
  row.tangential = tangential;
  push(row, by * row.normal + aside);
  return std::abs(by) + aside.norm();
}

double MomentumBalance::pass(TieRow& row) {
  const double softness = compliance / std::max(row.inverse.trace(), 1e-300);
  const Eigen::Vector3d distance = row.start + dt_ * change(row) + softness * row.force;
  const Eigen::Vector3d by = -(row.inverse * distance);
  row.force += by;
  push(row, by);
  return by.norm();
}

BalanceReport MomentumBalance::solve(int max_iterations) {
  BalanceReport report;
  while (report.n_iterations < max_iterations) {
    const bool goes_back = report.n_iterations % 2 == 1;
    double changed = 0.0, all = 0.0;
    const auto pass_all = [&](auto& rows) {
      for (std::size_t i = 0; i < rows.size(); ++i)
        changed += pass(rows[goes_back ? rows.size() - 1 - i : i]);
    };
    pass_all(tie_rows_);
    pass_all(rows_);
    for (const Row& row : rows_) all += row.force;
    for (const TieRow& row : tie_rows_) all += row.force.norm();
    ++report.n_iterations;
    report.residual = all > 0.0 ? changed / all : 0.0;
    if (report.residual <= balanced) break;
  }
  for (Row& row : rows_) finish(row);
  for (const TieRow& row : tie_rows_) finish(row);
  memory_.clear();
  for (const Row& row : rows_) {
    if (!(row.force > 0.0)) continue;
    const ContactRecord& point = points_[row.point];
    memory_.push_back({kind_of(point), point.first_place, point.second_place, point.part,
                       row.force / point.area, row.tangential / point.area, row.held});
  }
  if (!std::ranges::is_sorted(memory_, {}, &Memory::key))
    std::ranges::stable_sort(memory_, {}, &Memory::key);
  return report;
}

/// The velocity of the first side against the second, in the step before or in the coming one without these
/// forces [length/time].
Eigen::Vector3d MomentumBalance::relative_velocity(const ContactRecord& record, bool is_before) const {
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

void MomentumBalance::finish(Row& row) {
  ContactRecord& point = points_[row.point];
  const Eigen::Vector3d after = relative_velocity(point, false) + change(row);
  if (row.force > 0.0) {
    const Eigen::Vector3d before = relative_velocity(point, true);
    const double normal_before = -0.5 * dt_before_ * row.force * row.normal.dot(before);
    const double normal_after = -0.5 * dt_ * row.force * row.normal.dot(after);
    const double along_before = -0.5 * dt_before_ * row.tangential.dot(before);
    const double along_after = -0.5 * dt_ * row.tangential.dot(after);
    loss_.impact_before += normal_before;
    loss_.impact_after += normal_after;
    loss_.friction_before += along_before;
    loss_.friction_after += along_after;
    point.impact = normal_before + normal_after;
    point.dissipated = along_before + along_after;
  }
  point.force += row.force;
  point.tangential += row.tangential;
  if (row.slides_freely) return;
  const Eigen::Vector3d slip = dt_ * in_plane(after, row.normal);
  const bool slides = row.tangential.norm() >= (1.0 - 1e-9) * slip_limit(row);
  point.slip = slides ? slip : Eigen::Vector3d::Zero();
  row.held = slides ? Eigen::Vector3d::Zero() : Eigen::Vector3d(row.held + slip);
  if (!(row.force > 0.0)) row.held.setZero();
  point.elastic = row.held;
}

void MomentumBalance::finish(const TieRow& row) {
  FaceCorners second;
  for (int k = 0; k < 4; ++k) second.col(k) = surface_->x(row.tie->nodes[static_cast<std::size_t>(k) + 4]);
  row.tie->points[row.point].force = axes_of(second).transpose() * row.force;
}

TieForces MomentumBalance::find_forces(const Tie& tie) const {
  TieVectors x;
  for (std::size_t k = 0; k < 8; ++k) x.col(static_cast<Eigen::Index>(k)) = surface_->x(tie.nodes[k]);
  const TieVectors arms = x.colwise() - Eigen::Vector3d(x.col(0));
  const FaceCorners second = arms.rightCols<4>();
  const Eigen::Matrix3d axes = axes_of(second);
  TieForces found{TieVectors::Zero(), axes.col(2)};
  for (std::uint32_t p = 0; p < tie.n_points; ++p) {
    const TiePoint& point = tie.points[p];
    const Eigen::Vector3d force = axes * point.force;
    found.forces.leftCols<4>() += force * point.weights_1.transpose();
    const auto carried = carry_point(second, point.weights_2, axes * point.offset);
    for (std::size_t k = 0; k < 4; ++k)
      found.forces.col(static_cast<Eigen::Index>(k) + 4) -= carried[k].transpose() * force;
  }
  return found;
}

void MomentumBalance::renumber(const ContactRenumbering& places) {
  mobility_.forget();
  constexpr std::uint32_t gone = ContactRenumbering::gone;
  std::vector<Memory> kept;
  for (Memory known : memory_) {
    const auto& first = known.kind == 0 ? places.faces : known.kind == 2 ? places.edges : places.rows;
    known.first = first[known.first];
    if (known.kind != 3) known.second = (known.kind == 2 ? places.edges : places.faces)[known.second];
    if (known.first != gone && known.second != gone) kept.push_back(known);
  }
  std::ranges::stable_sort(kept, {}, &Memory::key);
  memory_ = std::move(kept);
}

void MomentumBalance::archive(StateArchive& saved) {
  saved.rows("contact/points", memory_, [](Memory& known, RowNumbers& row) {
    row(known.kind, known.first, known.second, known.part, known.pressure, known.traction, known.held);
  });
}

}  // namespace contactsim
