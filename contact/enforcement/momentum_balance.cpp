// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/momentum_balance.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "core/state_archive.hpp"

namespace contactsim {

namespace {

/// The most of a penetration that comes out in a step, over the thickness, and the share of a slip held by
/// friction.
constexpr double fastest_recovery = 2e-4, recovery = 0.1;

/// Constraints give way by this share of their softness, so that forces which move nothing stay bounded.
constexpr double compliance = 1e-6;

/// Share of the forces of the step before that those of a step begin with. Where passes leave the share r of
/// a slow mode of gaps g, a share w taken over makes g(n+1) = r ((2 + w) g(n) - (1 + 2 w) g(n-1) + w g(n-2)),
/// which for r near 1 stays bounded for w < 2/3 only.
constexpr double taken_over = 0.5;

/// Forces that change by less in a pass, over their sum, are balanced.
constexpr double balanced = 1e-4;

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
  tie_terms_.clear();
  rows_.clear();
  tie_rows_.clear();
  loss_ = {};
}

void MomentumBalance::add_terms(const ContactRecord& record, std::vector<Term>& terms) {
  const auto add_side = [&](const RecordSide& side, double sign) {
    carriers_.clear();
    const Eigen::Vector3d beside = -sign * side.radius * record.normal;
    for (std::size_t k = 0; k < 4; ++k) {
      const double weight = side.weights[static_cast<Eigen::Index>(k)];
      if (weight != 0.0) mobility_.add_terms(side.nodes[k], sign * weight, beside, carriers_);
    }
    for (const CarrierTerm& term : carriers_)
      terms.push_back({term.carrier, term.weight, term.weight * term.arm});
  };
  add_side(record.first, 1.0);
  add_side(record.second, -1.0);
}

void MomentumBalance::add(const ContactRecord& record, const PairRule& rule, double thickness) {
  Row row;
  row.point = static_cast<std::uint32_t>(points_.size());
  points_.push_back(record);
  row.first_term = static_cast<std::uint32_t>(terms_.size());
  add_terms(record, terms_);
  row.n_terms = static_cast<std::uint32_t>(terms_.size()) - row.first_term;
  if (record.touches()) {  // a law that acts besides
    const Eigen::Vector3d force = record.force_on_first();
    for (std::uint32_t i = row.first_term; i < terms_.size(); ++i)
      mobility_.push(terms_[i].carrier, terms_[i].weight * force, terms_[i].arm.cross(force));
  }
  if (!record.is_balanced || !(record.area > 0.0)) return;
  for (std::uint32_t i = row.first_term; i < terms_.size(); ++i)
    row.is_plain = row.is_plain && mobility_.is_plain(terms_[i].carrier);
  row.rule = &rule;
  row.normal = record.normal;
  row.start = record.gap - record.closing + std::max(0.0, -record.gap - fastest_recovery * thickness);
  row.slides_freely = !(rule.friction > 0.0);
  if (!row.slides_freely) {
    row.limit_per_force = rule.place == nullptr ? rule.friction : -1.0;
    row.slip = dt_ * in_plane(relative_velocity(record, false), record.normal);
  }
  recall(record, row);
  rows_.push_back(row);
}

/// A contact point that is new takes over the mean of what its first place has remembered.
void MomentumBalance::recall(const ContactRecord& record, Row& row) const {
  const Memory wanted{kind_of(record), record.first_place, record.second_place, record.part};
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
  row.force = taken_over * record.area * pressure / n * row.normal;
  if (row.slides_freely) return;
  row.force += taken_over * record.area / n * in_plane(traction, row.normal);
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
          is_first ? point.weights_1[static_cast<Eigen::Index>(k)] * Eigen::Matrix3d::Identity()
                   : carried[k - 4];
      const double share = is_first ? weight(0, 0) : point.weights_2[static_cast<Eigen::Index>(k) - 4];
      distance += (is_first ? share : -share) * (x[k] - x[0]);
      velocity += (is_first ? 1.0 : -1.0) * (weight * surface_->v(tie.nodes[k]));
      if (share != 0.0)
        mobility_.add_terms(tie.nodes[k], share, Eigen::Vector3d::Zero(),
                            is_first ? first_side : second_side);
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
    row.start = distance + dt_ * velocity;
    row.force = taken_over * axes * point.force;
    tie_rows_.push_back(row);
  }
}

namespace {

/// Bound of how much a matrix lengthens vectors, exact for multiples of the identity.
double bound_of(const Eigen::Matrix3d& matrix) {
  const Eigen::Matrix3d sizes = matrix.cwiseAbs();
  return std::max(sizes.rowwise().sum().maxCoeff(), sizes.colwise().sum().maxCoeff());
}

}  // namespace

/// By sums of rows: with the areas a > 0 of the points, |A| a <= D a bounds the eigenvalues of D^-1 A by 1
/// (Collatz and Wielandt). Where nodes are free, D is the lumped mass per area on both sides in series.
void MomentumBalance::find_softness() {
  area_of_.assign(mobility_.n_carriers(), {0.0, 0.0});
  const auto visit_rows = [&](const auto& visit) {
    for (Row& row : rows_) {
      const auto terms = std::span(terms_).subspan(row.first_term, row.n_terms);
      visit(row, points_[row.point].area, terms, [&](const Term& term) {
        const double turn = row.slides_freely ? mobility_.turn_root(term.carrier, term.arm.cross(row.normal))
                                              : mobility_.turn_bound(term.carrier) * term.arm.norm();
        return std::array{std::abs(term.weight), turn};
      });
    }
    for (TieRow& row : tie_rows_) {
      const auto terms = std::span(tie_terms_).subspan(row.first_term, row.n_terms);
      visit(row, row.tie->points[row.point].area, terms, [&](const TieTerm& term) {
        const double bound = bound_of(term.weight);
        return std::array{bound, mobility_.turn_bound(term.carrier) * bound * term.arm.norm()};
      });
    }
  };
  visit_rows([&](const auto&, double area, const auto& terms, const auto& sizes_of) {
    for (const auto& term : terms) {
      const auto sizes = sizes_of(term);
      area_of_[term.carrier][0] += area * sizes[0];
      area_of_[term.carrier][1] += area * sizes[1];
    }
  });
  visit_rows([&](auto& row, double area, const auto& terms, const auto& sizes_of) {
    double gap = 0.0;
    for (const auto& term : terms) {
      const auto sizes = sizes_of(term);
      gap += mobility_.translation_bound(term.carrier) * sizes[0] * area_of_[term.carrier][0] +
             sizes[1] * area_of_[term.carrier][1];
    }
    row.softness = dt_ * gap / area;
  });
}

Eigen::Vector3d MomentumBalance::change(const Row& row) const {
  NodeVector sum = NodeVector::Zero();
  for (const Term& term : std::span(terms_).subspan(row.first_term, row.n_terms))
    sum += term.weight * mobility_.change(term.carrier);
  Eigen::Vector3d changed = sum.head<3>();
  if (row.is_plain) return changed;
  for (const Term& term : std::span(terms_).subspan(row.first_term, row.n_terms))
    changed += mobility_.turning(term.carrier).cross(term.arm);
  return changed;
}

Eigen::Vector3d MomentumBalance::change(const TieRow& row) const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const TieTerm& term : std::span(tie_terms_).subspan(row.first_term, row.n_terms)) {
    const Eigen::Vector3d moved = mobility_.change(term.carrier).head<3>();
    sum += term.weight * (moved + mobility_.turning(term.carrier).cross(term.arm));
  }
  return sum;
}

/// Has the carriers move by the forces that the next pass looks at.
void MomentumBalance::push_all() {
  mobility_.begin_pass();
  for (const Row& row : rows_) {
    if (row.ahead.isZero(0.0)) continue;
    for (const Term& term : std::span(terms_).subspan(row.first_term, row.n_terms)) {
      if (row.is_plain) {
        mobility_.push_plain(term.carrier, term.weight * row.ahead);
      } else {
        mobility_.push(term.carrier, term.weight * row.ahead, term.arm.cross(row.ahead));
      }
    }
  }
  for (const TieRow& row : tie_rows_) {
    for (const TieTerm& term : std::span(tie_terms_).subspan(row.first_term, row.n_terms)) {
      const Eigen::Vector3d own = term.weight.transpose() * row.ahead;
      mobility_.push(term.carrier, own, term.arm.cross(own));
    }
  }
}

double MomentumBalance::slip_limit(const Row& row, double normal_force) const {
  if (row.limit_per_force >= 0.0) return row.limit_per_force * normal_force;
  ContactRecord record = points_[row.point];
  record.force = normal_force;
  record.slip = row.slip + dt_ * in_plane(change(row), row.normal);
  return row.rule->slip_limit(record, dt_);
}

/// Closes the gap: max(0, force - gap / softness), and the slip likewise, back on the cone.
Eigen::Vector3d MomentumBalance::next_force(const Row& row) const {
  const Eigen::Vector3d changed = dt_ * change(row);
  const double now = row.normal.dot(row.ahead), rate = (1.0 - compliance) / row.softness;
  const double gap = row.start + row.normal.dot(changed) + compliance * row.softness * now;
  const double force = std::max(0.0, now - rate * gap);
  if (row.slides_freely) return force * row.normal;
  const Eigen::Vector3d slip = recovery * row.held + row.slip + in_plane(changed, row.normal);
  Eigen::Vector3d tangential = in_plane(row.ahead, row.normal) - rate * slip;
  const double limit = slip_limit(row, force), size = tangential.norm();
  if (size > limit) tangential *= limit / size;
  return force * row.normal + tangential;
}

Eigen::Vector3d MomentumBalance::next_force(const TieRow& row) const {
  const Eigen::Vector3d distance = row.start + dt_ * change(row) + compliance * row.softness * row.ahead;
  return row.ahead - (1.0 - compliance) / row.softness * distance;
}

/// Finds the next forces of all points, and what the pass after looks at: by the momentum beyond them.
MomentumBalance::Pass MomentumBalance::pass(double momentum) {
  Pass sums;
  const auto pass_all = [&](auto& rows) {
    for (auto& row : rows) {
      const Eigen::Vector3d force = next_force(row), step = force - row.force, over = row.ahead - force;
      sums.changed += over.norm();
      sums.all += force.norm();
      sums.uphill += row.softness * over.dot(step);
      row.force = force;
      row.ahead = force + momentum * step;
    }
  };
  pass_all(tie_rows_);
  pass_all(rows_);
  return sums;
}

BalanceReport MomentumBalance::solve(int max_iterations) {
  BalanceReport report;
  mobility_.begin_passes();
  find_softness();
  // Between sides that are held or driven nothing can be done.
  std::erase_if(rows_, [](const Row& row) { return !(row.softness > 0.0); });
  std::erase_if(tie_rows_, [](const TieRow& row) { return !(row.softness > 0.0); });
  const auto forget_momentum = [](auto& rows) {
    for (auto& row : rows) row.ahead = row.force;
  };
  forget_momentum(rows_);
  forget_momentum(tie_rows_);
  double theta = 1.0;
  while (report.n_iterations < max_iterations) {
    push_all();
    const double next = 0.5 * (1.0 + std::sqrt(1.0 + 4.0 * theta * theta));
    const bool is_last = report.n_iterations + 1 == max_iterations;
    const Pass sums = pass(is_last ? 0.0 : (theta - 1.0) / next);
    theta = next;
    ++report.n_iterations;
    report.residual = sums.all > 0.0 ? sums.changed / sums.all : 0.0;
    if (report.residual <= balanced) break;
    if (sums.uphill > 0.0) {
      theta = 1.0;
      forget_momentum(rows_);
      forget_momentum(tie_rows_);
    }
  }
  forget_momentum(rows_);
  forget_momentum(tie_rows_);
  push_all();
  for (Row& row : rows_) finish(row);
  for (const TieRow& row : tie_rows_) finish(row);
  remember();
  return report;
}

void MomentumBalance::remember() {
  memory_.clear();
  for (const Row& row : rows_) {
    const double force = row.normal.dot(row.force);
    if (!(force > 0.0)) continue;
    const ContactRecord& point = points_[row.point];
    memory_.push_back({kind_of(point), point.first_place, point.second_place, point.part, force / point.area,
                       in_plane(row.force, row.normal) / point.area, row.held});
  }
  if (!std::ranges::is_sorted(memory_, {}, &Memory::key)) std::ranges::stable_sort(memory_, {}, &Memory::key);
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
  const double force = row.normal.dot(row.force);
  if (!(force > 0.0)) return;
  ContactRecord& point = points_[row.point];
  const Eigen::Vector3d tangential = in_plane(row.force, row.normal);
  const Eigen::Vector3d before = dt_before_ * relative_velocity(point, true),
                        after = dt_ * (relative_velocity(point, false) + change(row));
  const double normal_before = -0.5 * force * row.normal.dot(before),
               normal_after = -0.5 * force * row.normal.dot(after);
  const double along_before = -0.5 * tangential.dot(before), along_after = -0.5 * tangential.dot(after);
  loss_.impact_before += normal_before;
  loss_.impact_after += normal_after;
  loss_.friction_before += along_before;
  loss_.friction_after += along_after;
  point.impact = normal_before + normal_after;
  point.dissipated = along_before + along_after;
  point.force += force;
  point.tangential += tangential;
  if (row.slides_freely) return;
  const Eigen::Vector3d slip = in_plane(after, row.normal);
  const bool slides = tangential.norm() >= (1.0 - 1e-9) * slip_limit(row, force);
  if (slides) point.slip = slip;
  row.held = slides ? Eigen::Vector3d::Zero() : Eigen::Vector3d(row.held + slip);
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
  contactsim::balance(arms, found.forces);  // what a point is off its place makes no moment
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
