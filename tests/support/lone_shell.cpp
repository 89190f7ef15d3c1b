// SPDX-License-Identifier: BSD-3-Clause
#include "support/lone_shell.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>

#include "support/catch.hpp"
#include "support/lone_element.hpp"

namespace contactsim::test {

namespace {

Eigen::Matrix3Xd summed(const NodeSums& sums, const std::vector<NodeVector>& parts, Eigen::Index n) {
  Eigen::Matrix3Xd all = Eigen::Matrix3Xd::Zero(3, n);
  if (!parts.empty()) sums.add(parts, all);
  return all;
}

/// Of a step that displaces and turns the nodes [6 x n_nodes], and of all before [energy].
double work_after(LoneShell shell, const Eigen::MatrixXd& change) {
  const ChunkStep step = shell.move_to(shell.coordinates + change.topRows<3>(), change.bottomRows<3>());
  return step.hourglass_work + shell.stress_work();
}

}  // namespace

Eigen::Matrix3Xd regular_shell(Shape shape) {
  Eigen::Matrix3Xd x = Eigen::Matrix3Xd::Zero(3, topology(shape).n_nodes);
  if (x.cols() == 3) {
    x.row(0) << 0, 1, 0.5;
    x.row(1) << 0, 0, std::sqrt(0.75);
  } else {
    x.row(0) << 0, 1, 1, 0;
    x.row(1) << 0, 0, 1, 1;
  }
  return x;
}

ShellSettings gauss_layers(std::int64_t n_layers) {
  ShellSettings settings;
  settings.layers = make_layers("gauss", n_layers);
  return settings;
}

LoneShell::LoneShell(const ElementFormulation& row, const MaterialLaw& law, const Eigen::Matrix3Xd& at_rest,
                     double thickness, const ShellSettings& settings)
    : block(make_shell_block(one_element_mesh(row.shape, at_rest), 0, row, undamped(law), settings,
                             {&thickness, 1})),
      state(make_state(block)),
      coordinates(at_rest) {}

LoneShell::LoneShell(ModelBlock its_block, const Eigen::Matrix3Xd& at_rest)
    : block(std::move(its_block)), state(make_state(block)), coordinates(at_rest) {}

ChunkStep LoneShell::move_to(const Eigen::Matrix3Xd& there, const Eigen::Matrix3Xd& turns, double dt) {
  const double per_dt = dt > 0.0 ? 1.0 / dt : 0.0;
  const Eigen::Matrix3Xd velocity = per_dt * (there - coordinates), turning = per_dt * turns;
  coordinates = there;
  Motion motion{0.0, dt, coordinates, velocity};
  motion.angular_velocity = &turning;
  return block.element->advance(block, block.chunks[0], motion, state);
}

ChunkStep LoneShell::stay() {
  return move_to(coordinates, Eigen::Matrix3Xd::Zero(3, coordinates.cols()), 0.0);
}

Eigen::Matrix3Xd LoneShell::forces() const { return summed(block.sums, state.forces, coordinates.cols()); }

Eigen::Matrix3Xd LoneShell::moments() const { return summed(block.sums, state.moments, coordinates.cols()); }

Eigen::Matrix3d LoneShell::stress(std::size_t layer) const {
  constexpr std::size_t places[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  Eigen::Matrix3d tensor;
  for (std::size_t i = 0; i < 9; ++i) {
    tensor(static_cast<Eigen::Index>(i / 3), static_cast<Eigen::Index>(i % 3)) =
        state.at(block.layout, 0, layer * block.layout.point_size + places[i / 3][i % 3]);
  }
  return tensor;
}

Eigen::Matrix3Xd turns_of(double angle, Eigen::Index n) {
  const Eigen::AngleAxisd turn(rotation_of(angle));
  return (2.0 * std::tan(0.5 * turn.angle()) * turn.axis()).replicate(1, n);
}

Eigen::Matrix3Xd random_turns(Eigen::Index n, double size, unsigned seed) {
  return distorted(Eigen::Matrix3Xd::Zero(3, n), size, seed);
}

Eigen::Vector3d total_moment(const LoneShell& shell) {
  const Eigen::Matrix3Xd force = shell.forces();
  Eigen::Vector3d sum = shell.moments().rowwise().sum();
  for (Eigen::Index i = 0; i < force.cols(); ++i)
    sum += Eigen::Vector3d(shell.coordinates.col(i)).cross(Eigen::Vector3d(force.col(i)));
  return sum;
}

void check_derivatives_of_work(const LoneShell& shell, double margin) {
  constexpr double h = 1e-6;  // of edges near 1
  const Eigen::Index n = shell.coordinates.cols();
  Eigen::MatrixXd expected(6, n);
  expected << shell.forces(), shell.moments();
  for (Eigen::Index i = 0; i < expected.size(); ++i) {
    Eigen::MatrixXd change = Eigen::MatrixXd::Zero(6, n);
    change(i) = h;
    const double slope = (work_after(shell, change) - work_after(shell, -change)) / (2.0 * h);
    CHECK(-slope == Approx(expected(i)).margin(margin));
  }
}

Eigen::MatrixXd stiffness_of(const LoneShell& shell) {
  constexpr double h = 1e-7;  // of edges near 1: round-off and curvature are then alike
  const Eigen::Index n = shell.coordinates.cols();
  Eigen::MatrixXd stiffness(6 * n, 6 * n);
  for (Eigen::Index column = 0; column < 6 * n; ++column) {
    Eigen::MatrixXd resistance[2];
    for (const int side : {0, 1}) {
      LoneShell moved = shell;
      Eigen::MatrixXd change = Eigen::MatrixXd::Zero(6, n);
      change(column) = side == 0 ? -h : h;
      moved.move_to(shell.coordinates + change.topRows<3>(), change.bottomRows<3>());
      resistance[side].resize(6, n);
      resistance[side] << moved.forces(), moved.moments();
    }
    stiffness.col(column) = (resistance[0] - resistance[1]).reshaped() / (2.0 * h);
  }
  return stiffness;
}

double stable_limit(const LoneShell& shell) {
  const Eigen::Index n = shell.coordinates.cols();
  const double share = 1.0 / static_cast<double>(n);
  Eigen::VectorXd node(6);
  node << Eigen::Vector3d::Constant(share * shell.block.mass[0](0)),
      Eigen::Vector3d::Constant(share * shell.block.inertia[0](0));
  const Eigen::VectorXd scale = node.replicate(n, 1).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd stiffness = stiffness_of(shell);
  const Eigen::MatrixXd scaled =
      scale.asDiagonal() * (0.5 * (stiffness + stiffness.transpose())) * scale.asDiagonal();
  return 2.0 / std::sqrt(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
                             .eigenvalues()
                             .maxCoeff());
}

}  // namespace contactsim::test
