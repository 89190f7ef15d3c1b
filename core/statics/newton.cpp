// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/newton.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/statics/gmres.hpp"

namespace contactsim {

namespace {

/// Up to this share of what residuals are compared with contact is linearised by differences.
constexpr double near_balance = 0.05;

}  // namespace

void LinearisedEquilibrium::solve(const Eigen::VectorXd& increment, const Eigen::VectorXd& residual,
                                  const Eigen::VectorXd& right, CgReport& report, Eigen::VectorXd& z) {
  // Of faces that part and meet a step gains no more than a hundredth.
  const double tolerance = equilibrium_.is_rough() ? 1e-2 : 1e-3;
  constexpr int most_of_now = 240;
  const Eigen::VectorXd scales = equilibrium_.scales(right.size());
  // Rotations without inertia, of nodes of solids, have a scale of 0 and no moments.
  const Eigen::VectorXd lengths =
      scales.unaryExpr([](double scale) { return scale > 0.0 ? 1.0 / scale : 0.0; });
  Eigen::VectorXd moved;
  bool exists = true;
  const bool by_springs = equilibrium_.is_rough() && !is_near_;
  const auto multiply = [&](const Eigen::VectorXd& direction, Eigen::VectorXd& product) {
    const double factor = equilibrium_.probe_factor(direction);
    ++report.n_evaluations;
    equilibrium_.hold_rough(by_springs);
    exists = exists && equilibrium_.evaluate(increment + factor * direction, moved);
    equilibrium_.hold_rough(false);
    if (!exists) {
      product = scales.cwiseProduct(direction);
      return;
    }
    product = (residual - moved) / factor;
    if (by_springs) equilibrium_.add_springs(direction, product);
    if (const Eigen::VectorXd* ground = preconditioner_.ground()) product += ground->cwiseProduct(direction);
    const bool is_negative = !equilibrium_.is_rough() && product.dot(direction) < 0.0;
    report.meets_negative = report.meets_negative || is_negative;
    product = product.cwiseProduct(scales).eval();
  };
  const auto precondition = [&](const Eigen::VectorXd& left, Eigen::VectorXd& step) {
    preconditioner_.apply(left.cwiseProduct(lengths), step);
  };
  const auto minimise = [&](int most) {
    const LinearSearch search = gmres(multiply, precondition, right.cwiseProduct(scales), tolerance, most, z);
    report.n_linear += search.n_iterations;
    return search.end == LinearSearch::End::converged;
  };
  bool is_found = minimise(most_left_behind_);
  if (!is_found && preconditioner_.catch_up()) is_found = minimise(most_left_behind_);
  if (!is_found) {
    const std::int64_t before = report.n_linear;
    renew_(increment, false);
    minimise(most_of_now);
    // What needs many by that of now, too, gains nothing by another one.
    most_left_behind_ = std::clamp(static_cast<int>(2 * (report.n_linear - before)), most_left_behind_, 60);
  }
  if (!exists) preconditioner_.apply(right, z);
}

CgReport newton(Equilibrium& equilibrium, LinearisedEquilibrium& linearised, const CgSettings& settings,
                Eigen::VectorXd& increment) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const int max_idle =
      equilibrium.is_rough() ? 12 : 6;  // steps without a smaller residual than the least so far
  constexpr int max_halvings = 10;      // of a step that cannot be evaluated
  CgReport report;
  // A residual with contact, from which on a step is halved, is the largest of the last steps as long as it
  // is larger than what it is compared with: faces that part and meet make it grow on the way to where it
  // falls. Not so where contact alone holds a body, which would drift away. Source: Grippo, Lampariello and
  // Lucidi, SIAM J. Numer. Anal. 23 (1986) 707-716.
  std::array<double, 5> recent;
  recent.fill(0.0);
  Eigen::VectorXd residual, moved, z, trial, best_trial;
  ++report.n_evaluations;
  bool exists = equilibrium.evaluate(increment, residual);
  double least = infinity;
  // Friction by the pressure of a trial that is too deep drags as much too much, which leads nowhere. Far
  // from balance it has limits that do not follow, as the problem is then one of a potential; near balance
  // they do, and where that leaves more they are taken anew. Source: Kikuchi and Oden, Contact Problems in
  // Elasticity (1988), 10.4.
  constexpr int max_holds = 10;
  int n_holds = 0;
  bool is_limited = false;  // the last step
  bool is_stuck = false;    // the last step, by springs, left nearly all: the next one is by differences
  bool was_idle = false;    // the last step left more than half: the next one takes contact the other way
  // A residual that goes up and down, and has not halved for so many steps, may no longer grow.
  constexpr std::int64_t max_fruitless = 6;
  double marked_size = infinity;
  std::int64_t marked = 0;
  double size = 0.0;
  bool balances = false;
  const auto measure = [&] {
    size = equilibrium.norm(residual);
    balances = is_balanced(equilibrium, size, settings, report);
  };
  for (int n_idle = 0; exists; ++report.n_iterations) {
    measure();
    if (!std::isfinite(size)) break;
    const double held_up_to = report.n_iterations == 0 ? 1.0 : near_balance;
    if (linearised.holds_slip_limits() && size <= held_up_to * report.reference) {
      linearised.free_slip_limits();
      ++report.n_evaluations;
      if (!equilibrium.evaluate(increment, residual)) break;
      measure();
      least = marked_size = infinity;
      recent.fill(0.0);
    }
    if (balances && !linearised.holds_slip_limits()) break;
    if (!linearised.holds_slip_limits() && size > report.reference && n_holds++ < max_holds) {
      ++report.n_evaluations;
      equilibrium.evaluate(increment, residual);
      if (!linearised.hold_slip_limits()) n_holds = max_holds;
    }
    n_idle = size < least || is_limited ? 0 : n_idle + 1;
    least = std::min(least, size);
    if (least <= 0.5 * marked_size) {
      marked_size = least;
      marked = report.n_iterations;
    }
    if (n_idle > max_idle || report.n_iterations >= settings.max_iterations) break;
    if (equilibrium.is_rough()) linearised.note_contact(increment);
    const bool is_near = size <= near_balance * report.reference;
    const bool by_differences = is_near ? !was_idle : is_stuck;
    linearised.set_near(by_differences);
    recent[static_cast<std::size_t>(report.n_iterations) % recent.size()] = size;
    linearised.solve(increment, residual, residual, report, z);
    const double longest = equilibrium.longest_step(z);
    const bool is_fruitless = report.n_iterations - marked >= max_fruitless;
    const bool may_grow = size > report.reference && std::isinf(longest) && !is_fruitless;
    const double bound = may_grow ? *std::ranges::max_element(recent) : size;
    is_limited = longest < 1.0;
    if (is_limited) z *= longest;
    exists = false;
    double best = infinity;
    for (int i = 0; i < max_halvings; ++i, z *= 0.5) {
      trial = increment + z;
      ++report.n_evaluations;
      if (!equilibrium.evaluate(trial, moved) || !moved.allFinite()) continue;
      const double now = equilibrium.norm(moved);
      if (now >= best) break;
      exists = true;
      best = now;
      best_trial = trial;
      residual = moved;
      if (!equilibrium.is_rough() || now <= bound) break;
    }
    was_idle = is_near && !was_idle && best > 0.5 * size;
    is_stuck = !by_differences && size <= report.reference && best > 0.8 * size;
    if (exists) increment.swap(best_trial);
  }
  linearised.free_slip_limits();
  return report;
}

std::int64_t predict_by_newton(Equilibrium& equilibrium, LinearisedEquilibrium& linearised,
                               const Eigen::VectorXd& prescribed, Eigen::VectorXd& increment) {
  CgReport report;
  Eigen::VectorXd residual, moved, z;
  ++report.n_evaluations;
  if (!equilibrium.evaluate(increment, residual)) {
    increment += prescribed;
    return report.n_evaluations;
  }
  Eigen::VectorXd right = residual;
  if (!prescribed.isZero(0.0)) {
    const double factor = equilibrium.probe_factor(prescribed);
    ++report.n_evaluations;
    if (equilibrium.evaluate(increment + factor * prescribed, moved)) right -= (residual - moved) / factor;
    ++report.n_evaluations;
    equilibrium.evaluate(increment, residual);
  }
  linearised.set_near(false);
  linearised.solve(increment, residual, right, report, z);
  // What contact alone holds drifts no farther than contact sees; prescribed motion is what it is.
  increment += prescribed + std::min(1.0, equilibrium.longest_step(z)) * z;
  return report.n_evaluations;
}

}  // namespace contactsim
