// SPDX-License-Identifier: BSD-3-Clause
// Cohesive elements between two squares or triangles that lie on each other.
#include <Eigen/Geometry>
#include <cmath>

#include "core/dynamics/discrete_steps.hpp"
#include "core/dynamics/model.hpp"
#include "core/elements/cohesive/cohesive_pairs.hpp"
#include "core/elements/cohesive_section.hpp"
#include "core/elements/element_table.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3Xd;
using Eigen::Vector3d;

namespace {

/// Peak 10, from a hundredth to a half of an opening of 2e-3 or a sliding of 4e-3: the toughness is
/// 10 x 2e-3 (1 - 0.01 + 0.5) / 2 = 0.0149.
constexpr TractionLaw law{10.0, 0.01, 0.5, 2e-3, 4e-3, 3.0};
constexpr double toughness = 0.0149;

Mesh flat_mesh(Shape shape, double thickness = 0.0) {
  const Eigen::Index n = topology(shape).n_nodes / 2;
  Matrix3Xd x(3, 2 * n);
  const Matrix3Xd square{{0, 1, 1, 0}, {0, 0, 2, 2}, {0, 0, 0, 0}};
  x << square.leftCols(n), square.leftCols(n);
  x.row(2).tail(n).array() += thickness;
  return one_element_mesh(shape, x);
}

/// Of area 2 (eight nodes) or 1 (six), moved by a test.
struct Joint {
  Mesh mesh;
  ModelBlock block;
  ModelBlockState state;
  Matrix3Xd x;

  explicit Joint(Shape shape, double thickness = 0.0)
      : mesh(flat_mesh(shape, thickness)), x(mesh.coordinates()) {
    Diagnostics diagnostics;
    auto made = make_cohesive_block(mesh, 0, law, 0.0, {}, diagnostics);
    REQUIRE(made);
    block = std::move(*made);
    state = make_state(block);
  }
  Joint(const Joint&) = default;

  std::size_t n() const { return block.element->n_nodes / 2; }
  double area() const { return n() == 4 ? 2.0 : 1.0; }

  Matrix3Xd move_to(const Matrix3Xd& there) {
    x = there;
    const Matrix3Xd v = Matrix3Xd::Zero(3, x.cols());
    block.element->advance(block, block.chunks[0], {0.0, 1.0, x, v}, state);
    Matrix3Xd forces = Matrix3Xd::Zero(3, x.cols());
    block.sums.add(state.forces, forces);
    return forces;
  }
  /// The force by which the second face is pulled back when it stands off the first one.
  Vector3d part(const Vector3d& way) {
    Matrix3Xd there = mesh.coordinates();
    there.rightCols(static_cast<Eigen::Index>(n())).colwise() += way;
    return -move_to(there).rightCols(static_cast<Eigen::Index>(n())).rowwise().sum();
  }
  double work() const { return state.at(block.layout, 0, block.layout.energy()); }
};

const auto shapes = {Shape::cohesive8, Shape::cohesive6};

}  // namespace

TEST_CASE("a cohesive element pulled apart carries its peak and takes its toughness times area",
          "[core][cohesive]") {
  for (const Shape shape : shapes) {
    for (const Vector3d& way : {Vector3d(0, 0, 2e-3), Vector3d(4e-3, 0, 0), Vector3d(-1e-3, 2e-3, 2e-3)}) {
      Joint joint(shape);
      Vector3d greatest = Vector3d::Zero();
      constexpr int n_steps = 4000;
      for (int i = 1; i <= 2 * n_steps; ++i) {
        const Vector3d force = joint.part(way * i / n_steps);
        if (force.norm() > greatest.norm()) greatest = force;
        if (i > n_steps) CHECK(force == Vector3d::Zero());
      }
      CHECK(joint.work() == Approx(toughness * joint.area()).epsilon(1e-4));
      if (way.z() == 0.0) CHECK(greatest.isApprox(Vector3d(5.0 * joint.area(), 0, 0), 1e-3));
      if (way.x() == 0.0) CHECK(greatest.isApprox(Vector3d(0, 0, 10.0 * joint.area()), 1e-3));
    }
  }
}

TEST_CASE("damage stays, and back and again gives no energy", "[core][cohesive]") {
  Joint joint(Shape::cohesive8);
  for (int i = 1; i <= 150; ++i) joint.part({0, 0, 1e-5 * i});  // in the softening branch: lambda 0.75
  const Vector3d force = joint.part({0, 0, 1.5e-3});
  CHECK(force.z() == Approx(2.0 * 10.0 * 0.5));
  const double work = joint.work();
  for (int i = 150; i >= 0; --i) joint.part({0, 0, 1e-5 * i});
  CHECK(joint.work() == Approx(work - 0.5 * 1.5e-3 * force.z()));  // along the line to the origin
  for (int i = 0; i <= 150; ++i) joint.part({0, 0, 1e-5 * i});
  CHECK(joint.work() == Approx(work));
  CHECK(joint.part({0, 0, 0.75e-3}).z() == Approx(0.5 * force.z()));
}

TEST_CASE("compression meets the undamaged stiffness until all has failed", "[core][cohesive]") {
  Joint joint(Shape::cohesive6);
  const double stiffness = 3.0 * 10.0 / (0.01 * 2e-3);
  CHECK(joint.part({0, 0, -1e-6}).z() == Approx(-1e-6 * stiffness));
  for (int i = 1; i <= 99; ++i) joint.part({0, 0, 2e-5 * i});
  CHECK(joint.part({0, 0, -1e-6}).z() == Approx(-1e-6 * stiffness));
  joint.part({0, 0, 3e-3});
  CHECK(joint.part({0, 0, -1e-6}) == Vector3d::Zero());
}

TEST_CASE("cohesive forces have no resultant and no moment, wherever the nodes are", "[core][cohesive]") {
  for (const Shape shape : shapes) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
      Joint joint(shape);
      const Matrix3Xd there = rotation_of(0.1 * seed) * distorted(joint.x, 1e-3, seed);
      const Matrix3Xd force = joint.move_to(there);
      CHECK(force.norm() > 0.1);
      CHECK(force.rowwise().sum().norm() < 1e-12 * force.norm());
      Vector3d moment = Vector3d::Zero();
      for (Eigen::Index a = 0; a < force.cols(); ++a)
        moment += Vector3d(there.col(a)).cross(Vector3d(force.col(a)));
      CHECK(moment.norm() < 1e-12 * force.norm());
    }
  }
}

TEST_CASE("cohesive forces are the derivatives of the work", "[core][cohesive]") {
  for (const Shape shape : shapes) {
    Joint joint(shape);
    for (int i = 1; i <= 50; ++i)
      joint.move_to(joint.mesh.coordinates() +
                    (distorted(joint.mesh.coordinates(), 1e-3, 3) - joint.mesh.coordinates()) * i / 50.0);
    const Matrix3Xd at = distorted(joint.mesh.coordinates(), 0.8e-3, 3);
    const Matrix3Xd force = joint.move_to(at);
    constexpr double h = 1e-8;
    for (Eigen::Index i = 0; i < at.size(); ++i) {
      double work[2];
      for (const int side : {0, 1}) {
        Joint moved = joint;
        Matrix3Xd there = at;
        there(i) += side == 0 ? -h : h;
        moved.move_to(there);
        work[side] = moved.work();
      }
      CHECK(-(work[1] - work[0]) / (2.0 * h) == Approx(force(i)).margin(1e-5 * force.norm()));
    }
  }
}

TEST_CASE("a turn of a cohesive element with a thickness strains nothing", "[core][cohesive]") {
  for (const Shape shape : shapes) {
    Joint joint(shape, 0.1);
    for (int i = 1; i <= 10; ++i)
      CHECK(joint.move_to(rotation_of(0.3 * i) * joint.mesh.coordinates()).norm() < 1e-9);
    CHECK(joint.part({0, 0, 1e-6}).z() == Approx(joint.area() * 1e-6 * 10.0 / (0.01 * 2e-3)));
  }
}

TEST_CASE("the stable step of a cohesive element is that of its nodes on its springs", "[core][cohesive]") {
  Joint joint(Shape::cohesive8);
  Model model;
  model.mesh = &joint.mesh;
  model.blocks.push_back(joint.block);
  model.mass = Eigen::RowVectorXd::Constant(8, 0.25);
  set_discrete_steps(model);
  const double stiffness =
      3.0 * 10.0 / (0.01 * 2e-3) * 2.0 / 4.0;  // of compression, on a quarter of the area
  CHECK(model.blocks[0].cohesive.stable_step[0](0) == Approx(2.0 / std::sqrt(2.0 * stiffness / 0.25)));
}
