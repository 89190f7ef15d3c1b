// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/element_table.hpp"

#include <array>

#include "core/elements/elements.hpp"
#include "core/names.hpp"

namespace contactsim {

std::span<const SolidElement* const> solid_elements() {
  static constexpr std::array rows{&hex8_mean_quadrature,   &hex8_selective_deviatoric,
                                   &hex8_fully_integrated,  &tet4_mean_quadrature,
                                   &wedge6_mean_quadrature, &pyramid5_mean_quadrature};
  return rows;
}

const SolidElement* find_solid_element(Shape shape, std::string_view formulation) {
  const std::string wanted = fold(formulation);
  for (const SolidElement* row : solid_elements()) {
    if (row->shape == shape && row->formulation == wanted) return row;
  }
  return nullptr;
}

std::string list_formulations(Shape shape) {
  std::string list;
  for (const SolidElement* row : solid_elements()) {
    if (row->shape != shape) continue;
    if (!list.empty()) list += ", ";
    list += row->formulation;
  }
  return list;
}

}  // namespace contactsim
