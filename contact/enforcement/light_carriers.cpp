// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/light_carriers.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// The mismatch of forces and motion may have this share of the power that the forces have in the springs of
/// their constraints, and the impulses in the motion that they make.
constexpr double consistent = 1e-20;

double dot(const std::vector<RigidVector>& a, const std::vector<RigidVector>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i].dot(b[i]);
  return sum;
}

RigidMatrix blocks(const Eigen::Matrix3d& translation, const Eigen::Matrix3d& rotation) {
  RigidMatrix both = RigidMatrix::Zero();
  both.topLeftCorner<3, 3>() = translation;
  both.bottomRightCorner<3, 3>() = rotation;
  return both;
}

/// Mass by mobility, and the projection on the directions that are free.
struct MassOf {
  Eigen::Matrix3d mass = Eigen::Matrix3d::Zero(), free = Eigen::Matrix3d::Zero();

  explicit MassOf(const Eigen::Matrix3d& mobility) {
    constexpr double negligible = 1e-9;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(mobility);
    const double largest = axes.eigenvalues().maxCoeff();
    bool is_free = true;
    for (int i = 0; i < 3; ++i) {
      const double own = axes.eigenvalues()[i];
      const Eigen::Vector3d axis = axes.eigenvectors().col(i);
      if (!(own > negligible * largest)) {
        is_free = false;
        continue;
      }
      mass += axis * axis.transpose() / own;
      free += axis * axis.transpose();
    }
    if (is_free) free.setIdentity();
  }
};

}  // namespace

void LightCarriers::begin(std::size_t n_carriers) {
  index_.assign(n_carriers, std::nullopt);
  mobility_.clear();
  mass_.clear();
  free_.clear();
  rows_.clear();
  shares_.clear();
}

void LightCarriers::add(std::uint32_t carrier, const CarrierMobility& mobility) {
  index_[carrier] = static_cast<std::uint32_t>(mobility_.size());
  const MassOf moves(mobility.translation), turns(mobility.rotation);
  mobility_.push_back(blocks(mobility.translation, mobility.rotation));
  mass_.push_back(blocks(moves.mass, turns.mass));
  free_.push_back(blocks(moves.free, turns.free));
}

std::uint32_t LightCarriers::add_row(std::span<const LightShare> shares) {
  rows_.push_back({static_cast<std::uint32_t>(shares_.size()), static_cast<std::uint32_t>(shares.size())});
  shares_.insert(shares_.end(), shares.begin(), shares.end());
  return static_cast<std::uint32_t>(rows_.size()) - 1;
}

Eigen::Vector3d LightCarriers::velocity_of(std::uint32_t row, const Vectors& motion) const {
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();
  for (const LightShare& share : shares_of(row)) {
    const RigidVector& own = motion[share.light];
    velocity += share.weight * (own.head<3>() + own.tail<3>().cross(share.arm));
  }
  return velocity;
}

void LightCarriers::add_force(std::uint32_t row, const Eigen::Vector3d& force, Vectors& sums) const {
  for (const LightShare& share : shares_of(row)) {
    const Eigen::Vector3d own = share.weight.transpose() * force;
    sums[share.light].head<3>() += own;
    sums[share.light].tail<3>() += share.arm.cross(own);
  }
}

void LightCarriers::set_motion() {
  for (std::size_t i = 0; i < mobility_.size(); ++i) motion_[i] = mobility_[i] * impulse_[i];
}

/// Finds the answers to the motion, and what is missing of the impulses. Returns the power of that over the
/// power of forces and impulses: where all sides part at once there are no forces, and what is missing is
/// round-off of the impulses.
double LightCarriers::evaluate(const Answer& answer) {
  double of_forces = dot(impulse_, motion_), of_missing = 0.0;
  for (std::size_t i = 0; i < mobility_.size(); ++i) missing_[i] = -impulse_[i];
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    answers_[row] = answer(row, velocity_of(row, motion_));
    add_force(row, answers_[row].change, missing_);
    of_forces += answers_[row].force.squaredNorm() / answers_[row].stiffest;
  }
  for (std::size_t i = 0; i < mobility_.size(); ++i) {
    const RigidVector free = free_[i] * missing_[i];
    of_missing += free.dot(mobility_[i] * free);
  }
  return of_missing > 0.0 ? of_missing / (of_forces > 0.0 ? of_forces : of_missing) : 0.0;
}

/// The inverse of each carrier's own mass and stiffness.
void LightCarriers::precondition() {
  preconditioner_.assign(mobility_.size(), RigidMatrix::Zero());
  for (std::uint32_t row = 0; row < rows_.size(); ++row) {
    for (const LightShare& share : shares_of(row)) {
      Eigen::Matrix<double, 3, 6> lever;
      lever.leftCols<3>() = share.weight;
      for (int i = 0; i < 3; ++i) lever.col(3 + i) = share.weight * Eigen::Vector3d::Unit(i).cross(share.arm);
      preconditioner_[share.light] += lever.transpose() * answers_[row].rate * lever;
    }
  }
  for (std::size_t i = 0; i < mobility_.size(); ++i) {
    const RigidMatrix& free = free_[i];
    RigidMatrix own = mass_[i] + free * preconditioner_[i] * free;
    // Masses and inertias as numbers without units: what is held is as stiff as what is free, and pivots are
    // the same.
    const double move = own.topLeftCorner<3, 3>().trace(), turn = own.bottomRightCorner<3, 3>().trace();
    RigidVector scale;
    scale.head<3>().setConstant(move > 0.0 ? 1.0 / std::sqrt(move) : 1.0);
    scale.tail<3>().setConstant(turn > 0.0 ? 1.0 / std::sqrt(turn) : 1.0);
    own = scale.asDiagonal() * own * scale.asDiagonal();
    own += RigidMatrix::Identity() - free;
    const RigidMatrix scaled = scale.asDiagonal() * free;
    preconditioner_[i] = scaled * own.ldlt().solve(scaled);
  }
}

/// (M + R^T rate R) x.
void LightCarriers::multiply(const Vectors& x, Vectors& product) const {
  for (std::size_t i = 0; i < x.size(); ++i) product[i] = mass_[i] * x[i];
  for (std::uint32_t row = 0; row < rows_.size(); ++row)
    add_force(row, answers_[row].rate * velocity_of(row, x), product);
  for (std::size_t i = 0; i < x.size(); ++i) product[i] = free_[i] * product[i];
}

/// Newton's step of the impulses: what is missing, less what the motion takes from the forces.
void LightCarriers::find_step() {
  constexpr int max_iterations = 30;
  constexpr double small = 1e-6;  // of the first residual
  precondition();
  const auto scaled = [&](const Vectors& from, Vectors& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = preconditioner_[i] * from[i];
  };
  std::fill(x_.begin(), x_.end(), RigidVector::Zero());
  // What is missing of the moment about a line's own axis turns nothing.
  for (std::size_t i = 0; i < x_.size(); ++i) residual_[i] = free_[i] * missing_[i];
  scaled(residual_, step_);
  search_ = step_;
  double before = dot(residual_, step_);
  const double enough = small * small * before;
  for (int i = 0; i < max_iterations && before > enough; ++i) {
    multiply(search_, product_);
    const double resistance = dot(search_, product_);
    if (!(resistance > 0.0))
      break;  // round-off along what has no mass, such as the turn of a line about itself
    const double along = before / resistance;
    for (std::size_t k = 0; k < x_.size(); ++k) {
      x_[k] += along * search_[k];
      residual_[k] -= along * product_[k];
    }
    scaled(residual_, step_);
    const double now = dot(residual_, step_);
    for (std::size_t k = 0; k < x_.size(); ++k) search_[k] = step_[k] + now / before * search_[k];
    before = now;
  }
  for (std::size_t k = 0; k < x_.size(); ++k) step_[k] = mass_[k] * x_[k];
}

/// Finds the descent of the potential along Newton's step that is left at a share of it.
///   error  of evaluate() there
double LightCarriers::descent_at(double share, const Vectors& start, const Answer& answer, double& error) {
  for (std::size_t k = 0; k < start.size(); ++k) impulse_[k] = start[k] + share * step_[k];
  set_motion();
  error = evaluate(answer);
  return dot(missing_, x_);
}

/// Goes along Newton's step until no more than half of the descent is left of the potential that the forces
/// and the motion have together: what is missing is its descent. Where a constraint begins to press on the
/// way the step is too long, and that place is looked for by false position. The potential is convex: where
/// the descent grows the step is one of round-off. Returns whether it has gone.
///   error  of evaluate(), before and after
bool LightCarriers::go(const Answer& answer, double& error) {
  constexpr int max_tries = 12;
  constexpr double enough = 0.5, growth = 2.0, nearest = 0.1;
  const Vectors start = impulse_;
  const double before = error, descent = dot(missing_, x_);
  if (!(descent > 0.0)) return false;  // of round-off
  double low = 0.0, left_low = descent, high = 1.0, left_high = descent, share = 1.0;
  for (int i = 0; i < max_tries; ++i) {
    const double left = descent_at(share, start, answer, error);
    if (!(left <= growth * descent)) {
      descent_at(0.0, start, answer, error);
      return false;
    }
    const bool is_too_far = left<-enough * descent, is_too_short = left> enough * descent;
    if (!is_too_far && (share == 1.0 || !is_too_short)) return true;
    (is_too_far ? high : low) = share;
    (is_too_far ? left_high : left_low) = left;
    const double part = std::clamp(left_low / (left_low - left_high), nearest, 1.0 - nearest);
    share = low + part * (high - low);
  }
  if (low > 0.0 || error < before) {
    if (low > 0.0) descent_at(low, start, answer, error);
    return true;
  }
  descent_at(0.0, start, answer, error);
  return false;
}

void LightCarriers::solve(const Answer& answer) {
  constexpr int max_steps = 20;
  for (Vectors* all : {&impulse_, &motion_, &missing_, &step_, &x_, &residual_, &search_, &product_})
    all->assign(mobility_.size(), RigidVector::Zero());
  answers_.resize(rows_.size());
  double error = evaluate(answer);
  for (int i = 0; i < max_steps && error > consistent; ++i) {
    find_step();
    if (!go(answer, error)) return;
  }
}

}  // namespace contactsim
