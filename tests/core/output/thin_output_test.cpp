// SPDX-License-Identifier: BSD-3-Clause
// What shells and lines write: stresses along the global axes, strains of the surface or along the line.
#include <Eigen/Geometry>
#include <cmath>

#include "core/dynamics/internal_force.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "core/output/output_variables.hpp"
#include "support/catch.hpp"
#include "support/lone_element.hpp"
#include "support/lone_shell.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

constexpr ElasticModuli steel{160e9, 80e9};
constexpr double youngs = 9.0 * 160e9 * 80e9 / (3.0 * 160e9 + 80e9);

/// One element that a linear map moves in one step.
struct Moved {
  Moved(Mesh its_mesh, ModelBlock block, const Eigen::Matrix3d& f) : mesh(std::move(its_mesh)) {
    model.mesh = &mesh;
    model.blocks.push_back(std::move(block));
    model.mass = lumped_mass(mesh, model.blocks);
    model.inertia = lumped_inertia(mesh, model.blocks);
    state = make_state(mesh.coordinates(), model.blocks, 0.0);
    state.coordinates = f * mesh.coordinates();
    state.velocity = state.coordinates - mesh.coordinates();
    InternalForce internal(model, state);
    Eigen::Matrix3Xd forces = state.velocity;
    const Eigen::Matrix3Xd still = 0.0 * forces;
    Motion motion{1.0, 1.0, state.coordinates, state.velocity};
    motion.angular_velocity = &still;
    internal.set_forces(motion, forces);
  }

  std::vector<double> element(const std::string& name, std::optional<std::size_t> point = {}) const {
    const OutputVariables variables(model);
    const OutputVariable* variable = variables.find(FieldLocation::element, name);
    if (variable == nullptr) return {};
    std::vector<double> values(static_cast<std::size_t>(variable->n_components));
    variable->fill({model, state}, {0, 0, 1, point}, values);
    return values;
  }

  Mesh mesh;
  Model model;
  State state;
};

void check_close(const std::vector<double>& found, const std::vector<double>& expected, double margin) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).margin(margin));
}

/// Strain e along z, none across it.
Eigen::Matrix3d pulled_along_z(double e) { return Eigen::Vector3d(1.0, 1.0, 1.0 + e).asDiagonal(); }

/// A unit square in the plane x = 0, its edges at 45 degrees to y and z.
Moved pulled_shell() {
  const double r = std::sqrt(0.5);
  Eigen::Matrix3Xd x(3, 4);
  x << 0, 0, 0, 0, 0, r, 0, -r, 0, r, 2 * r, r;
  const Mesh mesh = one_element_mesh(Shape::shell4, x);
  const double thickness = 0.1;
  return {mesh,
          make_shell_block(mesh, 0, shell4_bt_shell, undamped(ElasticLaw{steel}), gauss_layers(),
                           {&thickness, 1}),
          pulled_along_z(1e-6)};
}

}  // namespace

TEST_CASE("a shell writes its stress along the global axes, its thickness and the strain of its surface",
          "[core][output][shells]") {
  const Moved shell = pulled_shell();
  const double nu = youngs / (2.0 * steel.shear) - 1.0, direct = youngs / (1.0 - nu * nu) * 1e-6;
  const std::vector<double> stress{0.0, nu * direct, direct, 0.0, 0.0, 0.0};
  check_close(shell.element("stress"), stress, 1.0);  // of 1e5: strains are of the middle of the step
  check_close(shell.element("stress", 2), stress, 1.0);
  check_close(shell.element("memb_stress"), stress, 1.0);
  const double thinner = -nu / (1.0 - nu) * 1e-6;
  check_close(shell.element("element_thickness"), {0.1 * (1.0 + thinner)}, 1e-12);
  check_close(shell.element("volume"), {0.1}, 1e-6);
  check_close(shell.element("log_strain"), {thinner, 0.0, 1e-6, 0.0, 0.0, 0.0}, 1e-11);
  check_close(shell.element("rate_of_deformation"), {0.0, 0.0, 1e-6, 0.0, 0.0, 0.0}, 1e-11);
}

TEST_CASE("a truss writes its stress and strain along itself, wherever it points", "[core][output][beams]") {
  Eigen::Matrix3Xd x(3, 2);
  x << 0, 0, 0, 0, 0, 2;
  const Mesh mesh = one_element_mesh(Shape::bar2, x);
  BeamShapeSettings one_fibre;
  one_fibre.fibres = {{}};
  const double area = 0.01;
  const Moved truss(mesh,
                    make_line_block(mesh, 0, bar2_truss, undamped(ElasticLaw{steel}), one_fibre, {&area, 1}),
                    pulled_along_z(1e-6));
  check_close(truss.element("stress"), {0.0, 0.0, youngs * 1e-6, 0.0, 0.0, 0.0}, 1.0);
  check_close(truss.element("log_strain"), {0.0, 0.0, 1e-6, 0.0, 0.0, 0.0}, 1e-11);
  check_close(truss.element("rate_of_deformation"), {0.0, 0.0, 1e-6, 0.0, 0.0, 0.0}, 1e-11);
  check_close(truss.element("volume"), {0.02}, 1e-12);
  CHECK(truss.element("element_thickness").empty());
}

TEST_CASE("rigid bodies have global variables by their names in lower case", "[core][output][rigid]") {
  Model model;
  const Mesh mesh;
  model.mesh = &mesh;
  RigidBody body;
  body.name = "Punch";
  body.centre = {1.0, 0.0, 0.0};
  model.rigid.bodies.push_back(body);
  State state;
  state.rigid.resize(1);
  state.rigid[0].position = {1.0, 2.0, 0.0};
  state.rigid[0].reaction = {0.0, 0.0, 7.0};
  const OutputVariables variables(model);
  const auto value_of = [&](const std::string& name) {
    const OutputVariable* variable = variables.find(FieldLocation::global, name);
    REQUIRE(variable != nullptr);
    double value = 0.0;
    variable->fill({model, state}, {}, {&value, 1});
    return value;
  };
  CHECK(value_of("disply_punch") == 2.0);
  CHECK(value_of("reactz_punch") == 7.0);
  CHECK(value_of("qvec1_punch") == 1.0);
  CHECK(value_of("rotvx_punch") == 0.0);
}
