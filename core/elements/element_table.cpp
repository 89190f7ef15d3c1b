// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_table.hpp"

#include <algorithm>
#include <array>

#include "core/base/names.hpp"
#include "core/elements/elements.hpp"

namespace contactsim {

std::span<const ElementFormulation* const> solid_elements() {
  static constexpr std::array rows{
      &hex8_mean_quadrature, &hex8_selective_deviatoric, &hex8_fully_integrated,   &tet4_mean_quadrature,
      &tet10_composite,      &wedge6_mean_quadrature,    &pyramid5_mean_quadrature};
  return rows;
}

std::span<const ElementFormulation* const> shell_elements() {
  static constexpr std::array rows{&shell4_bt_shell, &quad4_bt_shell, &shell3_c0_tri_shell};
  return rows;
}

std::span<const ElementFormulation* const> membrane_elements() {
  static constexpr std::array rows{&shell4_membrane, &quad4_membrane, &shell3_membrane};
  return rows;
}

std::span<const ElementFormulation* const> line_elements() {
  static constexpr std::array rows{&beam2_beam,      &bar2_beam,         &beam2_truss,         &bar2_truss,
                                   &sphere_particle, &beam2_spring,      &bar2_spring,         &beam2_damper,
                                   &bar2_damper,     &sphere_point_mass, &sphere_point_inertia};
  return rows;
}

namespace {

const ElementFormulation* find(std::span<const ElementFormulation* const> rows, Shape shape,
                               std::string_view formulation) {
  const std::string wanted = fold(formulation);
  for (const ElementFormulation* row : rows) {
    if (row->shape == shape && row->formulation == wanted) return row;
  }
  return nullptr;
}

}  // namespace

const ElementFormulation* find_solid_element(Shape shape, std::string_view formulation) {
  return find(solid_elements(), shape, formulation);
}

const ElementFormulation* default_solid_element(Shape shape) {
  const auto rows = solid_elements();
  const auto found = std::ranges::find(rows, shape, [](const ElementFormulation* row) { return row->shape; });
  return found == rows.end() ? nullptr : *found;
}

const ElementFormulation* find_shell_element(Shape shape, std::string_view formulation) {
  if (shape == Shape::shell3 && find(shell_elements(), Shape::shell4, formulation) != nullptr)
    return &shell3_c0_tri_shell;
  return find(shell_elements(), shape, formulation);
}

const ElementFormulation* find_membrane_element(Shape shape) {
  return find(membrane_elements(), shape, "mean_quadrature");
}

const ElementFormulation* find_line_element(Shape shape, std::string_view formulation) {
  return find(line_elements(), shape, formulation);
}

std::string list_formulations(Shape shape) {
  std::string list;
  for (const auto rows : {solid_elements(), shell_elements()}) {
    for (const ElementFormulation* row : rows) {
      if (row->shape != shape) continue;
      if (!list.empty()) list += ", ";
      list += row->formulation;
    }
  }
  return list;
}

}  // namespace contactsim
