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

/// Share of the forces of the step before that those of a step begin with. A pass leaves the share r of a slow
/// mode of gaps g; with a share w of the forces taken over, g(n+1) = r ((2 + w) g(n) - (1 + 2 w) g(n-1) +
/// w g(n-2)), which for r near 1 stays bounded for w < 2/3 only.
constexpr double taken_over = 0.5;

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
  next_point_.clear();
  row_of_node_.assign(surface.faces().n_nodes(), none);
  terms_.clear();
  tie_terms_.clear();
  rows_.clear();
  tie_rows_.clear();
  loss_ = {};
}

/// The row of a point, a new one if need be: points of one multiplier that look the same way have one. What is
/// still open stands aside where something closes.
std::uint32_t MomentumBalance::find_row(const ContactRecord& record, const PairRule& rule) {
  constexpr double same_way = 0.7;
  const auto make = [&] {
    Row& row = rows_.emplace_back();
    row.rule = &rule;
    row.is_open = record.is_open;
    row.normal = record.normal;
    return static_cast<std::uint32_t>(rows_.size()) - 1;
  };
  if (record.multiplier == ContactRecord::no_multiplier) return make();
  std::uint32_t* place = &row_of_node_[record.multiplier];
  std::uint32_t n = 0;
  for (; *place != none; place = &rows_[*place].next, ++n) {
    Row& row = rows_[*place];
    if (row.rule != &rule || row.normal.normalized().dot(record.normal) < same_way) continue;
    if (row.is_open == record.is_open) return *place;
    if (record.is_open) return none;
    row.first_point = row.last_point = none;
    row.is_open = false;
    row.area = row.gap = row.closing = 0.0;
    return *place;
  }
  const std::uint32_t made = static_cast<std::uint32_t>(rows_.size());
  *place = made;  // before the rows may move
  make();
  rows_.back().part = n;
  return made;
}

void MomentumBalance::add(const ContactRecord& record, const PairRule& rule, double thickness) {
  const auto point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(record);
  next_point_.push_back(none);
  if (record.touches()) {  // a law that acts besides
    Row law;
    law.first_term = static_cast<std::uint32_t>(terms_.size());
    add_terms(law, record, 1.0);
    law.n_terms = static_cast<std::uint32_t>(terms_.size()) - law.first_term;
    push_along(law, record.force_on_first());
  }
  if (!record.is_balanced || !(record.area > 0.0)) return;
  const std::uint32_t index = find_row(record, rule);
  if (index == none) return;
  Row& row = rows_[index];
  if (row.first_point == none) {
    row.first_point = point;
    row.normal.setZero();
    row.thickness = thickness;
  } else {
    next_point_[row.last_point] = point;
  }
  row.last_point = point;
  row.area += record.area;
  row.normal += record.area * record.normal;
  row.gap += record.area * record.gap;
  row.closing += record.area * record.closing;
  row.thickness = std::min(row.thickness, thickness);
}

/// Adds the terms of a point to those at the end, which are of its row.
void MomentumBalance::add_terms(const Row& row, const ContactRecord& point, double share) {
  const auto add_side = [&](const RecordSide& side, double sign) {
    carriers_.clear();
    const Eigen::Vector3d beside = -sign * side.radius * point.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) mobility_.add_terms(side.nodes[k], sign * weight, beside, carriers_);
    }
    for (const CarrierTerm& carrier : carriers_) {
      auto term = std::find_if(terms_.begin() + row.first_term, terms_.end(),
                               [&](const Term& known) { return known.carrier == carrier.carrier; });
      if (term == terms_.end()) {
        terms_.emplace_back().carrier = carrier.carrier;
        term = terms_.end() - 1;
      }
      const double weight = share * carrier.weight;
      term->normal.head<3>() += weight * point.normal;
      term->weight += weight;
      term->turn += weight * carrier.arm.cross(point.normal);
      term->arm += weight * carrier.arm;
    }
  };
  add_side(point.first, 1.0);
  add_side(point.second, -1.0);
}

template <class Visit>
void MomentumBalance::visit_points(const Row& row, const Visit& visit) {
  for (std::uint32_t i = row.first_point; i != none; i = next_point_[i]) visit(points_[i]);
}

/// Completes a row whose points are all there, and pushes with the force that it begins with.
void MomentumBalance::build(Row& row) {
  row.gap /= row.area;
  row.closing /= row.area;
  row.normal.normalize();
  row.first_term = static_cast<std::uint32_t>(terms_.size());
  visit_points(row, [&](const ContactRecord& point) { add_terms(row, point, point.area / row.area); });
  row.n_terms = static_cast<std::uint32_t>(terms_.size()) - row.first_term;
  Eigen::Matrix3d along = Eigen::Matrix3d::Zero();
  for (std::uint32_t i = row.first_term; i < terms_.size(); ++i) {
    const Term& term = terms_[i];
    row.is_plain = row.is_plain && mobility_.is_plain(term.carrier);
    row.mobility += dt_ * mobility_.mobility(term.carrier, term.normal.head<3>(), term.turn);
    along += dt_ * mobility_.mobility(term.carrier, term.weight, term.arm);
  }
  const double deep = std::max(0.0, -row.gap);
  const double comes_out = std::min(recovery * deep, fastest_recovery * row.thickness);
  row.start = row.gap - row.closing + std::max(0.0, deep - comes_out);
  row.slides_freely = !(row.rule->friction > 0.0);
  if (!(row.mobility > 0.0)) return;  // both sides are held or driven
  recall(row);
  if (row.force > 0.0) push_normal(row, row.force);
  if (row.slides_freely) return;
  row.limit_per_force = row.rule->place == nullptr ? row.rule->friction : -1.0;
  const Eigen::Matrix3d flat = Eigen::Matrix3d::Identity() - row.normal * row.normal.transpose();
  row.side_mobility = (flat * along * flat).cwiseAbs().rowwise().sum().maxCoeff();
  visit_points(row, [&](const ContactRecord& point) {
    row.slip += dt_ * point.area / row.area * in_plane(relative_velocity(point, false), row.normal);
  });
  push_along(row, row.tangential);
}

MomentumBalance::Memory MomentumBalance::key_of(const Row& row) const {
  const ContactRecord& point = points_[row.first_point];
  if (point.multiplier != ContactRecord::no_multiplier)
    return {kind_of(point), point.multiplier, point.pair, row.part};
  return {kind_of(point), point.first_place, point.second_place, point.part};
}

/// A contact point that is new takes over the mean of what its first place has remembered.
void MomentumBalance::recall(Row& row) const {
  const Memory wanted = key_of(row);
  const auto found = std::ranges::lower_bound(memory_, wanted.key(), {}, &Memory::key);
  const bool is_known = found != memory_.end() && found->key() == wanted.key();
  const Memory::Key of_place{wanted.kind, wanted.first, 0, 0};
  auto begin = is_known ? found : std::ranges::lower_bound(memory_, of_place, {}, &Memory::key);
  double pressure = 0.0;
  Eigen::Vector3d traction = Eigen::Vector3d::Zero(), held = Eigen::Vector3d::Zero();
  int n = 0;
  for (; begin != memory_.end() && begin->kind == wanted.kind && begin->first == wanted.first; ++begin) {
    pressure += begin->pressure;
    traction += begin->traction;
    held += begin->held;
    ++n;
    if (is_known) break;
  }
  if (n == 0) return;
  row.force = taken_over * row.area * pressure / n;
  if (row.slides_freely) return;
  row.tangential = taken_over * row.area / n * in_plane(traction, row.normal);
  row.held = in_plane(held / n, row.normal);
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
      mobility += term.weight * mobility_.mobility(term.carrier, 1.0, term.arm) * term.weight.transpose();
    }
    if (!(mobility.trace() > 0.0)) continue;
    const double softer = compliance * mobility.trace();
    row.inverse = (dt_ * (mobility + softer * Eigen::Matrix3d::Identity())).inverse();
    row.start = distance + dt_ * velocity;
    row.force = taken_over * axes * point.force;
    push(row, row.force);
    tie_rows_.push_back(row);
  }
}

/// The change of velocity along the normals [length/time].
double MomentumBalance::normal_change(const Row& row) const {
  const std::uint32_t end = row.first_term + row.n_terms;
  NodeVector sum = NodeVector::Zero();
  for (std::uint32_t i = row.first_term; i < end; ++i)
    sum += terms_[i].normal.cwiseProduct(mobility_.plain_change(terms_[i].carrier));
  double along = sum.sum();
  if (row.is_plain) return along;
  for (std::uint32_t i = row.first_term; i < end; ++i)
    along += mobility_.turning(terms_[i].carrier).dot(terms_[i].turn);
  return along;
}

Eigen::Vector3d MomentumBalance::change(const Row& row) const {
  const std::uint32_t end = row.first_term + row.n_terms;
  NodeVector sum = NodeVector::Zero();
  for (std::uint32_t i = row.first_term; i < end; ++i)
    sum += terms_[i].weight * mobility_.plain_change(terms_[i].carrier);
  Eigen::Vector3d along = sum.head<3>();
  if (row.is_plain) return along;
  for (std::uint32_t i = row.first_term; i < end; ++i)
    along += mobility_.turning(terms_[i].carrier).cross(terms_[i].arm);
  return along;
}

void MomentumBalance::push_normal(const Row& row, double force) {
  const std::uint32_t end = row.first_term + row.n_terms;
  for (std::uint32_t i = row.first_term; i < end; ++i) {
    const Term& term = terms_[i];
    if (mobility_.is_plain(term.carrier)) {
      mobility_.plain_change(term.carrier) += (force * mobility_.plain_mobility(term.carrier)) * term.normal;
    } else {
      mobility_.push(term.carrier, force * term.normal.head<3>(), force * term.turn);
    }
  }
}

void MomentumBalance::push_along(const Row& row, const Eigen::Vector3d& force) {
  for (std::uint32_t i = row.first_term; i < row.first_term + row.n_terms; ++i)
    mobility_.push(terms_[i].carrier, terms_[i].weight * force, terms_[i].arm.cross(force));
}

Eigen::Vector3d MomentumBalance::change(const TieRow& row) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::uint32_t i = row.first_term; i < row.first_term + row.n_terms; ++i) {
    const TieTerm& term = tie_terms_[i];
    const Eigen::Vector3d moved = mobility_.plain_change(term.carrier).head<3>();
    sum += term.weight * (moved + mobility_.turning(term.carrier).cross(term.arm));
  }
  return sum;
}

void MomentumBalance::push(const TieRow& row, const Eigen::Vector3d& force) {
  for (std::uint32_t i = row.first_term; i < row.first_term + row.n_terms; ++i) {
    const TieTerm& term = tie_terms_[i];
    const Eigen::Vector3d own = term.weight.transpose() * force;
    mobility_.push(term.carrier, own, term.arm.cross(own));
  }
}

double MomentumBalance::slip_limit(const Row& row) const {
  if (row.limit_per_force >= 0.0) return row.limit_per_force * row.force;
  ContactRecord record = points_[row.first_point];
  record.force = row.force;
  record.area = row.area;
  record.slip = row.slip + dt_ * in_plane(change(row), row.normal);
  return row.rule->slip_limit(record, dt_);
}

/// Closes the gap of one point: force <- max(0, force - gap / mobility), and the slip likewise, back on the
/// cone. Returns by how much the forces have changed.
double MomentumBalance::pass(Row& row) {
  if (!(row.mobility > 0.0)) return 0.0;
  const double gap = row.start + dt_ * normal_change(row) + compliance * row.mobility * row.force;
  const double force = std::max(0.0, row.force - gap / ((1.0 + compliance) * row.mobility));
  const double by = force - row.force;
  row.force = force;
  if (by != 0.0) push_normal(row, by);
  if (row.slides_freely || (force == 0.0 && row.tangential.isZero(0.0))) return std::abs(by);
  const Eigen::Vector3d slip = recovery * row.held + row.slip + dt_ * in_plane(change(row), row.normal) +
                               compliance * row.side_mobility * row.tangential;
  Eigen::Vector3d tangential = row.tangential - slip / ((1.0 + compliance) * row.side_mobility);
  const double limit = slip_limit(row), size = tangential.norm();
  if (size > limit) tangential *= limit / size;
  const Eigen::Vector3d aside = tangential - row.tangential;
  row.tangential = tangential;
  push_along(row, aside);
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
  std::erase_if(rows_, [](const Row& row) { return row.first_point == none; });
  for (Row& row : rows_) build(row);
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
  std::vector<Memory> known;
  for (const Row& row : rows_) {
    if (!(row.force > 0.0)) continue;
    Memory& memory = known.emplace_back(key_of(row));
    memory.pressure = row.force / row.area;
    memory.traction = row.tangential / row.area;
    memory.held = row.held;
  }
  memory_ = std::move(known);
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
  const Eigen::Vector3d changed = change(row);
  Eigen::Vector3d slip = Eigen::Vector3d::Zero();
  if (!row.slides_freely) slip = row.slip + dt_ * in_plane(changed, row.normal);
  const bool slides = !row.slides_freely && row.tangential.norm() >= (1.0 - 1e-9) * slip_limit(row);
  row.held = slides || !(row.force > 0.0) ? Eigen::Vector3d::Zero() : Eigen::Vector3d(row.held + slip);
  visit_points(row, [&](ContactRecord& point) {
    if (!(row.force > 0.0)) return;
    const double share = point.area / row.area, force = share * row.force;
    const Eigen::Vector3d tangential = share * row.tangential;
    const Eigen::Vector3d before = dt_before_ * relative_velocity(point, true),
                          after = dt_ * (relative_velocity(point, false) + change_at(point));
    const double normal_before = -0.5 * force * point.normal.dot(before),
                 normal_after = -0.5 * force * point.normal.dot(after);
    const double along_before = -0.5 * tangential.dot(before), along_after = -0.5 * tangential.dot(after);
    loss_.impact_before += normal_before;
    loss_.impact_after += normal_after;
    loss_.friction_before += along_before;
    loss_.friction_after += along_after;
    point.impact = normal_before + normal_after;
    point.dissipated = along_before + along_after;
    point.force += force;
    point.tangential += tangential;
    point.elastic = row.held;
    if (slides) point.slip = slip;
  });
}

/// The change of the velocity of a point's first side against its second [length/time].
Eigen::Vector3d MomentumBalance::change_at(const ContactRecord& point) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  const auto add_side = [&](const RecordSide& side, double sign) {
    carriers_.clear();
    const Eigen::Vector3d beside = -sign * side.radius * point.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) mobility_.add_terms(side.nodes[k], sign * weight, beside, carriers_);
    }
    for (const CarrierTerm& term : carriers_) {
      const Eigen::Vector3d moved = mobility_.plain_change(term.carrier).head<3>();
      sum += term.weight * (moved + mobility_.turning(term.carrier).cross(term.arm));
    }
  };
  add_side(point.first, 1.0);
  add_side(point.second, -1.0);
  return sum;
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
    const auto& first = known.kind == 0 ? places.nodes : known.kind == 2 ? places.edges : places.rows;
    known.first = first[known.first];
    if (known.kind == 1 || known.kind == 2) known.second = (known.kind == 2 ? places.edges : places.faces)[known.second];
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
