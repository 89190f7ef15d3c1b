// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/orthotropic.hpp"

#include <Eigen/Dense>

#include "core/elements/solid/material_point.hpp"
#include "core/materials/elastic.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Matrix3d;
using Eigen::Vector3d;

namespace {

/// Boron-epoxy: 30 and 3 million, another ratio along 3.
OrthotropicConstants ply() { return {{}, 30.0, 3.0, 2.0, 0.3, 0.25, 0.4, 1.0, 1.5, 0.8}; }

OrthotropicConstants isotropic(double youngs, double ratio) {
  const double shear = youngs / (2.0 * (1.0 + ratio));
  return {{}, youngs, youngs, youngs, ratio, ratio, ratio, shear, shear, shear};
}

SymmetricLanes lanes_of(const Matrix3d& a) {
  SymmetricLanes lanes;
  const double components[6] = {a(0, 0), a(1, 1), a(2, 2), a(0, 1), a(1, 2), a(2, 0)};
  for (std::size_t i = 0; i < 6; ++i) lanes[i].setConstant(components[i]);
  return lanes;
}

Matrix3d matrix_of(const SymmetricLanes& s) {
  return Matrix3d{{s[0](0), s[3](0), s[5](0)}, {s[3](0), s[1](0), s[4](0)}, {s[5](0), s[4](0), s[2](0)}};
}

/// The stress of a small strain, the directions as columns.
Matrix3d stress_of(const OrthotropicLaw& law, const Matrix3d& strain, const Matrix3d& directions) {
  std::array<Lanes, 6> state;
  for (Eigen::Index i = 0; i < 6; ++i) state[static_cast<std::size_t>(i)].setConstant(directions(i));
  SymmetricLanes stress = SymmetricLanes::zero();
  law.update({lanes_of(strain), {}, 1.0}, stress, state);
  return matrix_of(stress);
}

std::string error_of(const OrthotropicConstants& model) {
  try {
    make_orthotropic_law(model);
  } catch (const std::invalid_argument& problem) {
    return problem.what();
  }
  return "";
}

}  // namespace

TEST_CASE("an orthotropic point pulled along a direction has its modulus and contractions",
          "[core][materials]") {
  const OrthotropicLaw law = make_orthotropic_law(ply());
  const Vector3d moduli(30.0, 3.0, 2.0);
  const Matrix3d ratios{
      {-1.0, 0.3, 0.25}, {0.3 * 3.0 / 30.0, -1.0, 0.4}, {0.25 * 2.0 / 30.0, 0.4 * 2.0 / 3.0, -1.0}};
  for (const Matrix3d& directions : {Matrix3d(Matrix3d::Identity()), rotation_of(0.7)}) {
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Vector3d strains = -1e-3 * ratios.row(i).transpose();
      const Matrix3d strain = directions * strains.asDiagonal() * directions.transpose();
      const Matrix3d expected = 1e-3 * moduli(i) * directions.col(i) * directions.col(i).transpose();
      CHECK((stress_of(law, strain, directions) - expected).norm() < 1e-15 * 30.0);
    }
    const double shear[3] = {1.0, 0.8, 1.5};  // of 12, 23, 31
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Matrix3d pair = directions.col(i) * directions.col((i + 1) % 3).transpose();
      const Matrix3d strain = 5e-4 * (pair + pair.transpose());
      CHECK((stress_of(law, strain, directions) - 2.0 * shear[i] * strain).norm() < 1e-15 * 30.0);
    }
  }
}

TEST_CASE("with equal constants an orthotropic material is the isotropic one, bounds too",
          "[core][materials]") {
  const OrthotropicLaw law = make_orthotropic_law(isotropic(26.0, 0.3));
  const ElasticLaw other{{26.0 / 1.2, 10.0}};
  const Matrix3d strain{{1e-3, 2e-3, -3e-3}, {2e-3, -1e-3, 1e-3}, {-3e-3, 1e-3, 2e-3}};
  SymmetricLanes stress = SymmetricLanes::zero();
  other.update({lanes_of(strain), {}, 1.0}, stress, {});
  CHECK((stress_of(law, strain, rotation_of(1.1)) - matrix_of(stress)).norm() < 1e-14);
  CHECK(law.moduli.bulk == Approx(other.moduli.bulk));
  CHECK(law.moduli.shear == Approx(10.0));
  CHECK(law.bounds.bulk == Approx(other.moduli.bulk));
  CHECK(law.bounds.shear == Approx(10.0));
  CHECK(law.plane_ratio == Approx(1.0));
}

TEST_CASE("the orthotropic bounds hold for the stiffness, as tight as its largest wave asks",
          "[core][materials]") {
  for (OrthotropicConstants model : {ply(), isotropic(1.0, 0.45)}) {
    const OrthotropicLaw law = make_orthotropic_law(model);
    double closest = 1.0;
    for (int i = 0; i < 200; ++i) {
      const Matrix3d gradient = Matrix3d::Random();
      const Matrix3d strain = 0.5 * (gradient + gradient.transpose());
      const double power = (stress_of(law, strain, Matrix3d::Identity()).cwiseProduct(strain)).sum();
      const double bound = law.bounds.lambda() * strain.trace() * strain.trace() +
                           2.0 * law.bounds.shear * strain.squaredNorm();
      CHECK(power <= bound * (1.0 + 1e-12));
      CHECK(power > 0.0);
      closest = std::min(closest, 1.0 - power / bound);
    }
    CHECK(closest < 0.3);
  }
}

TEST_CASE("the directions and the stress turn with the material", "[core][materials]") {
  const OrthotropicLaw law = make_orthotropic_law(ply());
  const Matrix3d strain = Vector3d(1e-3, 0.0, 0.0).asDiagonal(), turn = rotation_of(0.8);
  std::vector<Lanes> point(12, Lanes::Zero());
  law.start(std::span(point).subspan(6));
  // Turned in one step without strain, then strained along what was x.
  TensorLanes rotation, none;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      rotation[i][j].setConstant(turn(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)));
      none[i][j].setConstant(i == j);
    }
  }
  update_point(law, {{SymmetricLanes::zero(), {}, 1.0}, rotation}, point);
  const PointStep step =
      update_point(law, {{lanes_of(turn * strain * turn.transpose()), {}, 1.0}, none}, point);
  const Matrix3d expected = turn * stress_of(law, strain, Matrix3d::Identity()) * turn.transpose();
  CHECK((matrix_of(step.stress) - expected).norm() < 1e-15 * 30.0);
}

TEST_CASE("an orthotropic shell is the solid without stress along its normal, at any angle",
          "[core][materials][shells]") {
  const OrthotropicLaw law = make_orthotropic_law(ply());
  for (const double angle : {0.0, 0.4, -1.2}) {
    const double c = std::cos(angle), s = std::sin(angle);
    const Matrix3d directions{{c, -s, 0.0}, {s, c, 0.0}, {0.0, 0.0, 1.0}};
    std::array<Lanes, 6> state;
    for (Eigen::Index i = 0; i < 6; ++i) state[static_cast<std::size_t>(i)].setConstant(directions(i));
    const std::array<double, 5> strain{1e-3, -2e-3, 3e-3, 1e-3, -0.5e-3};
    PlaneStep step{{}, 1.0};
    PlaneLanes stress;
    for (std::size_t i = 0; i < 5; ++i) {
      step.strain[i].setConstant(strain[i]);
      stress[i].setZero();
    }
    law.update_plane(step, stress, state);
    Matrix3d solid{{strain[0], strain[2] / 2, strain[4] / 2},
                   {strain[2] / 2, strain[1], strain[3] / 2},
                   {strain[4] / 2, strain[3] / 2, 0.0}};
    const double at_none = stress_of(law, solid, directions)(2, 2);
    solid(2, 2) = -at_none / law.direct[2][2];
    const Matrix3d expected = stress_of(law, solid, directions);
    CHECK(std::abs(expected(2, 2)) < 1e-15);
    const double components[5] = {expected(0, 0), expected(1, 1), expected(0, 1), expected(1, 2),
                                  expected(2, 0)};
    for (std::size_t i = 0; i < 5; ++i) CHECK(stress[i](0) == Approx(components[i]).margin(1e-15));
  }
}

TEST_CASE("orthotropic constants that set energy free are refused", "[core][materials]") {
  OrthotropicConstants model = ply();
  model.nu12 = 3.2;  // sqrt(30 / 3) = 3.16
  CHECK(error_of(model) ==
        "NU12 = 3.2 gives no stable material: with these moduli it must be less than 3.16228 in size");
  model = isotropic(1.0, 0.6);
  CHECK_THAT(error_of(model), Catch::StartsWith("NU12, NU13 and NU23 together give no stable material"));
  model = ply();
  model.g23 = 0.0;
  CHECK(error_of(model) == "E11 to G23 must be positive");
  CHECK(error_of(ply()) == "");
}

TEST_CASE("elastic constants beside the orthotropic ones say which isotropic material is alike",
          "[core][materials]") {
  OrthotropicConstants model = ply();
  model.elastic.youngs_modulus = 2.6;
  model.elastic.poissons_ratio = 0.3;
  const OrthotropicLaw law = make_orthotropic_law(model);
  CHECK(law.moduli.shear == Approx(1.0));
  CHECK(law.bounds.shear == make_orthotropic_law(ply()).bounds.shear);
  CHECK(law.plane_ratio > 30.0 / (2.6 / 0.91));  // the stiffest direction over E / (1 - nu^2)
}
