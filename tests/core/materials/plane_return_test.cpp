// SPDX-License-Identifier: BSD-3-Clause
// Plane stress against the solid law: where the strain along z is chosen such that its stress vanishes, both
// must agree.
#include <cmath>
#include <random>

#include "core/materials/elastic.hpp"
#include "core/materials/johnson_cook.hpp"
#include "core/materials/linear_hardening.hpp"
#include "core/materials/multilinear_hardening.hpp"
#include "core/materials/power_hardening.hpp"
#include "core/materials/voce_hardening.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace plane_return_test {

namespace {

constexpr ElasticModuli steel{160e9, 80e9};
const std::vector<FunctionPoint> bends{{0.0, 200e6}, {0.001, 260e6}, {0.004, 300e6}, {0.02, 340e6}};

std::vector<MaterialLaw> plastic_laws() {
  return {PlasticLaw<LinearHardening>{steel, {200e6, 1e9, 0.0}},
          PlasticLaw<LinearHardening>{steel, {200e6, 0.5e9, 20e9}},
          PlasticLaw<LinearHardening>{steel, {200e6, -2e9, 0.0}},
          PlasticLaw<LinearHardening>{steel, {200e6, 0.0, 0.0}},
          PlasticLaw<PowerHardening>{steel, {200e6, 500e6, 0.3, 0.001}},
          PlasticLaw<JohnsonCookHardening>{steel, {{200e6, 500e6, 0.3}, 0.015, 1.0}},
          PlasticLaw<MultilinearHardening>{steel, {HardeningCurve(bends), 1.0}},
          PlasticLaw<MultilinearHardening>{steel, {HardeningCurve(bends), 0.3}},
          PlasticLaw<MultilinearHardening>{steel, {HardeningCurve(bends), 0.0}},
          PlasticLaw<VoceHardening>{steel, {200e6, 150e6, 20.0}}};
}

/// A material point of eight equal elements by both ways.
struct Point {
  explicit Point(const MaterialLaw& its_law) : law(its_law), state(law.kind().n_state) {
    for (Lanes& component : stress) component.setZero();
    law.start(state);
  }

  void move_plane(const std::array<double, 5>& strain) {
    PlaneStep step{{}, 1.0};
    for (std::size_t i = 0; i < 5; ++i) step.strain[i].setConstant(strain[i]);
    law.update_plane(step, stress, state);
  }

  double von_mises() const {
    const double xx = stress[0](0), yy = stress[1](0), xy = stress[2](0), yz = stress[3](0),
                 zx = stress[4](0);
    return std::sqrt(xx * xx - xx * yy + yy * yy + 3.0 * (xy * xy + yz * yz + zx * zx));
  }

  MaterialLaw law;
  PlaneLanes stress;
  std::vector<Lanes> state;
};

/// The solid law's answer to a strain whose zz is sought by bisection such that the stress zz vanishes.
struct SolidPoint {
  explicit SolidPoint(const MaterialLaw& its_law) : law(its_law), state(law.kind().n_state) {
    law.start(state);
  }

  SymmetricLanes stress_for(const std::array<double, 5>& strain, double zz, std::vector<Lanes>& end) const {
    StrainStep step{SymmetricLanes::zero(), {}, 1.0};
    const std::array<double, 6> components{strain[0],       strain[1],       zz,
                                           0.5 * strain[2], 0.5 * strain[3], 0.5 * strain[4]};
    for (std::size_t i = 0; i < 6; ++i) step.strain[i].setConstant(components[i]);
    SymmetricLanes moved = stress;
    end = state;
    law.update(step, moved, end);
    return moved;
  }

  void move_plane(const std::array<double, 5>& strain) {
    double low = -0.1, high = 0.1;
    std::vector<Lanes> end;
    for (int i = 0; i < 100; ++i) {
      const double middle = 0.5 * (low + high);
      (stress_for(strain, middle, end)[2](0) > 0.0 ? high : low) = middle;
    }
    stress = stress_for(strain, 0.5 * (low + high), end);
    state = end;
  }

  MaterialLaw law;
  SymmetricLanes stress = SymmetricLanes::zero();
  std::vector<Lanes> state;
};

}  // namespace

TEST_CASE("plane plasticity is the solid law with no stress along z", "[core][materials][shells]") {
  std::size_t index = 0;
  for (const MaterialLaw& law : plastic_laws()) {
    Point plane(law);
    SolidPoint solid(law);
    ++index;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> size(-2e-3, 2e-3);
    double before = 0.0;
    for (int step = 0; step < 30; ++step) {
      INFO("law " << index << ", step " << step);
      const std::array<double, 5> strain{size(random), size(random), size(random), size(random),
                                         size(random)};
      plane.move_plane(strain);
      solid.move_plane(strain);
      for (std::size_t i = 0; i < 5; ++i)
        CHECK(plane.stress[i](0) == Approx(solid.stress[plane_places[i]](0)).margin(1.0));  // of 1e8
      for (std::size_t i = 0; i < plane.state.size(); ++i)
        CHECK(plane.state[i](0) == Approx(solid.state[i](0)).epsilon(1e-8).margin(1e-11));
      const double eqps = plane.state.back()(0);
      CHECK(eqps >= before);
      before = eqps;
    }
    CHECK(before > 1e-3);
  }
}

TEST_CASE("the plane yield condition holds to round-off", "[core][materials][shells]") {
  for (const double hardening : {0.0, 1e9, -1e9}) {
    Point point(PlasticLaw<LinearHardening>{steel, {200e6, hardening, 0.0}});
    point.move_plane({4e-3, -1e-3, 2e-3, 1e-3, 0.5e-3});
    const double eqps = point.state.back()(0);
    CHECK(point.von_mises() == Approx(200e6 + hardening * eqps).epsilon(1e-11));
  }
}

TEST_CASE("pulled along x alone a plane elastic point follows Young's modulus", "[core][materials][shells]") {
  Point point(ElasticLaw{steel});
  const double youngs = 9.0 * 160e9 * 80e9 / (3.0 * 160e9 + 80e9), nu = youngs / (2.0 * 80e9) - 1.0;
  point.move_plane({1e-4, -nu * 1e-4, 0.0, 2e-4, 0.0});
  CHECK(point.stress[0](0) == Approx(youngs * 1e-4));
  CHECK(point.stress[1](0) == Approx(0.0).margin(1e-6));
  CHECK(point.stress[3](0) == Approx(80e9 * 2e-4));
}

TEST_CASE("lanes that yield and lanes that do not may stand in one batch", "[core][materials][shells]") {
  const PlasticLaw<LinearHardening> law{steel, {200e6, 1e9, 0.0}};
  PlaneStep step{{}, 1.0};
  for (Lanes& strain : step.strain) strain.setZero();
  for (int lane = 0; lane < n_lanes; ++lane) step.strain[0](lane) = 4e-4 * lane;
  PlaneLanes stress;
  for (Lanes& component : stress) component.setZero();
  std::vector<Lanes> state(law.n_state);
  law.start(state);
  law.update_plane(step, stress, state);
  for (int lane = 0; lane < n_lanes; ++lane) {
    Point alone(law);
    alone.move_plane({4e-4 * lane, 0.0, 0.0, 0.0, 0.0});
    CHECK(stress[0](lane) == Approx(alone.stress[0](0)).epsilon(1e-11));
  }
  CHECK(state.back()(0) == 0.0);
  CHECK(state.back()(7) > 0.0);
}

}  // namespace plane_return_test
