// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_table.hpp"

#include "core/elements/elements.hpp"
#include "support/catch.hpp"

using namespace contactsim;

// What every row does is in the conformance tests.
TEST_CASE("rows are found by shape and formulation, in any case", "[core][elements]") {
  CHECK(find_solid_element(Shape::hex8, "Mean Quadrature") == &hex8_mean_quadrature);
  CHECK(find_solid_element(Shape::hex8, "selective_deviatoric") == &hex8_selective_deviatoric);
  CHECK(find_solid_element(Shape::tet4, "selective_deviatoric") == nullptr);
  CHECK(find_solid_element(Shape::shell4, "bt_shell") == nullptr);
  CHECK(find_shell_element(Shape::shell4, "BT_SHELL") == &shell4_bt_shell);
  CHECK(find_shell_element(Shape::quad4, "bt_shell") == &quad4_bt_shell);
  CHECK(find_membrane_element(Shape::shell3) == &shell3_membrane);
  CHECK(find_membrane_element(Shape::hex8) == nullptr);
  CHECK(find_line_element(Shape::beam2, "truss") == &beam2_truss);
  CHECK(find_line_element(Shape::sphere, "particle") == &sphere_particle);
  CHECK(find_line_element(Shape::sphere, "truss") == nullptr);
}

TEST_CASE("the first row of a shape is its default", "[core][elements]") {
  CHECK(default_solid_element(Shape::hex8) == &hex8_mean_quadrature);
  CHECK(default_solid_element(Shape::tet10) == &tet10_composite);
  CHECK(default_solid_element(Shape::hex20) == nullptr);
}

TEST_CASE("triangles take every formulation of quadrilaterals as their own", "[core][elements]") {
  CHECK(find_shell_element(Shape::shell3, "bt_shell") == &shell3_c0_tri_shell);
  CHECK(find_shell_element(Shape::shell3, "c0_tri_shell") == &shell3_c0_tri_shell);
  CHECK(find_shell_element(Shape::shell3, "kh_shell") == nullptr);
  CHECK(find_shell_element(Shape::shell4, "c0_tri_shell") == nullptr);
}

TEST_CASE("formulations of a shape are listed in the order of the rows", "[core][elements]") {
  CHECK(list_formulations(Shape::hex8) == "mean_quadrature, selective_deviatoric, fully_integrated");
  CHECK(list_formulations(Shape::shell4) == "bt_shell");
  CHECK(list_formulations(Shape::hex20) == "");
}

TEST_CASE("rows name nodes and points as their shapes have them", "[core][elements]") {
  for (const auto rows : {solid_elements(), shell_elements(), membrane_elements(), line_elements()}) {
    for (const ElementFormulation* row : rows) {
      INFO(topology(row->shape).name << " " << row->formulation);
      CHECK(row->n_nodes == static_cast<std::size_t>(topology(row->shape).n_nodes));
      CHECK(row->volumes != nullptr);
      CHECK(row->advance != nullptr);
      double whole = 0.0;
      for (std::size_t node = 0; node < row->n_nodes; ++node) whole += row->mass_share(node);
      CHECK(whole == Approx(1.0).epsilon(1e-14));
      for (const ElementFormulation* other : rows)
        CHECK((other == row || other->shape != row->shape || other->formulation != row->formulation));
    }
  }
}
