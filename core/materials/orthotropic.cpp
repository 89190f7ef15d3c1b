// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/orthotropic.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

namespace contactsim {

namespace {

using Eigen::Matrix3d;

/// Strain along i by stress along j: 1 / E_i, and -nu_ij / E_i = -nu_ji / E_j beside the diagonal.
Matrix3d compliance_of(const OrthotropicConstants& m) {
  return Matrix3d{{1.0 / m.e11, -m.nu12 / m.e11, -m.nu13 / m.e11},
                  {-m.nu12 / m.e11, 1.0 / m.e22, -m.nu23 / m.e22},
                  {-m.nu13 / m.e11, -m.nu23 / m.e22, 1.0 / m.e33}};
}

void check_stability(const OrthotropicConstants& m) {
  const auto is_positive = [](double modulus) { return std::isfinite(modulus) && modulus > 0.0; };
  for (const double modulus : {m.e11, m.e22, m.e33, m.g12, m.g13, m.g23}) {
    if (!is_positive(modulus)) throw std::invalid_argument("E11 to G23 must be positive");
  }
  const auto check = [](const char* name, double ratio, double limit) {
    if (std::abs(ratio) < limit) return;
    throw std::invalid_argument(
        fmt::format("{} = {} gives no stable material: with these moduli it must be less than {:.6g} in size",
                    name, ratio, limit));
  };
  check("NU12", m.nu12, std::sqrt(m.e11 / m.e22));
  check("NU13", m.nu13, std::sqrt(m.e11 / m.e33));
  check("NU23", m.nu23, std::sqrt(m.e22 / m.e33));
  const Matrix3d unit = Eigen::Vector3d(m.e11, m.e22, m.e33).cwiseSqrt().asDiagonal();
  const double determinant = (unit * compliance_of(m) * unit).determinant();
  if (determinant > 0.0) return;
  throw std::invalid_argument(fmt::format(
      "NU12, NU13 and NU23 together give no stable material: 1 - NU12 NU21 - NU23 NU32 - NU31 NU13 - 2 NU21 "
      "NU32 NU13 is {:.6g} and must be positive",
      determinant));
}

/// Takes as much lambda as all pairs of directions have, and for the rest twice the largest stiffness that
/// any strain of its norm meets, shears with 2 G each. Of an isotropic material these are its own moduli.
ElasticModuli bounds_of(const Matrix3d& direct, const std::array<double, 3>& shear) {
  const double lambda = std::max(0.0, std::min({direct(0, 1), direct(1, 2), direct(0, 2)}));
  const Matrix3d rest = direct - Matrix3d::Constant(lambda);
  const double largest =
      Eigen::SelfAdjointEigenSolver<Matrix3d>(rest, Eigen::EigenvaluesOnly).eigenvalues()(2);
  const double bound = std::max(0.5 * largest, *std::max_element(shear.begin(), shear.end()));
  return {lambda + 2.0 / 3.0 * bound, bound};
}

/// The isotropic material that has the same energy on average over all directions:
///   9 K = C11 + C22 + C33 + 2 (C12 + C23 + C13)
///   15 G = C11 + C22 + C33 - (C12 + C23 + C13) + 3 (C44 + C55 + C66)
/// Source: Voigt, Lehrbuch der Kristallphysik (1928).
ElasticModuli mean_of(const Matrix3d& direct, const std::array<double, 3>& shear) {
  const double diagonal = direct.trace(), across = direct(0, 1) + direct(1, 2) + direct(0, 2);
  const double shears = shear[0] + shear[1] + shear[2];
  return {(diagonal + 2.0 * across) / 9.0, (diagonal - across + 3.0 * shears) / 15.0};
}

/// The largest ratio of energies that a strain in the plane has in the law and in the isotropic material that
/// is alike: the largest eigenvalue x of Q e = x Q_alike e, or a ratio of shear moduli.
double ratio_of_planes(const OrthotropicLaw& law) {
  const PlaneModuli alike(law.moduli);
  const double across = std::max(alike.across, 0.0);
  const Eigen::Matrix2d plane{{law.plane[0], law.plane[2]}, {law.plane[2], law.plane[1]}};
  const Eigen::Matrix2d other =
      Eigen::Matrix2d::Constant(across) + 2.0 * alike.shear * Eigen::Matrix2d::Identity();
  const double largest =
      Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::Matrix2d>(plane, other, Eigen::EigenvaluesOnly)
          .eigenvalues()(1);
  return std::max(largest, *std::max_element(law.shear.begin(), law.shear.end()) / alike.shear);
}

/// The directions as rows.
TensorLanes directions_of(std::span<const Lanes> state) {
  const std::array<Lanes, 3> a{state[0], state[1], state[2]}, b{state[3], state[4], state[5]};
  return {a, b, {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
}

TensorLanes transposed(const TensorLanes& a) {
  TensorLanes b;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) b[i][j] = a[j][i];
  }
  return b;
}

/// A turn of the directions about one of their axes.
std::vector<Parameter> turn(const std::string& before, std::vector<Parameter> so_far) {
  so_far.push_back(parameter::word(before + "direction for rotation", {"1", "2", "3"},
                                   "Axis about which the directions are turned"));
  so_far.push_back(parameter::real(before + "alpha", "Angle of that turn [degrees]").otherwise(0.0));
  return so_far;
}

std::vector<Parameter> orthotropic_parameters() {
  std::vector<Parameter> lines{
      parameter::positive("e11", "Young's modulus along 1 [force/length^2]").required(),
      parameter::positive("e22", "Young's modulus along 2 [force/length^2]").required(),
      parameter::positive("e33", "Young's modulus along 3 [force/length^2]").required(),
      parameter::real("nu12", "Contraction along 2 under a stress along 1 [1]").required(),
      parameter::real("nu13", "Contraction along 3 under a stress along 1 [1]").required(),
      parameter::real("nu23", "Contraction along 3 under a stress along 2 [1]").required(),
      parameter::positive("g12", "Shear modulus of 1 and 2 [force/length^2]").required(),
      parameter::positive("g13", "Shear modulus of 1 and 3 [force/length^2]").required(),
      parameter::positive("g23", "Shear modulus of 2 and 3 [force/length^2]").required(),
      parameter::coordinate_system("coordinate system",
                                   "System of the directions 1, 2, 3, else the global one"),
  };
  lines = turn("second ", turn("", std::move(lines)));
  for (const char* direction : {"11", "22", "33"}) {
    lines.push_back(parameter::ignored(fmt::format("thermal strain {} function", direction),
                                       "temperature has no effect on materials"));
  }
  return lines;
}

}  // namespace

void OrthotropicLaw::start(std::span<Lanes> state) const {
  for (std::size_t i = 0; i < 6; ++i) state[i].setConstant(i == 0 || i == 4 ? 1.0 : 0.0);
}

LaneModuli OrthotropicLaw::update(const StrainStep& step, SymmetricLanes& stress,
                                  std::span<Lanes> state) const {
  const TensorLanes directions = directions_of(state);
  const SymmetricLanes strain = transformed(step.strain, directions);
  SymmetricLanes growth;
  for (std::size_t i = 0; i < 3; ++i) {
    growth[i] = direct[i][0] * strain[0] + direct[i][1] * strain[1] + direct[i][2] * strain[2];
    growth[3 + i] = 2.0 * shear[i] * strain[3 + i];
  }
  growth = transformed(growth, transposed(directions));
  for (std::size_t i = 0; i < 6; ++i) stress[i] += growth[i];
  return {Lanes::Constant(bounds.bulk), Lanes::Constant(bounds.shear)};
}

void OrthotropicLaw::update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const {
  const Lanes &c = state[0], &s = state[1];  // direction 1 along x and y
  const Lanes cc = c * c, ss = s * s, cs = c * s;
  // Strains and stresses are turned by the angle whose cosine and sine these are; xy, yz and zx are twice the
  // components of the tensor.
  const auto& [xx, yy, xy, yz, zx] = step.strain;
  const Lanes e1 = cc * xx + ss * yy + cs * xy, e2 = ss * xx + cc * yy - cs * xy;
  const Lanes s1 = plane[0] * e1 + plane[2] * e2, s2 = plane[2] * e1 + plane[1] * e2;
  const Lanes t12 = shear[0] * (2.0 * cs * (yy - xx) + (cc - ss) * xy);
  const Lanes t23 = shear[1] * (c * yz - s * zx), t13 = shear[2] * (s * yz + c * zx);
  stress[0] += cc * s1 + ss * s2 - 2.0 * cs * t12;
  stress[1] += ss * s1 + cc * s2 + 2.0 * cs * t12;
  stress[2] += cs * (s1 - s2) + (cc - ss) * t12;
  stress[3] += c * t23 + s * t13;
  stress[4] += c * t13 - s * t23;
}

OrthotropicLaw make_orthotropic_law(const OrthotropicConstants& constants) {
  check_stability(constants);
  const Matrix3d direct = compliance_of(constants).inverse();
  OrthotropicLaw law{};
  law.shear = {constants.g12, constants.g23, constants.g13};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j)
      law.direct[i][j] = direct(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  // Without stress along 3: Q11 = E1 / (1 - nu12 nu21), Q22 = E2 / (...), Q12 = nu12 E2 / (...), where
  // nu21 = nu12 E2 / E1.
  const double scale = 1.0 / (1.0 - constants.nu12 * constants.nu12 * constants.e22 / constants.e11);
  law.plane = {scale * constants.e11, scale * constants.e22, scale * constants.nu12 * constants.e22};
  law.bounds = bounds_of(direct, law.shear);
  law.moduli =
      constants.elastic.n_given() > 0 ? make_elastic_moduli(constants.elastic) : mean_of(direct, law.shear);
  law.plane_ratio = ratio_of_planes(law);
  return law;
}

MaterialRow orthotropic_material() {
  return {{"elastic_orthotropic"},
          "Hypoelastic, with directions",
          orthotropic_parameters(),
          {&law_kind<OrthotropicLaw>},
          [](const MaterialInput& input) -> std::optional<MaterialLaw> {
            const auto real = [&](const char* phrase) { return input.values.real(phrase); };
            return make_orthotropic_law({elastic_constants_of(input.values), real("e11"), real("e22"),
                                         real("e33"), real("nu12"), real("nu13"), real("nu23"), real("g12"),
                                         real("g13"), real("g23")});
          },
          ElasticNeed::none_or_two};
}

}  // namespace contactsim
