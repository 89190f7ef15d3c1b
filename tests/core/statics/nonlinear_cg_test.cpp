// SPDX-License-Identifier: BSD-3-Clause
#include "core/statics/nonlinear_cg.hpp"

#include <Eigen/Dense>
#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Springs in a row that get stiffer, f = k u + c u^3 between neighbours, the first held, the last pushed.
class SpringRow final : public Equilibrium {
 public:
  SpringRow(Eigen::Index n, double cubic, double push) : n_(n), cubic_(cubic), push_(push) {}

  bool evaluate(const Eigen::VectorXd& increment, Eigen::VectorXd& residual) override {
    ++n_evaluations;
    if (increment.cwiseAbs().maxCoeff() > largest) return false;
    residual = Eigen::VectorXd::Zero(n_);
    residual(n_ - 1) = push_;
    for (Eigen::Index i = 0; i < n_; ++i) {
      const double stretch = increment(i) - (i > 0 ? increment(i - 1) : 0.0);
      const double force = stretch + cubic_ * stretch * stretch * stretch;
      residual(i) -= force;
      if (i > 0) residual(i - 1) += force;
    }
    project(residual);
    return true;
  }
  double reference() const override { return std::abs(push_); }
  double probe_factor(const Eigen::VectorXd& direction) const override {
    return 1e-6 / direction.cwiseAbs().maxCoeff();
  }
  void project(Eigen::VectorXd& vector) const override {
    if (holds_last) vector(n_ - 1) = 0.0;
  }

  double largest = 1e9;
  bool holds_last = false;
  int n_evaluations = 0;

 private:
  Eigen::Index n_;
  double cubic_, push_;
};

class Identity final : public Preconditioner {
 public:
  void apply(const Eigen::VectorXd& residual, Eigen::VectorXd& z) const override { z = residual; }
};

CgSettings to(double target) {
  CgSettings settings;
  settings.target_relative_residual = target;
  settings.max_iterations = 500;
  return settings;
}

}  // namespace

TEST_CASE("linear springs come to rest within as many iterations as there are", "[core][statics]") {
  SpringRow row(10, 0.0, 2.0);
  Eigen::VectorXd u = Eigen::VectorXd::Zero(10);
  const CgReport report = nonlinear_cg(row, Identity(), to(1e-8), u);
  CHECK(report.end == CgReport::End::converged);
  CHECK(report.n_iterations <= 11);
  CHECK(report.n_evaluations == row.n_evaluations);
  for (Eigen::Index i = 0; i < 10; ++i) CHECK(u(i) == Approx(2.0 * static_cast<double>(i + 1)));
}

TEST_CASE("springs that get stiffer share the push", "[core][statics]") {
  SpringRow row(10, 3.0, 4.0);  // 1 + 3 = 4: each is stretched by 1
  Eigen::VectorXd u = Eigen::VectorXd::Zero(10);
  const CgReport report = nonlinear_cg(row, Identity(), to(1e-9), u);
  CHECK(report.end == CgReport::End::converged);
  CHECK(report.residual <= 1e-9 * 4.0);
  for (Eigen::Index i = 0; i < 10; ++i) CHECK(u(i) == Approx(static_cast<double>(i + 1)));
}

TEST_CASE("a search turns back from where nothing can be evaluated", "[core][statics]") {
  SpringRow row(3, 0.0, 1.0);
  row.largest = 3.5;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(3);
  CHECK(nonlinear_cg(row, Identity(), to(1e-8), u).end == CgReport::End::converged);
  row.largest = 2.5;  // the solution lies beyond
  u.setZero();
  const CgReport report = nonlinear_cg(row, Identity(), to(1e-8), u);
  CHECK(report.end == CgReport::End::failed);
  CHECK(report.residual > 0.0);
}

TEST_CASE("what is left over may be put up with after the last iteration", "[core][statics]") {
  SpringRow row(20, 0.0, 1.0);
  CgSettings settings = to(1e-10);
  settings.max_iterations = 19;
  settings.acceptable_relative_residual = 10.0;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(20);
  CHECK(nonlinear_cg(row, Identity(), settings, u).end == CgReport::End::acceptable);
  settings.acceptable_relative_residual = 1e-9;
  u.setZero();
  CHECK(nonlinear_cg(row, Identity(), settings, u).end == CgReport::End::failed);
  settings.acceptable_residual = 10.0;
  u.setZero();
  CHECK(nonlinear_cg(row, Identity(), settings, u).end == CgReport::End::acceptable);
}

TEST_CASE("a search has the iterations that it shall have at least", "[core][statics]") {
  SpringRow row(5, 1.0, 1e-3);
  CgSettings settings = to(2.0);
  settings.min_iterations = 4;
  Eigen::VectorXd u = Eigen::VectorXd::Zero(5);
  CHECK(nonlinear_cg(row, Identity(), settings, u).n_iterations == 4);
}

TEST_CASE("a prediction that cannot be evaluated has what is prescribed all the same", "[core][statics]") {
  SpringRow row(3, 0.0, 0.0);
  row.largest = -1.0;  // nothing can be evaluated
  Eigen::VectorXd prescribed = Eigen::Vector3d(0.0, 0.0, 1.0), u = Eigen::VectorXd::Zero(3);
  predict_linearly(row, Identity(), prescribed, 100, u);
  CHECK(u == prescribed);
}

TEST_CASE("a linear prediction moves what stands between held ends along", "[core][statics]") {
  SpringRow row(10, 0.0, 0.0);
  row.holds_last = true;
  row.largest = 1.01;
  Eigen::VectorXd prescribed = Eigen::VectorXd::Zero(10), u = prescribed;
  prescribed(9) = 1.0;
  predict_linearly(row, Identity(), prescribed, 100, u);
  for (Eigen::Index i = 0; i < 10; ++i) CHECK(u(i) == Approx(0.1 * static_cast<double>(i + 1)).margin(2e-3));
}
