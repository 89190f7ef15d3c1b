// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/output_table.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "support/row_values.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::vector<OutputRow> all_rows() {
  std::vector<OutputRow> rows;
  for (const auto some : {global_output_rows(), nodal_output_rows(), element_output_rows()})
    rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

Eigen::Matrix3d shear_and_stretch() {
  Eigen::Matrix3d f;
  f << 1.2, 0.3, 0, 0, 0.9, 0, 0.1, 0, 1.1;
  return f;
}

using Values = std::vector<double>;

}  // namespace

TEST_CASE("every output variable is complete and has a name of its own", "[core][output]") {
  std::set<std::pair<FieldLocation, std::string_view>> names;
  for (const OutputRow& row : all_rows()) {
    CAPTURE(row.name);
    CHECK(names.insert({row.location, row.name}).second);
    CHECK(row.help.ends_with("]"));
    CHECK(std::none_of(row.name.begin(), row.name.end(), [](char c) { return c == ' ' || std::isupper(c); }));
    CHECK((row.location == FieldLocation::element || !row.is_at_points));
  }
}

TEST_CASE("every output variable fills all its values, any range alike", "[core][output]") {
  SampleRun run;
  run.deform(shear_and_stretch(), Eigen::Matrix3d::Random());
  for (const OutputRow& row : all_rows()) {
    CAPTURE(row.name);
    if (row.is_of_shells) continue;
    const std::size_t n = row.location == FieldLocation::global ? 1 : 9;
    const Values all = values_of(run, row, {0, 0, n, {}});
    CHECK(std::all_of(all.begin(), all.end(), [](double value) { return std::isfinite(value); }));
    if (row.location == FieldLocation::global) continue;
    const auto n_components = static_cast<std::ptrdiff_t>(row.n_components());
    CHECK(values_of(run, row, {0, 7, 2, {}}) ==
          Values(all.begin() + 7 * n_components, all.begin() + 9 * n_components));
  }
}

TEST_CASE("global variables by hand", "[core][output]") {
  SampleRun run;
  run.state.time = 3.0;
  run.state.next_dt = 0.25;
  run.state.energies.external = 7.0;
  run.state.energies.error = -1.0;
  run.state.momentum = {1, 2, 3};
  CHECK(global(run, "time") == Values{3});
  CHECK(global(run, "timestep") == Values{0.25});
  run.state.dt = 0.5;
  CHECK(global(run, "timestep") == Values{0.5});
  CHECK(global(run, "external_energy") == Values{7});
  CHECK(global(run, "energy_error") == Values{-1});
  CHECK(global(run, "momentum") == Values{1, 2, 3});
  run.set_point_value(0, 8, run.model.blocks[0].layout.energy(), 5.0);
  run.set_point_value(1, 1, run.model.blocks[1].layout.energy(), 0.5);
  CHECK(global(run, "strain_energy") == Values{5.5});
}

TEST_CASE("dead elements are counted, dying ones and empty lanes are not", "[core][output]") {
  SampleRun run;
  CHECK(global(run, "dead_elements") == Values{0});
  std::vector<Lanes>& life = run.state.blocks[0].life;
  life.assign(2, Lanes::Constant(1.0));
  life[0](1) = 0.5;
  life[0](3) = life[1](0) = 0.0;
  life[1] = first_lanes(1).select(life[1], 0.0);  // the block has nine elements
  CHECK(global(run, "dead_elements") == Values{2});
}

TEST_CASE("a spinning bar has the angular momentum of its masses", "[core][output]") {
  SampleRun run;
  Eigen::Matrix3d spin;
  spin << 0, -2, 0, 2, 0, 0, 0, 0, 0;
  run.deform(Eigen::Matrix3d::Identity(), spin);
  double sum = 0.0;
  for (Eigen::Index n = 0; n < run.mesh.coordinates().cols(); ++n)
    sum += 2.0 * run.model.mass(n) * run.mesh.coordinates().col(n).head<2>().squaredNorm();
  CHECK(global(run, "angular_momentum")[2] == Approx(sum));
}

TEST_CASE("nodal variables by hand", "[core][output]") {
  SampleRun run;
  run.deform(2.0 * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero());
  const Eigen::Vector3d place = run.mesh.coordinates().col(5);
  check_close(nodal(run, "displacement", 5), {place[0], place[1], place[2]});
  check_close(nodal(run, "coordinates", 5), {2 * place[0], 2 * place[1], 2 * place[2]});
  check_close(nodal(run, "model_coordinates", 5), {place[0], place[1], place[2]});
  // The first node has an eighth of one element of density 2 and volume 1.
  check_close(nodal(run, "mass", 0), {0.25});
  run.state.acceleration.col(0) << 4, 0, 0;
  run.state.forces.internal.col(0) << 3, 1, 0;
  run.state.forces.external.col(0) << -1, 0, 0;
  check_close(nodal(run, "force_internal", 0), {-3, -1, 0});
  check_close(nodal(run, "force_external", 0), {-1, 0, 0});
  check_close(nodal(run, "force_inertial", 0), {1, 0, 0});
  check_close(nodal(run, "force_contact", 0), {0, 0, 0});
  check_close(nodal(run, "residual", 0), {2, 1, 0});
  check_close(nodal(run, "reaction", 0), {0, 0, 0});
  run.state.forces.contact = Eigen::Matrix3Xd::Ones(3, run.mesh.coordinates().cols());
  check_close(nodal(run, "force_contact", 0), {1, 1, 1});
  check_close(nodal(run, "residual", 0), {3, 2, 1});
}

TEST_CASE("what holds a node is the reaction", "[core][output]") {
  SampleRun run;
  PrescribedMotion held;
  held.nodes = {{0}};
  run.model.kinematic_constraints = KinematicConstraints(run.mesh, {held});
  for (const Eigen::Index n : {0, 1}) {
    run.state.acceleration.col(n) << 4, 0, 0;
    run.state.forces.internal.col(n) << 3, 1, 0;
  }
  check_close(nodal(run, "reaction", 0), {1 - 3, -1, 0});  // mass 0.25
  check_close(nodal(run, "reaction", 1), {0, 0, 0});
}

TEST_CASE("a node without elements has no mass", "[core][output]") {
  SampleRun run;
  run.model.mass.col(3).setConstant(minimum_nodal_mass);
  CHECK(nodal(run, "mass", 3) == Values{0});
}

TEST_CASE("strains of a uniform deformation are the same in every element", "[core][output]") {
  SampleRun run;
  const Eigen::Matrix3d f = Eigen::Vector3d(std::exp(0.2), std::exp(-0.1), 1.0).asDiagonal();
  Eigen::Matrix3d l;
  l << 1, 4, 0, 0, 2, 0, 0, 0, 3;
  run.deform(f, l);
  for (const std::size_t e : {std::size_t{0}, std::size_t{8}}) {
    check_close(element(run, "log_strain", e), {0.2, -0.1, 0, 0, 0, 0});
    check_close(element(run, "max_principal_log_strain", e), {0.2});
    check_close(element(run, "intermediate_principal_log_strain", e), {0});
    check_close(element(run, "min_principal_log_strain", e), {-0.1});
    check_close(element(run, "max_shear_log_strain", e), {0.15});
    check_close(element(run, "green_lagrange_strain", e),
                {0.5 * (std::exp(0.4) - 1), 0.5 * (std::exp(-0.2) - 1), 0, 0, 0, 0});
    check_close(element(run, "rate_of_deformation", e), {1, 2, 3, 2, 0, 0});
    check_close(element(run, "volume", e), {std::exp(0.1)});
  }
  check_close(element(run, "centroid", 8), {8.5 * std::exp(0.2), 0.5 * std::exp(-0.1), 0.5});
}

TEST_CASE("stresses of an element by hand", "[core][output]") {
  SampleRun run;
  for (std::size_t c = 0; c < 6; ++c) run.set_point_value(0, 8, c, Values{6, 0, 0, 4, 0, 0}[c]);
  check_close(element(run, "stress", 8), {6, 0, 0, 4, 0, 0});
  check_close(element(run, "von_mises", 8), {std::sqrt(36.0 + 3 * 16)});
  check_close(element(run, "hydrostatic_stress", 8), {2});
  check_close(element(run, "fluid_pressure", 8), {-2});
  // The roots of s^2 - 6 s - 16, and 0.
  check_close(element(run, "principal_stresses", 8), {8, 0, -2});
  check_close(element(run, "max_principal_stress", 8), {8});
  check_close(element(run, "intermediate_principal_stress", 8), {0});
  check_close(element(run, "min_principal_stress", 8), {-2});
  check_close(element(run, "stress", 7), {0, 0, 0, 0, 0, 0});
}

TEST_CASE("unrotated and first Piola-Kirchhoff stress undo the motion", "[core][output]") {
  SampleRun run;
  run.set_point_value(0, 2, 1, 5.0);  // yy
  Eigen::Matrix3d quarter_turn;
  quarter_turn << 0, -1, 0, 1, 0, 0, 0, 0, 1;
  run.deform(quarter_turn * Eigen::Vector3d(1, 2, 1).asDiagonal(), Eigen::Matrix3d::Zero());
  check_close(element(run, "unrotated_stress", 2), {5, 0, 0, 0, 0, 0});
  // det F = 2; F^-T turns x to y: the force along y on the face that was across x.
  check_close(element(run, "first_pk_stress", 2), {0, 0, 0, 0, 0, 0, 10, 0, 0});
}

TEST_CASE("what else elements have", "[core][output]") {
  SampleRun run;
  run.set_point_value(1, 1, run.model.blocks[1].layout.energy(), 6.0);
  check_close(element(run, "element_mass", 1, 1), {3});
  check_close(element(run, "strain_energy", 1, 1), {6});
  check_close(element(run, "strain_energy_density", 1, 1), {6});
  check_close(element(run, "death_status", 0), {1});
  check_close(element(run, "processor_id", 0), {0});
}

TEST_CASE("an element of several integration points has their mean, or one of them", "[core][output]") {
  SampleRun run;
  // As if the six stresses and the state stood there twice: at one place and the next.
  run.model.blocks[1].layout.n_points = 2;
  run.model.blocks[1].layout.point_size = 1;
  run.set_point_value(1, 0, 0, 1.0);
  run.set_point_value(1, 0, 1, 3.0);
  CHECK(stress_of(run.context(), {1, 0, 1, {}}, 0)(0, 0) == 2.0);
  CHECK(stress_of(run.context(), {1, 0, 1, 0}, 0)(0, 0) == 1.0);
  CHECK(stress_of(run.context(), {1, 0, 1, 1}, 0)(0, 0) == 3.0);
}
