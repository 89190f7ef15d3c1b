// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/newton.hpp"

#include <Eigen/Dense>
#include <optional>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A block on springs of its own that slides over a floor which it is pressed onto: friction makes the
/// stiffness unsymmetric, and the floor is rough.
class Slider final : public Equilibrium {
 public:
  bool evaluate(const Eigen::VectorXd& increment, Eigen::VectorXd& residual) override {
    ++n_evaluations;
    if (!holds_) pressed_ = increment;
    const double depth = std::max(0.0, -pressed_(1)), pressure = floor * depth * depth;
    residual = push - (stiffness * increment.array()).matrix();
    drag_ = friction * pressure;
    residual += Eigen::Vector2d(-held_drag_.value_or(drag_), pressure);
    return increment.cwiseAbs().maxCoeff() < 1e3;
  }
  double reference() const override { return push.norm(); }
  double probe_factor(const Eigen::VectorXd& direction) const override {
    return 1e-7 / direction.cwiseAbs().maxCoeff();
  }
  bool is_rough() const override { return true; }
  void hold_rough(bool does) override { holds_ = does; }
  bool hold_slip_limits(bool does) override {
    held_drag_ = does ? std::optional(drag_) : std::nullopt;
    return does;
  }
  bool holds_slip_limits() const { return held_drag_.has_value(); }
  void find_springs() override { ++n_springs; }
  void add_springs(const Eigen::VectorXd& direction, Eigen::VectorXd& product) const override {
    const double slope = 2.0 * floor * std::max(0.0, -pressed_(1)) * direction(1);
    product += Eigen::Vector2d(held_drag_ ? 0.0 : -friction * slope, slope);
  }

  Eigen::Array2d stiffness{1.0, 2.0};
  double floor = 1e4, friction = 0.8;
  Eigen::Vector2d push{3.0, -1.0};
  int n_evaluations = 0, n_springs = 0;

 private:
  bool holds_ = false;
  double drag_ = 0.0;
  std::optional<double> held_drag_;
  Eigen::VectorXd pressed_;
};

/// Divides by stiffnesses.
class Divider final : public Preconditioner {
 public:
  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override {
    z = (residual.array() / of).matrix();
  }
  Eigen::Array2d of{1.0, 2.0};
};

/// A spring that is pulled, and a rotation that has neither inertia nor moments.
class SpringAndTurn final : public Equilibrium {
 public:
  bool evaluate(const Eigen::VectorXd& increment, Eigen::VectorXd& residual) override {
    residual = Eigen::Vector2d(3.0 - 1.0 * increment(0), 0.0);
    return true;
  }
  double reference() const override { return 3.0; }
  double probe_factor(const Eigen::VectorXd& direction) const override {
    return 1e-7 / direction.cwiseAbs().maxCoeff();
  }
  Eigen::VectorXd scales(Eigen::Index /*size*/) const override { return Eigen::Vector2d(1.0, 0.0); }
};

CgSettings slider_settings(double target) {
  CgSettings settings;
  settings.target_relative_residual = target;
  settings.max_iterations = 50;
  return settings;
}

}  // namespace

TEST_CASE("Newton's steps by differences find where friction slides", "[core][statics]") {
  Slider slider;
  Divider divider;
  int n_renewed = 0;
  LinearisedEquilibrium linearised(slider, divider, [&](const Eigen::VectorXd& at, bool may_keep_elements) {
    CHECK(may_keep_elements);
    Eigen::VectorXd residual;
    slider.evaluate(at, residual);
    slider.find_springs();
    ++n_renewed;
  });
  Eigen::VectorXd increment = Eigen::VectorXd::Zero(2), residual;
  const CgReport report = newton(slider, linearised, slider_settings(1e-10), increment);
  CHECK(report.end == CgReport::End::converged);
  CHECK(report.n_iterations == n_renewed);
  CHECK(slider.n_springs == n_renewed);
  CHECK(report.n_iterations < 12);
  CHECK(report.n_linear >= report.n_iterations);
  CHECK_FALSE(report.meets_negative);
  REQUIRE(slider.evaluate(increment, residual));
  CHECK(residual.norm() < 1e-9);
  const double depth = -increment(1);
  CHECK(slider.floor * depth * depth + 2.0 * depth == Approx(1.0));
  CHECK(increment(0) == Approx(3.0 - 0.8 * slider.floor * depth * depth));
}

TEST_CASE("far from balance friction has limits that do not follow what presses, near it they do",
          "[core][statics]") {
  Slider slider;
  Divider divider;
  LinearisedEquilibrium linearised(slider, divider, [&](const Eigen::VectorXd&, bool) {});
  Eigen::VectorXd increment = Eigen::Vector2d(0.0, -0.01), residual;
  REQUIRE(slider.evaluate(increment, residual));
  CHECK(linearised.hold_slip_limits());
  increment(1) = -0.5;  // by what presses there it would be dragged by 2000
  const CgReport report = newton(slider, linearised, slider_settings(1e-10), increment);
  CHECK(report.end == CgReport::End::converged);
  CHECK_FALSE(slider.holds_slip_limits());
  REQUIRE(slider.evaluate(increment, residual));
  CHECK(residual.norm() < 1e-9);

  linearised.set_free(true);
  CHECK_FALSE(linearised.hold_slip_limits());
  CHECK_FALSE(slider.holds_slip_limits());
}

TEST_CASE("a prediction by a step of Newton's balances what is prescribed", "[core][statics]") {
  Slider slider;
  slider.floor = 0.0;
  Divider divider;
  LinearisedEquilibrium linearised(slider, divider, [](const Eigen::VectorXd&, bool) {});
  Eigen::VectorXd increment = Eigen::VectorXd::Zero(2);
  const std::int64_t n = predict_by_newton(slider, linearised, Eigen::Vector2d(0.5, 0.0), increment);
  CHECK(n == slider.n_evaluations);
  CHECK((increment - Eigen::Vector2d(3.0, -0.5)).norm() < 1e-5);
}

TEST_CASE("rotations without inertia stay numbers", "[core][statics]") {
  SpringAndTurn equilibrium;
  Divider divider;
  LinearisedEquilibrium linearised(equilibrium, divider, [&](const Eigen::VectorXd&, bool) {});
  Eigen::VectorXd increment = Eigen::VectorXd::Zero(2);
  CHECK(newton(equilibrium, linearised, slider_settings(1e-10), increment).end == CgReport::End::converged);
  CHECK(increment(0) == Approx(3.0));
  CHECK(increment(1) == 0.0);
}
