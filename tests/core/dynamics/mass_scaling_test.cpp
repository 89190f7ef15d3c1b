// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/mass_scaling.hpp"

#include "core/definition/region.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/internal_force.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "support/catch.hpp"
#include "support/material_model.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace {

SimulationDefinition steel() {
  SimulationDefinition definition;
  const MaterialModel elastic =
      test::material_model("elastic", {{"youngs modulus", 200e9}, {"poissons ratio", 0.3}});
  definition.materials.push_back({{"steel", {}}, 7800.0, {elastic}});
  BlockParameters parameters;
  parameters.includes_all_blocks = true;
  parameters.material = DeckName{"steel", {}};
  parameters.model = DeckName{"elastic", {}};
  definition.finite_element_models.push_back({{"fem", {}}, {}, {}, {parameters}, {}});
  return definition;
}

/// A block of ten cubes of width 1 and one of ten flat boxes of a tenth of it.
Mesh thick_and_thin() {
  test::MeshBuilder b;
  b.add_hexes({.id = 1, .name = "thick", .cells = {10, 1, 1}, .size = {10, 1, 1}});
  b.add_hexes({.id = 2, .name = "thin", .cells = {10, 1, 1}, .origin = {0, 0, 1}, .size = {10, 1, 0.1}});
  return b.build();
}

struct Scaled {
  Scaled(double target, std::optional<double> bound = {}, const char* block = nullptr) {
    Region region;
    MassScaling scaling;
    if (block != nullptr) scaling.set.blocks.push_back({block, {}});
    scaling.set.includes_all_blocks = block == nullptr;
    scaling.target_time_step = target;
    scaling.allowable_mass_increase = bound;
    region.mass_scalings.push_back(scaling);
    model = make_model(definition, region, mesh, diagnostics);
  }
  double stable_step() const {
    State state = make_state(mesh.coordinates(), model.blocks, 0.0);
    InternalForce force(model, state);
    const Eigen::Matrix3Xd still = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
    Eigen::Matrix3Xd forces(3, mesh.n_nodes());
    return force.set_forces({0.0, 0.0, mesh.coordinates(), still}, forces).stable_step;
  }
  bool said(const char* id) const {
    return std::ranges::any_of(diagnostics.all(), [&](const Diagnostic& d) { return d.id == id; });
  }

  SimulationDefinition definition = steel();
  Mesh mesh = thick_and_thin();
  Diagnostics diagnostics;
  Model model;
};

constexpr double thick_mass = 10 * 7800.0, thin_mass = 7800.0;

}  // namespace

TEST_CASE("mass scaling brings every element to the target step and adds no more than that",
          "[core][mass_scaling]") {
  const double as_it_is = Scaled(1e-12).stable_step();
  const Scaled scaled(3.0 * as_it_is);
  CHECK(scaled.stable_step() == Approx(3.0 * as_it_is));
  // The flat ones alone have become heavier, by the square of what their step has grown.
  CHECK(scaled.model.mass.row(0).sum() == Approx(thick_mass + 9.0 * thin_mass));
  CHECK(scaled.said("mass-scaled"));
}

TEST_CASE("a bound of mass scaling holds and is reported", "[core][mass_scaling]") {
  const double as_it_is = Scaled(1e-12).stable_step();
  const Scaled scaled(3.0 * as_it_is, 4.0);
  CHECK(scaled.model.mass.row(0).sum() == Approx(thick_mass + 4.0 * thin_mass));
  CHECK(scaled.stable_step() == Approx(2.0 * as_it_is));
  CHECK(scaled.said("mass-scaling-bounded"));
}

TEST_CASE("mass scaling acts on its own blocks alone, and tells when there is nothing to do",
          "[core][mass_scaling]") {
  const double as_it_is = Scaled(1e-12).stable_step();
  const Scaled of_thick(3.0 * as_it_is, {}, "thick");
  CHECK(of_thick.said("mass-scaling-idle"));
  CHECK(of_thick.model.mass.row(0).sum() == Approx(thick_mass + thin_mass));
  CHECK(of_thick.stable_step() == as_it_is);
}
