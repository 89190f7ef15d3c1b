// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/loft_spins.hpp"

#include <Eigen/Geometry>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two plates of a roof that share their ridge.
MeshBuilder roof() {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 2}, .u = {3, 0, 0.9}, .v = {0, 2, 0.1}}, 0.2);
  add_plate(b, {.id = 2, .cells = {2, 2}, .origin = {3, 0, 0.9}, .u = {2, 0, -1.4}, .v = {0, 2, 0.1}}, 0.2);
  return b;
}

struct Roof {
  Roof() { spins.update(parts.x); }

  Eigen::Vector3d spin(std::size_t i, const Eigen::Matrix3Xd& velocity) const {
    return spins.spin(i, Eigen::Vector3d::Zero(), velocity.col(spins.node(i).value),
                      [&](std::size_t k) { return velocity.col(spins.neighbours(i)[k].value); });
  }

  ContactParts parts{roof(), general_contact()};
  LoftSpins spins{parts.contact_mesh.loft, static_cast<std::size_t>(parts.x.cols()), RigidNodes{}};
};

}  // namespace

TEST_CASE("nodes of lofted shells spin as the shells turn", "[contact][loft_spins]") {
  Roof roof;
  REQUIRE(roof.spins.size() == static_cast<std::size_t>(roof.parts.x.cols()));
  const Eigen::Vector3d turning(0.3, -0.2, 0.5), moving(1, 2, 3);
  Eigen::Matrix3Xd velocity = roof.parts.x;
  for (Eigen::Index i = 0; i < velocity.cols(); ++i)
    velocity.col(i) = moving + turning.cross(Eigen::Vector3d(roof.parts.x.col(i)));
  for (std::size_t i = 0; i < roof.spins.size(); ++i)
    CHECK((roof.spin(i, velocity) - turning).norm() < 1e-12);
}

TEST_CASE("a turn through any angle in a step is found exactly", "[contact][loft_spins]") {
  Roof roof;
  const double angle = 0.7, dt = 0.1;
  const Eigen::Vector3d axis = Eigen::Vector3d(1, -2, 2) / 3.0;
  const Eigen::Matrix3Xd after = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * roof.parts.x;
  const Eigen::Matrix3Xd velocity = (after - roof.parts.x) / dt;
  for (std::size_t i = 0; i < roof.spins.size(); ++i) {
    const Eigen::Vector3d spin = roof.spins.mid_spin(i, after, velocity, dt, Eigen::Vector3d::Zero());
    CHECK((spin.normalized() - axis).norm() < 1e-12);
    CHECK(2.0 * std::atan(0.5 * dt * spin.norm()) == Approx(angle));
  }
}

TEST_CASE("a moment on a lofted shell is forces around that do the same work", "[contact][loft_spins]") {
  Roof roof;
  const Eigen::Vector3d moment(0.4, 1.1, -0.3);
  Eigen::Matrix3Xd velocity = roof.parts.x;
  for (Eigen::Index i = 0; i < velocity.cols(); ++i)
    velocity.col(i) =
        Eigen::Vector3d(std::sin(3.0 * static_cast<double>(i)), std::cos(5.0 * static_cast<double>(i)),
                        std::sin(7.0 * static_cast<double>(i) + 1.0));
  for (std::size_t i = 0; i < roof.spins.size(); ++i) {
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, roof.parts.x.cols());
    double largest = 0.0;
    forces.col(roof.spins.node(i).value) =
        roof.spins.spread(i, moment, [&](std::size_t k, const Eigen::Vector3d& force) {
          forces.col(roof.spins.neighbours(i)[k].value) += force;
          largest = std::max(largest, force.norm() / (roof.spins.bound(i, k) * moment.norm()));
        });
    CHECK(largest <= 1.0);
    CHECK(forces.rowwise().sum().norm() < 1e-12);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (Eigen::Index k = 0; k < forces.cols(); ++k)
      sum += Eigen::Vector3d(roof.parts.x.col(k)).cross(Eigen::Vector3d(forces.col(k)));
    CHECK((sum - moment).norm() < 1e-12);
    CHECK(forces.cwiseProduct(velocity).sum() == Approx(moment.dot(roof.spin(i, velocity))));
  }
}

TEST_CASE("bending that turns every other node the other way does not tilt a loft", "[contact][loft_spins]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {4, 4}, .u = {4, 0, 0}, .v = {0, 4, 0}}, 0.2);
  ContactParts parts(b, general_contact());
  LoftSpins spins(parts.contact_mesh.loft, static_cast<std::size_t>(parts.x.cols()), RigidNodes{});
  spins.update(parts.x);
  Eigen::Matrix3Xd velocity = Eigen::Matrix3Xd::Zero(3, parts.x.cols());
  for (Eigen::Index i = 0; i < velocity.cols(); ++i)
    velocity(2, i) = std::lround(parts.x(0, i) + parts.x(1, i)) % 2 == 0 ? 1.0 : -1.0;
  for (std::size_t i = 0; i < spins.size(); ++i) {
    const Eigen::Vector3d x = parts.x.col(spins.node(i).value);
    if (x[0] == 0.0 || x[0] == 4.0 || x[1] == 0.0 || x[1] == 4.0) continue;
    CHECK(spins
              .spin(i, Eigen::Vector3d(1, 2, 3), velocity.col(spins.node(i).value),
                    [&](std::size_t k) { return velocity.col(spins.neighbours(i)[k].value); })
              .norm() < 1e-12);
  }
}

TEST_CASE("nodes of rigid bodies have no spin of their own", "[contact][loft_spins]") {
  ContactParts parts(roof(), general_contact());
  RigidNodes rigid;
  rigid.body_of.assign(static_cast<std::size_t>(parts.x.cols()), std::nullopt);
  rigid.body_of[0] = 0;
  LoftSpins spins(parts.contact_mesh.loft, static_cast<std::size_t>(parts.x.cols()), rigid);
  CHECK(spins.size() == static_cast<std::size_t>(parts.x.cols()) - 1);
  CHECK(!spins.find({0}));
  for (std::size_t i = 0; i < spins.size(); ++i) {
    for (const NodeIndex other : spins.neighbours(i)) CHECK(other != NodeIndex{0});
  }
}
