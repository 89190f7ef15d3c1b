// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_table.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr ElasticModuli moduli{160e9, 80e9};
constexpr double size = 1e-6;

LoneElement make_hex(const char* formulation, double deviatoric_parameter, double distortion = 0.0) {
  ElementProperties properties = undamped_elastic();
  properties.deviatoric_parameter = deviatoric_parameter;
  return {*find_solid_element(Shape::hex8, formulation), properties,
          distorted(regular_element(Shape::hex8), distortion, 1)};
}

/// The work of moving the nodes of a unit cube along x by size times a product of natural coordinates.
double work_of(LoneElement element, const std::vector<Eigen::Index>& factors) {
  Eigen::Matrix3Xd there = element.coordinates;
  for (Eigen::Index node = 0; node < 8; ++node) {
    double product = size;
    for (const Eigen::Index i : factors) product *= 2.0 * element.coordinates(i, node) - 1.0;
    there(0, node) += product;
  }
  element.move_to(there);
  return element.stress_work();
}

}  // namespace

TEST_CASE("eight points resist hourglass motions with the energy of their strains", "[core][elements]") {
  // u = c eta zeta: shears c zeta and c eta, whose squares have the mean c^2 / 3.
  const double twisting = 4.0 / 3.0 * moduli.shear * size * size;
  // u = c xi eta: a strain 2 c eta along x and a shear c xi; mean dilatation leaves 2/3 of the former's
  // square.
  const double deviatoric = (8.0 / 9.0 + 2.0 / 3.0) * moduli.shear * size * size;
  const double full = (2.0 / 3.0 * moduli.lambda() + 2.0 * moduli.shear) * size * size;
  const LoneElement selective = make_hex("selective_deviatoric", 1.0),
                    fully = make_hex("fully_integrated", 1.0);
  CHECK(work_of(selective, {1, 2}) == Approx(twisting).epsilon(1e-5));
  CHECK(work_of(fully, {1, 2}) == Approx(twisting).epsilon(1e-5));
  CHECK(work_of(selective, {0, 1}) == Approx(deviatoric).epsilon(1e-5));
  CHECK(work_of(fully, {0, 1}) == Approx(full).epsilon(1e-5));
  // The parameter scales the strains that are not the mean one.
  CHECK(work_of(make_hex("selective_deviatoric", 0.5), {0, 1}) == Approx(0.25 * deviatoric).epsilon(1e-5));
}

TEST_CASE("a deviatoric parameter of 0 gives mean quadrature, hourglass forces and all", "[core][elements]") {
  LoneElement selective = make_hex("selective_deviatoric", 0.0, 0.1),
              mean = make_hex("mean_quadrature", 0.0, 0.1);
  double work = 0.0, mean_work = 0.0;
  for (unsigned step = 1; step <= 4; ++step) {
    const Eigen::Matrix3Xd there = rotation_of(0.2 * step) * distorted(mean.coordinates, 0.02, step);
    work += selective.move_to(there).hourglass_work;
    mean_work += mean.move_to(there).hourglass_work;
  }
  CHECK((selective.forces() - mean.forces()).norm() < 1e-12 * mean.forces().norm());
  CHECK(selective.stress_work() == Approx(mean.stress_work()).epsilon(1e-12));
  CHECK(work == Approx(mean_work).epsilon(1e-12));
  CHECK(mean_work > 0.0);
}
