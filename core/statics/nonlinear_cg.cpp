// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/nonlinear_cg.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace contactsim {

namespace {

/// Whether a residual is as small as one of two bounds.
bool is_below(double residual, double reference, std::optional<double> relative,
              std::optional<double> absolute) {
  if (!std::isfinite(residual) || !std::isfinite(reference)) return false;
  return (relative && residual <= *relative * reference) || (absolute && residual <= *absolute);
}

}  // namespace

bool is_balanced(const Equilibrium& equilibrium, double size, const CgSettings& settings, CgReport& report) {
  report.residual = size;
  report.reference = equilibrium.reference();
  if (report.n_iterations < settings.min_iterations) return false;
  if (size > equilibrium.round_off() &&
      !is_below(size, report.reference, settings.target_relative_residual, settings.target_residual))
    return false;
  report.end = CgReport::End::converged;
  return true;
}

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// The search along one direction after another.
class Search {
 public:
  Search(Equilibrium& equilibrium, const CgSettings& settings, Eigen::VectorXd& increment)
      : equilibrium_(equilibrium), settings_(settings), increment_(increment) {}

  /// Where the search begins. Returns false when it cannot.
  bool begin() { return evaluate(increment_, residual_); }

  /// Goes along the steepest direction first.
  void begin_along(const Preconditioner& preconditioner) {
    preconditioner.apply(residual_, z_);
    direction_ = z_;
    z_dot_residual_ = z_.dot(residual_);
  }

  /// Chooses the next direction. Precondition: move() has been called.
  void turn(const Preconditioner& preconditioner) {
    preconditioner.apply(residual_, z_);
    const double now = z_.dot(residual_);
    const double beta = std::max(0.0, (now - z_.dot(last_residual_)) / z_dot_residual_);
    direction_ = z_ + beta * direction_;
    if (!(direction_.dot(residual_) > 0.0)) direction_ = z_;
    z_dot_residual_ = now;
  }

  /// Moves along the direction. Returns false when there is nowhere to go.
  bool move();

  double size() const { return equilibrium_.norm(residual_); }
  std::int64_t n_evaluations() const { return n_evaluations_; }

 private:
  bool evaluate(const Eigen::VectorXd& at, Eigen::VectorXd& residual) {
    ++n_evaluations_;
    return equilibrium_.evaluate(at, residual) && residual.allFinite();
  }

  Equilibrium& equilibrium_;
  const CgSettings& settings_;
  Eigen::VectorXd& increment_;
  Eigen::VectorXd residual_, last_residual_, z_, direction_, trial_, trial_residual_;
  double z_dot_residual_ = 0.0;
  double way_ = 1.0;  // along the last direction
  std::int64_t n_evaluations_ = 0;
};

/// Regula falsi between ways with a slope ahead and one behind, once both are known; before, the secant.
bool Search::move() {
  constexpr int max_trials = 4, max_halvings = 20;
  // No trial goes this many times as far as the one before.
  constexpr double widest = 4.0;
  const double slope = direction_.dot(residual_);
  if (!(slope > 0.0) || !std::isfinite(slope)) return false;
  const double longest = equilibrium_.longest_step(direction_);
  double way = std::min(way_, longest), near = 0.0, near_slope = slope;
  std::optional<double> far;
  double far_slope = 0.0;
  for (int trial = 0, halvings = 0;; ++trial) {
    trial_ = increment_ + way * direction_;
    if (!evaluate(trial_, trial_residual_)) {
      if (++halvings > max_halvings) return false;
      way = near + 0.5 * (way - near);
      --trial;
      continue;
    }
    const double found = direction_.dot(trial_residual_);
    if (std::abs(found) <= settings_.line_search_tolerance * slope || trial + 1 == max_trials) break;
    if (found > 0.0 && way >= longest) break;
    if (found > 0.0) {
      const double fall = near_slope - found;
      if (!far) far_slope = fall > 0.0 ? found * (way - near) / fall : infinity;  // how far it seems to be
      near = way;
      near_slope = found;
      if (!far) {
        way = std::min(way + std::min(far_slope, (widest - 1.0) * way), longest);
        continue;
      }
    } else {
      far = way;
      far_slope = found;
    }
    way = near + (*far - near) * near_slope / (near_slope - far_slope);
  }
  way_ = std::max(way, std::numeric_limits<double>::min());
  increment_ = trial_;
  last_residual_.swap(residual_);
  residual_.swap(trial_residual_);
  return true;
}

}  // namespace

CgReport nonlinear_cg(Equilibrium& equilibrium, const Preconditioner& preconditioner,
                      const CgSettings& settings, Eigen::VectorXd& increment) {
  CgReport report;
  Search search(equilibrium, settings, increment);
  const bool begins = search.begin();
  while (begins) {
    if (is_balanced(equilibrium, search.size(), settings, report)) break;
    if (report.n_iterations >= settings.max_iterations) break;
    report.n_iterations == 0 ? search.begin_along(preconditioner) : search.turn(preconditioner);
    if (!search.move()) break;
    ++report.n_iterations;
  }
  if (report.end == CgReport::End::failed && begins && report.residual > 0.0 &&
      is_below(report.residual, report.reference, settings.acceptable_relative(),
               settings.acceptable_residual))
    report.end = CgReport::End::acceptable;
  report.n_evaluations = search.n_evaluations();
  return report;
}

std::int64_t predict_linearly(Equilibrium& equilibrium, const Preconditioner& preconditioner,
                              const Eigen::VectorXd& prescribed, std::int64_t max_iterations,
                              Eigen::VectorXd& increment) {
  constexpr double tolerance = 1e-3;  // of the first residual: the search that follows does the rest
  Eigen::VectorXd at_base, moved;
  std::int64_t n_evaluations = 1;
  if (!equilibrium.evaluate(increment, at_base)) {
    increment += prescribed;
    return n_evaluations;
  }
  // Sets `product` to the stiffness times a direction.
  const auto multiply = [&](const Eigen::VectorXd& direction, Eigen::VectorXd& product) {
    ++n_evaluations;
    const double factor = equilibrium.probe_factor(direction);
    if (!equilibrium.evaluate(increment + factor * direction, moved)) return false;
    product = (at_base - moved) / factor;
    return true;
  };
  Eigen::VectorXd residual = at_base, solution = prescribed, product, z;
  if (!prescribed.isZero(0.0)) {
    if (multiply(prescribed, product)) residual -= product;
  }
  const double target = tolerance * equilibrium.norm(residual);
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(residual.size());
  double last = 1.0;  // z . residual
  for (std::int64_t i = 0; i < max_iterations && equilibrium.norm(residual) > target; ++i) {
    preconditioner.apply(residual, z);
    const double now = z.dot(residual);
    direction = z + (i == 0 ? 0.0 : now / last) * direction;
    last = now;
    if (!multiply(direction, product)) break;
    const double curvature = direction.dot(product);
    if (!(curvature > 0.0)) break;
    const double way = now / curvature;
    solution += way * direction;
    residual -= way * product;
  }
  // What contact alone holds drifts no farther than contact sees; prescribed motion is what it is.
  const Eigen::VectorXd free = solution - prescribed;
  increment += prescribed + std::min(1.0, equilibrium.longest_step(free)) * free;
  return n_evaluations;
}

}  // namespace contactsim
