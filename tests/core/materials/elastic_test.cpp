// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/elastic.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Lambda 72, shear 72, Young's modulus 180, Poisson's ratio 0.25.
constexpr ElasticLaw quarter_law{{120.0, 72.0}};

}  // namespace

TEST_CASE("a strain adds Hooke's stress to what is there", "[core][materials]") {
  StrainStep step{};
  const std::array<double, 6> strains{0.01, -0.02, 0.03, 0.004, -0.005, 0.006};
  SymmetricLanes stress = SymmetricLanes::zero();
  for (std::size_t i = 0; i < 6; ++i) {
    step.strain[i] = Lanes::Constant(strains[i]);
    stress[i] = Lanes::Constant(1.0);
  }
  const LaneModuli bounds = quarter_law.update(step, stress, {});
  for (std::size_t i = 0; i < 6; ++i)
    CHECK(stress[i](4) == Approx(1.0 + (i < 3 ? 72.0 * 0.02 : 0.0) + 144.0 * strains[i]));
  CHECK(bounds.lambda()(0) >= 72.0);
}

TEST_CASE("in a plane and along a fibre nothing presses across", "[core][materials]") {
  PlaneStep plane{{}, 1.0};
  for (Lanes& component : plane.strain) component.setZero();
  plane.strain[0].setConstant(0.01);
  plane.strain[1].setConstant(0.02);
  PlaneLanes stress = plane.strain;
  for (Lanes& component : stress) component.setZero();
  quarter_law.update_plane(plane, stress, {});
  // E / (1 - nu^2) = 192 of each strain and a quarter of the other.
  CHECK(stress[0](0) == Approx(192.0 * (0.01 + 0.25 * 0.02)));
  CHECK(stress[1](0) == Approx(192.0 * (0.02 + 0.25 * 0.01)));
  FibreStep fibre{{}, 1.0};
  FibreLanes along;
  for (std::size_t i = 0; i < 3; ++i) {
    fibre.strain[i].setConstant(0.01 * static_cast<double>(i + 1));
    along[i].setConstant(1.0);
  }
  quarter_law.update_fibre(fibre, along, {});
  CHECK(along[0](0) == Approx(1.0 + 180.0 * 0.01));
  CHECK(along[1](0) == Approx(1.0 + 72.0 * 0.02));
  CHECK(along[2](0) == Approx(1.0 + 72.0 * 0.03));
}
